//! Colours of one 8 x 8 block: one value per pixel where the samples agree, one per sample where they do not.
//!
//! In: shaded fragments. Out: colours to resolve. Linear light, premultiplied.

use crate::lanes::{LANES, Lanes, Rgba};
use crate::raster::{BLOCK_PIXELS, NO_TRIANGLE};
use crate::shade::{ColorGroup, Destination};

/// How a fragment's colour (source) and the stored one (destination) combine, sample by sample.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Blend {
    /// The source alone. Such draws may be shaded after their visibility is known.
    #[default]
    Replace,
    /// Source over destination (Porter and Duff, "Compositing Digital Images", 1984).
    Over,
    /// The sum.
    Add,
    /// The product of the colours; destination alpha stays.
    Multiply,
}

/// Red, green, blue and alpha of a block's pixels.
type Plane = [[f32; BLOCK_PIXELS]; 4];

/// Colours of one block.
pub struct ColorBlock {
    planes: Vec<Plane>,
    is_per_sample: bool,
}

impl ColorBlock {
    /// A block whose pixels have `samples` samples.
    #[must_use]
    pub fn new(samples: usize) -> Self {
        Self { planes: vec![[[0.0; BLOCK_PIXELS]; 4]; samples], is_per_sample: false }
    }

    /// Sets every sample to one colour.
    pub fn clear(&mut self, color: [f32; 4]) {
        self.is_per_sample = false;
        for (channel, value) in self.planes[0].iter_mut().zip(color) {
            channel.fill(value);
        }
    }

    /// True if samples of a pixel can differ.
    #[must_use]
    pub fn is_per_sample(&self) -> bool {
        self.is_per_sample
    }

    /// Colours of sample `s`; of every sample, if the block is not per sample.
    #[must_use]
    pub fn plane(&self, s: usize) -> &[[f32; BLOCK_PIXELS]; 4] {
        &self.planes[s]
    }

    /// Gives each sample its own value.
    fn expand(&mut self) {
        if !self.is_per_sample {
            if let Some((first, rest)) = self.planes.split_first_mut() {
                rest.fill(*first);
            }
            self.is_per_sample = true;
        }
    }

    /// Sets all pixels, every sample alike: lane groups in pixel order.
    pub(crate) fn fill(&mut self, colors: &[ColorGroup]) {
        self.is_per_sample = false;
        for (g, group) in colors.iter().enumerate() {
            for (channel, values) in self.planes[0].iter_mut().zip(group) {
                channel[g * LANES..(g + 1) * LANES].copy_from_slice(values);
            }
        }
    }

    /// Stores the colours of fragments at their destinations.
    pub(crate) fn store(&mut self, destinations: &[Destination], colors: &[ColorGroup]) {
        let all = self.all_samples();
        let is_whole = destinations.iter().all(|d| d.samples == all);
        if !is_whole {
            self.expand();
        }
        for (i, d) in destinations.iter().enumerate() {
            let (group, lane, pixel) = (&colors[i / LANES], i % LANES, usize::from(d.pixel));
            let color = [group[0][lane], group[1][lane], group[2][lane], group[3][lane]];
            if self.is_per_sample {
                let mut rest = d.samples;
                while rest != 0 {
                    write(&mut self.planes[rest.trailing_zeros() as usize], pixel, color);
                    rest &= rest - 1;
                }
            } else {
                write(&mut self.planes[0], pixel, color);
            }
        }
    }

    /// Blends the colours of fragments into their destinations, which must be distinct.
    pub(crate) fn blend(&mut self, destinations: &[Destination], colors: &[ColorGroup], blend: Blend) {
        let all = self.all_samples();
        if !destinations.iter().all(|d| d.samples == all) {
            self.expand();
        }
        for (i, d) in destinations.iter().enumerate() {
            debug_assert!(d.id != NO_TRIANGLE);
            let (group, lane, pixel) = (&colors[i / LANES], i % LANES, usize::from(d.pixel));
            let source = [group[0][lane], group[1][lane], group[2][lane], group[3][lane]];
            let mut rest = if self.is_per_sample { d.samples } else { 1 };
            while rest != 0 {
                let plane = &mut self.planes[rest.trailing_zeros() as usize];
                let old = [plane[0][pixel], plane[1][pixel], plane[2][pixel], plane[3][pixel]];
                write(plane, pixel, combine(blend, source, old));
                rest &= rest - 1;
            }
        }
    }

    fn all_samples(&self) -> u16 {
        u16::MAX >> (16 - self.planes.len())
    }

    /// Colours of sample `s` of the sixteen pixels of lane group `g`.
    #[inline(always)]
    pub(crate) fn lanes<L: Lanes>(&self, l: L, s: usize, g: usize) -> Rgba<L> {
        let plane = &self.planes[s];
        let groups = plane.each_ref().map(
            #[inline(always)]
            |channel| channel.as_chunks::<LANES>().0,
        );
        Rgba {
            r: l.f32_array(&groups[0][g]),
            g: l.f32_array(&groups[1][g]),
            b: l.f32_array(&groups[2][g]),
            a: l.f32_array(&groups[3][g]),
        }
    }

    /// Samples of a pixel.
    #[inline(always)]
    pub(crate) fn sample_count(&self) -> usize {
        self.planes.len()
    }
}

#[inline(always)]
fn write(plane: &mut Plane, pixel: usize, color: [f32; 4]) {
    for c in 0..4 {
        plane[c][pixel] = color[c];
    }
}

#[inline(always)]
fn combine(blend: Blend, [r, g, b, a]: [f32; 4], [dr, dg, db, da]: [f32; 4]) -> [f32; 4] {
    match blend {
        Blend::Replace => [r, g, b, a],
        Blend::Over => {
            let t = 1.0 - a;
            [r + dr * t, g + dg * t, b + db * t, a + da * t]
        }
        Blend::Add => [r + dr, g + dg, b + db, a + da],
        Blend::Multiply => [r * dr, g * dg, b * db, da],
    }
}
