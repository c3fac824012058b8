//! Pixels to palette indices, with an ordered dither between the two palette colors that enclose a color.
//!
//! The first of the two is the nearest; the second is the one for which the color lies nearest to the line between
//! them, with a handicap for colors far apart, whose pattern would be coarse. An 8 x 8 threshold pattern chooses: the
//! share of the second is as far as the color lies towards it. Colors of the palette itself are never dithered, and the
//! pattern stands still in an animation.
//!
//! Source: the pattern is from B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures" (1973).

/// Finds palette indices; remembers colors it has seen.
pub(super) struct PaletteMapper {
    /// Reds, greens and blues of the palette, so that loops over it vectorize; unused entries are too far away to matter.
    channels: [[f32; 256]; 3],
    is_dithered: bool,
    /// By a hash of the color: the color plus 1 in the upper bits, and its mix.
    cache: Vec<(u32, Mix)>,
}

/// Two palette indices in ascending order, and how many of 64 pixels show the second.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Mix {
    first: u8,
    second: u8,
    share_of_second: u8,
}

/// Room for the colors of most frames; a color pushed out is only searched again.
const CACHE_BITS: u32 = 18;

impl PaletteMapper {
    /// `palette` holds 1 to 256 colors.
    pub(super) fn new(palette: &[[u8; 3]], is_dithered: bool) -> Self {
        let mut channels = [[UNUSED; 256]; 3];
        for (index, color) in palette.iter().enumerate().take(256) {
            for (channel, &code) in channels.iter_mut().zip(color) {
                channel[index] = f32::from(code);
            }
        }
        Self { channels, is_dithered, cache: vec![(0, Mix::default()); 1 << CACHE_BITS] }
    }

    /// The index for a pixel of `color` at column `x` and row `y`.
    pub(super) fn index(&mut self, color: [u8; 3], x: u32, y: u32) -> u8 {
        let [r, g, b] = color;
        let key = u32::from_be_bytes([0, r, g, b]) + 1;
        let slot = (key.wrapping_mul(0x9e37_79b1) >> (32 - CACHE_BITS)) as usize;
        if self.cache[slot].0 != key {
            self.cache[slot] = (key, self.mix(color));
        }
        let mix = self.cache[slot].1;
        if BAYER[(y % 8) as usize][(x % 8) as usize] < mix.share_of_second { mix.second } else { mix.first }
    }

    fn mix(&self, color: [u8; 3]) -> Mix {
        let color = color.map(f32::from);
        let (near, distance) = smallest(&self.squared_distances(color));
        if !self.is_dithered || distance == 0.0 {
            return Mix { first: near, second: near, share_of_second: 0 };
        }
        let shares = self.shares(color, near);
        // Of two equal errors the first is taken: that of the nearest alone, with a share of 0.
        let (best, error) = smallest(&shares.map(|share| share.error));
        let far = if error < distance { best } else { near };
        let share = if far == near { 0.0 } else { shares[usize::from(far)].of_far };
        // In ascending order, so that the pattern does not turn over where the two swap roles.
        let share = if near <= far { share } else { 1.0 - share };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the share is in 0..=1")]
        let share_of_second = (share * 64.0 + 0.5) as u8;
        Mix { first: near.min(far), second: near.max(far), share_of_second }
    }

    fn squared_distances(&self, [r, g, b]: [f32; 3]) -> [f32; 256] {
        let [reds, greens, blues] = &self.channels;
        std::array::from_fn(|i| square(reds[i] - r) + square(greens[i] - g) + square(blues[i] - b))
    }

    /// For each palette color the best mix of it and the nearest color.
    fn shares(&self, [r, g, b]: [f32; 3], near: u8) -> [Share; 256] {
        let [reds, greens, blues] = &self.channels;
        let near = usize::from(near);
        let origin = [reds[near], greens[near], blues[near]];
        let offset = [r - origin[0], g - origin[1], b - origin[2]];
        let distance = square(offset[0]) + square(offset[1]) + square(offset[2]);
        std::array::from_fn(|i| {
            let way = [reds[i] - origin[0], greens[i] - origin[1], blues[i] - origin[2]];
            let length = square(way[0]) + square(way[1]) + square(way[2]);
            let towards = offset[0] * way[0] + offset[1] * way[1] + offset[2] * way[2];
            // How far along the way the color lies; at most half, or the other would be the nearest.
            let of_far = (towards / length.max(1.0)).clamp(0.0, 0.5);
            let error_of_mean = distance - 2.0 * of_far * towards + of_far * of_far * length;
            let error_of_mean = if error_of_mean > 0.0 { error_of_mean } else { 0.0 };
            Share { of_far, error: error_of_mean + COARSENESS * of_far * (1.0 - of_far) * length }
        })
    }
}

