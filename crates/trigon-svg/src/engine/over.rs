//! Source over, on premultiplied bytes: `s + round(d * (255 - alpha of s) / 255)` for each channel.
//!
//! Two channels are multiplied at once in the halves of a word. The rounding is exact: to nearest, and halves cannot
//! occur. As no channel of `s` is above its alpha, sums stay within a byte.

use trigon::lanes::{LANES, Lanes, U32};

/// Sixteen pixels or samples.
pub(crate) type Pixels16 = [u32; LANES];

/// Two bytes in the halves of a word.
const PAIR: u32 = 0x00FF_00FF;

/// `round(channel * factor / 255)` for each of the four channels; `factor` up to 255.
#[inline(always)]
pub(crate) fn scale(pixel: u32, factor: u32) -> u32 {
    div_pair((pixel & PAIR) * factor) | div_pair((pixel >> 8 & PAIR) * factor) << 8
}

#[inline(always)]
fn div_pair(pair: u32) -> u32 {
    let biased = pair + 0x0080_0080;
    (biased + (biased >> 8 & PAIR)) >> 8 & PAIR
}

/// One pixel over another.
#[inline(always)]
pub(crate) fn over(source: u32, below: u32) -> u32 {
    source + scale(below, 255 - (source >> 24))
}

/// [`scale`] in sixteen lanes.
#[inline(always)]
pub(crate) fn scale_lanes<L: Lanes>(l: L, pixels: U32<L>, factors: U32<L>) -> U32<L> {
    let pair = l.u32(PAIR);
    let low = div_pair_lanes(l, (pixels & pair) * factors);
    let high = div_pair_lanes(l, ((pixels >> 8) & pair) * factors);
    low | (high << 8)
}

#[inline(always)]
fn div_pair_lanes<L: Lanes>(l: L, pairs: U32<L>) -> U32<L> {
    let pair = l.u32(PAIR);
    let biased = pairs + l.u32(0x0080_0080);
    ((biased + ((biased >> 8) & pair)) >> 8) & pair
}

/// [`over`] in sixteen lanes.
#[inline(always)]
pub(crate) fn over_lanes<L: Lanes>(l: L, source: U32<L>, below: U32<L>) -> U32<L> {
    source + scale_lanes(l, below, l.u32(255) - (source >> 24))
}

/// One colour over a row of pixels.
#[inline(always)]
pub(crate) fn over_solid<L: Lanes>(l: L, source: u32, below: &mut [u32]) {
    let (chunks, rest) = below.as_chunks_mut::<LANES>();
    let (sources, factors) = (l.u32(source), l.u32(255 - (source >> 24)));
    for chunk in chunks {
        *chunk = (sources + scale_lanes(l, l.u32_array(chunk), factors)).to_array();
    }
    for pixel in rest {
        *pixel = over(source, *pixel);
    }
}

/// A row of pixels over another.
#[inline(always)]
pub(crate) fn over_row<L: Lanes>(l: L, sources: &[u32], below: &mut [u32]) {
    let (source_chunks, source_rest) = sources.as_chunks::<LANES>();
    let (chunks, rest) = below.as_chunks_mut::<LANES>();
    for (source, chunk) in source_chunks.iter().zip(chunks) {
        *chunk = over_lanes(l, l.u32_array(source), l.u32_array(chunk)).to_array();
    }
    for (source, pixel) in source_rest.iter().zip(rest) {
        *pixel = over(*source, *pixel);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::color::div_255;

    #[test]
    fn every_byte_times_every_factor_is_rounded_to_nearest() {
        for factor in 0..=255 {
            for byte in 0..=255u32 {
                let scaled = scale(byte * 0x0101_0101, factor);
                assert_eq!(scaled, div_255(byte * factor) * 0x0101_0101);
            }
        }
    }
}
