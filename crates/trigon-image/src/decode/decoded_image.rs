//! What a decoder gives: the file's own precision, in one of three image types.

use crate::{Rgba8Image, Rgba16Image, RgbaF32Image};

/// A decoded picture in the precision of its file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum DecodedImage {
    /// Up to 8 bits a channel: sRGB-encoded, straight alpha.
    Rgba8(Rgba8Image),
    /// 16 bits a channel (PNG, TIFF): sRGB-encoded, straight alpha. Kept, because height and normal maps need the bits.
    Rgba16(Rgba16Image),
    /// Floating point (HDR, EXR, TIFF): linear light, premultiplied alpha.
    RgbaF32(RgbaF32Image),
}

impl DecodedImage {
    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        match self {
            Self::Rgba8(image) => image.width(),
            Self::Rgba16(image) => image.width(),
            Self::RgbaF32(image) => image.width(),
        }
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        match self {
            Self::Rgba8(image) => image.height(),
            Self::Rgba16(image) => image.height(),
            Self::RgbaF32(image) => image.height(),
        }
    }

    /// Whether no pixel is translucent.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        match self {
            Self::Rgba8(image) => image.is_opaque(),
            Self::Rgba16(image) => image.is_opaque(),
            Self::RgbaF32(image) => image.is_opaque(),
        }
    }

    /// Eight bits a channel, sRGB-encoded, straight alpha; float colour is clamped to 0..=1.
    #[must_use]
    pub fn into_rgba8(self) -> Rgba8Image {
        match self {
            Self::Rgba8(image) => image,
            Self::Rgba16(image) => image.to_rgba8(),
            Self::RgbaF32(image) => image.to_srgb8(),
        }
    }

    /// Linear light, premultiplied alpha.
    #[must_use]
    pub fn into_linear(self) -> RgbaF32Image {
        match self {
            Self::Rgba8(image) => image.to_linear(),
            Self::Rgba16(image) => image.to_linear(),
            Self::RgbaF32(image) => image,
        }
    }
}
