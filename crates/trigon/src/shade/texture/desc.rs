//! What a texture is made from: size, format, meaning of alpha, mip chain; and what can be wrong with it.

use core::fmt;

/// The largest width or height of a texture.
pub const MAX_TEXTURE_SIZE: u32 = 32_768;

/// The texels of all levels together stay below this, so that an index fits 31 bits.
pub(super) const MAX_TEXELS: u64 = 1 << 31;

/// Size, format and treatment of the pixels that a texture is made from.
///
/// Make one with [`TextureDesc::new`] and change the fields that differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TextureDesc {
    /// Width and height in texels, 1 to [`MAX_TEXTURE_SIZE`] each.
    pub size: [u32; 2],
    /// Channels and encoding, of the input and in memory.
    pub format: TexelFormat,
    /// What the fourth channel means.
    pub alpha: Alpha,
    /// Which levels there are.
    pub mips: MipChain,
}

/// Channels, type and encoding of a texel.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum TexelFormat {
    /// Four bytes: red, green, blue sRGB-encoded, alpha linear. For colours.
    Rgba8Srgb,
    /// Four bytes, 255 is 1. For normals and other values that are not colours.
    Rgba8,
    /// One byte, 255 is 1; samples as (r, 0, 0, 1).
    R8,
    /// One float; samples as (r, 0, 0, 1).
    R32Float,
    /// Four floats, linear.
    Rgba32Float,
}

/// What the fourth channel of a texture means to its filters.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Alpha {
    /// Coverage, not yet multiplied into the colour (straight), as image files hold it.
    ///
    /// Filters weigh colours by alpha, so that what is transparent does not bleed, and samples come out premultiplied.
    Coverage,
    /// A value of its own: the four channels are filtered independently of each other.
    Independent,
}

/// Which levels a texture has.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum MipChain {
    /// The image alone.
    None,
    /// Down to 1x1: each size is half of the one above, rounded down but at least 1; each texel is the mean, in linear
    /// light, of exactly the area that it covers.
    Box,
}

impl TextureDesc {
    /// A full mip chain; alpha is coverage in sRGB images and an independent value in all others.
    #[must_use]
    pub fn new(size: [u32; 2], format: TexelFormat) -> Self {
        let alpha = if format == TexelFormat::Rgba8Srgb { Alpha::Coverage } else { Alpha::Independent };
        Self { size, format, alpha, mips: MipChain::Box }
    }

    /// The number of input values (bytes or floats) that the description asks for.
    #[must_use]
    pub fn values(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1]) * self.format.channels() as u64
    }
}

impl TexelFormat {
    /// Values per texel: 1 or 4.
    #[must_use]
    pub fn channels(self) -> usize {
        match self {
            Self::R8 | Self::R32Float => 1,
            Self::Rgba8Srgb | Self::Rgba8 | Self::Rgba32Float => 4,
        }
    }

    /// True if the values are floats, false if they are bytes.
    #[must_use]
    pub fn is_float(self) -> bool {
        matches!(self, Self::R32Float | Self::Rgba32Float)
    }
}

/// Why a texture cannot be made.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum TextureError {
    /// A side is zero.
    Empty {
        /// The size asked for.
        size: [u32; 2],
    },
    /// A side is above [`MAX_TEXTURE_SIZE`], or all levels together have 2^31 texels or more.
    TooLarge {
        /// The size asked for.
        size: [u32; 2],
    },
    /// The input does not have as many values as the description asks for.
    WrongLength {
        /// Values that size and format ask for.
        expected: u64,
        /// Values given.
        actual: u64,
    },
    /// Bytes were given for a float format, or floats for a byte format.
    WrongType {
        /// The format asked for.
        format: TexelFormat,
    },
}

impl fmt::Display for TextureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { size: [w, h] } => write!(f, "texture of {w} x {h} texels; both sides must be at least 1"),
            Self::TooLarge { size: [w, h] } => write!(
                f,
                "texture of {w} x {h} texels is too large; the limits are {MAX_TEXTURE_SIZE} a side and 2^31 texels with all mip levels"
            ),
            Self::WrongLength { expected, actual } => {
                write!(f, "texture input has {actual} values; its size and format ask for {expected}")
            }
            Self::WrongType { format } => {
                let (wanted, constructor) =
                    if format.is_float() { ("floats", "from_floats") } else { ("bytes", "from_bytes") };
                write!(f, "texture format {format:?} is made from {wanted}; call Texture::{constructor}")
            }
        }
    }
}

impl core::error::Error for TextureError {}
