//! The sRGB transfer function on lanes, bit for bit that of `trigon_image`: one gather each way.

use crate::lanes::{F32, Lanes, U32};
use std::sync::LazyLock;
use trigon_image::color::{SRGB8_STEPS, SRGB8_STEPS_FIRST_BITS, srgb_to_linear};

/// The 8-bit sRGB code nearest to each linear value: 0 for NaN and below 0, 255 above 1.
///
/// Equal to `trigon_image::color::linear_to_srgb` for every float. The entry for the float's upper 16 bits holds the
/// code and how far the next step is; adding the lower 16 bits carries into the code from that step on.
#[inline(always)]
pub fn linear_to_srgb8<L: Lanes>(x: F32<L>) -> U32<L> {
    let l = x.token();
    // NaN goes to the smallest value, whose code is 0; the largest float below 1 has code 255.
    let bits = x.clamp(f32::from_bits(SRGB8_STEPS_FIRST_BITS), 1.0_f32.next_down()).to_bits();
    let bucket = (bits - l.u32(SRGB8_STEPS_FIRST_BITS)) >> 16;
    (bucket.gather_u32(&SRGB8_STEPS) + (bits & l.u32(0xffff))) >> 16
}

/// The linear value of each 8-bit sRGB code. Codes above 255 read 0.
#[inline(always)]
pub fn srgb8_to_linear<L: Lanes>(code: U32<L>) -> F32<L> {
    code.gather_f32(srgb8_to_linear_table())
}

/// The linear values of the 256 codes.
#[inline]
fn srgb8_to_linear_table() -> &'static [f32; 256] {
    static TABLE: LazyLock<[f32; 256]> = LazyLock::new(|| {
        let mut table = [0.0; 256];
        for (code, value) in (0..=u8::MAX).zip(&mut table) {
            *value = srgb_to_linear(code);
        }
        table
    });
    &TABLE
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{LANES, SimdLevel, dispatch};
    use trigon_image::color::linear_to_srgb;

    fn encode(level: SimdLevel, x: &[f32; LANES]) -> [u32; LANES] {
        dispatch!(level.to_level().expect("the level is available"), l => linear_to_srgb8(l.f32_array(x)).to_array())
    }

    fn check(level: SimdLevel, bits: impl Iterator<Item = u32>) {
        let mut bits = bits.peekable();
        while bits.peek().is_some() {
            let x = core::array::from_fn(|_| f32::from_bits(bits.next().unwrap_or(0)));
            let codes = encode(level, &x);
            for (x, code) in x.iter().zip(codes) {
                assert_eq!(code, u32::from(linear_to_srgb(*x)), "{x} at {level}");
            }
        }
    }

    #[test]
    fn encoding_is_that_of_the_image_crate() {
        for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            // All signs, exponents, infinities and NaN.
            check(level, (0..=u32::MAX).step_by(65_521));
            // The ends of the table and the neighbours of each bucket.
            check(level, 0x38ff_ff00..0x3900_0100);
            check(level, 0x3f7f_ff00..0x3f80_0100);
            check(level, (0x3900_0000..0x3f80_0000).step_by(1 << 16).flat_map(|bits| bits - 2..bits + 2));
        }
    }

    #[test]
    #[ignore = "a billion floats: run with --release"]
    fn encoding_is_that_of_the_image_crate_for_every_float_up_to_two() {
        check(SimdLevel::detect(), 0..=2.0_f32.to_bits());
    }

    #[test]
    fn every_step_is_where_the_image_crate_has_it() {
        for code in 1..=u8::MAX {
            // The first float of the code, by bisection.
            let (mut below, mut first) = (0, 1.0_f32.to_bits());
            while first - below > 1 {
                let middle = below.midpoint(first);
                if linear_to_srgb(f32::from_bits(middle)) < code { below = middle } else { first = middle }
            }
            for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
                let codes =
                    encode(level, &[f32::from_bits(below), f32::from_bits(first)].repeat(8).try_into().unwrap());
                assert_eq!(codes[..2], [u32::from(code) - 1, u32::from(code)], "at {level}");
            }
        }
    }

    #[test]
    fn decoding_is_that_of_the_image_crate() {
        let codes: [u32; LANES] =
            core::array::from_fn(|i| [0, 1, 10, 11, 12, 127, 128, 254, 255, 256, u32::MAX][i % 11]);
        for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            let token = level.to_level().expect("the level is available");
            let linear = dispatch!(token, l => srgb8_to_linear(l.u32_array(&codes)).to_array());
            for (code, linear) in codes.iter().zip(linear) {
                assert_eq!(linear, u8::try_from(*code).map_or(0.0, srgb_to_linear));
            }
        }
    }
}
