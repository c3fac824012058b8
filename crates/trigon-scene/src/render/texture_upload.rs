//! From a decoded picture to a sampler's texture, for one use of it.
//!
//! In: a picture and what a material map reads from it. Out: a [`Texture`](trigon::shade::texture::Texture) with its mip
//! chain, and how its opacity is distributed. Colours are sRGB-encoded; normals and scalars are numbers as stored, and
//! keep the precision of 16-bit and float files.

use super::working_space::from_linear_premultiplied;
use crate::scene::ScalarSource;
use trigon::shade::texture::{Alpha, MipChain, TexelFormat, Texture, TextureDesc, TextureError};
use trigon::target::ColorSpace;
use trigon_image::DecodedImage;

/// What a material map reads from a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Usage {
    /// A colour and its opacity.
    Color(ColorSpace),
    /// A colour; the fourth channel is ignored.
    OpaqueColor(ColorSpace),
    /// Three numbers: a normal.
    Vector,
    /// One number.
    Scalar(ScalarSource),
    /// Heights, as luminance; or normals, if the picture looks like a normal map.
    Height,
}

/// Which opacities a picture holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Opacity {
    /// Only 1.
    Opaque,
    /// 0 and 1, with few values between at the edges.
    Binary,
    /// Values between, too.
    Partial,
}

impl Opacity {
    /// Values between 0 and 1 are those of edges, not of translucent areas, up to this share: one in eight.
    const EDGE_SHARE: usize = 8;

    fn of(values: impl Iterator<Item = u8>) -> Self {
        let (mut count, mut below_one, mut between) = (0usize, 0usize, 0usize);
        for value in values {
            count += 1;
            below_one += usize::from(value != u8::MAX);
            between += usize::from((16..240).contains(&value));
        }
        if below_one == 0 {
            Self::Opaque
        } else if between <= count / Self::EDGE_SHARE {
            Self::Binary
        } else {
            Self::Partial
        }
    }
}

/// A texture, and the opacities that it holds: those of its alpha channel, or of its numbers.
pub(super) struct Uploaded {
    pub(super) texture: Texture,
    pub(super) opacity: Opacity,
    /// It was asked for as heights, but holds normals.
    pub(super) holds_normals: bool,
}

impl Uploaded {
    fn new(texture: Texture, opacity: Opacity) -> Self {
        Self { texture, opacity, holds_normals: false }
    }
}

/// Makes the texture for one use of `image`.
pub(super) fn upload(image: &DecodedImage, usage: Usage) -> Result<Uploaded, TextureError> {
    let size = [image.width(), image.height()];
    match usage {
        Usage::Color(space) => color(image, size, space, true),
        Usage::OpaqueColor(space) => color(image, size, space, false),
        Usage::Vector => vector(image, size),
        Usage::Scalar(source) => scalar(image, size, source),
        Usage::Height if looks_like_normals(image) => Ok(Uploaded { holds_normals: true, ..vector(image, size)? }),
        Usage::Height => scalar(image, size, ScalarSource::Luminance),
    }
}

fn color(image: &DecodedImage, size: [u32; 2], space: ColorSpace, has_alpha: bool) -> Result<Uploaded, TextureError> {
    if let DecodedImage::RgbaF32(linear) = image {
        // Premultiplied already, so the channels are filtered as they are.
        let desc = TextureDesc { alpha: Alpha::Independent, ..TextureDesc::new(size, TexelFormat::Rgba32Float) };
        let mut pixels: Vec<[f32; 4]> =
            linear.pixels().iter().map(|pixel| from_linear_premultiplied(space, *pixel)).collect();
        let opacity = if has_alpha { Opacity::of(pixels.iter().map(|p| unit_to_byte(p[3]))) } else { Opacity::Opaque };
        if !has_alpha {
            pixels.iter_mut().for_each(|p| p[3] = 1.0);
        }
        return Ok(Uploaded::new(Texture::from_floats(&desc, pixels.as_flattened())?, opacity));
    }
    let bytes = image.clone().into_rgba8();
    let format = match space {
        ColorSpace::Linear => TexelFormat::Rgba8Srgb,
        ColorSpace::Encoded => TexelFormat::Rgba8,
    };
    let desc = TextureDesc { alpha: Alpha::Coverage, ..TextureDesc::new(size, format) };
    // An alpha channel that is zero everywhere was never meant as opacity.
    if has_alpha && bytes.pixels().iter().any(|p| p[3] != 0) {
        let opacity = Opacity::of(bytes.pixels().iter().map(|p| p[3]));
        return Ok(Uploaded::new(Texture::from_bytes(&desc, bytes.as_bytes())?, opacity));
    }
    let mut pixels = bytes.into_pixels();
    pixels.iter_mut().for_each(|p| p[3] = u8::MAX);
    Ok(Uploaded::new(Texture::from_bytes(&desc, pixels.as_flattened())?, Opacity::Opaque))
}

