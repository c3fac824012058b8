//! From texture coordinates to texels of one level: wrapping, the two neighbours along an axis, their weights.
//!
//! In: one coordinate of sixteen points, the size of their level along it. Out: columns or rows, always inside the
//! level, whatever the coordinate is (NaN and infinities count as some point of the image, or as outside with a border).

use super::sampler::Wrap;
use crate::lanes::{F32, I32, Lanes, Mask};

/// The texels along one axis between whose centres a point lies.
#[derive(Clone, Copy)]
pub(super) struct Neighbours<L: Lanes> {
    pub(super) texels: [I32<L>; 2],
    /// The weight of the second one, 0 to 1; that of the first is the rest.
    pub(super) weight: F32<L>,
    /// False where the border colour stands in for the texel; only meaningful for [`Wrap::Border`].
    pub(super) inside: [Mask<L>; 2],
}

/// The two texels around coordinate `t` of an axis with `size` texels.
#[inline(always)]
pub(super) fn bilinear<L: Lanes>(l: L, wrap: Wrap, t: F32<L>, size: I32<L>) -> Neighbours<L> {
    let (zero, one) = (l.i32(0), l.i32(1));
    let extent = size.to_f32();
    // Texel centres lie at halves, so the first neighbour of t * size is the texel of half a texel less.
    let position = match wrap {
        Wrap::Repeat => repeat(t) * extent - 0.5,
        Wrap::Mirror => mirror(t) * extent - 0.5,
        Wrap::ClampToEdge => t.saturate() * extent - 0.5,
        Wrap::Border(_) => (t * extent - 0.5).max(-1.0).min(extent),
    };
    let below = position.floor();
    let weight = position - below;
    let first = below.to_i32_in_range();
    let second = first + one;
    let last = size - one;
    match wrap {
        Wrap::Repeat => Neighbours {
            texels: [first + (size & (first >> 31)), last.lt(second).select(zero, second)],
            weight,
            inside: [l.mask(true); 2],
        },
        Wrap::Mirror | Wrap::ClampToEdge => {
            Neighbours { texels: [first.max(zero), second.min(last)], weight, inside: [l.mask(true); 2] }
        }
        Wrap::Border(_) => Neighbours {
            texels: [first.max(zero).min(last), second.max(zero).min(last)],
            weight,
            inside: [first.ge(zero) & first.lt(size), second.lt(size)],
        },
    }
}

/// The texel that holds coordinate `t`, and whether it is one of the image (else the border colour stands in for it).
#[inline(always)]
pub(super) fn nearest<L: Lanes>(l: L, wrap: Wrap, t: F32<L>, size: I32<L>) -> (I32<L>, Mask<L>) {
    let extent = size.to_f32();
    let last = size - l.i32(1);
    let position = match wrap {
        Wrap::Repeat => repeat(t) * extent,
        Wrap::Mirror => mirror(t) * extent,
        Wrap::ClampToEdge => t.saturate() * extent,
        Wrap::Border(_) => {
            let texel = (t * extent).floor().max(-1.0).min(extent).to_i32_in_range();
            let inside = texel.ge(l.i32(0)) & texel.lt(size);
            return (texel.max(l.i32(0)).min(last), inside);
        }
    };
    // Truncation is the floor here; what was rounded up to the far edge belongs to the last texel.
    (position.to_i32_in_range().min(last), l.mask(true))
}

/// The fraction, 0 to 1; 1 only by rounding, or for NaN and infinities.
#[inline(always)]
fn repeat<L: Lanes>(t: F32<L>) -> F32<L> {
    // NaN fails the comparison of `min`.
    (t - t.floor()).min(1.0)
}

/// Up from 0 to 1, down again, and so on; 0 to 1 for any `t`.
#[inline(always)]
fn mirror<L: Lanes>(t: F32<L>) -> F32<L> {
    let period = (t - 2.0 * (0.5 * t).floor()).min(2.0);
    period.min(2.0 - period)
}
