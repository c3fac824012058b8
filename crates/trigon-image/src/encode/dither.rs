//! Pixels to palette indices, with an ordered dither between the two palette colors that enclose a color.
//!
//! The first of the two is the nearest; the second is the one for which the color lies nearest to the line between
//! them, with a handicap for colors far apart, whose pattern would be coarse. An 8 x 8 threshold pattern chooses: the
//! share of the second is as far as the color lies towards it. Colors of the palette itself are never dithered, and the
//! pattern stands still in an animation.
//!
//! Source: the pattern is from B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures" (1973).

/// Finds palette indices; remembers colors it has seen.
pub(super) struct PaletteMapper<'a> {
    palette: &'a [[u8; 3]],
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

const CACHE_BITS: u32 = 15;

impl<'a> PaletteMapper<'a> {
    /// `palette` holds 1 to 256 colors.
    pub(super) fn new(palette: &'a [[u8; 3]], is_dithered: bool) -> Self {
        Self { palette, is_dithered, cache: vec![(0, Mix::default()); 1 << CACHE_BITS] }
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
        let near = self.nearest(color);
        let near_color = self.palette[usize::from(near)];
        if !self.is_dithered || near_color == color {
            return Mix { first: near, second: near, share_of_second: 0 };
        }
        let offset = difference(color, near_color);
        let mut far = near;
        let mut share = 0.0;
        let mut least_error = dot(offset, offset);
        for (index, &candidate) in (0..=u8::MAX).zip(self.palette) {
            let way = difference(candidate, near_color);
            let length = dot(way, way);
            let towards = dot(offset, way);
            // How far along the way the color lies; at most half, or the candidate would be the nearest.
            if towards > 0.0 {
                let t = (towards / length).min(0.5);
                let error =
                    dot(offset, offset) - 2.0 * t * towards + t * t * length + COARSENESS * t * (1.0 - t) * length;
                if error < least_error {
                    (far, share, least_error) = (index, t, error);
                }
            }
        }
        // In ascending order, so that the pattern does not turn over where the two swap roles.
        let share = if near <= far { share } else { 1.0 - share };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the share is in 0..=1")]
        let share_of_second = (share * 64.0 + 0.5) as u8;
        Mix { first: near.min(far), second: near.max(far), share_of_second }
    }

    /// The palette color with the least squared distance; the first of equals.
    fn nearest(&self, color: [u8; 3]) -> u8 {
        let distance = |entry: &[u8; 3]| -> u32 { (0..3).map(|i| u32::from(entry[i].abs_diff(color[i])).pow(2)).sum() };
        let nearest = self.palette.iter().enumerate().min_by_key(|(_, entry)| distance(entry));
        nearest.and_then(|(index, _)| u8::try_from(index).ok()).unwrap_or(0)
    }
}

/// Weight of the variance of a pattern against the error of its mean; also the share under which one does not dither.
const COARSENESS: f32 = 1.0 / 32.0;

fn difference(a: [u8; 3], b: [u8; 3]) -> [f32; 3] {
    [0, 1, 2].map(|i| f32::from(a[i]) - f32::from(b[i]))
}

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
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
