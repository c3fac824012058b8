//! The one entry point of decoding: finds the format and calls its decoder.

use super::DecodedImage;
use crate::{DecodeError, Format, Limits};

/// Decodes a picture file.
///
/// The format is found by content first ([`Format::sniff`]); `hint`, usually the format of the file's extension, decides
/// only where the content has no magic number (TGA) or a broken one.
///
/// Of an animation the first frame is decoded, of a file with several pictures the first. Rows come out top first,
/// whatever their order in the file; grey and palettes become red, green, blue, alpha. Colour profiles and gamma chunks
/// are ignored.
///
/// # Errors
/// [`DecodeError::Malformed`] for a broken or truncated file, [`DecodeError::Unsupported`] for a feature or format this
/// crate does not read, [`DecodeError::LimitExceeded`] for a picture larger than `limits`.
pub fn decode(bytes: &[u8], hint: Option<Format>, limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let Some(format) = Format::sniff(bytes).or(hint) else {
        return Err(DecodeError::Unsupported { format: None, feature: unrecognized(bytes).into() });
    };
    match format {
        Format::Png => super::png::decode(bytes, limits),
        Format::Jpeg => super::jpeg::decode(bytes, limits),
        Format::Tga => super::tga::decode(bytes, limits),
        Format::Bmp => super::bmp::decode(bytes, limits),
        Format::Tiff => super::tiff::decode(bytes, limits),
        Format::WebP => super::webp::decode(bytes, limits),
        Format::Hdr => super::hdr::decode(bytes, limits),
        Format::Gif => super::gif::decode(bytes, limits),
        Format::Qoi => super::qoi::decode(bytes, limits),
        Format::Exr => super::exr::decode(bytes, limits),
    }
}

/// What to say of a file of no known format.
fn unrecognized(bytes: &[u8]) -> &'static str {
    if bytes.is_empty() {
        "the file is empty"
    } else {
        "the content is none of PNG, JPEG, BMP, TIFF, WebP, HDR, GIF, QOI, EXR (a TGA file needs its extension)"
    }
}
