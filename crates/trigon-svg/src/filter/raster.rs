//! The picture that filter primitives read and write: premultiplied RGBA, 8 bits a channel, and its color space.
//!
//! Eight bits between primitives is what SVG renderers agree on; inside a primitive the arithmetic is wider.
//! Colors are multiplied by alpha; conversions between sRGB and linearRGB divide it out first, as Filter Effects 1,
//! "color-interpolation-filters" asks.

use std::sync::OnceLock;

use trigon_image::color::{linear_to_srgb, srgb_to_linear, unit_to_u8};

/// One pixel: red, green, blue, alpha.
pub type Pixel = [u8; 4];

/// A picture of `width * height` premultiplied pixels, row 0 at the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Raster {
    width: usize,
    height: usize,
    pixels: Vec<Pixel>,
}

/// The encoding of the color channels of a [`Raster`] (`color-interpolation-filters`).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColorSpace {
    /// The sRGB transfer function, as in the document.
    Srgb,
    /// Proportional to light.
    LinearRgb,
}

/// A rectangle of pixels: from `left`, `top` (inclusive) to `right`, `bottom` (exclusive).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Region {
    /// First column.
    pub left: i32,
    /// First row.
    pub top: i32,
    /// One past the last column.
    pub right: i32,
    /// One past the last row.
    pub bottom: i32,
}

impl Raster {
    /// A transparent picture.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Self {
        Self::filled(width, height, [0; 4])
    }

    /// A picture of one premultiplied color.
    #[must_use]
    pub fn filled(width: usize, height: usize, pixel: Pixel) -> Self {
        Self { width, height, pixels: vec![pixel; width * height] }
    }

    /// A picture of these pixels in row order; `None` where there are not `width * height` of them.
    #[must_use]
    pub fn from_pixels(width: usize, height: usize, pixels: Vec<Pixel>) -> Option<Self> {
        (width.checked_mul(height) == Some(pixels.len())).then_some(Self { width, height, pixels })
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// All pixels in row order.
    #[must_use]
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// All pixels in row order, to write.
    pub fn pixels_mut(&mut self) -> &mut [Pixel] {
        &mut self.pixels
    }

    /// Gives the pixels away, in row order.
    #[must_use]
    pub fn into_pixels(self) -> Vec<Pixel> {
        self.pixels
    }

    /// The pixel at column `x`, row `y`; transparent outside the picture.
    #[must_use]
    pub fn pixel(&self, x: i64, y: i64) -> Pixel {
        match (usize::try_from(x), usize::try_from(y)) {
            (Ok(x), Ok(y)) if x < self.width && y < self.height => self.pixels[y * self.width + x],
            _ => [0; 4],
        }
    }

    /// The whole picture as a rectangle.
    #[must_use]
    pub fn bounds(&self) -> Region {
        let side = |length: usize| i32::try_from(length).unwrap_or(i32::MAX);
        Region { left: 0, top: 0, right: side(self.width), bottom: side(self.height) }
    }

    /// The part in `rect`, which is cut to the picture first.
    #[must_use]
    pub fn cropped(&self, rect: Region) -> Self {
        let Some(rect) = rect.intersect(self.bounds()) else { return Self::new(0, 0) };
        let (left, right) = (to_index(rect.left), to_index(rect.right));
        let rows = to_index(rect.top)..to_index(rect.bottom);
        let height = rows.len();
        let pixels = rows.flat_map(|y| &self.pixels[y * self.width + left..y * self.width + right]).copied().collect();
        Self { width: right - left, height, pixels }
    }

    /// A picture of the size of `self` with `source` placed at (`left`, `top`), transparent elsewhere.
    #[must_use]
    pub fn placed(source: &Self, left: i32, top: i32, width: usize, height: usize) -> Self {
        let mut placed = Self::new(width, height);
        let shown = Region {
            left,
            top,
            right: left.saturating_add(source.bounds().right),
            bottom: top.saturating_add(source.bounds().bottom),
        };
        let Some(shown) = shown.intersect(placed.bounds()) else { return placed };
        let columns = to_index(shown.left)..to_index(shown.right);
        let from = to_index(shown.left - left);
        for y in shown.top..shown.bottom {
            let start = to_index(y - top) * source.width + from;
            let row = to_index(y) * width;
            placed.pixels[row + columns.start..row + columns.end]
                .copy_from_slice(&source.pixels[start..start + columns.len()]);
        }
        placed
    }

    /// Makes everything outside `rect` transparent.
    pub fn clear_outside(&mut self, rect: Region) {
        let Some(kept) = rect.intersect(self.bounds()) else { return self.pixels.fill([0; 4]) };
        let (left, right) = (to_index(kept.left), to_index(kept.right));
        let rows = to_index(kept.top)..to_index(kept.bottom);
        for (y, row) in self.pixels.chunks_exact_mut(self.width.max(1)).enumerate() {
            if rows.contains(&y) {
                row[..left].fill([0; 4]);
                row[right..].fill([0; 4]);
            } else {
                row.fill([0; 4]);
            }
        }
    }

    /// Columns as rows.
    #[must_use]
    pub fn transposed(&self) -> Self {
        /// Side of the squares copied at a time, so that both pictures stay in the cache.
        const BLOCK: usize = 16;
        let mut transposed = Self::new(self.height, self.width);
        for top in (0..self.height).step_by(BLOCK) {
            for left in (0..self.width).step_by(BLOCK) {
                for y in top..(top + BLOCK).min(self.height) {
                    for x in left..(left + BLOCK).min(self.width) {
                        transposed.pixels[x * self.height + y] = self.pixels[y * self.width + x];
                    }
                }
            }
        }
        transposed
    }

    /// Recodes the color channels.
    pub fn convert(&mut self, from: ColorSpace, to: ColorSpace) {
        let table = match (from, to) {
            (ColorSpace::Srgb, ColorSpace::LinearRgb) => linear_from_srgb(),
            (ColorSpace::LinearRgb, ColorSpace::Srgb) => srgb_from_linear(),
            _ => return,
        };
        for pixel in &mut self.pixels {
            match pixel[3] {
                0 => {}
                255 => *pixel = recode(*pixel, table),
                _ => *pixel = multiply(recode(divide(*pixel), table)),
            }
        }
    }
}

