//! Truth values per lane: the result of comparisons and the choice between two lane values.

use super::plain::lane_op;
use super::{F32, I32, LANES, Lanes, U32};
use core::ops::{BitAnd, BitAndAssign, BitOr, BitOrAssign, Not};
use fearless_simd::{Select, SimdMask, mask32x16};

/// Sixteen truth values.
#[derive(Clone, Copy)]
pub struct Mask<L: Lanes>(pub(super) mask32x16<L>);

impl<L: Lanes> Mask<L> {
    /// Bit `i` is lane `i`.
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "sixteen lanes give sixteen bits")]
    pub fn bits(self) -> u16 {
        let a = self;
        lane_op!(a.token(), (a: Mask<L>) -> u16 = a.0.to_bitmask() as u16)
    }

    #[inline(always)]
    fn token(self) -> L {
        fearless_simd::ExtractToken::token(&self.0)
    }

    /// True if any lane is.
    #[inline(always)]
    pub fn any(self) -> bool {
        let a = self;
        lane_op!(a.token(), (a: Mask<L>) -> bool = a.0.any_true())
    }

    /// True if every lane is.
    #[inline(always)]
    pub fn all(self) -> bool {
        let a = self;
        lane_op!(a.token(), (a: Mask<L>) -> bool = a.0.all_true())
    }

    /// Per lane: `yes` where true, `no` where false.
    #[inline(always)]
    pub fn select<T: Selectable<L>>(self, yes: T, no: T) -> T {
        T::select(self, yes, no)
    }

    /// The lanes of `values` where true, packed at the front; zero behind them.
    #[inline(always)]
    pub(crate) fn pack(self, values: U32<L>) -> U32<L> {
        let (l, mask) = (values.token(), self);
        lane_op!(l, (l: L, values: U32<L>, mask: Mask<L>) -> U32<L> = U32(l.compress_u32x16(values.0, mask.0)))
    }

    /// One truth value per lane.
    #[inline(always)]
    pub fn to_array(self) -> [bool; LANES] {
        let bits = self.bits();
        core::array::from_fn(
            #[inline(always)]
            |i| bits >> i & 1 == 1,
        )
    }
}

/// A lane value that a [`Mask`] can choose between.
pub trait Selectable<L: Lanes>: Sized {
    /// Per lane: `yes` where `mask` is true, `no` where it is false.
    fn select(mask: Mask<L>, yes: Self, no: Self) -> Self;
}

impl<L: Lanes> Selectable<L> for F32<L> {
    #[inline(always)]
    fn select(mask: Mask<L>, yes: Self, no: Self) -> Self {
        lane_op!(yes.token(), (mask: Mask<L>, yes: F32<L>, no: F32<L>) -> F32<L> = F32(mask.0.select(yes.0, no.0)))
    }
}

impl<L: Lanes> Selectable<L> for I32<L> {
    #[inline(always)]
    fn select(mask: Mask<L>, yes: Self, no: Self) -> Self {
        lane_op!(yes.token(), (mask: Mask<L>, yes: I32<L>, no: I32<L>) -> I32<L> = I32(mask.0.select(yes.0, no.0)))
    }
}

impl<L: Lanes> Selectable<L> for U32<L> {
    #[inline(always)]
    fn select(mask: Mask<L>, yes: Self, no: Self) -> Self {
        lane_op!(yes.token(), (mask: Mask<L>, yes: U32<L>, no: U32<L>) -> U32<L> = U32(mask.0.select(yes.0, no.0)))
    }
}

impl<L: Lanes> BitAnd for Mask<L> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, rhs: Self) -> Self {
        let (a, b) = (self, rhs);
        lane_op!(a.token(), (a: Mask<L>, b: Mask<L>) -> Mask<L> = Mask(a.0 & b.0))
    }
}

impl<L: Lanes> BitOr for Mask<L> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, rhs: Self) -> Self {
        let (a, b) = (self, rhs);
        lane_op!(a.token(), (a: Mask<L>, b: Mask<L>) -> Mask<L> = Mask(a.0 | b.0))
    }
}

impl<L: Lanes> BitAndAssign for Mask<L> {
    #[inline(always)]
    fn bitand_assign(&mut self, rhs: Self) {
        *self = *self & rhs;
    }
}

impl<L: Lanes> BitOrAssign for Mask<L> {
    #[inline(always)]
    fn bitor_assign(&mut self, rhs: Self) {
        *self = *self | rhs;
    }
}

impl<L: Lanes> Not for Mask<L> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        let a = self;
        lane_op!(a.token(), (a: Mask<L>) -> Mask<L> = Mask(!a.0))
    }
}
