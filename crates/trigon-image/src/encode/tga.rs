//! TGA files of version 2.0: 24 bits for opaque pictures, else 32, from the top-left corner, in run-length packets.
//!
//! Source: Truevision TGA File Format Specification, version 2.0 (1991), appendix C.

use super::EncodeOptions;
use crate::format::TGA_SIGNATURE;
use crate::{EncodeError, Format, Rgba8Image};

/// Pixels in the longest packet.
const LONGEST_PACKET: usize = 128;

pub(super) fn encode(image: &Rgba8Image, options: &EncodeOptions) -> Result<Vec<u8>, EncodeError> {
    let (Ok(width), Ok(height)) = (u16::try_from(image.width()), u16::try_from(image.height())) else {
        return Err(EncodeError::unsupported(Format::Tga, "pictures are at most 65535 pixels wide and high"));
    };
    let has_alpha = !image.is_opaque();
    let image_type = if options.tga_run_length { 10 } else { 2 };
    let (pixel_bytes, descriptor) = if has_alpha { (4, 0x28) } else { (3, 0x20) };

    let mut file = vec![0, 0, image_type, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    file.extend(width.to_le_bytes());
    file.extend(height.to_le_bytes());
    file.extend([pixel_bytes * 8, descriptor]);
    for row in image.rows() {
        if options.tga_run_length {
            append_packets(row, usize::from(pixel_bytes), &mut file);
        } else {
            append_pixels(row, usize::from(pixel_bytes), &mut file);
        }
    }
    // The footer: no extension area, no developer area, and the signature.
    file.extend([0; 8]);
    file.extend(TGA_SIGNATURE);
    Ok(file)
}

/// One row as packets: runs of 2 and more equal pixels, and stretches of unequal ones between them.
fn append_packets(row: &[[u8; 4]], pixel_bytes: usize, file: &mut Vec<u8>) {
    let mut rest = row;
    while let Some(first) = rest.first() {
        let run = rest.iter().take(LONGEST_PACKET).take_while(|pixel| *pixel == first).count();
        let length = if run >= 2 { run } else { length_until_run(rest) };
        let (packet, after) = rest.split_at(length);
        let count_less_1 = u8::try_from(length - 1).expect("a packet has at most 128 pixels");
        if run >= 2 {
            file.push(0x80 | count_less_1);
            append_pixels(&packet[..1], pixel_bytes, file);
        } else {
            file.push(count_less_1);
            append_pixels(packet, pixel_bytes, file);
        }
        rest = after;
    }
}

/// The number of pixels before the next two equal ones, at most a packet.
fn length_until_run(pixels: &[[u8; 4]]) -> usize {
    let longest = pixels.len().min(LONGEST_PACKET);
    (1..longest).find(|&i| pixels.get(i + 1) == Some(&pixels[i])).unwrap_or(longest)
}

/// Blue, green, red, and alpha if there is room.
fn append_pixels(pixels: &[[u8; 4]], pixel_bytes: usize, file: &mut Vec<u8>) {
    for &[r, g, b, a] in pixels {
        file.extend_from_slice(&[b, g, r, a][..pixel_bytes]);
    }
}
