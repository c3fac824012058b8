//! Sine, cosine and their inverses, in radians.
//!
//! Reduction to an interval around zero (to a quarter turn by Cody and Waite's method, to ratios below 1 by swapping,
//! to sines below 1/2 by halving), then an odd or even minimax polynomial.

use crate::lanes::{F32, I32, Lanes};
use core::f32::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// The sine. Largest error 1e-7 for |x| up to 8192, relative 1.5e-7 for |x| up to pi/4.
///
/// Larger angles lose their phase (the next floats are too far apart), but the result stays within -1.01..=1.01; NaN and
/// infinities count as some angle.
#[inline(always)]
pub fn sin<L: Lanes>(x: F32<L>) -> F32<L> {
    let (quarters, r) = reduce(x);
    of_quadrant(quarters, r)
}

/// The cosine. Largest error 1e-7 for |x| up to 8192; otherwise as [`sin`].
#[inline(always)]
pub fn cos<L: Lanes>(x: F32<L>) -> F32<L> {
    let (quarters, r) = reduce(x);
    of_quadrant(quarters + x.token().i32(1), r)
}

/// The angle of the point (x, y), -pi to pi: `atan2(y, x)`. Largest relative error 3e-7.
///
/// 0 for the origin, whatever the signs of its zeros, and for NaN.
#[inline(always)]
pub fn atan2<L: Lanes>(y: F32<L>, x: F32<L>) -> F32<L> {
    let l = x.token();
    let (width, height) = (x.abs(), y.abs());
    let steep = height.gt(width);
    let (less, more) = (steep.select(width, height), steep.select(height, width));
    // Infinity over infinity, 0 over 0 and NaN fail the comparison of `min`.
    let t = (less / more).min(1.0);
    let t = more.gt(0.0).select(t, l.f32(0.0));
    let z = t * t;
    // (atan(t) - t) / t^3
    let p = 2.920_688e-3 * z - 0.016_367_91;
    let p = p * z + 0.043_211_83;
    let p = p * z - 0.075_522_12;
    let p = p * z + 0.106_660_03;
    let p = p * z - 0.142_110_55;
    let p = p * z + 0.199_937_73;
    let p = p * z - 0.333_331_53;
    let angle = t + (t * z) * p;
    let angle = steep.select(FRAC_PI_2 - angle, angle);
    let angle = x.lt(0.0).select(PI - angle, angle);
    y.lt(0.0).select(-angle, angle)
}

/// The angle, 0 to pi, whose cosine is `x`. Largest relative error 3e-7.
///
/// `x` is clamped to -1..=1; NaN counts as -1.
#[inline(always)]
pub fn acos<L: Lanes>(x: F32<L>) -> F32<L> {
    let x = x.clamp(-1.0, 1.0);
    let size = x.abs();
    let near_end = size.gt(0.5);
    // acos(x) = 2 asin(sqrt((1 - x) / 2)); the difference is exact.
    let half = (1.0 - size) * 0.5;
    let z = near_end.select(half, size * size);
    let s = near_end.select(half.sqrt(), size);
    // (asin(s) - s) / s^3
    let p = 0.042_166_32 * z + 0.024_179_507;
    let p = p * z + 0.045_470_38;
    let p = p * z + 0.074_952_975;
    let p = p * z + 0.166_667_52;
    let arc = s + (s * z) * p;
    let end = x.lt(0.0).select(PI - 2.0 * arc, 2.0 * arc);
    let middle = FRAC_PI_2 - x.lt(0.0).select(-arc, arc);
    near_end.select(end, middle)
}

/// The number of quarter turns nearest to `x` and what is left, about -pi/4 to pi/4.
#[inline(always)]
fn reduce<L: Lanes>(x: F32<L>) -> (I32<L>, F32<L>) {
    // Products of the first two parts of pi/2 with up to 13 bits are exact.
    const PARTS: [f32; 3] = [1.570_312_5, 4.837_513e-4, 7.549_79e-8];
    let x = x.clamp(-1e6, 1e6);
    let quarters = (x * FRAC_2_PI).round_ties_even();
    let r = ((x - quarters * PARTS[0]) - quarters * PARTS[1]) - quarters * PARTS[2];
    (quarters.to_i32_in_range(), r.clamp(-0.8, 0.8))
}

