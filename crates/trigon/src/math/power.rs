//! Powers: real and integer exponents, and the reciprocal square root.
//!
//! A power is `2^(y log2 x)`. Its relative error is the absolute error of that exponent, which reaches 126; so the
//! logarithm and the product are carried in two floats, as exact sums and products of short numbers (Dekker, "A
//! Floating-Point Technique for Extending the Available Precision", 1971).

use super::log_exp::{exp2_reduced, split_exponent};
use crate::lanes::{F32, Lanes};

/// `x` to the power of `y`, for `x >= 0`. Largest relative error 4e-7 where the result lies between 2^-32 and 2^32,
/// 2.5e-6 on all normal results.
///
/// `pow(x, 0) = 1` for every `x`. `pow(0, y)` is 0 for `y > 0` and infinite for `y < 0`; subnormal, negative and NaN `x`
/// count as 0. Infinite `x` counts as 2^128. Never NaN.
#[inline(always)]
pub fn pow<L: Lanes>(x: F32<L>, y: F32<L>) -> F32<L> {
    let l = x.token();
    // Larger exponents change nothing: no float but 1 is nearer to 1 than 2^-24.
    let y = y.clamp(-EXPONENT_LIMIT, EXPONENT_LIMIT);
    let (log, log_rest) = log2_in_two(x);
    // Short factors: their product is exact.
    let (log_short, y_short) = (first_half(log), first_half(y));
    let product = y_short * log_short;
    let rest = (y - y_short) * log_short + y * ((log - log_short) + log_rest);
    let whole = (product + rest).clamp(-160.0, 160.0).round_ties_even();
    let fraction = ((product - whole) + rest).clamp(-1.0, 1.0);
    let power = exp2_reduced(whole, fraction);
    let of_zero = y.gt(0.0).select(l.f32(0.0), y.lt(0.0).select(l.f32(f32::INFINITY), l.f32(1.0)));
    x.ge(f32::MIN_POSITIVE).select(power, of_zero)
}

/// `x` to the power of a small integer, by squaring: `x.powi(32)` is five products. Relative error about `n` times 6e-8.
#[inline(always)]
pub fn powi<L: Lanes>(x: F32<L>, n: u32) -> F32<L> {
    let mut power = x.token().f32(1.0);
    let (mut square, mut bits) = (x, n);
    while bits > 0 {
        if bits & 1 == 1 {
            power *= square;
        }
        bits >>= 1;
        if bits > 0 {
            square *= square;
        }
    }
    power
}

/// `1 / sqrt(x)`: two correct roundings, largest relative error 9e-8. Infinite for 0, NaN for negative numbers.
#[inline(always)]
pub fn rsqrt<L: Lanes>(x: F32<L>) -> F32<L> {
    1.0 / x.sqrt()
}

const EXPONENT_LIMIT: f32 = 4_294_967_296.0;

/// The base-2 logarithm of a positive normal number as a sum of two floats, to about 2^-28 of log2(1 + t).
#[inline(always)]
fn log2_in_two<L: Lanes>(x: F32<L>) -> (F32<L>, F32<L>) {
    // log2(e) in two parts, the first of 12 bits.
    const FIRST: f32 = 1.442_382_8;
    const REST: f32 = 3.122_284e-4;
    let (exponent, t) = split_exponent(x);
    // (log2(1 + t) - t log2(e)) / t^2
    let p = -0.110_293_955 * t + 0.186_424_3;
    let p = p * t - 0.191_052_05;
    let p = p * t + 0.204_563_4;
    let p = p * t - 0.239_614_28;
    let p = p * t + 0.288_569_12;
    let p = p * t - 0.360_696_82;
    let p = p * t + 0.480_898_2;
    let p = p * t - 0.721_347_33;
    let t_short = first_half(t);
    let leading = t_short * FIRST;
    let log = exponent + leading;
    // What the sum lost, exactly: the exponent is 0 or the greater one (Dekker's fast two-sum).
    let lost = (exponent - log) + leading;
    (log, lost + (((t - t_short) * FIRST + t * REST) + (t * t) * p))
}

