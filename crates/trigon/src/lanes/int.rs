//! Sixteen `i32` or `u32` values; arithmetic wraps on every target.

use super::plain::lane_op;
use super::{F32, LANES, Lanes, Mask};
use core::ops::{Add, AddAssign, BitAnd, BitOr, BitXor, Mul, Neg, Shl, Shr, Sub};
use fearless_simd::{Bytes, SimdBase, SimdInt, i32x16, u32x16};

/// Sixteen `i32` values.
#[derive(Clone, Copy)]
pub struct I32<L: Lanes>(pub(super) i32x16<L>);

/// Sixteen `u32` values.
#[derive(Clone, Copy)]
pub struct U32<L: Lanes>(pub(super) u32x16<L>);

macro_rules! integer {
    ($name:ident, $scalar:ident) => {
        impl<L: Lanes> $name<L> {
            /// The token of these lanes' level.
            #[inline(always)]
            pub fn token(self) -> L {
                fearless_simd::ExtractToken::token(&self.0)
            }

            /// The values, lane 0 first.
            #[inline(always)]
            pub fn to_array(self) -> [$scalar; LANES] {
                self.0.to_array()
            }

            /// Writes the values to `out`, lane 0 first.
            #[inline(always)]
            pub fn store(self, out: &mut [$scalar; LANES]) {
                self.0.store_array(out);
            }

            /// The smaller of the two, per lane.
            #[inline(always)]
            pub fn min(self, other: Self) -> Self {
                let (a, b) = (self, other);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> $name<L> = $name(a.0.min(b.0)))
            }

            /// The larger of the two, per lane.
            #[inline(always)]
            pub fn max(self, other: Self) -> Self {
                let (a, b) = (self, other);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> $name<L> = $name(a.0.max(b.0)))
            }

            /// Per lane `self < other`.
            #[inline(always)]
            pub fn lt(self, other: Self) -> Mask<L> {
                let (a, b) = (self, other);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> Mask<L> = Mask(a.0.simd_lt(b.0)))
            }

            /// Per lane `self >= other`.
            #[inline(always)]
            pub fn ge(self, other: Self) -> Mask<L> {
                let (a, b) = (self, other);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> Mask<L> = Mask(a.0.simd_ge(b.0)))
            }

            /// Per lane `self == other`.
            #[inline(always)]
            pub fn eq(self, other: Self) -> Mask<L> {
                let (a, b) = (self, other);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> Mask<L> = Mask(a.0.simd_eq(b.0)))
            }

            /// The nearest floats; exact up to 2^24.
            #[inline(always)]
            pub fn to_f32(self) -> F32<L> {
                let a = self;
                lane_op!(a.token(), (a: $name<L>) -> F32<L> = F32(a.0.to_float()))
            }

            /// Shifts each lane left by its own count, 0..32.
            #[inline(always)]
            pub fn shl_lanes(self, counts: Self) -> Self {
                let (a, b) = (self, counts);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> $name<L> = $name(a.0 << b.0))
            }

            /// Shifts each lane right by its own count, 0..32.
            #[inline(always)]
            pub fn shr_lanes(self, counts: Self) -> Self {
                let (a, b) = (self, counts);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> $name<L> = $name(a.0 >> b.0))
            }
        }

        integer!(@op $name, Add, add, +);
        integer!(@op $name, Sub, sub, -);
        integer!(@op $name, Mul, mul, *);
        integer!(@op $name, BitAnd, bitand, &);
        integer!(@op $name, BitOr, bitor, |);
        integer!(@op $name, BitXor, bitxor, ^);

        impl<L: Lanes> AddAssign for $name<L> {
            #[inline(always)]
            fn add_assign(&mut self, rhs: Self) {
                *self = *self + rhs;
            }
        }

        impl<L: Lanes> Shl<u32> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn shl(self, bits: u32) -> Self {
                let a = self;
                lane_op!(a.token(), (a: $name<L>, bits: u32) -> $name<L> = $name(a.0 << bits))
            }
        }

        impl<L: Lanes> Shr<u32> for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn shr(self, bits: u32) -> Self {
                let a = self;
                lane_op!(a.token(), (a: $name<L>, bits: u32) -> $name<L> = $name(a.0 >> bits))
            }
        }
    };
    (@op $name:ident, $trait:ident, $method:ident, $symbol:tt) => {
        impl<L: Lanes> $trait for $name<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, rhs: Self) -> Self {
                let (a, b) = (self, rhs);
                lane_op!(a.token(), (a: $name<L>, b: $name<L>) -> $name<L> = $name(a.0 $symbol b.0))
            }
        }
    };
}

integer!(I32, i32);
integer!(U32, u32);

impl<L: Lanes> I32<L> {
    /// The same bits, read as unsigned.
    #[inline(always)]
    pub fn as_u32(self) -> U32<L> {
        let a = self;
        lane_op!(a.token(), (a: I32<L>) -> U32<L> = U32(a.0.bitcast()))
    }
}

impl<L: Lanes> U32<L> {
    /// The same bits, read as signed.
    #[inline(always)]
    pub fn as_i32(self) -> I32<L> {
        let a = self;
        lane_op!(a.token(), (a: U32<L>) -> I32<L> = I32(a.0.bitcast()))
    }

    /// The floats with these bit patterns.
    #[inline(always)]
    pub fn as_f32_bits(self) -> F32<L> {
        let a = self;
        lane_op!(a.token(), (a: U32<L>) -> F32<L> = F32(a.0.bitcast()))
    }
}

impl<L: Lanes> Neg for I32<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: I32<L>) -> I32<L> = I32(-a.0))
    }
}
