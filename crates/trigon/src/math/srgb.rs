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
