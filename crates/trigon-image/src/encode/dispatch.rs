//! The one entry point of encoding: any image type, any format.

use std::borrow::Cow;

use super::EncodeOptions;
use crate::{EncodeError, Format, GrayF32Image, Rgba8Image, Rgba16Image, RgbaF32Image};

/// A borrowed image of any type; made by `From` from a reference to one.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum ImageRef<'a> {
    /// sRGB-encoded, straight alpha.
    Rgba8(&'a Rgba8Image),
    /// sRGB-encoded, straight alpha.
    Rgba16(&'a Rgba16Image),
    /// Linear, premultiplied alpha.
    RgbaF32(&'a RgbaF32Image),
    /// One channel without transfer function; formats of integers store it clamped to 0..=1.
    GrayF32(&'a GrayF32Image),
}

impl<'a> ImageRef<'a> {
    /// Width in pixels.
    #[must_use]
    pub fn width(self) -> u32 {
        match self {
            Self::Rgba8(image) => image.width(),
            Self::Rgba16(image) => image.width(),
            Self::RgbaF32(image) => image.width(),
            Self::GrayF32(image) => image.width(),
        }
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(self) -> u32 {
        match self {
            Self::Rgba8(image) => image.height(),
            Self::Rgba16(image) => image.height(),
            Self::RgbaF32(image) => image.height(),
            Self::GrayF32(image) => image.height(),
        }
    }

    /// The picture with 8 bits a channel; converted unless it has them.
    #[must_use]
    pub fn to_rgba8(self) -> Cow<'a, Rgba8Image> {
        match self {
            Self::Rgba8(image) => Cow::Borrowed(image),
            Self::Rgba16(image) => Cow::Owned(image.to_rgba8()),
            Self::RgbaF32(image) => Cow::Owned(image.to_srgb8()),
            Self::GrayF32(image) => Cow::Owned(image.to_rgba8()),
        }
    }
}

macro_rules! image_ref_from {
    ($($image:ident => $variant:ident),*) => { $(
        impl<'a> From<&'a $image> for ImageRef<'a> {
            fn from(image: &'a $image) -> Self {
                Self::$variant(image)
            }
        }
    )* };
}

image_ref_from!(Rgba8Image => Rgba8, Rgba16Image => Rgba16, RgbaF32Image => RgbaF32, GrayF32Image => GrayF32);

/// Encodes a picture as a file of `format`.
///
/// The image is converted to what the format holds: sRGB codes with straight alpha, linear `f32` with premultiplied
/// alpha for EXR. Formats without alpha (JPEG) show `options.background` through.
///
/// # Errors
/// [`EncodeError::Unsupported`] for a format this crate does not write ([`Format::is_writable`]) or a picture larger than
/// the format can say, [`EncodeError::Invalid`] for a picture without pixels.
pub fn encode<'a>(
    image: impl Into<ImageRef<'a>>,
    format: Format,
    options: &EncodeOptions,
) -> Result<Vec<u8>, EncodeError> {
    let image = image.into();
    if image.width() == 0 || image.height() == 0 {
        return Err(EncodeError::invalid(format, "the picture has no pixels"));
    }
    match format {
        Format::Png => super::png::encode(image, options),
        Format::Tga => super::tga::encode(&image.to_rgba8(), options),
        Format::Qoi => Ok(super::qoi::encode(&image.to_rgba8())),
        Format::Jpeg => super::jpeg::encode(&image.to_rgba8(), options),
        Format::Gif => super::gif::encode(&image.to_rgba8(), options),
        Format::Exr => super::exr::encode(image, options),
        _ => Err(EncodeError::unsupported(format, "this format is only read; write PNG, TGA, QOI, JPEG, GIF or EXR")),
    }
}