/// What part of the pixels shows the farther of two colors, and the error of that.
#[derive(Clone, Copy)]
struct Share {
    of_far: f32,
    error: f32,
}

/// The value of palette entries that are not there.
const UNUSED: f32 = 1e6;

/// Weight of the variance of a pattern against the error of its mean; also the share under which one does not dither.
const COARSENESS: f32 = 1.0 / 32.0;

fn square(x: f32) -> f32 {
    x * x
}

/// The first of the smallest values, none below 0, and its index.
fn smallest(values: &[f32; 256]) -> (u8, f32) {
    // The bits of floats from 0 on are in the order of the floats, and unlike them their minimum vectorizes.
    let least = values.iter().map(|value| value.to_bits()).min().unwrap_or(0);
    let index = values.iter().position(|value| value.to_bits() == least).unwrap_or(0);
    (u8::try_from(index).unwrap_or(0), f32::from_bits(least))
}

/// Thresholds 0 to 63, neighbours far apart.
const BAYER: [[u8; 8]; 8] = bayer();

/// Bit i of x and of x ^ y, interleaved and reversed.
const fn bayer() -> [[u8; 8]; 8] {
    let mut pattern = [[0; 8]; 8];
    let mut y = 0;
    while y < 8 {
        let mut x = 0;
        while x < 8 {
            let mut bit = 0;
            while bit < 3 {
                let low = x >> bit & 1;
                let crossed = (x ^ y) >> bit & 1;
                pattern[y as usize][x as usize] |= (crossed << 1 | low) << (2 * (2 - bit));
                bit += 1;
            }
            x += 1;
        }
        y += 1;
    }
    pattern
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pattern_has_every_threshold_once() {
        let mut thresholds: Vec<u8> = BAYER.into_iter().flatten().collect();
        thresholds.sort_unstable();
        assert!(thresholds.into_iter().eq(0..64));
        // Every 2 x 2 block has one threshold of each quarter.
        for y in (0..8).step_by(2) {
            let mut quarters = [BAYER[y][0], BAYER[y][1], BAYER[y + 1][0], BAYER[y + 1][1]].map(|t| t / 16);
            quarters.sort_unstable();
            assert_eq!(quarters, [0, 1, 2, 3]);
        }
    }

    #[test]
    fn palette_colors_are_not_dithered() {
        let palette = [[0, 0, 0], [100, 100, 100], [255, 255, 255]];
        let mut mapper = PaletteMapper::new(&palette, true);
        for (index, color) in (0..).zip(palette) {
            assert!((0..64).all(|i| mapper.index(color, i % 8, i / 8) == index));
        }
    }

    #[test]
    fn a_dithered_area_has_the_mean_of_its_color() {
        let palette = [[0, 0, 0], [64, 64, 64], [255, 255, 255]];
        let mut mapper = PaletteMapper::new(&palette, true);
        for code in 0..=255_u8 {
            let sum: u32 =
                (0..64).map(|i| u32::from(palette[usize::from(mapper.index([code; 3], i % 8, i / 8))][0])).sum();
            let mean = f64::from(sum) / 64.0;
            // Under one share in 32 the pattern is left out.
            assert!((mean - f64::from(code)).abs() <= 191.0 / 32.0, "{code} became {mean}");
        }
    }

    #[test]
    fn without_dither_the_nearest_is_taken() {
        let palette = [[10, 0, 0], [20, 0, 0], [200, 0, 0]];
        let mut mapper = PaletteMapper::new(&palette, false);
        assert_eq!([0, 14, 16, 109, 111, 255].map(|r| mapper.index([r, 0, 0], 3, 5)), [0, 0, 1, 1, 2, 2]);
    }
}