fn vector(image: &DecodedImage, size: [u32; 2]) -> Result<Uploaded, TextureError> {
    let texture = match image {
        DecodedImage::Rgba8(image) => {
            Texture::from_bytes(&TextureDesc::new(size, TexelFormat::Rgba8), image.as_bytes())?
        }
        DecodedImage::Rgba16(image) => {
            let values: Vec<f32> = image.pixels().as_flattened().iter().map(|v| word_to_unit(*v)).collect();
            Texture::from_floats(&TextureDesc::new(size, TexelFormat::Rgba32Float), &values)?
        }
        DecodedImage::RgbaF32(image) => {
            Texture::from_floats(&TextureDesc::new(size, TexelFormat::Rgba32Float), image.pixels().as_flattened())?
        }
        _ => {
            let image = image.clone().into_rgba8();
            Texture::from_bytes(&TextureDesc::new(size, TexelFormat::Rgba8), image.as_bytes())?
        }
    };
    Ok(Uploaded::new(texture, Opacity::Opaque))
}

fn scalar(image: &DecodedImage, size: [u32; 2], source: ScalarSource) -> Result<Uploaded, TextureError> {
    let source = match source {
        ScalarSource::AlphaOrLuminance if image.is_opaque() => ScalarSource::Luminance,
        ScalarSource::AlphaOrLuminance => ScalarSource::Alpha,
        source => source,
    };
    let desc = |format| TextureDesc { size, format, alpha: Alpha::Independent, mips: MipChain::Box };
    let floats = |values: Vec<f32>| {
        let opacity = Opacity::of(values.iter().map(|v| unit_to_byte(*v)));
        let texture = Texture::from_floats(&desc(TexelFormat::R32Float), &values)?;
        Ok(Uploaded::new(texture, opacity))
    };
    match image {
        DecodedImage::Rgba16(image) => floats(image.pixels().iter().map(|p| source.of(p.map(word_to_unit))).collect()),
        DecodedImage::RgbaF32(image) => floats(image.pixels().iter().map(|p| source.of(*p)).collect()),
        image => {
            let image = image.clone().into_rgba8();
            let bytes: Vec<u8> =
                image.pixels().iter().map(|p| unit_to_byte(source.of(p.map(|v| f32::from(v) / 255.0)))).collect();
            let opacity = Opacity::of(bytes.iter().copied());
            Ok(Uploaded::new(Texture::from_bytes(&desc(TexelFormat::R8), &bytes)?, opacity))
        }
    }
}

/// Whether nearly all pixels are unit vectors that point out of the surface, and the picture is blue on the whole.
fn looks_like_normals(image: &DecodedImage) -> bool {
    let image = image.clone().into_rgba8();
    let (mut n_unit, mut sum) = (0usize, [0.0f64; 3]);
    for &[r, g, b, _] in image.pixels() {
        let n = [r, g, b].map(|code| (f64::from(code) - 128.0) / 127.0);
        let length_squared = (n[0] * n[0] + n[1] * n[1]) + n[2] * n[2];
        n_unit += usize::from(n[2] > 0.0 && (0.6..1.4).contains(&length_squared));
        sum = [sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]];
    }
    let count = image.pixels().len();
    #[expect(clippy::cast_precision_loss, reason = "a threshold")]
    let is_blue = sum[2] - sum[0].max(sum[1]) > 0.4 * count as f64;
    is_blue && n_unit >= count - count / 10
}

fn word_to_unit(value: u16) -> f32 {
    f32::from(value) / 65535.0
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped into range")]
fn unit_to_byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_image::Rgba8Image;

    #[test]
    fn opacity_of_leaves_glass_and_walls() {
        let of = |values: &[u8]| Opacity::of(values.iter().copied());
        assert_eq!(of(&[255; 64]), Opacity::Opaque);
        let mut leaf = [255; 64];
        leaf[..20].fill(0);
        leaf[20..24].fill(128);
        assert_eq!(of(&leaf), Opacity::Binary);
        assert_eq!(of(&[128; 64]), Opacity::Partial);
    }

    #[test]
    fn scalars_read_the_channel_that_is_asked_for() {
        let image = DecodedImage::Rgba8(Rgba8Image::filled(2, 1, [10, 20, 30, 40]));
        let value = |source| upload(&image, Usage::Scalar(source)).unwrap().texture.texel(0, 0, 0).unwrap()[0] * 255.0;
        for (source, want) in [
            (ScalarSource::Red, 10.0),
            (ScalarSource::Green, 20.0),
            (ScalarSource::Blue, 30.0),
            (ScalarSource::Alpha, 40.0),
            (ScalarSource::AlphaOrLuminance, 40.0),
            (ScalarSource::Luminance, 19.0),
        ] {
            assert!((value(source) - want).abs() < 1e-3, "{source:?} gives {}", value(source));
        }
    }
}