/// The sine of `r` plus a number of quarter turns.
#[inline(always)]
fn of_quadrant<L: Lanes>(quarters: I32<L>, r: F32<L>) -> F32<L> {
    let l = r.token();
    let z = r * r;
    let p = -1.951_697_8e-4 * z + 8.332_176e-3;
    let sine = r + (r * z) * (p * z - 0.166_666_55);
    let p = 2.443_809_2e-5 * z - 1.388_736_4e-3;
    let cosine = (1.0 - 0.5 * z) + (z * z) * (p * z + 0.041_666_646);
    let odd = (quarters & l.i32(1)).eq(l.i32(1));
    let value = odd.select(cosine, sine);
    (quarters & l.i32(2)).eq(l.i32(2)).select(-value, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::check::{absolute_error, evaluate, evenly, floats, relative_error};

    fn sin_of(x: &[f32]) -> Vec<f32> {
        evaluate!(sin, x)
    }

    fn cos_of(x: &[f32]) -> Vec<f32> {
        evaluate!(cos, x)
    }

    fn acos_of(x: &[f32]) -> Vec<f32> {
        evaluate!(acos, x)
    }

    fn atan2_of(a: &[f32], b: &[f32]) -> Vec<f32> {
        evaluate!(atan2, a, b)
    }

    #[test]
    fn sine_and_cosine_are_within_their_errors() {
        let x = [evenly(-8192.0, 8192.0, 65_535), evenly(-10.0, 10.0, 65_535)].concat();
        let sine = absolute_error(&sin_of(&x), x.iter().map(|x| libm::sin(f64::from(*x))));
        let cosine = absolute_error(&cos_of(&x), x.iter().map(|x| libm::cos(f64::from(*x))));
        assert!(sine < 1e-7 && cosine < 1e-7, "{sine:e} {cosine:e}");
        let small = floats(1e-30, core::f32::consts::FRAC_PI_4, 10_007);
        let sine = relative_error(&sin_of(&small), small.iter().map(|x| libm::sin(f64::from(*x))));
        assert!(sine < 1.5e-7, "{sine:e}");
    }

    #[test]
    fn sine_and_cosine_are_bounded() {
        let odd = [1e6, -3e7, 1e30, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
        for value in [sin_of(&odd), cos_of(&odd)].concat() {
            assert!(value.abs() <= 1.01, "{value}");
        }
        assert_eq!(sin_of(&[0.0]), [0.0]);
        assert_eq!(cos_of(&[0.0]), [1.0]);
    }

    #[test]
    fn atan2_is_within_its_error() {
        let mut points = Vec::new();
        for scale in [1e-20_f32, 1.0, 1e15] {
            for (a, b) in
                evenly(-3.3, 3.1, 401).iter().flat_map(|a| evenly(-1.1, 1.3, 307).into_iter().map(|b| (*a, b)))
            {
                points.push((a * scale, b * scale));
            }
        }
        points.retain(|(_, x)| *x != 0.0);
        let (y, x): (Vec<f32>, Vec<f32>) = points.into_iter().unzip();
        let exact = y.iter().zip(&x).map(|(y, x)| libm::atan2(f64::from(*y), f64::from(*x)));
        let error = relative_error(&atan2_of(&y, &x), exact);
        assert!(error < 3e-7, "{error:e}");
    }

    #[test]
    fn atan2_has_its_limits() {
        let infinity = f32::INFINITY;
        let y = [0.0, -0.0, 1.0, -1.0, 0.0, infinity, f32::NAN, 1.0];
        let x = [0.0, -1.0, 0.0, 0.0, 5.0, infinity, 1.0, -infinity];
        let expected = [0.0, PI, FRAC_PI_2, -FRAC_PI_2, 0.0, FRAC_PI_2 / 2.0];
        let results = atan2_of(&y, &x);
        for (result, expected) in results.iter().zip(expected) {
            assert!((result - expected).abs() < 3e-7, "{results:?}");
        }
        assert!(results.iter().all(|angle| angle.is_finite()));
    }

    #[test]
    fn acos_is_within_its_error() {
        let x = [evenly(-1.0, 0.9999, 65_535), floats(0.99, 1.0, 3), floats(1e-20, 0.5, 20_011)].concat();
        let x: Vec<f32> = x.into_iter().filter(|x| *x < 1.0).collect();
        let error = relative_error(&acos_of(&x), x.iter().map(|x| libm::acos(f64::from(*x))));
        assert!(error < 3e-7, "{error:e}");
        assert_eq!(acos_of(&[1.0, 2.0, -1.0, -5.0, f32::NAN]), [0.0, 0.0, PI, PI, PI]);
    }
}
