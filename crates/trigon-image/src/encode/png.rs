//! PNG files of 8 and 16 bits a channel, marked as sRGB; grey and opaque pictures take fewer channels.
//!
//! Fast by default: the row filter is fixed and the compressor (fdeflate) is made for filtered rows.

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, SrgbRenderingIntent};

use super::{Effort, EncodeOptions, ImageRef};
use crate::color::{unit_to_u8, unit_to_u16};
use crate::{EncodeError, Format, Rgba8Image, Rgba16Image};

pub(super) fn encode(image: ImageRef<'_>, options: &EncodeOptions) -> Result<Vec<u8>, EncodeError> {
    let samples = Samples::of(image, options.depth);
    write(image.width(), image.height(), &samples, options.effort)
}

/// The picture with four channels of 8 bits, opaque or not.
pub(super) fn encode_rgba8(image: &Rgba8Image, effort: Effort) -> Result<Vec<u8>, EncodeError> {
    let bytes = image.as_bytes().to_vec();
    let samples = Samples { color: ColorType::Rgba, depth: BitDepth::Eight, bytes, is_srgb: true };
    write(image.width(), image.height(), &samples, effort)
}

/// Interleaved samples as PNG stores them: 16-bit samples big-endian.
struct Samples {
    color: ColorType,
    depth: BitDepth,
    bytes: Vec<u8>,
    /// Whether the samples are colours; depth and masks carry no transfer function.
    is_srgb: bool,
}

impl Samples {
    fn of(image: ImageRef<'_>, depth: super::BitDepth) -> Self {
        use super::BitDepth::{Auto, Eight, Sixteen};
        match (image, depth) {
            (ImageRef::Rgba8(image), Auto | Eight) => Self::from_rgba8(image),
            (ImageRef::Rgba8(image), Sixteen) => Self::from_rgba16(&image.to_rgba16()),
            (ImageRef::Rgba16(image), Auto | Sixteen) => Self::from_rgba16(image),
            (ImageRef::Rgba16(image), Eight) => Self::from_rgba8(&image.to_rgba8()),
            (ImageRef::RgbaF32(image), Auto | Eight) => Self::from_rgba8(&image.to_srgb8()),
            (ImageRef::RgbaF32(image), Sixteen) => Self::from_rgba16(&image.to_srgb16()),
            (ImageRef::GrayF32(image), Eight) => {
                let bytes = image.pixels().iter().map(|&x| unit_to_u8(x)).collect();
                Self { color: ColorType::Grayscale, depth: BitDepth::Eight, bytes, is_srgb: false }
            }
            (ImageRef::GrayF32(image), Auto | Sixteen) => {
                let bytes = image.pixels().iter().flat_map(|&x| unit_to_u16(x).to_be_bytes()).collect();
                Self { color: ColorType::Grayscale, depth: BitDepth::Sixteen, bytes, is_srgb: false }
            }
        }
    }

    fn from_rgba8(image: &Rgba8Image) -> Self {
        let pixels = image.pixels();
        let (color, bytes) = if !image.is_opaque() {
            (ColorType::Rgba, image.as_bytes().to_vec())
        } else if is_gray(pixels) {
            (ColorType::Grayscale, pixels.iter().map(|p| p[0]).collect())
        } else {
            (ColorType::Rgb, pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect())
        };
        Self { color, depth: BitDepth::Eight, bytes, is_srgb: true }
    }

    fn from_rgba16(image: &Rgba16Image) -> Self {
        let pixels = image.pixels();
        let (color, channels) = match (image.is_opaque(), is_gray(pixels)) {
            (false, _) => (ColorType::Rgba, 4),
            (true, true) => (ColorType::Grayscale, 1),
            (true, false) => (ColorType::Rgb, 3),
        };
        let bytes = pixels.iter().flat_map(|p| p[..channels].iter().flat_map(|code| code.to_be_bytes())).collect();
        Self { color, depth: BitDepth::Sixteen, bytes, is_srgb: true }
    }
}

fn is_gray<T: PartialEq>(pixels: &[[T; 4]]) -> bool {
    pixels.iter().all(|[r, g, b, _]| r == g && g == b)
}

fn write(width: u32, height: u32, samples: &Samples, effort: Effort) -> Result<Vec<u8>, EncodeError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(samples.color);
    encoder.set_depth(samples.depth);
    encoder.set_compression(match effort {
        Effort::Fast => Compression::Fast,
        Effort::Balanced => Compression::Balanced,
        Effort::Best => Compression::High,
    });
    if samples.is_srgb {
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    let mut writer = encoder.write_header().map_err(convert_error)?;
    writer.write_image_data(&samples.bytes).map_err(convert_error)?;
    writer.finish().map_err(convert_error)?;
    Ok(bytes)
}

fn convert_error(error: EncodingError) -> EncodeError {
    match error {
        EncodingError::IoError(error) => EncodeError::Io(error),
        other => EncodeError::invalid(Format::Png, other.to_string()),
    }
}
