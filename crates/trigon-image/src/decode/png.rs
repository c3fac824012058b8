//! PNG files to pixels: all colour types and depths, interlaced or not; 16 bits stay 16 bits.
//!
//! Expansion of palettes, low depths and transparent colours is the `png` crate's; here rows become RGBA.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, DecodingError, Transformations};

use super::DecodedImage;
use crate::{DecodeError, Format, Limits, Rgba8Image, Rgba16Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    // The crate's own limit covers its working memory: one row and the metadata chunks.
    let working_bytes = usize::try_from(limits.max_bytes).unwrap_or(usize::MAX);
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: working_bytes });
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);

    let header = decoder.read_header_info().map_err(convert_error)?;
    let (width, height) = (header.width, header.height);
    let is_16_bit = header.bit_depth == BitDepth::Sixteen;
    let count = limits.check(width, height, if is_16_bit { 8 } else { 4 })?;

    let mut reader = decoder.read_info().map_err(convert_error)?;
    let (color, _) = reader.output_color_type();
    let channels = color.samples();
    let mut samples = vec![0; count * channels * if is_16_bit { 2 } else { 1 }];
    reader.next_frame(&mut samples).map_err(convert_error)?;

    let wrong_size = |error: crate::SizeMismatch| DecodeError::malformed_somewhere(Format::Png, error.to_string());
    if is_16_bit {
        let codes: Vec<u16> = samples.as_chunks().0.iter().map(|&pair| u16::from_be_bytes(pair)).collect();
        let pixels = to_rgba(&codes, color, u16::MAX);
        Rgba16Image::from_pixels(width, height, pixels).map(DecodedImage::Rgba16).map_err(wrong_size)
    } else {
        let pixels = to_rgba(&samples, color, u8::MAX);
        Rgba8Image::from_pixels(width, height, pixels).map(DecodedImage::Rgba8).map_err(wrong_size)
    }
}

/// Interleaved samples to RGBA; `opaque` is the alpha of pixels that have none.
fn to_rgba<T: Copy>(samples: &[T], color: ColorType, opaque: T) -> Vec<[T; 4]> {
    match color {
        ColorType::Grayscale => samples.iter().map(|&v| [v, v, v, opaque]).collect(),
        ColorType::GrayscaleAlpha => samples.as_chunks().0.iter().map(|&[v, a]| [v, v, v, a]).collect(),
        // The expansion leaves no palette.
        ColorType::Rgb | ColorType::Indexed => {
            samples.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, opaque]).collect()
        }
        ColorType::Rgba => samples.as_chunks().0.to_vec(),
    }
}

fn convert_error(error: DecodingError) -> DecodeError {
    match error {
        DecodingError::LimitsExceeded => {
            DecodeError::unsupported(Format::Png, "chunks that need more memory than Limits::max_bytes")
        }
        // The file is in memory, so the only failure of reading is its end.
        DecodingError::IoError(error) => {
            DecodeError::malformed_somewhere(Format::Png, format!("the file ends too early ({error})"))
        }
        other => DecodeError::malformed_somewhere(Format::Png, other.to_string()),
    }
}
