//! Procedural textures: a checkerboard of two colours under grainy noise, all from integer hashes of a seed.

use trigon::shade::texture::{TexelFormat, Texture, TextureDesc, TextureError};

/// A square texture of `size` texels a side, sRGB-encoded, opaque, with its mip chain.
///
/// # Errors
/// The size is zero or too large.
pub(super) fn texture(size: u32, seed: u32) -> Result<Texture, TextureError> {
    let bytes: Vec<u8> = (0..size).flat_map(|y| (0..size).flat_map(move |x| texel(size, seed, x, y))).collect();
    Texture::from_bytes(&TextureDesc::new([size, size], TexelFormat::Rgba8Srgb), &bytes)
}

/// One texel: eight by eight fields, grain two texels wide.
fn texel(size: u32, seed: u32, x: u32, y: u32) -> [u8; 4] {
    let is_odd = (x * 8 / size + y * 8 / size) & 1 == 1;
    let grain = byte(hash(x >> 1, y >> 1, seed.wrapping_add(100)) & 63);
    let channel = |k| {
        let field = if is_odd { 64 + (hash(k, 1, seed) & 127) } else { 32 + (hash(k, 2, seed) & 127) };
        byte(field * 3 / 4) + grain
    };
    [channel(0), channel(1), channel(2), u8::MAX]
}

/// `value` is at most 143: 191 * 3 / 4.
#[expect(clippy::cast_possible_truncation, reason = "the callers' values are below 144")]
fn byte(value: u32) -> u8 {
    value as u8
}

/// Mixes two coordinates and a seed.
fn hash(x: u32, y: u32, seed: u32) -> u32 {
    let mixed = x
        .wrapping_mul(374_761_393)
        .wrapping_add(y.wrapping_mul(668_265_263))
        .wrapping_add(seed.wrapping_mul(2_246_822_519));
    let mixed = (mixed ^ (mixed >> 13)).wrapping_mul(1_274_126_177);
    mixed ^ (mixed >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grain_is_two_texels_wide_and_fields_alternate() {
        assert_eq!(texel(1024, 1, 10, 20), texel(1024, 1, 11, 21));
        let mean = |x0: u32| {
            let red = (0..128 * 128u32).map(|i| u32::from(texel(1024, 1, x0 + i % 128, i / 128)[0])).sum::<u32>();
            f64::from(red) / (128.0 * 128.0)
        };
        assert!((mean(0) - mean(256)).abs() < 2.0, "{} {}", mean(0), mean(256));
        assert!((mean(0) - mean(128)).abs() > 5.0, "{} {}", mean(0), mean(128));
    }
}
