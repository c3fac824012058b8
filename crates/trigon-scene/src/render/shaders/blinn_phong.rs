//! Materials under the lights, as the MTL specification's `illum` 0, 1 and 2 define it.
//!
//! 0: Kd. 1: Ka Ia + Kd sum(N.L I). 2: that + Ks sum((N.H)^Ns I). Ke is added to each; vertex colours multiply Ka and Kd.
//! Flat and unlit drawing are this shader with another normal and without light.

use super::lighting::{Reflected, reflect};
use super::maps::{Factors, Footprint};
use super::normal::NormalSource;
use super::obstacles::{Effects, Nothing, Obstacles};
use super::point::{SurfacePoint, footprint};
use super::vertex::{Attributes, Layout, MeshView};
use crate::render::frame::FrameUniforms;
use crate::render::material::{Coverage, Slot, Surface};
use crate::render::shader_kind::ShaderKind;
use crate::scene::Illumination;
use std::marker::PhantomData;
use trigon::lanes::{F32, Lanes, Mask, Rgba, U32, Vec3, Vec4};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws one material on one mesh.
pub(in crate::render) struct BlinnPhong<'a, A> {
    pub(super) frame: &'a FrameUniforms,
    pub(super) mesh: MeshView<'a>,
    pub(super) surface: &'a Surface<'a>,
    normals: NormalSource<'a>,
    illumination: Illumination,
    /// Whether light can be dimmed on its way, or is painted in steps.
    has_effects: bool,
    is_toon: bool,
    layout: PhantomData<A>,
}

impl<'a, A: Layout> BlinnPhong<'a, A> {
    /// `is_flat`: with the triangles' own normals; `is_point`: for primitives without a plane; not `is_lit`: with its
    /// colour alone.
    pub(in crate::render) fn new(
        frame: &'a FrameUniforms,
        mesh: MeshView<'a>,
        surface: &'a Surface<'a>,
        is_flat: bool,
        is_point: bool,
        is_lit: bool,
    ) -> Self {
        let normals = NormalSource {
            is_flat: is_flat || mesh.normals.is_empty(),
            is_point,
            has_tangents: surface.has_tangents() && !mesh.tangents.is_empty(),
            normal: surface.normal.as_ref(),
            bump: surface.bump.as_ref(),
        };
        let illumination = if is_lit { surface.illumination } else { Illumination::Color };
        let has_effects = frame.has_effects();
        let is_toon = frame.shader == ShaderKind::Toon;
        Self { frame, mesh, surface, normals, illumination, has_effects, is_toon, layout: PhantomData }
    }

    #[inline(always)]
    pub(super) fn point<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> SurfacePoint<L> {
        SurfacePoint::new(l, self.frame, f)
    }

    /// The shading normal.
    #[inline(always)]
    pub(super) fn normal<L: Lanes>(&self, l: L, point: &SurfacePoint<L>) -> Vec3<L> {
        self.normals.normal(l, point)
    }

    #[inline(always)]
    fn material(&self) -> Lit<'_> {
        Lit { frame: self.frame, surface: self.surface, normals: &self.normals, illumination: self.illumination }
    }
}