/// The upper twelve bits of the mantissa.
#[inline(always)]
fn first_half<L: Lanes>(x: F32<L>) -> F32<L> {
    (x.to_bits() & x.token().u32(0xffff_f000)).as_f32_bits()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::check::{evaluate, evenly, floats, relative_error};

    fn power_32_of(x: &[f32]) -> Vec<f32> {
        evaluate!(power_32, x)
    }

    fn power_7_of(x: &[f32]) -> Vec<f32> {
        evaluate!(power_7, x)
    }

    fn rsqrt_of(x: &[f32]) -> Vec<f32> {
        evaluate!(rsqrt, x)
    }

    fn pow_of(a: &[f32], b: &[f32]) -> Vec<f32> {
        evaluate!(pow, a, b)
    }

    /// The largest relative error over a grid, where the result is between 2^-limit and 2^limit.
    fn pow_error(limit: f64) -> f64 {
        let bases = [floats(1e-30, 1e30, 4_000_037), floats(0.25, 4.0, 40_009), floats(0.999, 1.001, 97)].concat();
        let exponents = [evenly(-9.0, 9.0, 37), vec![0.45, 1.0 / 2.4, 32.0, 100.0, 333.3, 1000.0, -200.0, 12345.6]];
        let (mut x, mut y) = (Vec::new(), Vec::new());
        for exponent in exponents.concat() {
            for base in &bases {
                if (f64::from(exponent) * libm::log2(f64::from(*base))).abs() < limit {
                    x.push(*base);
                    y.push(exponent);
                }
            }
        }
        assert!(x.len() > 20_000, "{}", x.len());
        let exact = x.iter().zip(&y).map(|(x, y)| libm::pow(f64::from(*x), f64::from(*y)));
        relative_error(&pow_of(&x, &y), exact)
    }

    #[test]
    fn pow_is_within_its_error() {
        let (usual, all) = (pow_error(32.0), pow_error(126.0));
        assert!(usual < 4e-7 && all < 2.5e-6, "{usual:e} {all:e}");
    }

    #[test]
    fn pow_has_its_limits() {
        let infinity = f32::INFINITY;
        let cases = [
            (0.0, 2.0, 0.0),
            (0.0, 0.0, 1.0),
            (0.0, -1.0, infinity),
            (5.0, 0.0, 1.0),
            (f32::NAN, 0.0, 1.0),
            (f32::NAN, 2.0, 0.0),
            (-3.0, 2.0, 0.0),
            (1.0, 1e30, 1.0),
            (1.0, infinity, 1.0),
            (2.0, 1e30, infinity),
            (2.0, -1e30, 0.0),
            (0.5, infinity, 0.0),
            (infinity, 1.0, infinity),
            (infinity, -2.0, 0.0),
            (2.0, 10.0, 1024.0),
            (3.0, 1.0, 3.0),
        ];
        let (x, y) = (cases.map(|case| case.0), cases.map(|case| case.1));
        assert_eq!(pow_of(&x, &y), cases.map(|case| case.2));
    }

    #[test]
    fn pow_is_never_nan() {
        let odd = [0.0, -0.0, 1e-45, 1.0, 0.999_999_94, 1.5, 3e38, -2.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
        let x: Vec<f32> = odd.iter().flat_map(|x| odd.map(|_| *x)).collect();
        let y: Vec<f32> = odd.iter().flat_map(|_| odd).collect();
        assert!(pow_of(&x, &y).iter().all(|power| *power >= 0.0));
    }

    #[inline(always)]
    fn power_32<L: Lanes>(x: F32<L>) -> F32<L> {
        powi(x, 32)
    }

    #[inline(always)]
    fn power_7<L: Lanes>(x: F32<L>) -> F32<L> {
        powi(x, 7)
    }

    #[test]
    fn powi_is_within_its_error() {
        let x = [evenly(-2.0, -0.1, 10_000), evenly(0.1, 2.0, 10_000)].concat();
        let seventh = relative_error(&power_7_of(&x), x.iter().map(|x| libm::pow(f64::from(*x), 7.0)));
        let thirty_second = relative_error(&power_32_of(&x), x.iter().map(|x| libm::pow(f64::from(*x), 32.0)));
        assert!(seventh < 7.0 * 6e-8 && thirty_second < 32.0 * 6e-8, "{seventh:e} {thirty_second:e}");
    }

    #[test]
    fn rsqrt_is_within_its_error() {
        let x = floats(f32::MIN_POSITIVE, f32::MAX, 100_003);
        let error = relative_error(&rsqrt_of(&x), x.iter().map(|x| 1.0 / f64::from(*x).sqrt()));
        assert!(error < 9e-8, "{error:e}");
    }
}
