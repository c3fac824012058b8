//! GIF files to pixels: the first frame, at its place on a transparent canvas of the size of the logical screen.

use std::io::Cursor;
use std::num::NonZeroU64;

use gif::{ColorOutput, DecodeOptions, DecodingError, MemoryLimit};

use super::DecodedImage;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    options.set_memory_limit(MemoryLimit::Bytes(NonZeroU64::new(limits.max_bytes).unwrap_or(NonZeroU64::MIN)));
    let mut decoder = options.read_info(Cursor::new(bytes)).map_err(convert_error)?;
    let screen = (u32::from(decoder.width()), u32::from(decoder.height()));
    limits.check(screen.0, screen.1, 4)?;

    let frame = decoder.next_frame_info().map_err(convert_error)?;
    let frame = frame.ok_or_else(|| DecodeError::malformed_somewhere(Format::Gif, "there is no frame"))?;
    let (left, top) = (u32::from(frame.left), u32::from(frame.top));
    let (width, height) = (u32::from(frame.width), u32::from(frame.height));
    let count = limits.check(width, height, 4)?;
    let mut samples = vec![0; count * 4];
    decoder.read_into_buffer(&mut samples).map_err(convert_error)?;

    // Some files leave the screen empty.
    let (screen_width, screen_height) =
        if screen.0 == 0 || screen.1 == 0 { (left + width, top + height) } else { screen };
    limits.check(screen_width, screen_height, 4)?;
    if screen_width == 0 || screen_height == 0 {
        return Err(DecodeError::malformed_somewhere(Format::Gif, "width and height are at least 1"));
    }
    let mut canvas = Rgba8Image::new(screen_width, screen_height);
    // The part of a frame that lies outside of the screen is not shown.
    let visible_width = width.min(screen_width.saturating_sub(left)) as usize;
    if visible_width > 0 {
        for (y, row) in (top..screen_height).zip(samples.as_chunks().0.chunks_exact(width as usize)) {
            canvas.row_mut(y)[left as usize..][..visible_width].copy_from_slice(&row[..visible_width]);
        }
    }
    Ok(DecodedImage::Rgba8(canvas))
}

fn convert_error(error: DecodingError) -> DecodeError {
    match error {
        DecodingError::MemoryLimit | DecodingError::OutOfMemory => {
            DecodeError::unsupported(Format::Gif, "a frame that needs more memory than Limits::max_bytes")
        }
        other => DecodeError::malformed_somewhere(Format::Gif, other.to_string()),
    }
}
