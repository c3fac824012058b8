//! Whole images from one encoding to another: sRGB codes with straight alpha, and linear `f32` with premultiplied alpha.

use super::unpremultiply;
use super::{linear_to_srgb, linear_to_srgb16, premultiply, srgb_to_linear, srgb16_to_linear, unit_to_u8, unit_to_u16};
use crate::{GrayF32Image, Rgba8Image, Rgba16Image, RgbaF32Image};

/// Builds an image of the same size, pixel by pixel.
macro_rules! map_pixels {
    ($image:expr, $to:ident, $convert:expr) => {{
        let image = $image;
        let pixels = image.pixels().iter().map($convert).collect();
        $to::from_pixels(image.width(), image.height(), pixels).expect("as many pixels as before")
    }};
}

impl Rgba8Image {
    /// Decodes sRGB and premultiplies.
    #[must_use]
    pub fn to_linear(&self) -> RgbaF32Image {
        map_pixels!(self, RgbaF32Image, |&[r, g, b, a]| {
            premultiply([srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b), f32::from(a) / 255.0])
        })
    }

    /// The same picture with 16 bits a channel, exactly: each code times 257.
    #[must_use]
    pub fn to_rgba16(&self) -> Rgba16Image {
        map_pixels!(self, Rgba16Image, |pixel| pixel.map(|code| u16::from(code) * 257))
    }

    /// The picture over an opaque background, composed in linear light.
    #[must_use]
    pub fn over(&self, background: super::Color) -> Self {
        let behind = background.to_linear();
        map_pixels!(self, Self, |&[r, g, b, a]| {
            if a == u8::MAX {
                return [r, g, b, a];
            }
            let alpha = f32::from(a) / 255.0;
            let mix = |front: u8, back: f32| linear_to_srgb(srgb_to_linear(front) * alpha + back * (1.0 - alpha));
            [mix(r, behind[0]), mix(g, behind[1]), mix(b, behind[2]), u8::MAX]
        })
    }
}

impl Rgba16Image {
    /// Decodes sRGB and premultiplies.
    #[must_use]
    pub fn to_linear(&self) -> RgbaF32Image {
        map_pixels!(self, RgbaF32Image, |&[r, g, b, a]| {
            premultiply([srgb16_to_linear(r), srgb16_to_linear(g), srgb16_to_linear(b), f32::from(a) / 65535.0])
        })
    }

    /// Rounds each code to the nearest of 8 bits.
    #[must_use]
    pub fn to_rgba8(&self) -> Rgba8Image {
        map_pixels!(self, Rgba8Image, |pixel| pixel.map(u16_to_u8))
    }
}

impl RgbaF32Image {
    /// Undoes the premultiplication, clamps to 0..=1 and encodes with 8 bits.
    #[must_use]
    pub fn to_srgb8(&self) -> Rgba8Image {
        map_pixels!(self, Rgba8Image, |&pixel| {
            let [r, g, b, a] = unpremultiply(pixel);
            [linear_to_srgb(r), linear_to_srgb(g), linear_to_srgb(b), unit_to_u8(a)]
        })
    }

    /// Undoes the premultiplication, clamps to 0..=1 and encodes with 16 bits.
    #[must_use]
    pub fn to_srgb16(&self) -> Rgba16Image {
        map_pixels!(self, Rgba16Image, |&pixel| {
            let [r, g, b, a] = unpremultiply(pixel);
            [linear_to_srgb16(r), linear_to_srgb16(g), linear_to_srgb16(b), unit_to_u16(a)]
        })
    }
}

impl GrayF32Image {
    /// Opaque grey with 8 bits, clamped to 0..=1, with no transfer function: 0.5 becomes 128.
    #[must_use]
    pub fn to_rgba8(&self) -> Rgba8Image {
        map_pixels!(self, Rgba8Image, |&x| {
            let code = unit_to_u8(x);
            [code, code, code, u8::MAX]
        })
    }
}

/// The nearest 8-bit code: 65535 = 255 * 257, and 257 is odd, so there is no tie.
#[expect(clippy::cast_possible_truncation, reason = "(65535 + 128) / 257 is 255")]
pub(crate) fn u16_to_u8(code: u16) -> u8 {
    ((u32::from(code) + 128) / 257) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Color;

    #[test]
    fn opaque_codes_survive_linear_light() {
        let pixels = (0..=u8::MAX).map(|i| [i, 255 - i, i / 2, 255]).collect();
        let image = Rgba8Image::from_pixels(16, 16, pixels).unwrap();
        assert_eq!(image.to_linear().to_srgb8(), image);
        assert_eq!(image.to_linear().to_srgb16(), image.to_rgba16());
        assert_eq!(image.to_rgba16().to_rgba8(), image);
        assert_eq!(image.to_rgba16().to_linear(), image.to_linear());
    }

    #[test]
    fn translucent_codes_survive_linear_light() {
        let pixels = (0..=u8::MAX).map(|i| [i, 77, 200, i.max(1)]).collect();
        let image = Rgba8Image::from_pixels(256, 1, pixels).unwrap();
        assert_eq!(image.to_linear().to_srgb8(), image);
    }

    #[test]
    fn composing_is_in_linear_light() {
        let half_white = Rgba8Image::filled(1, 1, [255, 255, 255, 128]);
        let [r, ..] = half_white.over(Color::BLACK).pixel(0, 0);
        assert_eq!(r, linear_to_srgb(128.0 / 255.0));
        assert_eq!(Rgba8Image::new(1, 1).over(Color::WHITE).pixel(0, 0), [255; 4]);
    }

    #[test]
    fn depth_has_no_transfer_function() {
        let depth = GrayF32Image::from_pixels(4, 1, vec![0.5, -1.0, 2.0, f32::NAN]).unwrap();
        assert_eq!(depth.to_rgba8().row(0).iter().map(|p| p[0]).collect::<Vec<_>>(), [128, 0, 255, 0]);
    }
}
