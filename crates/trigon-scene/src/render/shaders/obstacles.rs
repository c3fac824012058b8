//! What keeps light from a surface: nothing, or the shadows of what stands in its way.
//!
//! In: a source and sixteen points. Out: how much of its light arrives. A trait with a type for "nothing", so that
//! frames without shadows are drawn by code that knows of none.

use super::point::SurfacePoint;
use crate::render::lights::Source;
use trigon::lanes::{F32, Lanes, Vec3};

/// What is in the way of light.
pub(super) trait Obstacles<L: Lanes> {
    /// The part of `strength` that gets from `source` to `point`. `cosine` is that of the angle to the normal: where it
    /// is not positive nothing is asked, as the light does not count there.
    fn pass(
        &self,
        l: L,
        source: &Source,
        point: &SurfacePoint<L>,
        to_light: Vec3<L>,
        cosine: F32<L>,
        strength: F32<L>,
    ) -> F32<L>;
}

/// Nothing is in the way.
pub(super) struct Nothing;

/// The shadow maps of the sources say what is.
pub(super) struct Shadowed;

impl<L: Lanes> Obstacles<L> for Nothing {
    #[inline(always)]
    fn pass(&self, _: L, _: &Source, _: &SurfacePoint<L>, _: Vec3<L>, _: F32<L>, strength: F32<L>) -> F32<L> {
        strength
    }
}

impl<L: Lanes> Obstacles<L> for Shadowed {
    #[inline(always)]
    fn pass(
        &self,
        l: L,
        source: &Source,
        point: &SurfacePoint<L>,
        to_light: Vec3<L>,
        cosine: F32<L>,
        strength: F32<L>,
    ) -> F32<L> {
        let Some(map) = &source.shadow else { return strength };
        if !(cosine.gt(0.0) & strength.gt(0.0)).any() {
            return strength;
        }
        strength * map.visibility(l, point, source.place, to_light)
    }
}
