//! Textures with the course's mip chain, and its six ways to sample them.
//!
//! Each level is half the size of the one above, rounded down; along an axis of even size a texel is the mean of two, of
//! odd size of three, weighted so that all count alike. Eight bits a channel at every level.

use super::cast::{to_f32, to_f64, to_u8, to_usize};
use trigon_image::Rgba8Image;

use super::{LevelSampling, NearestRule, Options, PixelSampling};

/// A texture and its smaller levels; at least one texel.
#[derive(Debug, Clone)]
pub(super) struct Texture {
    levels: Vec<Level>,
}

#[derive(Debug, Clone)]
struct Level {
    width: usize,
    height: usize,
    texels: Vec<[u8; 3]>,
}

type Rgb = [f32; 3];

impl Texture {
    /// The picture without its alpha; `None` where it has no pixels.
    pub(super) fn new(image: &Rgba8Image) -> Option<Self> {
        let texels: Vec<_> = image.pixels().iter().map(|[r, g, b, _]| [*r, *g, *b]).collect();
        if texels.is_empty() {
            return None;
        }
        let mut levels = vec![Level { width: image.width() as usize, height: image.height() as usize, texels }];
        while let Some(next) = levels.last().and_then(Level::halved) {
            levels.push(next);
        }
        Some(Self { levels })
    }

    /// Width and height of level 0.
    pub(super) fn size(&self) -> [f64; 2] {
        [to_f64(self.levels[0].width), to_f64(self.levels[0].height)]
    }

    /// The color at `uv` where `level` is the real-valued level, not yet clamped.
    pub(super) fn sample(&self, uv: [f64; 2], level: f64, options: &Options) -> Rgb {
        let level = level.clamp(0.0, to_f64(self.levels.len() - 1));
        let at = |index: usize| self.levels[index.min(self.levels.len() - 1)].sample(uv, options);
        match options.level {
            LevelSampling::Zero => at(0),
            LevelSampling::Nearest => at(to_usize(level + 0.5)),
            LevelSampling::Linear => {
                let lower = to_usize(level);
                let fraction = to_f32(level - to_f64(lower));
                if fraction > 0.0 { mix(at(lower), at(lower + 1), fraction) } else { at(lower) }
            }
        }
    }

    /// Level 0 at `uv`, bilinear.
    pub(super) fn bilinear(&self, uv: [f64; 2]) -> Rgb {
        self.levels[0].bilinear(uv)
    }
}

impl Level {
    fn sample(&self, uv: [f64; 2], options: &Options) -> Rgb {
        match options.pixel {
            PixelSampling::Nearest => self.nearest(uv, options.nearest),
            PixelSampling::Bilinear => self.bilinear(uv),
        }
    }

    fn nearest(&self, [u, v]: [f64; 2], rule: NearestRule) -> Rgb {
        let index = |t: f64, n: usize| match rule {
            NearestRule::Holding => (t * to_f64(n)).floor(),
            NearestRule::Course => (t * to_f64(n - 1) + 0.5).floor(),
        };
        self.texel(index(u, self.width), index(v, self.height))
    }

    fn bilinear(&self, [u, v]: [f64; 2]) -> Rgb {
        let (x, y) = (u * to_f64(self.width) - 0.5, v * to_f64(self.height) - 0.5);
        let (left, top) = (x.floor(), y.floor());
        let row = |y: f64| mix(self.texel(left, y), self.texel(left + 1.0, y), to_f32(x - left));
        mix(row(top), row(top + 1.0), to_f32(y - top))
    }

    /// The texel at a column and row, clamped to the edge.
    fn texel(&self, x: f64, y: f64) -> Rgb {
        let clamped = |at: f64, n: usize| to_usize(at).min(n - 1);
        let texel = self.texels[clamped(y, self.height) * self.width + clamped(x, self.width)];
        texel.map(|code| f32::from(code) / 255.0)
    }

    /// The next level; `None` after the one of a single texel.
    fn halved(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let columns: Vec<_> = (0..width).map(|x| taps(x, self.width)).collect();
        let mut texels = Vec::with_capacity(width * height);
        for y in 0..height {
            let rows = taps(y, self.height);
            for column in &columns {
                let mut sum = [0.0; 3];
                for (row, row_weight) in rows.iter().filter(|tap| tap.1 > 0.0) {
                    for (x, weight) in column.iter().filter(|tap| tap.1 > 0.0) {
                        let texel = self.texels[row * self.width + x];
                        for (total, code) in sum.iter_mut().zip(texel) {
                            *total += f64::from(code) * (row_weight * weight);
                        }
                    }
                }
                texels.push(sum.map(|value| to_u8(value + 0.5)));
            }
        }
        Some(Self { width, height, texels })
    }
}

/// Which of `n` texels make up texel `at` of the next level, and their weights, which sum to 1.
fn taps(at: usize, n: usize) -> [(usize, f64); 3] {
    if n == 1 {
        return [(0, 1.0), (0, 0.0), (0, 0.0)];
    }
    let first = 2 * at;
    if n.is_multiple_of(2) {
        return [(first, 0.5), (first + 1, 0.5), (first, 0.0)];
    }
    let size = to_f64(n / 2);
    let whole = 2.0 + 1.0 / size;
    let before = (1.0 - to_f64(at) / size) / whole;
    let after = ((to_f64(at) + 1.0) / size) / whole;
    [(first, before), (first + 1, 1.0 / whole), (first + 2, after)]
}

fn mix(a: Rgb, b: Rgb, t: f32) -> Rgb {
    std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texture(width: u32, height: u32, texel: impl Fn(u32, u32) -> u8) -> Texture {
        let pixels = (0..width * height).map(|i| [texel(i % width, i / width), 0, 0, 255]).collect();
        Texture::new(&Rgba8Image::from_pixels(width, height, pixels).unwrap()).unwrap()
    }

    #[test]
    fn a_flat_texture_is_flat_at_every_level() {
        let texture = texture(13, 6, |_, _| 77);
        assert_eq!(texture.levels.len(), 4);
        for level in &texture.levels {
            assert!(level.texels.iter().all(|texel| *texel == [77, 0, 0]));
        }
    }

    #[test]
    fn nearest_rules_differ_as_said() {
        let texture = texture(4, 1, |x, _| u8::try_from(x * 10).unwrap());
        let red = |u: f64, nearest| {
            let options = Options { nearest, ..Options::new(1, 1) };
            (texture.sample([u, 0.5], 0.0, &options)[0] * 255.0 + 0.5).floor()
        };
        let at = [0.0, 0.24, 0.4, 0.6, 1.0];
        assert_eq!(at.map(|u| red(u, NearestRule::Holding)), [0.0, 0.0, 10.0, 20.0, 30.0]);
        assert_eq!(at.map(|u| red(u, NearestRule::Course)), [0.0, 10.0, 10.0, 20.0, 30.0]);
    }

    #[test]
    fn levels_are_mixed_by_the_fraction() {
        let texture = texture(2, 1, |x, _| if x == 0 { 0 } else { 200 });
        let options = Options { level: LevelSampling::Linear, ..Options::new(1, 1) };
        let red = |level: f64| texture.sample([0.1, 0.5], level, &options)[0] * 255.0;
        assert!((red(0.0) - 0.0).abs() < 1e-3 && (red(0.5) - 50.0).abs() < 1e-3 && (red(9.0) - 100.0).abs() < 1e-3);
    }
}
