//! From samples to stored pixels.
//!
//! In: a [`ColorBlock`]. Out: sixteen resolved colours, and their 8-bit sRGB encoding with straight alpha. The mean is
//! taken in linear light, and the encoding happens once per stored pixel; or in stored values, and there is none.

use super::block::ColorBlock;
use crate::lanes::{F32, LANES, Lanes, Rgba, U32};
use crate::math::linear_to_srgb8;
use crate::target::ColorSpace;

/// The mean colour of each of sixteen pixels.
///
/// Written as `c0 + (sum of (ci - c0)) / n`: exactly `c0` where all samples agree, whatever n is, so that a pixel is
/// the same whether it was stored per pixel or per sample.
#[inline(always)]
pub fn resolve<L: Lanes>(l: L, block: &ColorBlock, g: usize) -> Rgba<L> {
    let first = block.lanes(l, 0, g);
    if !block.is_per_sample() {
        return first;
    }
    let zero = l.f32(0.0);
    let mut sum = Rgba { r: zero, g: zero, b: zero, a: zero };
    for s in 1..block.sample_count() {
        sum += block.lanes(l, s, g) - first;
    }
    first + sum * (1.0 / block.sample_count() as f32)
}

/// Encodes premultiplied colours of a space as straight 8-bit sRGB; alpha is linear. NaN becomes 0.
#[inline(always)]
pub fn encode_srgb8<L: Lanes>(l: L, color: Rgba<L>, space: ColorSpace) -> [[u8; 4]; LANES] {
    let alpha = color.a.saturate();
    let opaque = alpha.eq(1.0);
    let mut straight = color;
    if !opaque.all() {
        // A transparent pixel has no colour of its own: zero, not the quotient of two small numbers.
        let scale = alpha.gt(0.0).select(1.0 / alpha, l.f32(0.0));
        straight = color * scale;
    }
    let Rgba { r, g, b, .. } = straight;
    let [r, g, b] = match space {
        ColorSpace::Linear => [linear_to_srgb8(r), linear_to_srgb8(g), linear_to_srgb8(b)],
        ColorSpace::Encoded => [unit_to_byte(r), unit_to_byte(g), unit_to_byte(b)],
    };
    let packed = (r | (g << 8)) | ((b << 16) | (unit_to_byte(alpha) << 24));
    let words = packed.to_array();
    let mut out = [[0; 4]; LANES];
    for i in 0..LANES {
        out[i] = words[i].to_le_bytes();
    }
    out
}

/// 0 to 1 as 0 to 255, rounded to the nearest; NaN becomes 0.
#[inline(always)]
fn unit_to_byte<L: Lanes>(v: F32<L>) -> U32<L> {
    (v.saturate() * 255.0 + 0.5).to_i32_within(0.0, 255.0).as_u32()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{SimdLevel, dispatch};

    /// The bytes of one colour in both spaces.
    fn encoded([r, g, b, a]: [f32; 4]) -> [[u8; 4]; 2] {
        let level = SimdLevel::detect().to_level().unwrap();
        [ColorSpace::Linear, ColorSpace::Encoded]
            .map(|space| dispatch!(level, l => encode_srgb8(l, l.vec3([r, g, b]).rgba(a), space))[0])
    }

    #[test]
    fn half_is_code_188_in_linear_light_and_128_in_stored_values() {
        assert_eq!(encoded([0.5, 0.0, 1.0, 1.0]), [[188, 0, 255, 255], [128, 0, 255, 255]]);
    }

    #[test]
    fn colors_beyond_the_range_are_cut_and_made_straight() {
        assert_eq!(encoded([9.0, -1.0, f32::NAN, 1.0])[1], [255, 0, 0, 255]);
        assert_eq!(encoded([0.25, 0.5, 0.1, 0.5])[1], [128, 255, 51, 128]);
        assert_eq!(encoded([0.25, 0.5, 0.1, 0.0])[1], [0; 4]);
    }
}
