//! What keeps light from a surface: nothing, or what stands in its way.
//!
//! In: light and sixteen points. Out: how much of it arrives. A trait with a type for "nothing", so that frames without
//! effects are drawn by code that knows of none.

use super::point::SurfacePoint;
use crate::render::lights::Source;
use crate::render::occlusion::OcclusionMap;
use trigon::lanes::{F32, Lanes, Vec2, Vec3};

/// What is in the way of light.
pub(super) trait Obstacles<L: Lanes> {
    /// The part of `strength` that gets from `source` to `point`. `cosine` is that of the angle to the normal: where it
    /// is not positive the light does not count, and all of `strength` is returned.
    fn pass(
        &self,
        l: L,
        source: &Source,
        point: &SurfacePoint<L>,
        to_light: Vec3<L>,
        cosine: F32<L>,
        strength: F32<L>,
    ) -> F32<L>;

    /// What arrives of `light` that comes from all around.
    fn dim(&self, l: L, light: Vec3<L>) -> Vec3<L>;
}

/// Nothing is in the way.
pub(super) struct Nothing;

/// Shadow maps of the sources, and the occlusion of sixteen points.
pub(super) struct Effects<L: Lanes> {
    /// The part of the surroundings that the points can see, if it is known.
    openness: Option<F32<L>>,
}

impl<L: Lanes> Effects<L> {
    /// For fragments in `pixel`.
    #[inline(always)]
    pub(super) fn new(l: L, occlusion: Option<&OcclusionMap>, pixel: Vec2<L>, point: &SurfacePoint<L>) -> Self {
        match occlusion {
            Some(map) => {
                let openness = map.openness(l, pixel, point.position);
                l.note("openness", openness);
                Self { openness: Some(openness) }
            }
            None => Self { openness: None },
        }
    }
}

impl<L: Lanes> Obstacles<L> for Nothing {
    #[inline(always)]
    fn pass(&self, _: L, _: &Source, _: &SurfacePoint<L>, _: Vec3<L>, _: F32<L>, strength: F32<L>) -> F32<L> {
        strength
    }

    #[inline(always)]
    fn dim(&self, _: L, light: Vec3<L>) -> Vec3<L> {
        light
    }
}

impl<L: Lanes> Obstacles<L> for Effects<L> {
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
        // By lane: what a fragment gets must not depend on its neighbours.
        let counts = cosine.gt(0.0) & strength.gt(0.0);
        if !counts.any() {
            return strength;
        }
        let visibility = map.visibility(l, point, source.place, to_light);
        l.note("part that the shadow map lets through", visibility);
        counts.select(strength * visibility, strength)
    }

    #[inline(always)]
    fn dim(&self, _: L, light: Vec3<L>) -> Vec3<L> {
        match self.openness {
            Some(openness) => light * openness,
            None => light,
        }
    }
}