impl<A: Layout> Shader for BlinnPhong<'_, A> {
    type Varying<L: Lanes> = A::Varying<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, A::Varying<L>> {
        self.mesh.vertex::<L, A>(l, index)
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Rgba<L> {
        let point = self.point(l, f);
        if !self.has_effects {
            return self.material().shade(l, &point);
        }
        let effects = Effects::new(l, self.frame.occlusion.as_ref(), f.pixel, &point);
        if self.is_toon {
            self.material().shade_toon(l, &point, &effects)
        } else {
            self.material().shade_in(l, &point, &effects)
        }
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Mask<L> {
        self.surface.is_kept(l, &footprint(f), f.color(l).w)
    }

    fn discards(&self) -> bool {
        self.surface.coverage == Coverage::CutOut
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> SurfaceLanes<L> {
        let point = self.point(l, f);
        SurfaceLanes { position: point.position, normal: self.normal(l, &point), uv: f.uv() }
    }
}

/// A surface under the light of a frame.
pub(super) struct Lit<'a> {
    pub(super) frame: &'a FrameUniforms,
    pub(super) surface: &'a Surface<'a>,
    pub(super) normals: &'a NormalSource<'a>,
    pub(super) illumination: Illumination,
}

impl Lit<'_> {
    /// Linear colours, premultiplied.
    #[inline(never)]
    fn shade<L: Lanes>(&self, l: L, point: &SurfacePoint<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.shade_inline(l, point, &Nothing),
        )
    }

    /// The same in frames with effects: a copy of the code, so that the plain one asks for nothing.
    #[inline(never)]
    fn shade_in<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, effects: &Effects<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.shade_inline(l, point, effects),
        )
    }

    #[inline(always)]
    fn shade_inline<L: Lanes, O: Obstacles<L>>(&self, l: L, point: &SurfacePoint<L>, obstacles: &O) -> Rgba<L> {
        let surface = self.surface;
        let factors = Factors::read(l, &surface.maps, &point.footprint);
        l.note_topic("surface", None);
        let color = point.color.xyz();
        let diffuse = (l.vec3(surface.diffuse) * factors.get(Slot::Diffuse).rgb()) * color;
        l.note("vertex colour", point.color);
        l.note("diffuse reflectance", diffuse);
        let mut other = l.vec3([0.0; 3]);
        if surface.emissive != [0.0; 3] {
            other = l.vec3(surface.emissive) * factors.get(Slot::Emissive).rgb();
            l.note("emitted light", other);
        }
        if self.illumination == Illumination::Color && !surface.is_halo {
            return surface.combine(l, &factors, point.color, l.f32(1.0), diffuse, other);
        }
        let normal = self.normals.normal(l, point);
        let cos_eye = normal.dot(point.to_eye);
        l.note("shading normal N", normal);
        l.note("unit vector to the eye V", point.to_eye);
        l.note("N.V", cos_eye);
        if self.illumination == Illumination::Color {
            return surface.combine(l, &factors, point.color, cos_eye, diffuse, other);
        }
        let lighting = &self.frame.lighting;
        if lighting.ambient != [0.0; 3] {
            let ambient = (l.vec3(surface.ambient) * factors.get(Slot::Ambient).rgb()) * color;
            let ambient_light = ambient * obstacles.dim(l, l.vec3(lighting.ambient));
            other += ambient_light;
            l.note("ambient light", ambient_light);
        }
        let shines = self.illumination == Illumination::Specular && surface.specular != [0.0; 3];
        let exponent = if shines { Some(factors.get(Slot::Exponent).r * surface.exponent) } else { None };
        let Reflected { diffuse: diffuse_light, specular } = reflect(l, lighting, obstacles, point, normal, exponent);
        l.note_topic("sum", None);
        l.note("diffuse light of all lights", diffuse_light);
        l.note("diffuse term", diffuse * diffuse_light);
        if shines {
            let reflectance = l.vec3(surface.specular) * factors.get(Slot::Specular).rgb();
            other += reflectance * specular;
            l.note("highlights of all lights", specular);
            l.note("specular reflectance", reflectance);
            l.note("specular term", reflectance * specular);
        }
        l.note("ambient, emitted and specular", other);
        surface.combine(l, &factors, point.color, cos_eye, diffuse * diffuse_light, other)
    }
}

impl Surface<'_> {
    /// The diffuse and all other light that leaves the surface, weighed by opacity.
    #[inline(always)]
    pub(super) fn combine<L: Lanes>(
        &self,
        l: L,
        factors: &Factors<L>,
        vertex_color: Vec4<L>,
        cos_eye: F32<L>,
        diffuse: Vec3<L>,
        other: Vec3<L>,
    ) -> Rgba<L> {
        match self.coverage {
            Coverage::Opaque => (diffuse + other).rgba(1.0),
            // The diffuse map is premultiplied; what is kept counts as opaque.
            Coverage::CutOut => (diffuse / factors.get(Slot::Diffuse).a.max(1.0 / 512.0) + other).rgba(1.0),
            Coverage::Blend => {
                let mut opacity = l.f32(self.opacity);
                if self.is_halo {
                    opacity = 1.0 - cos_eye.saturate() * (1.0 - opacity);
                }
                opacity = (opacity * factors.get(Slot::Opacity).r) * vertex_color.w;
                let alpha = opacity * factors.get(Slot::Diffuse).a;
                l.note("opacity", alpha);
                (diffuse * opacity + other * alpha).rgba(alpha)
            }
        }
    }

    /// Fragments that are at least half opaque.
    #[inline(never)]
    pub(super) fn is_kept<L: Lanes>(&self, l: L, footprint: &Footprint<L>, vertex_alpha: F32<L>) -> Mask<L> {
        l.vectorize(
            #[inline(always)]
            || {
                let factors = Factors::read(l, &self.opacity_maps, footprint);
                let opacity = (factors.opacity() * self.opacity) * vertex_alpha;
                l.note("opacity, kept from 0.5 on", opacity);
                opacity.ge(0.5)
            },
        )
    }
}
