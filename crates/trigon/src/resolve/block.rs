//! Colours of one 8 x 8 block: one value per pixel where the samples agree, one per sample where they do not.
//!
//! In: shaded fragments. Out: colours to resolve. Linear light, premultiplied.

use crate::lanes::{F32, LANES, Lanes, Rgba};
use crate::raster::GROUPS;
use crate::shade::{ColorGroup, FragmentList, Placement};
use core::ops::{Add, Mul};

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

/// One sample of a block's pixels: red, green, blue and alpha of sixteen pixels at a time.
type Plane = [ColorGroup; GROUPS];

/// Colours of one block.
pub struct ColorBlock {
    planes: Vec<Plane>,
    is_per_sample: bool,
}

impl ColorBlock {
    /// A block whose pixels have `samples` samples.
    #[must_use]
    pub fn new(samples: usize) -> Self {
        Self { planes: vec![[[[0.0; LANES]; 4]; GROUPS]; samples], is_per_sample: false }
    }

    /// Sets every sample to one colour.
    pub fn clear(&mut self, color: [f32; 4]) {
        self.is_per_sample = false;
        self.planes[0] = [color.map(|value| [value; LANES]); GROUPS];
    }

    /// Every sample is going to be replaced: nothing of what is there will be seen.
    pub(crate) fn forget(&mut self) {
        self.is_per_sample = false;
    }

    /// True if samples of a pixel can differ.
    #[must_use]
    pub fn is_per_sample(&self) -> bool {
        self.is_per_sample
    }

    /// Gives each sample its own value.
    #[inline(never)]
    fn expand(&mut self) {
        if let Some((first, rest)) = self.planes.split_first_mut() {
            rest.fill(*first);
        }
        self.is_per_sample = true;
    }

    /// Combines the colours of the listed fragments with what is there. No sample is listed twice.
    #[inline(always)]
    pub(crate) fn merge<L: Lanes>(&mut self, l: L, list: &FragmentList, colors: &[ColorGroup], blend: Blend) {
        for (placement, color) in list.placements().iter().zip(colors) {
            match *placement {
                Placement::InPlace { group, masks } => {
                    self.merge_in_place(l, group, list.masks(masks, self.planes.len()), color, blend);
                }
                Placement::Packed { first, count } => self.merge_packed(list, first, count, color, blend),
            }
        }
    }

    #[inline(always)]
    fn merge_in_place<L: Lanes>(&mut self, l: L, group: usize, masks: &[u16], color: &ColorGroup, blend: Blend) {
        let mut differ = 0;
        for mask in masks {
            differ |= mask ^ masks[0];
        }
        if differ != 0 && !self.is_per_sample {
            self.expand();
        }
        let source = lanes_of(l, color);
        let planes = if self.is_per_sample { self.planes.len() } else { 1 };
        for (plane, bits) in self.planes.iter_mut().zip(masks).take(planes) {
            if *bits == 0 {
                continue;
            }
            let (mask, stored) = (l.mask_from_bits(*bits), &mut plane[group]);
            let old = lanes_of(l, stored);
            let one_minus_alpha = 1.0 - source[3];
            let new = combine(blend, source, one_minus_alpha, old);
            for c in 0..4 {
                mask.select(new[c], old[c]).store(&mut stored[c]);
            }
        }
    }

    #[inline(always)]
    fn merge_packed(&mut self, list: &FragmentList, first: usize, count: usize, color: &ColorGroup, blend: Blend) {
        let all = u32::from(u16::MAX >> (16 - self.planes.len()));
        for lane in 0..count {
            let destination = list.destination(first + lane);
            let (pixel, mut rest) = (destination.pixel(), destination.samples());
            if !self.is_per_sample {
                if rest != all {
                    self.expand();
                } else {
                    rest = 1;
                }
            }
            let source = [color[0][lane], color[1][lane], color[2][lane], color[3][lane]];
            while rest != 0 {
                let stored = &mut self.planes[rest.trailing_zeros() as usize][pixel / LANES];
                rest &= rest - 1;
                let at = pixel % LANES;
                let old = [stored[0][at], stored[1][at], stored[2][at], stored[3][at]];
                let new = combine(blend, source, 1.0 - source[3], old);
                for c in 0..4 {
                    stored[c][at] = new[c];
                }
            }
        }
    }

    /// Colours of sample `s` of the sixteen pixels of lane group `g`.
    #[inline(always)]
    pub(crate) fn lanes<L: Lanes>(&self, l: L, s: usize, g: usize) -> Rgba<L> {
        let [r, g, b, a] = lanes_of(l, &self.planes[s][g]);
        Rgba { r, g, b, a }
    }

    /// The colours of the samples of one pixel, by its number in the block.
    pub(crate) fn pixel(&self, pixel: usize) -> Vec<[f32; 4]> {
        let (g, lane) = (pixel / LANES, pixel % LANES);
        let of = |s: usize| self.planes[if self.is_per_sample { s } else { 0 }][g].map(|channel| channel[lane]);
        (0..self.planes.len()).map(of).collect()
    }

    /// Samples of a pixel.
    #[inline(always)]
    pub(crate) fn sample_count(&self) -> usize {
        self.planes.len()
    }
}

#[inline(always)]
fn lanes_of<L: Lanes>(l: L, group: &ColorGroup) -> [F32<L>; 4] {
    [l.f32_array(&group[0]), l.f32_array(&group[1]), l.f32_array(&group[2]), l.f32_array(&group[3])]
}

/// The one formula, for one fragment and for sixteen.
#[inline(always)]
fn combine<T>(blend: Blend, [r, g, b, a]: [T; 4], one_minus_alpha: T, [dr, dg, db, da]: [T; 4]) -> [T; 4]
where
    T: Copy + Add<Output = T> + Mul<Output = T>,
{
    let t = one_minus_alpha;
    match blend {
        Blend::Replace => [r, g, b, a],
        Blend::Over => [r + dr * t, g + dg * t, b + db * t, a + da * t],
        Blend::Add => [r + dr, g + dg, b + db, a + da],
        Blend::Multiply => [r * dr, g * dg, b * db, da],
    }
}
