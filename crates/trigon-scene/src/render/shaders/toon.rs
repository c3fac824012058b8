//! Toon shading: light in a few flat steps, as a painter of cartoons lays it on.
//!
//! In: a surface under its lights. Out: its diffuse colour, times one of a few brightnesses; highlights are there or not.
//! What is rounded is the whole light, shadows included, in steps that look equally far apart: its square root, which is
//! close to how displays encode light. (Decaudin, "Cartoon-Looking Rendering of 3D-Scenes", 1996.)

use super::blinn_phong::Lit;
use super::lighting::{Reflected, reflect};
use super::maps::Factors;
use super::obstacles::{Effects, Obstacles};
use super::point::SurfacePoint;
use crate::render::material::Slot;
use crate::scene::Illumination;
use trigon::lanes::{F32, Lanes, Rgba, Vec3};

impl Lit<'_> {
    /// Linear colours, premultiplied.
    #[inline(never)]
    pub(super) fn shade_toon<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, effects: &Effects<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.shade_toon_inline(l, point, effects),
        )
    }

    #[inline(always)]
    fn shade_toon_inline<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, effects: &Effects<L>) -> Rgba<L> {
        let surface = self.surface;
        let factors = Factors::read(l, &surface.maps, &point.footprint);
        let diffuse = (l.vec3(surface.diffuse) * factors.get(Slot::Diffuse).rgb()) * point.color.xyz();
        let mut other = l.vec3(surface.emissive) * factors.get(Slot::Emissive).rgb();
        let normal = self.normals.normal(l, point);
        let cos_eye = normal.dot(point.to_eye);
        if self.illumination == Illumination::Color {
            return surface.combine(l, &factors, point.color, cos_eye, diffuse, other);
        }
        let lighting = &self.frame.lighting;
        let shines = self.illumination == Illumination::Specular && surface.specular != [0.0; 3];
        let exponent = if shines { Some(factors.get(Slot::Exponent).r * surface.exponent) } else { None };
        let Reflected { diffuse: mut light, specular } = reflect(l, lighting, effects, point, normal, exponent);
        // Painters know one light: that from all around is part of it.
        light += effects.dim(l, l.vec3(lighting.ambient));
        let brightness = luminance(light).max(1e-6);
        let root = brightness.sqrt();
        let step = stepped(l, root, self.frame.toon_levels);
        l.note("brightness", brightness);
        l.note("its step", step * step);
        if shines {
            let highlight = rise(luminance(specular), l.f32(0.5));
            other += (l.vec3(surface.specular) * factors.get(Slot::Specular).rgb()) * highlight;
        }
        surface.combine(l, &factors, point.color, cos_eye, diffuse * (light * ((step * step) / brightness)), other)
    }
}

/// `value` rounded up to the next of `levels` equal steps to 1, with a short ramp from each to the next.
#[inline(always)]
fn stepped<L: Lanes>(l: L, value: F32<L>, levels: u32) -> F32<L> {
    if levels < 2 {
        return l.f32(1.0);
    }
    let scaled = value * levels as f32;
    // The nearest edge between two steps; those below are passed.
    let edge = (scaled + 0.5).floor().clamp(1.0, (levels - 1) as f32);
    (edge + rise(scaled, edge)) * (1.0 / levels as f32)
}

/// 0 below `edge`, 1 above it.
#[inline(always)]
fn rise<L: Lanes>(value: F32<L>, edge: F32<L>) -> F32<L> {
    /// Wide enough to be smooth, narrow enough to look like an edge.
    const WIDTH: f32 = 0.05;
    let t = ((value - (edge - 0.5 * WIDTH)) * (1.0 / WIDTH)).saturate();
    (t * t) * (3.0 - 2.0 * t)
}

#[inline(always)]
fn luminance<L: Lanes>(c: Vec3<L>) -> F32<L> {
    (c.x * 0.2126 + c.y * 0.7152) + c.z * 0.0722
}
