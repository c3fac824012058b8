//! Sixteen `f32` values and the exact operations on them.
//!
//! Every operation here rounds once, to nearest even, or not at all, on every target (IEEE 754-2019, section 5.4);
//! minimum, maximum and conversion to integers are defined as comparisons, so that NaN and -0 behave alike too.

use super::plain::lane_op;
use super::{I32, LANES, Lanes, Mask, U32};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use fearless_simd::{Bytes, SimdBase, SimdFloat, f32x16};

/// Sixteen `f32` values.
#[derive(Clone, Copy)]
pub struct F32<L: Lanes>(pub(super) f32x16<L>);

impl<L: Lanes> F32<L> {
    /// The token of these lanes' level.
    #[inline(always)]
    pub fn token(self) -> L {
        fearless_simd::ExtractToken::token(&self.0)
    }

    /// The values, lane 0 first.
    #[inline(always)]
    pub fn to_array(self) -> [f32; LANES] {
        self.0.to_array()
    }

    /// Writes the values to `out`, lane 0 first.
    #[inline(always)]
    pub fn store(self, out: &mut [f32; LANES]) {
        self.0.store_array(out);
    }

    /// Clears the sign.
    #[inline(always)]
    pub fn abs(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> F32<L> = F32(a.0.abs()))
    }

    /// The square root, correctly rounded; NaN for negative values.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> F32<L> = F32(a.0.sqrt()))
    }

    /// The largest integer not above.
    #[inline(always)]
    pub fn floor(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> F32<L> = F32(a.0.floor()))
    }

    /// The nearest integer; halves go to the even one.
    #[inline(always)]
    pub fn round_ties_even(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> F32<L> = F32(a.0.round_ties_even()))
    }

    /// `self < other ? self : other`; so `other` where either is NaN.
    #[inline(always)]
    pub fn min(self, other: impl IntoF32<L>) -> Self {
        let other = other.into_f32(self.token());
        if has_select_min(self.token()) { Self(self.0.min(other.0)) } else { self.lt(other).select(self, other) }
    }

    /// `self > other ? self : other`; so `other` where either is NaN.
    #[inline(always)]
    pub fn max(self, other: impl IntoF32<L>) -> Self {
        let other = other.into_f32(self.token());
        if has_select_min(self.token()) { Self(self.0.max(other.0)) } else { self.gt(other).select(self, other) }
    }

    /// Into `low..=high`; NaN becomes `low`.
    #[inline(always)]
    pub fn clamp(self, low: f32, high: f32) -> Self {
        self.max(low).min(high)
    }

    /// Into `0..=1`; NaN becomes 0.
    #[inline(always)]
    pub fn saturate(self) -> Self {
        self.clamp(0.0, 1.0)
    }

    /// Truncates towards zero after a clamp into `low..=high`, which must lie within the `i32` range; NaN becomes `low`.
    #[inline(always)]
    pub fn to_i32_within(self, low: f32, high: f32) -> I32<L> {
        self.clamp(low, high).to_i32_in_range()
    }

    /// Truncates towards zero. The caller knows that the values are finite and within the `i32` range.
    #[inline(always)]
    pub(crate) fn to_i32_in_range(self) -> I32<L> {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> I32<L> = I32(a.0.to_int()))
    }

    /// The bit patterns.
    #[inline(always)]
    pub fn to_bits(self) -> U32<L> {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> U32<L> = U32(a.0.bitcast()))
    }

    /// Per lane `self < other`; false where either is NaN.
    #[inline(always)]
    pub fn lt(self, other: impl IntoF32<L>) -> Mask<L> {
        let (a, b) = (self, other.into_f32(self.token()));
        lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> Mask<L> = Mask(a.0.simd_lt(b.0)))
    }

    /// Per lane `self <= other`; false where either is NaN.
    #[inline(always)]
    pub fn le(self, other: impl IntoF32<L>) -> Mask<L> {
        let (a, b) = (self, other.into_f32(self.token()));
        lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> Mask<L> = Mask(a.0.simd_le(b.0)))
    }

    /// Per lane `self > other`; false where either is NaN.
    #[inline(always)]
    pub fn gt(self, other: impl IntoF32<L>) -> Mask<L> {
        let (a, b) = (self, other.into_f32(self.token()));
        lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> Mask<L> = Mask(a.0.simd_gt(b.0)))
    }

    /// Per lane `self >= other`; false where either is NaN.
    #[inline(always)]
    pub fn ge(self, other: impl IntoF32<L>) -> Mask<L> {
        let (a, b) = (self, other.into_f32(self.token()));
        lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> Mask<L> = Mask(a.0.simd_ge(b.0)))
    }

    /// Per lane `self == other`; false where either is NaN.
    #[inline(always)]
    pub fn eq(self, other: impl IntoF32<L>) -> Mask<L> {
        let (a, b) = (self, other.into_f32(self.token()));
        lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> Mask<L> = Mask(a.0.simd_eq(b.0)))
    }

    /// `self + t * (other - self)`: `self` at 0.
    #[inline(always)]
    pub fn mix(self, other: Self, t: Self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>, other: F32<L>, t: F32<L>) -> F32<L> = a + t * (other - a))
    }

    /// The smallest of the lanes; they must not hold NaN (the order then does not matter).
    #[inline(always)]
    pub(crate) fn smallest_lane(self) -> f32 {
        let v = self.to_array();
        let mut a: [f32; 8] = [0.0; 8];
        for (i, a) in a.iter_mut().enumerate() {
            *a = if v[i] < v[i + 8] { v[i] } else { v[i + 8] };
        }
        for half in [4, 2, 1] {
            for i in 0..half {
                a[i] = if a[i] < a[i + half] { a[i] } else { a[i + half] };
            }
        }
        a[0]
    }
}

