//! Heights: the picture of a displacement map in, the height at any texture coordinates out.
//!
//! Read between the four nearest texels, at full size: a mesh fine enough to show them is what they are read for.

use crate::scene::{ScalarSource, TextureOptions};
use trigon_image::DecodedImage;

/// A picture of heights and how it lies on a surface.
pub(crate) struct HeightMap {
    width: usize,
    height: usize,
    /// Row by row from the top, after gain and base of the map's options.
    values: Vec<f32>,
    /// `uv * scale + offset`.
    scale: [f32; 2],
    offset: [f32; 2],
    is_clamped: bool,
}

impl HeightMap {
    /// The channel that the options name, or luminance; as stored, without decoding sRGB. White is 1.
    pub(crate) fn new(image: &DecodedImage, options: &TextureOptions) -> Self {
        let source = ScalarSource::new(options.channel, ScalarSource::Luminance);
        let height = |pixel: [f32; 4]| source.of(pixel) * options.gain + options.base;
        let values = match image {
            DecodedImage::Rgba16(image) => {
                image.pixels().iter().map(|p| height(p.map(|v| f32::from(v) / 65_535.0))).collect()
            }
            DecodedImage::RgbaF32(image) => image.pixels().iter().map(|p| height(*p)).collect(),
            image => {
                let image = image.clone().into_rgba8();
                image.pixels().iter().map(|p| height(p.map(|v| f32::from(v) / 255.0))).collect()
            }
        };
        let (scale, offset) = options.uv_transform();
        let size = |side: u32| usize::try_from(side).unwrap_or(0);
        Self {
            width: size(image.width()),
            height: size(image.height()),
            values,
            scale,
            offset,
            is_clamped: options.clamp,
        }
    }

    /// The height at `uv`, v down; 0 where coordinates are not finite.
    pub(crate) fn at(&self, uv: [f32; 2]) -> f32 {
        let place = |axis: usize| f64::from(uv[axis]) * f64::from(self.scale[axis]) + f64::from(self.offset[axis]);
        let (u, v) = (place(0), place(1));
        if !(u.is_finite() && v.is_finite()) || self.values.is_empty() {
            return 0.0;
        }
        let ([left, right], x) = self.texels(u, self.width);
        let ([top, bottom], y) = self.texels(v, self.height);
        let row = |row: usize| {
            let (a, b) = (self.values[row * self.width + left], self.values[row * self.width + right]);
            a + x * (b - a)
        };
        let (above, below) = (row(top), row(bottom));
        above + y * (below - above)
    }

    /// The two texels around a coordinate, and how far it is from the first to the second.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_precision_loss,
        clippy::cast_sign_loss,
        reason = "in 0..count"
    )]
    fn texels(&self, coordinate: f64, count: usize) -> ([usize; 2], f32) {
        let whole = count as f64;
        let inside = if self.is_clamped { coordinate.clamp(0.0, 1.0) } else { coordinate - libm::floor(coordinate) };
        let place = inside * whole - 0.5;
        let below = libm::floor(place);
        let texel = |at: f64| {
            let at = if self.is_clamped { at.clamp(0.0, whole - 1.0) } else { at - libm::floor(at / whole) * whole };
            (at as usize).min(count - 1)
        };
        ([texel(below), texel(below + 1.0)], (place - below) as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_image::Rgba8Image;

    fn map(options: &TextureOptions) -> HeightMap {
        let grey = |v: u8| [v, v, v, 255];
        let image = Rgba8Image::from_pixels(2, 2, vec![grey(0), grey(255), grey(0), grey(255)]).unwrap();
        HeightMap::new(&DecodedImage::Rgba8(image), options)
    }

    #[test]
    fn texels_are_hit_in_their_middle_and_mixed_between() {
        let map = map(&TextureOptions::default());
        assert_eq!([map.at([0.25, 0.25]), map.at([0.75, 0.9]), map.at([0.5, 0.5])], [0.0, 1.0, 0.5]);
        // Over the edge the picture begins anew.
        assert_eq!([map.at([0.0, 0.3]), map.at([1.0, 0.3]), map.at([-3.25, 7.0])], [0.5, 0.5, 1.0]);
        assert_eq!(map.at([f32::NAN, 0.0]), 0.0);
    }

    #[test]
    fn options_of_the_map_apply() {
        let options = TextureOptions { clamp: true, gain: 2.0, base: -0.5, ..TextureOptions::default() };
        assert_eq!([map(&options).at([-1.0, 0.0]), map(&options).at([9.0, 0.5])], [-0.5, 1.5]);
    }
}