impl Region {
    /// The common part; `None` where there is none.
    #[must_use]
    pub fn intersect(self, other: Self) -> Option<Self> {
        let common = Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        };
        (common.left < common.right && common.top < common.bottom).then_some(common)
    }

    /// Moved by (`dx`, `dy`), saturating.
    #[must_use]
    pub fn translated(self, dx: i32, dy: i32) -> Self {
        Self {
            left: self.left.saturating_add(dx),
            top: self.top.saturating_add(dy),
            right: self.right.saturating_add(dx),
            bottom: self.bottom.saturating_add(dy),
        }
    }

    /// Columns.
    #[must_use]
    pub fn width(self) -> usize {
        to_index(self.right.saturating_sub(self.left))
    }

    /// Rows.
    #[must_use]
    pub fn height(self) -> usize {
        to_index(self.bottom.saturating_sub(self.top))
    }
}

/// A coordinate inside a picture as an index; 0 for negative ones.
fn to_index(coordinate: i32) -> usize {
    usize::try_from(coordinate).unwrap_or(0)
}

/// A color in another color space.
#[must_use]
pub fn convert_color(rgb: [u8; 3], from: ColorSpace, to: ColorSpace) -> [u8; 3] {
    let table = match (from, to) {
        (ColorSpace::Srgb, ColorSpace::LinearRgb) => linear_from_srgb(),
        (ColorSpace::LinearRgb, ColorSpace::Srgb) => srgb_from_linear(),
        _ => return rgb,
    };
    rgb.map(|code| table[usize::from(code)])
}

