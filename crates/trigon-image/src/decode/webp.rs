//! WebP files to pixels: lossy and lossless, with alpha; of an animation the first frame.
//!
//! The `image-webp` crate decodes, in integers. It takes memory for the size that each bitstream inside the container
//! claims, so those sizes are checked here first.

use std::io::Cursor;

use image_webp::{DecodingError, WebPDecoder};

use super::DecodedImage;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    check_bitstreams(bytes.get(12..).unwrap_or_default(), limits)?;
    let mut decoder = WebPDecoder::new(Cursor::new(bytes)).map_err(convert_error)?;
    decoder.set_memory_limit(usize::try_from(limits.max_bytes).unwrap_or(usize::MAX));
    let (width, height) = decoder.dimensions();
    let count = limits.check(width, height, 4)?;
    let has_alpha = decoder.has_alpha();
    let mut samples = vec![0; count * if has_alpha { 4 } else { 3 }];
    decoder.read_image(&mut samples).map_err(convert_error)?;
    let pixels = if has_alpha {
        samples.as_chunks().0.to_vec()
    } else {
        samples.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, u8::MAX]).collect()
    };
    Rgba8Image::from_pixels(width, height, pixels)
        .map(DecodedImage::Rgba8)
        .map_err(|error| DecodeError::malformed_somewhere(Format::WebP, error.to_string()))
}

/// Bytes of an animation frame's own header, before its chunks.
const FRAME_HEADER: usize = 16;

/// Checks the size in the header of every VP8 and VP8L bitstream among the RIFF chunks, animation frames included.
///
/// Chunks that are cut off are left for the decoder to report.
fn check_bitstreams(mut chunks: &[u8], limits: &Limits) -> Result<(), DecodeError> {
    while let Some((head, rest)) = chunks.split_first_chunk::<8>() {
        let [name @ .., l0, l1, l2, l3] = *head;
        let length = u32::from_le_bytes([l0, l1, l2, l3]) as usize;
        let content = &rest[..length.min(rest.len())];
        match &name {
            b"VP8 " => {
                if let Some(&[w0, w1, h0, h1]) = content.get(6..10) {
                    let side = |low, high| u32::from(u16::from_le_bytes([low, high]) & 0x3fff);
                    limits.check(side(w0, w1), side(h0, h1), 4)?;
                }
            }
            b"VP8L" => {
                if let Some(&[b0, b1, b2, b3]) = content.get(1..5) {
                    let bits = u32::from_le_bytes([b0, b1, b2, b3]);
                    limits.check((bits & 0x3fff) + 1, (bits >> 14 & 0x3fff) + 1, 4)?;
                }
            }
            b"ANMF" => check_bitstreams(content.get(FRAME_HEADER..).unwrap_or_default(), limits)?,
            _ => {}
        }
        // Chunks are padded to an even length.
        chunks = rest.get(length.saturating_add(length % 2)..).unwrap_or_default();
    }
    Ok(())
}

fn convert_error(error: DecodingError) -> DecodeError {
    match error {
        DecodingError::MemoryLimitExceeded => {
            DecodeError::unsupported(Format::WebP, "chunks that need more memory than Limits::max_bytes")
        }
        other => DecodeError::malformed_somewhere(Format::WebP, other.to_string()),
    }
}
