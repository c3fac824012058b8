//! Hashes of picture files: what the encoders write, and what the decoders read back from it, must be the same
//! everywhere too.

use crate::frames::hash_words;
use trigon_image::{EncodeOptions, Format, Limits, Rgba8Image, decode, encode};

/// Pairs of a name and a hash.
pub(super) fn hashes() -> Vec<(String, u64)> {
    let picture = gradients();
    let options = EncodeOptions::default();
    let formats = [Format::Png, Format::Tga, Format::Qoi, Format::Jpeg, Format::Gif, Format::Exr];
    let mut hashes = Vec::new();
    for format in formats {
        let bytes = encode(&picture, format, &options).expect("a picture that any format holds");
        let back = decode(&bytes, Some(format), &Limits::default()).expect("a file just written").into_rgba8();
        let name = format!("{format:?}").to_lowercase();
        hashes.push((format!("file/{name}-written"), hash_words(bytes.iter().map(|byte| u32::from(*byte)))));
        let pixels = back.pixels().iter().map(|pixel| u32::from_le_bytes(*pixel));
        hashes.push((format!("file/{name}-read"), hash_words(pixels)));
    }
    hashes
}

/// Smooth colours and a sharp edge.
fn gradients() -> Rgba8Image {
    let mut picture = Rgba8Image::new(61, 47);
    for y in 0..47_u8 {
        for x in 0..61_u8 {
            let alpha = if x > y { 255 } else { 5 * y };
            picture.set_pixel(x.into(), y.into(), [4 * x, 5 * y, x ^ y, alpha]);
        }
    }
    picture
}
