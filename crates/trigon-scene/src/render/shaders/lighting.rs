//! Light on a surface: positions and normals in, diffuse and specular light out.
//!
//! Diffuse is Lambert's cosine, specular is Blinn's: the cosine between the normal and the half vector, to the power of
//! the exponent, on the lit side only. With unit vectors N.H = (N.L + N.V) / sqrt(2 + 2 L.V), so that no half vector
//! has to be made.

use super::obstacles::Obstacles;
use super::point::SurfacePoint;
use crate::render::lights::{Lighting, Sky, Source};
use trigon::lanes::{F32, Lanes, Vec3};
use trigon::math::{exp2, log2};

/// Light that a surface sends on, before its reflectances.
pub(super) struct Reflected<L: Lanes> {
    pub(super) diffuse: Vec3<L>,
    pub(super) specular: Vec3<L>,
}

/// Light from the sky and all sources, as far as `obstacles` let it; `exponent` is that of highlights, if there are any.
#[inline(always)]
pub(super) fn reflect<L: Lanes, O: Obstacles<L>>(
    l: L,
    lighting: &Lighting,
    obstacles: &O,
    point: &SurfacePoint<L>,
    normal: Vec3<L>,
    exponent: Option<F32<L>>,
) -> Reflected<L> {
    let black = l.vec3([0.0; 3]);
    let mut sum = Reflected { diffuse: black, specular: black };
    if let Some(sky) = &lighting.sky {
        sum.diffuse = obstacles.dim(l, sky.light(l, normal));
        l.note_topic("sky", None);
        l.note("diffuse light", sum.diffuse);
    }
    let cos_eye = normal.dot(point.to_eye);
    for (number, source) in (0..).zip(&lighting.sources) {
        let (to_light, strength) = source.reach(l, point.position);
        let cosine = normal.dot(to_light);
        let strength = obstacles.pass(l, source, point, to_light, cosine, strength);
        let lit = cosine.max(0.0) * strength;
        sum.diffuse += l.vec3(source.color) * lit;
        l.note_topic("light", Some(number));
        l.note("unit vector to the light L", to_light);
        l.note("strength at the surface", strength);
        l.note("N.L", cosine);
        l.note("diffuse light", l.vec3(source.color) * lit);
        let Some(exponent) = exponent else { continue };
        if !source.has_highlight || !cosine.gt(0.0).any() {
            continue;
        }
        let along = to_light.dot(point.to_eye);
        let toward_half = (cosine + cos_eye).max(0.0);
        // The square of N.H; where light and view are opposite there is no half vector, and no highlight.
        let squared = (toward_half * toward_half) / (2.0 * along + 2.0).max(1e-6);
        let power = exp2(log2(squared.min(1.0)) * (exponent * 0.5));
        let highlight = cosine.gt(0.0).select(power * strength, l.f32(0.0));
        sum.specular += l.vec3(source.color) * highlight;
        l.note("(N.H)^2", squared);
        l.note("exponent", exponent);
        l.note("highlight", l.vec3(source.color) * highlight);
    }
    sum
}

impl Sky {
    #[inline(always)]
    fn light<L: Lanes>(&self, l: L, normal: Vec3<L>) -> Vec3<L> {
        l.vec3(self.mean) + l.vec3(self.slope) * normal.dot(l.vec3(self.up))
    }
}

impl Source {
    /// The unit vector to the light, and how much of it arrives.
    #[inline(always)]
    pub(super) fn reach<L: Lanes>(&self, l: L, position: Vec3<L>) -> (Vec3<L>, F32<L>) {
        let place = l.vec3(self.place);
        if self.is_directional {
            return (place, l.f32(1.0));
        }
        let to_light = place - position;
        let inverse = 1.0 / to_light.dot(to_light).max(1e-12).sqrt();
        let to_light = to_light * inverse;
        let mut strength = inverse * inverse;
        if let Some(cone) = &self.cone {
            let cosine = -to_light.dot(l.vec3(cone.axis));
            let t = ((cosine - l.f32(cone.cos_outer)) * cone.inverse_range).saturate();
            // Smooth at both ends.
            strength *= (t * t) * (3.0 - 2.0 * t);
        }
        (to_light, strength)
    }
}
