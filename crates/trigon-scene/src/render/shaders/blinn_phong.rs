//! Materials under the lights, as the MTL specification's `illum` 0, 1 and 2 define it.
//!
//! 0: Kd. 1: Ka Ia + Kd sum(N.L I). 2: that + Ks sum((N.H)^Ns I). Ke is added to each; vertex colours multiply Ka and Kd.
//! Flat and unlit drawing are this shader with another normal and without light.

use super::lighting::{LitPoint, Reflected, reflect};
use super::maps::{Factors, Footprint};
use super::normal::NormalSource;
use super::vertex::{Attributes, Layout, MeshView};
use crate::render::frame::FrameUniforms;
use crate::render::material::{Coverage, Slot, Surface};
use crate::scene::Illumination;
use std::marker::PhantomData;
use trigon::lanes::{F32, Lanes, Mask, Rgba, U32, Vec3};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws one material on one mesh.
pub(in crate::render) struct BlinnPhong<'a, A> {
    pub(super) frame: &'a FrameUniforms,
    pub(super) mesh: MeshView<'a>,
    pub(super) surface: &'a Surface<'a>,
    pub(super) normals: NormalSource<'a>,
    illumination: Illumination,
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
            has_tangents: !mesh.tangents.is_empty(),
            normal: surface.normal.as_ref(),
            bump: surface.bump.as_ref(),
        };
        let illumination = if is_lit { surface.illumination } else { Illumination::Color };
        Self { frame, mesh, surface, normals, illumination, layout: PhantomData }
    }

    /// Position, normal and the direction to the eye.
    #[inline(always)]
    pub(super) fn point<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> LitPoint<L> {
        let position = f.position();
        let to_eye = to_eye(l, self.frame, position);
        LitPoint { position, normal: self.normals.normal(l, f, to_eye), to_eye }
    }

    /// Fragments that are at least half opaque.
    #[inline(always)]
    pub(super) fn is_kept<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Mask<L> {
        let footprint = Footprint { uv: f.uv(), dx: f.dx.uv(), dy: f.dy.uv() };
        let factors = Factors::read(l, &self.surface.opacity_maps, &footprint);
        let mut opacity = factors.opacity() * self.surface.opacity;
        if let Some(color) = f.color() {
            opacity = opacity * color.w;
        }
        opacity.ge(0.5)
    }

    /// What the diffuse colour and all other terms are multiplied by, and the alpha that is stored.
    #[inline(always)]
    fn weights<L: Lanes>(
        &self,
        l: L,
        factors: &Factors<L>,
        vertex_alpha: Option<F32<L>>,
        cos_eye: F32<L>,
    ) -> [F32<L>; 3] {
        let one = l.f32(1.0);
        match self.surface.coverage {
            Coverage::Opaque => [one; 3],
            Coverage::CutOut => [1.0 / factors.get(Slot::Diffuse).a.max(1.0 / 512.0), one, one],
            Coverage::Blend => {
                let mut opacity = l.f32(self.surface.opacity);
                if self.surface.is_halo {
                    opacity = 1.0 - cos_eye.saturate() * (1.0 - opacity);
                }
                opacity = opacity * factors.get(Slot::Opacity).r;
                if let Some(alpha) = vertex_alpha {
                    opacity = opacity * alpha;
                }
                // The diffuse map is premultiplied already.
                let alpha = opacity * factors.get(Slot::Diffuse).a;
                [opacity, alpha, alpha]
            }
        }
    }
}

/// The unit vector from a point to the eye.
#[inline(always)]
pub(super) fn to_eye<L: Lanes>(l: L, frame: &FrameUniforms, position: Vec3<L>) -> Vec3<L> {
    let [x, y, z, w] = frame.eye;
    (l.vec3([x, y, z]) - position * w).normalize()
}

impl<A: Layout> Shader for BlinnPhong<'_, A> {
    type Varying<L: Lanes> = A::Varying<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, A::Varying<L>> {
        self.mesh.vertex::<L, A>(l, index)
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Rgba<L> {
        let surface = self.surface;
        let footprint = Footprint { uv: f.uv(), dx: f.dx.uv(), dy: f.dy.uv() };
        let factors = Factors::read(l, &surface.maps, &footprint);
        let mut diffuse = l.vec3(surface.diffuse) * factors.get(Slot::Diffuse).rgb();
        let mut ambient = l.vec3(surface.ambient) * factors.get(Slot::Ambient).rgb();
        let mut vertex_alpha = None;
        if let Some(color) = f.color() {
            diffuse = diffuse * color.xyz();
            ambient = ambient * color.xyz();
            vertex_alpha = Some(color.w);
        }
        if self.illumination == Illumination::Color && !surface.is_halo {
            let [w_diffuse, w_other, alpha] = self.weights(l, &factors, vertex_alpha, l.f32(1.0));
            let glow = l.vec3(surface.emissive) * factors.get(Slot::Emissive).rgb();
            return (diffuse * w_diffuse + glow * w_other).rgba(alpha);
        }
        let point = self.point(l, f);
        let [w_diffuse, w_other, alpha] = self.weights(l, &factors, vertex_alpha, point.normal.dot(point.to_eye));
        if self.illumination == Illumination::Color {
            return (diffuse * w_diffuse).rgba(alpha);
        }
        let shines = self.illumination == Illumination::Specular && surface.specular != [0.0; 3];
        let exponent = if shines { Some(factors.get(Slot::Exponent).r * surface.exponent) } else { None };
        let lighting = &self.frame.lighting;
        let Reflected { diffuse: diffuse_light, specular } = reflect(l, lighting, &point, exponent);
        let mut other = ambient * l.vec3(lighting.ambient);
        if shines {
            other += (l.vec3(surface.specular) * factors.get(Slot::Specular).rgb()) * specular;
        }
        if surface.emissive != [0.0; 3] {
            other += l.vec3(surface.emissive) * factors.get(Slot::Emissive).rgb();
        }
        ((diffuse * diffuse_light) * w_diffuse + other * w_other).rgba(alpha)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Mask<L> {
        self.is_kept(l, f)
    }

    fn discards(&self) -> bool {
        self.surface.coverage == Coverage::CutOut
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> SurfaceLanes<L> {
        let point = self.point(l, f);
        SurfaceLanes { position: point.position, normal: point.normal, uv: f.uv() }
    }
}
