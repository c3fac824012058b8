//! Baseline JPEG files; grey pictures with one component. The `jpeg-encoder` crate computes in integers.

use jpeg_encoder::{ColorType, Encoder, EncodingError};

use super::EncodeOptions;
use crate::{EncodeError, Format, Rgba8Image};

pub(super) fn encode(image: &Rgba8Image, options: &EncodeOptions) -> Result<Vec<u8>, EncodeError> {
    let (Ok(width), Ok(height)) = (u16::try_from(image.width()), u16::try_from(image.height())) else {
        return Err(EncodeError::unsupported(Format::Jpeg, "pictures are at most 65535 pixels wide and high"));
    };
    let composed;
    let image = if image.is_opaque() {
        image
    } else {
        composed = image.over(options.background);
        &composed
    };
    let mut file = Vec::new();
    let encoder = Encoder::new(&mut file, options.jpeg_quality.clamp(1, 100));
    let is_gray = image.pixels().iter().all(|[r, g, b, _]| r == g && g == b);
    let result = if is_gray {
        let samples: Vec<u8> = image.pixels().iter().map(|pixel| pixel[0]).collect();
        encoder.encode(&samples, width, height, ColorType::Luma)
    } else {
        encoder.encode(image.as_bytes(), width, height, ColorType::Rgba)
    };
    match result {
        Ok(()) => Ok(file),
        Err(EncodingError::IoError(error)) => Err(EncodeError::Io(error)),
        Err(other) => Err(EncodeError::invalid(Format::Jpeg, other.to_string())),
    }
}
