//! Logarithm and exponential functions, base 2 and e.
//!
//! In: lanes. Out: lanes. Argument reduction by the exponent bits of the float, then a minimax polynomial on the rest
//! (Remez exchange on the relative error; Muller, "Elementary Functions", 3rd edition, chapter 3).

use crate::lanes::{F32, Lanes};

/// The base-2 logarithm. Largest relative error 2.0e-7 on the positive normal floats, zero at 1.
///
/// Subnormal numbers count as zero. Zero and negative numbers give -128, infinity 128, NaN -128: always finite.
#[inline(always)]
pub fn log2<L: Lanes>(x: F32<L>) -> F32<L> {
    let l = x.token();
    // Comparisons that NaN fails.
    let positive = x.ge(f32::MIN_POSITIVE);
    let (exponent, t) = split_exponent(x);
    // log2(1 + t) / t
    let p = 0.125_836_97 * t - 0.207_269_71;
    let p = p * t + 0.215_715_6;
    let p = p * t - 0.238_944_83;
    let p = p * t + 0.287_916_25;
    let p = p * t - 0.360_703_68;
    let p = p * t + 0.480_910_63;
    let p = p * t - 0.721_347_33;
    let p = p * t + core::f32::consts::LOG2_E;
    positive.select(exponent + t * p, l.f32(-128.0))
}

/// `(e, t)` with `x = 2^e (1 + t)` and 1 + t between sqrt(1/2) and sqrt(2), for positive normal `x`.
#[inline(always)]
pub(super) fn split_exponent<L: Lanes>(x: F32<L>) -> (F32<L>, F32<L>) {
    let l = x.token();
    // Counted from the bits of sqrt(1/2), the exponent field steps where the mantissa should.
    const ROOT_HALF: u32 = 0x3f35_04f3;
    let from_root = x.to_bits().as_i32() - l.u32(ROOT_HALF).as_i32();
    let exponent = from_root >> 23;
    let mantissa = (from_root & l.i32(0x007f_ffff)) + l.u32(ROOT_HALF).as_i32();
    (exponent.to_f32(), mantissa.as_u32().as_f32_bits() - 1.0)
}

/// 2 to the power of `x`. Largest relative error 1.5e-7 where the result is a normal float.
///
/// Underflows gradually to 0 below -126 and to infinity from 128 on; NaN gives 0.
#[inline(always)]
pub fn exp2<L: Lanes>(x: F32<L>) -> F32<L> {
    let x = x.clamp(-160.0, 130.0);
    let whole = x.round_ties_even();
    exp2_reduced(whole, x - whole)
}

/// `2^(whole + fraction)` for an integer `whole` in -200..=200 and `fraction` in -0.5..=0.5 (a little more does no harm).
#[inline(always)]
pub(super) fn exp2_reduced<L: Lanes>(whole: F32<L>, fraction: F32<L>) -> F32<L> {
    let l = whole.token();
    let f = fraction;
    let p = 1.534_581_2e-4 * f + 1.339_993_1e-3;
    let p = p * f + 9.618_489e-3;
    let p = p * f + 0.055_503_286;
    let p = p * f + 0.240_226_46;
    let p = p * f + core::f32::consts::LN_2;
    let p = p * f + 1.0;
    // Two factors, so that the product may be subnormal or infinite.
    let whole = whole.to_i32_in_range();
    let half = whole >> 1;
    let bias = l.i32(127);
    let first = ((half + bias) << 23).as_u32().as_f32_bits();
    let second = ((whole - half + bias) << 23).as_u32().as_f32_bits();
    (p * first) * second
}

/// e to the power of `x`. Largest relative error 2.5e-7 where the result is a normal float.
///
/// Underflows gradually to 0 below -87.3 and to infinity above 88.7; NaN gives 0.
#[inline(always)]
pub fn exp<L: Lanes>(x: F32<L>) -> F32<L> {
    let x = x.clamp(-110.0, 90.0);
    let whole = (x * core::f32::consts::LOG2_E).round_ties_even();
    // ln 2 in two parts; products with the first are exact (Cody and Waite).
    let rest = (x - whole * 0.693_359_4) - whole * -2.121_944_4e-4;
    exp2_reduced(whole, rest * core::f32::consts::LOG2_E)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::check::{evaluate, evenly, floats, relative_error};

    fn log2_of(x: &[f32]) -> Vec<f32> {
        evaluate!(log2, x)
    }

    fn exp2_of(x: &[f32]) -> Vec<f32> {
        evaluate!(exp2, x)
    }

    fn exp_of(x: &[f32]) -> Vec<f32> {
        evaluate!(exp, x)
    }

    #[test]
    fn log2_is_within_its_error() {
        let mut x = floats(f32::MIN_POSITIVE, f32::MAX, 9973);
        x.extend(floats(0.5, 2.0, 101));
        x.retain(|x| *x != 1.0);
        let error = relative_error(&log2_of(&x), x.iter().map(|x| libm::log2(f64::from(*x))));
        assert!(error < 2.0e-7, "{error:e}");
    }

    #[test]
    fn log2_is_finite_everywhere() {
        let odd = [1.0, 0.0, -0.0, 1e-40, -1.0, f32::NEG_INFINITY, f32::NAN, -f32::NAN, f32::INFINITY];
        let results = log2_of(&odd);
        assert_eq!(results, [0.0, -128.0, -128.0, -128.0, -128.0, -128.0, -128.0, -128.0, 128.0]);
        // Powers of two are exact.
        let powers: Vec<f32> = (1..=254).map(|e| f32::from_bits(e << 23)).collect();
        for (power, result) in (-126_i16..).zip(log2_of(&powers)) {
            assert_eq!(result, f32::from(power));
        }
    }

    #[test]
    fn exp2_is_within_its_error() {
        let mut x = evenly(-126.0, 127.99, 60_001);
        x.extend(floats(1e-9, 1.0, 4001));
        let error = relative_error(&exp2_of(&x), x.iter().map(|x| libm::exp2(f64::from(*x))));
        assert!(error < 1.5e-7, "{error:e}");
    }

    #[test]
    fn exp2_of_integers_is_exact_and_its_ends_are_right() {
        let x: Vec<f32> = (-149_i16..=127).map(f32::from).collect();
        for (x, result) in x.iter().zip(exp2_of(&x)) {
            assert_eq!(f64::from(result), libm::exp2(f64::from(*x)), "{x}");
        }
        let odd = [128.0, 1e30, f32::INFINITY, -151.0, -1e30, f32::NEG_INFINITY, f32::NAN, -0.0];
        let infinity = f32::INFINITY;
        assert_eq!(exp2_of(&odd), [infinity, infinity, infinity, 0.0, 0.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn exp_is_within_its_error() {
        let mut x = evenly(-87.3, 88.7, 60_001);
        x.extend(floats(1e-9, 1.0, 4001));
        let error = relative_error(&exp_of(&x), x.iter().map(|x| libm::exp(f64::from(*x))));
        assert!(error < 2.5e-7, "{error:e}");
        assert_eq!(exp_of(&[0.0, 89.0, -104.0, f32::NAN]), [1.0, f32::INFINITY, 0.0, 0.0]);
    }
}
