//! The sRGB transfer function between codes of 8 or 16 bits and linear light: exact, and fast where it is used per pixel.
//!
//! Exact means: decoding gives the `f32` nearest to the true value, encoding gives the code nearest to the true value of
//! the curve for every `f32` (NaN and negative numbers give 0, numbers above 1 the largest code).
//!
//! Encoding to 8 bits is one table entry and one addition. The curve is monotonic, so it is 255 thresholds. Cut the line
//! of floats into buckets of 2^16 neighbours (128 to an octave): no bucket holds two thresholds. An entry is
//! `(code at the start << 16) + (2^16 - offset of the threshold)`, or without the second term if there is none; adding
//! the low 16 bits of the float carries into the code exactly from the threshold on.
//!
//! Source: IEC 61966-2-1:1999, section 5.2.

use std::sync::OnceLock;

use super::tables::{SRGB8_THRESHOLD_BITS, SRGB8_TO_LINEAR_BITS};

/// The bits of 2^-13, where the first bucket of [`SRGB8_STEPS`] begins. Smaller numbers encode to 0.
pub const SRGB8_STEPS_FIRST_BITS: u32 = 0x3900_0000;

const ONE_BITS: u32 = 0x3f80_0000;
const BUCKETS: u32 = (ONE_BITS - SRGB8_STEPS_FIRST_BITS) >> 16;

/// The table of [`linear_to_srgb`], for kernels that encode many pixels at once.
///
/// For `x` in 2^-13 up to, not including, 1, with `bits = x.to_bits()`:
/// `code = (SRGB8_STEPS[(bits - SRGB8_STEPS_FIRST_BITS) >> 16] + (bits & 0xffff)) >> 16`.
pub static SRGB8_STEPS: [u32; BUCKETS as usize] = srgb8_steps();

static SRGB8_TO_LINEAR: [f32; 256] = srgb8_to_linear_table();

/// The linear value, 0 to 1, of an 8-bit sRGB code.
#[must_use]
#[inline]
pub fn srgb_to_linear(code: u8) -> f32 {
    SRGB8_TO_LINEAR[usize::from(code)]
}

/// The 8-bit sRGB code nearest to linear `x`, halves up; 0 for NaN and below 0, 255 above 1.
#[must_use]
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "a table entry plus 2^16 - 1 is below 2^24")]
pub fn linear_to_srgb(x: f32) -> u8 {
    if x >= 1.0 {
        return u8::MAX;
    }
    // A comparison that NaN fails.
    if x >= f32::from_bits(SRGB8_STEPS_FIRST_BITS) {
        let bits = x.to_bits();
        let entry = SRGB8_STEPS[((bits - SRGB8_STEPS_FIRST_BITS) >> 16) as usize];
        ((entry + (bits & 0xffff)) >> 16) as u8
    } else {
        0
    }
}

/// The linear value, 0 to 1, of a 16-bit sRGB code.
#[must_use]
pub fn srgb16_to_linear(code: u16) -> f32 {
    static TABLE: OnceLock<Vec<f32>> = OnceLock::new();
    let table = TABLE.get_or_init(|| (0..=u16::MAX).map(srgb16_to_linear_exact).collect());
    table[usize::from(code)]
}

/// The 16-bit sRGB code nearest to linear `x`, halves up; 0 for NaN and below 0, 65535 above 1.
///
/// A parabola for each of 256 intervals an octave gives the encoded value to far less than `NEAR_TIE` of a code; only a
/// value that close to a tie needs the power itself.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "the value is in 0..65536")]
pub fn linear_to_srgb16(x: f32) -> u16 {
    if x >= 1.0 {
        return u16::MAX;
    }
    if x >= f32::from_bits(PARABOLA_FIRST_BITS) {
        let bits = x.to_bits();
        let [c0, c1, c2] = parabolas()[((bits - PARABOLA_FIRST_BITS) >> 15) as usize];
        let t = f64::from(bits & 0x7fff);
        let scaled = c0 + t * (c1 + t * c2);
        let rounded = (scaled + 0.5) as u16;
        let to_tie = scaled + 0.5 - f64::from(rounded);
        if (NEAR_TIE..=1.0 - NEAR_TIE).contains(&to_tie) {
            return rounded;
        }
        linear_to_srgb16_exact(x)
    } else if x > 0.0 {
        linear_to_srgb16_exact(x)
    } else {
        0
    }
}

/// The curve itself from linear `x` in 0..=1 to its encoded value in 0..=1. Slow: it takes a power.
#[must_use]
pub fn srgb_encode(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 }
}

/// The inverse of [`srgb_encode`], from an encoded value in 0..=1 to linear in 0..=1. Slow: it takes a power.
#[must_use]
pub fn srgb_decode(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) }
}

#[expect(clippy::cast_possible_truncation, reason = "the rounding to f32 is the point")]
fn srgb16_to_linear_exact(code: u16) -> f32 {
    srgb_decode(f64::from(code) / 65535.0) as f32
}

/// `x` in 0..1. Doubles settle every case: no `f32` comes nearer to a tie than 1e-9 of a code (tested), and the
/// error of the double is below 1e-10.
#[expect(clippy::cast_possible_truncation, reason = "the value is in 0..65536")]
fn linear_to_srgb16_exact(x: f32) -> u16 {
    (srgb_encode(f64::from(x)) * 65535.0 + 0.5) as u16
}

/// The bits of 2^-8, below which the linear segment of the curve is near enough to go to the exact function.
const PARABOLA_FIRST_BITS: u32 = 0x3b80_0000;
const PARABOLAS: u32 = (ONE_BITS - PARABOLA_FIRST_BITS) >> 15;

/// Distance from a tie, in 16-bit codes, within which the exact function decides.
const NEAR_TIE: f64 = 0.01;

