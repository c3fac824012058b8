//! From samples to stored pixels.
//!
//! In: a [`ColorBlock`]. Out: sixteen resolved colours, and their 8-bit sRGB encoding with straight alpha. The mean is
//! taken in linear light; the encoding happens once per stored pixel.

use super::block::ColorBlock;
use crate::lanes::{LANES, Lanes, Rgba};
use crate::math::linear_to_srgb8;

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

/// Encodes premultiplied linear colours as straight 8-bit sRGB; alpha is linear. NaN becomes 0.
#[inline(always)]
pub fn encode_srgb8<L: Lanes>(l: L, color: Rgba<L>) -> [[u8; 4]; LANES] {
    let alpha = color.a.saturate();
    let opaque = alpha.eq(1.0);
    let mut straight = color;
    if !opaque.all() {
        // A transparent pixel has no colour of its own: zero, not the quotient of two small numbers.
        let scale = alpha.gt(0.0).select(1.0 / alpha, l.f32(0.0));
        straight = color * scale;
    }
    let r = linear_to_srgb8(straight.r);
    let g = linear_to_srgb8(straight.g);
    let b = linear_to_srgb8(straight.b);
    let a = (alpha * 255.0 + 0.5).to_i32_within(0.0, 255.0).as_u32();
    let packed = (r | (g << 8)) | ((b << 16) | (a << 24));
    let words = packed.to_array();
    let mut out = [[0; 4]; LANES];
    for i in 0..LANES {
        out[i] = words[i].to_le_bytes();
    }
    out
}
