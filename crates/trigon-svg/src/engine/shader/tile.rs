//! Patterns: a small picture, repeated without end.
//!
//! Between pixels of the tile, colours are mixed by weights of 1/256; at whole pixels they are copied.

use crate::canvas::Transform;
use crate::engine::over::scale;

/// A tile with the map from pixels to its own.
pub(crate) struct Tile {
    width: u32,
    height: u32,
    /// Premultiplied.
    pixels: Vec<u32>,
    /// Tile pixels from pixels.
    to_tile: Transform,
    /// 0..=255.
    opacity: u32,
}

impl Tile {
    /// `None` if there is nothing to repeat, or no way back from pixels to the tile's.
    pub(crate) fn new(
        [width, height]: [u32; 2],
        pixels: Vec<u32>,
        from_tile: &Transform,
        opacity: u32,
    ) -> Option<Self> {
        let to_tile = from_tile.inverse()?;
        let is_whole = !pixels.is_empty() && pixels.len() == width as usize * height as usize;
        is_whole.then_some(Self { width, height, pixels, to_tile, opacity })
    }

    /// The colours of the pixels of row `y` from column `x` on.
    pub(crate) fn row(&self, x: u32, y: u32, out: &mut [u32]) {
        for (column, out) in (x..).zip(out) {
            let [u, v] = self.to_tile.apply([f64::from(column) + 0.5, f64::from(y) + 0.5]);
            *out = scale(self.sample(u, v), self.opacity);
        }
    }

    /// The colour at a point of the tile's plane.
    fn sample(&self, u: f64, v: f64) -> u32 {
        // Texel centres lie at halves.
        let (left, right, x) = neighbours(u - 0.5, self.width);
        let (top, bottom, y) = neighbours(v - 0.5, self.height);
        let at = |column: u32, row: u32| self.pixels[row as usize * self.width as usize + column as usize];
        let upper = mix(at(left, top), at(right, top), x);
        if y == 0 { upper } else { mix(upper, mix(at(left, bottom), at(right, bottom), x), y) }
    }
}

/// The two texels around a coordinate, wrapped, and the weight of the second in 1/256.
fn neighbours(coordinate: f64, size: u32) -> (u32, u32, u32) {
    let size_f = f64::from(size);
    let wrapped = coordinate - libm::floor(coordinate / size_f) * size_f;
    // 1/512 is added to round the weight.
    let fixed = (wrapped * 256.0 + 0.5) as u32;
    let (texel, weight) = ((fixed >> 8) % size, fixed & 255);
    (texel, (texel + 1) % size, weight)
}

/// `a + (b - a) * weight / 256` for each channel, halves up.
fn mix(a: u32, b: u32, weight: u32) -> u32 {
    if weight == 0 {
        return a;
    }
    let pair = |a: u32, b: u32| ((a * (256 - weight) + b * weight + 0x0080_0080) >> 8) & 0x00FF_00FF;
    pair(a & 0x00FF_00FF, b & 0x00FF_00FF) | pair(a >> 8 & 0x00FF_00FF, b >> 8 & 0x00FF_00FF) << 8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_pixels_are_copied_and_repeat() {
        let pixels: Vec<u32> = (0..6).map(|i| 0xFF00_0000 | i).collect();
        let tile = Tile::new([3, 2], pixels, &Transform::translate(1.0, 0.0), 255).unwrap();
        let mut row = [0; 7];
        tile.row(0, 3, &mut row);
        assert_eq!(row.map(|pixel| pixel & 255), [5, 3, 4, 5, 3, 4, 5]);
    }

    #[test]
    fn colours_between_pixels_are_mixed() {
        assert_eq!(mix(0xFF00_0000, 0xFF00_00FF, 128), 0xFF00_0080);
        assert_eq!(mix(0x0000_0000, 0xFFFF_FFFF, 255), 0xFEFE_FEFE);
    }
}