/// True where the hardware's minimum and maximum are compare-and-select (x86 `minps`: the second operand wins ties
/// and NaN).
#[inline(always)]
fn has_select_min<L: Lanes>(l: L) -> bool {
    cfg!(any(target_arch = "x86", target_arch = "x86_64")) && !l.level().is_fallback()
}

/// A float operand: lanes, or one value for all lanes.
pub trait IntoF32<L: Lanes> {
    /// The operand in every lane.
    fn into_f32(self, l: L) -> F32<L>;
}

impl<L: Lanes> IntoF32<L> for F32<L> {
    #[inline(always)]
    fn into_f32(self, _: L) -> F32<L> {
        self
    }
}

impl<L: Lanes> IntoF32<L> for f32 {
    #[inline(always)]
    fn into_f32(self, l: L) -> F32<L> {
        l.f32(self)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $symbol:tt) => {
        impl<L: Lanes> $trait for F32<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, rhs: Self) -> Self {
                let (a, b) = (self, rhs);
                lane_op!(a.token(), (a: F32<L>, b: F32<L>) -> F32<L> = F32(a.0 $symbol b.0))
            }
        }

        impl<L: Lanes> $trait<f32> for F32<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, rhs: f32) -> Self {
                $trait::$method(self, self.token().f32(rhs))
            }
        }

        impl<L: Lanes> $trait<F32<L>> for f32 {
            type Output = F32<L>;
            #[inline(always)]
            fn $method(self, rhs: F32<L>) -> F32<L> {
                $trait::$method(rhs.token().f32(self), rhs)
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);
operator!(Div, div, /);

impl<L: Lanes> Neg for F32<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: F32<L>) -> F32<L> = F32(-a.0))
    }
}

impl<L: Lanes> AddAssign for F32<L> {
    #[inline(always)]
    fn add_assign(&mut self, rhs: Self) {
        *self = *self + rhs;
    }
}

impl<L: Lanes> SubAssign for F32<L> {
    #[inline(always)]
    fn sub_assign(&mut self, rhs: Self) {
        *self = *self - rhs;
    }
}

impl<L: Lanes> MulAssign for F32<L> {
    #[inline(always)]
    fn mul_assign(&mut self, rhs: Self) {
        *self = *self * rhs;
    }
}
