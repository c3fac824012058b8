//! QOI files to pixels.
//!
//! Source: The Quite OK Image Format, version 1.0 (2022), qoiformat.org.

use super::DecodedImage;
use super::reader::Reader;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut reader = Reader::new(Format::Qoi, bytes);
    if reader.array("header")? != *b"qoif" {
        return Err(DecodeError::malformed(Format::Qoi, 0, "the file begins with \"qoif\""));
    }
    let width = reader.u32_be("header")?;
    let height = reader.u32_be("header")?;
    let [channels, _color_space] = reader.array("header")?;
    if width == 0 || height == 0 {
        return Err(DecodeError::malformed(Format::Qoi, 4, "width and height are at least 1"));
    }
    if !matches!(channels, 3 | 4) {
        return Err(DecodeError::malformed(Format::Qoi, 12, format!("there are 3 or 4 channels, not {channels}")));
    }
    let count = limits.check(width, height, 4)?;
    // A byte makes at most 62 pixels: a short file cannot claim a large picture.
    if reader.rest().len().saturating_mul(62) < count {
        return Err(reader.malformed(format!("the file is too short for {count} pixels, even if all were runs")));
    }
    let mut pixels = read_pixels(&mut reader, count)?;
    if channels == 3 {
        pixels.iter_mut().for_each(|pixel| pixel[3] = u8::MAX);
    }
    Rgba8Image::from_pixels(width, height, pixels)
        .map(DecodedImage::Rgba8)
        .map_err(|error| DecodeError::malformed_somewhere(Format::Qoi, error.to_string()))
}

fn read_pixels(reader: &mut Reader<'_>, count: usize) -> Result<Vec<[u8; 4]>, DecodeError> {
    let mut pixels = Vec::with_capacity(count);
    let mut seen = [[0_u8; 4]; 64];
    let mut pixel = [0, 0, 0, u8::MAX];
    while pixels.len() < count {
        let head = reader.u8("pixels")?;
        match (head >> 6, head & 0x3f) {
            // Literal colors first: their heads would else be runs.
            (0b11, 0x3e) => {
                let [r, g, b] = reader.array("pixels")?;
                pixel = [r, g, b, pixel[3]];
            }
            (0b11, 0x3f) => pixel = reader.array("pixels")?,
            (0b11, run) => {
                let length = usize::from(run) + 1;
                if length > count - pixels.len() {
                    return Err(reader.malformed("a run goes past the end of the picture"));
                }
                // All but the last; that one is pushed below.
                pixels.resize(pixels.len() + length - 1, pixel);
            }
            (0b00, index) => pixel = seen[usize::from(index)],
            // Differences to the previous pixel, modulo 256.
            (0b01, bits) => {
                let [r, g, b, a] = pixel;
                let step = |shift: u8| (bits >> shift & 3).wrapping_sub(2);
                pixel = [r.wrapping_add(step(4)), g.wrapping_add(step(2)), b.wrapping_add(step(0)), a];
            }
            (_, green) => {
                let second = reader.u8("pixels")?;
                let [r, g, b, a] = pixel;
                let green = green.wrapping_sub(32);
                let step = |bits: u8| green.wrapping_add((bits & 0xf).wrapping_sub(8));
                pixel = [r.wrapping_add(step(second >> 4)), g.wrapping_add(green), b.wrapping_add(step(second)), a];
            }
        }
        seen[hash(pixel)] = pixel;
        pixels.push(pixel);
    }
    Ok(pixels)
}

/// The place of a color among the 64 last seen.
pub(crate) fn hash([r, g, b, a]: [u8; 4]) -> usize {
    (usize::from(r) * 3 + usize::from(g) * 5 + usize::from(b) * 7 + usize::from(a) * 11) % 64
}