/// For each interval of 2^15 neighbouring floats the parabola, in the offset from its start, through the curve at the
/// start, middle and end.
fn parabolas() -> &'static [[f64; 3]] {
    static TABLE: OnceLock<Vec<[f64; 3]>> = OnceLock::new();
    TABLE.get_or_init(|| {
        (0..PARABOLAS)
            .map(|interval| {
                let at = |offset: u32| {
                    let bits = PARABOLA_FIRST_BITS + (interval << 15) + offset;
                    srgb_encode(f64::from(f32::from_bits(bits))) * 65535.0
                };
                let (start, middle, end) = (at(0), at(0x4000), at(0x8000));
                let length = 32768.0;
                let bend = 2.0 * (start - 2.0 * middle + end);
                [start, (end - start - bend) / length, bend / (length * length)]
            })
            .collect()
    })
}

const fn srgb8_to_linear_table() -> [f32; 256] {
    let mut table = [0.0; 256];
    let mut code = 0;
    while code < 256 {
        table[code] = f32::from_bits(SRGB8_TO_LINEAR_BITS[code]);
        code += 1;
    }
    table
}

const fn srgb8_steps() -> [u32; BUCKETS as usize] {
    let mut steps = [0; BUCKETS as usize];
    let mut code: u32 = 0;
    let mut bucket: u32 = 0;
    while bucket < BUCKETS {
        let start = SRGB8_STEPS_FIRST_BITS + (bucket << 16);
        while threshold(code) <= start {
            code += 1;
        }
        let next = threshold(code);
        steps[bucket as usize] = code << 16;
        if next < start + 0x1_0000 {
            assert!(threshold(code + 1) >= start + 0x1_0000, "a bucket holds at most one threshold");
            steps[bucket as usize] += 0x1_0000 - (next - start);
        }
        bucket += 1;
    }
    steps
}

/// Bits of the smallest float that encodes to more than `code`; none does to more than 255.
const fn threshold(code: u32) -> u32 {
    if code < 255 { SRGB8_THRESHOLD_BITS[code as usize] } else { u32::MAX }
}

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "the reference rounds")]
mod tests {
    use super::*;

    /// The true encoded value in codes, by a double-precision power: off by less than 1e-10.
    fn encoded(x: f32, codes: f64) -> f64 {
        srgb_encode(f64::from(x)) * codes
    }

    #[test]
    fn decoding_is_correctly_rounded_and_round_trips() {
        for code in 0..=u8::MAX {
            let x = srgb_to_linear(code);
            let truth = srgb_decode(f64::from(code) / 255.0);
            let error = (f64::from(x) - truth).abs();
            for neighbour in [x.next_up(), x.next_down()] {
                assert!(error < (f64::from(neighbour) - truth).abs(), "code {code}");
            }
            assert_eq!(linear_to_srgb(x), code);
        }
        for code in 0..=u16::MAX {
            assert_eq!(linear_to_srgb16(srgb16_to_linear(code)), code);
        }
    }

    #[test]
    fn each_8_bit_threshold_is_the_first_float_past_the_tie() {
        for (below, &bits) in SRGB8_THRESHOLD_BITS.iter().enumerate() {
            let tie = below as f64 + 0.5;
            let x = f32::from_bits(bits);
            // A margin far above the error of the reference settles it.
            assert!(encoded(x, 255.0) > tie + 1e-9 && encoded(x.next_down(), 255.0) < tie - 1e-9, "code {below}");
            assert_eq!(usize::from(linear_to_srgb(x)), below + 1);
            assert_eq!(usize::from(linear_to_srgb(x.next_down())), below);
        }
    }

    #[test]
    fn each_16_bit_code_changes_at_its_tie() {
        let mut nearest = f64::INFINITY;
        for below in 0..u16::MAX {
            let tie = f64::from(below) + 0.5;
            // The float next to the tie, found by bisection of the exact curve.
            let (mut low, mut high) = (0, ONE_BITS);
            while high - low > 1 {
                let middle = low.midpoint(high);
                if encoded(f32::from_bits(middle), 65535.0) < tie { low = middle } else { high = middle }
            }
            let (before, after) = (f32::from_bits(low), f32::from_bits(high));
            nearest = nearest.min(tie - encoded(before, 65535.0)).min(encoded(after, 65535.0) - tie);
            assert_eq!(linear_to_srgb16(before), below);
            assert_eq!(linear_to_srgb16(after), below + 1);
        }
        assert!(nearest > 1e-9, "a float only {nearest} from a tie needs more than doubles");
    }

    #[test]
    fn encoding_equals_the_curve_on_millions_of_floats() {
        // A stride coprime to 2^k visits all low bits; the range runs past both ends.
        let last = 2.0_f32.to_bits();
        for bits in (1e-9_f32.to_bits()..last).step_by(1021) {
            let x = f32::from_bits(bits);
            let clamped = x.min(1.0);
            assert_eq!(linear_to_srgb(x), (encoded(clamped, 255.0) + 0.5) as u8, "{x}");
            assert_eq!(linear_to_srgb16(x), (encoded(clamped, 65535.0) + 0.5) as u16, "{x}");
        }
    }

    #[test]
    fn odd_values_clamp() {
        for x in [f32::NAN, -f32::NAN, -0.0, 0.0, -1.0, f32::NEG_INFINITY, f32::MIN_POSITIVE, 1e-40] {
            assert_eq!((linear_to_srgb(x), linear_to_srgb16(x)), (0, 0), "{x}");
        }
        for x in [1.0, 1.0_f32.next_down(), 2.0, f32::MAX, f32::INFINITY] {
            assert_eq!((linear_to_srgb(x), linear_to_srgb16(x)), (255, 65535), "{x}");
        }
    }
}
