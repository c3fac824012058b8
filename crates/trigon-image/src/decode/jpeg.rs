//! JPEG files to pixels: baseline and progressive; grey, YCbCr, RGB, CMYK and YCCK.
//!
//! The `zune-jpeg` crate decodes, without its SIMD code, so that the bytes are those of its integer scalar code on every
//! machine. It fills what a truncated file lacks with grey; here such a file is an error.

use std::io::Cursor;

use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;

use super::DecodedImage;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    require_end_marker(bytes)?;
    let options = DecoderOptions::default()
        .set_use_unsafe(false)
        .set_max_width(limits.max_width as usize)
        .set_max_height(limits.max_height as usize)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(|error| convert_error(&error, limits))?;
    let Some((width, height)) = decoder.dimensions() else {
        return Err(DecodeError::malformed_somewhere(Format::Jpeg, "there is no frame header"));
    };
    // A JPEG side has 16 bits.
    let (width, height) = (u32::try_from(width).unwrap_or(u32::MAX), u32::try_from(height).unwrap_or(u32::MAX));
    limits.check(width, height, 4)?;

    let samples = decoder.decode().map_err(|error| convert_error(&error, limits))?;
    let (pixels, rest) = samples.as_chunks();
    if !rest.is_empty() {
        return Err(DecodeError::unsupported(Format::Jpeg, "its number of components"));
    }
    let pixels = pixels.iter().map(|&[r, g, b]| [r, g, b, u8::MAX]).collect();
    Rgba8Image::from_pixels(width, height, pixels)
        .map(DecodedImage::Rgba8)
        .map_err(|_| DecodeError::unsupported(Format::Jpeg, "its number of components"))
}

const MARKER: u8 = 0xff;
const START_OF_SCAN: u8 = 0xda;
const END_OF_IMAGE: u8 = 0xd9;

/// Fails if no end-of-image marker follows the first scan's header: then the file was cut off.
///
/// Only after that header: a thumbnail in the metadata has such a marker too.
fn require_end_marker(bytes: &[u8]) -> Result<(), DecodeError> {
    let cut_off = || DecodeError::malformed(Format::Jpeg, bytes.len(), "the file ends before the end-of-image marker");
    // Over the segments: marker, length, content.
    let mut offset = 2;
    loop {
        let rest = bytes.get(offset..).ok_or_else(cut_off)?;
        match *rest {
            [MARKER, START_OF_SCAN, ..] => break,
            // Fill bytes before a marker, and markers without content.
            [MARKER, MARKER, ..] => offset += 1,
            [MARKER, 0x01 | 0xd0..=0xd8, ..] => offset += 2,
            [MARKER, _, high, low, ..] => offset += 2 + usize::from(u16::from_be_bytes([high, low])),
            // Bytes between segments are against the rules, but decoders pass over them.
            [_, _, ..] => offset += 1,
            _ => return Err(cut_off()),
        }
    }
    let scans = &bytes[offset..];
    if scans.windows(2).rev().any(|pair| pair == [MARKER, END_OF_IMAGE]) { Ok(()) } else { Err(cut_off()) }
}

fn convert_error(error: &DecodeErrors, limits: &Limits) -> DecodeError {
    match error {
        DecodeErrors::Unsupported(scheme) => DecodeError::unsupported(Format::Jpeg, format!("{scheme:?}")),
        DecodeErrors::LargeDimensions(side) => DecodeError::LimitExceeded {
            limit: "max_width or max_height",
            asked: *side as u64,
            allowed: u64::from(limits.max_width.min(limits.max_height)),
        },
        other => DecodeError::malformed_somewhere(Format::Jpeg, other.to_string()),
    }
}