/// Color times alpha, nearest code.
#[must_use]
pub fn multiply([r, g, b, a]: Pixel) -> Pixel {
    [product(r, a), product(g, a), product(b, a), a]
}

/// Color over alpha, nearest code; black where alpha is 0.
#[must_use]
pub fn divide([r, g, b, a]: Pixel) -> Pixel {
    let quotient = |code: u8| match a {
        0 => 0,
        _ => u8::try_from((u32::from(code) * 255 + u32::from(a) / 2) / u32::from(a)).unwrap_or(u8::MAX),
    };
    [quotient(r), quotient(g), quotient(b), a]
}

/// `a * b / 255`, nearest code, exactly.
#[must_use]
pub fn product(a: u8, b: u8) -> u8 {
    let scaled = u32::from(a) * u32::from(b) + 128;
    // Blinn's exact division by 255 of a number of 16 bits.
    ((scaled + (scaled >> 8)) >> 8).to_le_bytes()[0]
}

fn recode([r, g, b, a]: Pixel, table: &[u8; 256]) -> Pixel {
    [table[usize::from(r)], table[usize::from(g)], table[usize::from(b)], a]
}

fn linear_from_srgb() -> &'static [u8; 256] {
    static TABLE: OnceLock<[u8; 256]> = OnceLock::new();
    TABLE.get_or_init(|| table_of(|code| unit_to_u8(srgb_to_linear(code))))
}

fn srgb_from_linear() -> &'static [u8; 256] {
    static TABLE: OnceLock<[u8; 256]> = OnceLock::new();
    TABLE.get_or_init(|| table_of(|code| linear_to_srgb(f32::from(code) / 255.0)))
}

/// `function` of every code.
pub(super) fn table_of(function: impl Fn(u8) -> u8) -> [u8; 256] {
    let mut table = [0; 256];
    for (entry, code) in table.iter_mut().zip(0..=u8::MAX) {
        *entry = function(code);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn product_is_the_nearest_code() {
        for a in 0..=255u8 {
            for b in 0..=255u8 {
                let exact = f64::from(a) * f64::from(b) / 255.0;
                assert!((f64::from(product(a, b)) - exact).abs() <= 0.5, "{a} {b}");
            }
        }
    }

    #[test]
    fn opaque_ends_of_the_scale_survive_both_conversions() {
        let mut raster = Raster::from_pixels(2, 1, vec![[0, 255, 0, 255], [0, 0, 0, 0]]).unwrap();
        let before = raster.clone();
        raster.convert(ColorSpace::Srgb, ColorSpace::LinearRgb);
        raster.convert(ColorSpace::LinearRgb, ColorSpace::Srgb);
        assert_eq!(raster, before);
        assert_eq!(convert_color([128, 188, 10], ColorSpace::Srgb, ColorSpace::LinearRgb), [55, 128, 1]);
    }

    #[test]
    fn cropping_and_placing_are_inverse_inside_the_rectangle() {
        let pixels = (0..12).map(|i| [i, i, i, 255]).collect();
        let raster = Raster::from_pixels(4, 3, pixels).unwrap();
        let rect = Region { left: 1, top: 1, right: 3, bottom: 9 };
        let crop = raster.cropped(rect);
        assert_eq!((crop.width(), crop.height(), crop.pixels()[0][0]), (2, 2, 5));
        let mut kept = raster.clone();
        kept.clear_outside(rect);
        assert_eq!(Raster::placed(&crop, 1, 1, 4, 3), kept);
        assert_eq!(Raster::placed(&crop, -1, 2, 4, 3).pixel(0, 2)[0], 6);
    }

    #[test]
    fn transposing_twice_changes_nothing() {
        let pixels = (0..35u8).map(|i| [i, 2 * i, 3, 255]).collect();
        let raster = Raster::from_pixels(7, 5, pixels).unwrap();
        assert_eq!(raster.transposed().pixel(4, 6), raster.pixel(6, 4));
        assert_eq!(raster.transposed().transposed(), raster);
    }
}
