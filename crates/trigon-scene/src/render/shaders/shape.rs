//! The shape of a surface, without its colour: what shadow maps, occlusion and outlines are drawn from.
//!
//! Cut-out surfaces have the shape of what is left of them, blended ones that of what is at least half opaque. Normals are
//! those of the vertices: relief that maps paint on a surface is not part of its shape.

use super::maps::Footprint;
use super::normal::NormalSource;
use super::point::SurfacePoint;
use super::vertex::{MeshView, PlainVarying};
use crate::render::material::{Coverage, Surface};
use trigon::lanes::{Lanes, Mask, Rgba, U32};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws one material on one mesh.
pub(in crate::render) struct Shape<'a> {
    mesh: MeshView<'a>,
    surface: &'a Surface<'a>,
    /// The eye and 1, or the unit vector towards an infinitely distant eye and 0.
    eye: [f32; 4],
}

trigon::varying! {
    /// What a shape consists of.
    pub(in crate::render) struct ShapeVarying {
        /// World space.
        position: Vec3,
        /// World space, any length.
        normal: Vec3,
        /// v down.
        uv: Vec2,
        /// That of the vertex colours.
        alpha: F32,
    }
}

impl<'a> Shape<'a> {
    /// `mesh` is placed as the eye sees it, or a light.
    pub(in crate::render) fn new(mesh: MeshView<'a>, surface: &'a Surface<'a>, eye: [f32; 4]) -> Self {
        Self { mesh, surface, eye }
    }
}

impl Shader for Shape<'_> {
    type Varying<L: Lanes> = ShapeVarying<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, ShapeVarying<L>> {
        let PlainVarying { position, normal, uv } = self.mesh.plain(l, index);
        let alpha = if self.mesh.colors.is_empty() { l.f32(1.0) } else { index.gather_vec4(self.mesh.colors).w };
        Vertex { position: self.mesh.clip_position(l, index), varying: ShapeVarying { position, normal, uv, alpha } }
    }

    /// Never asked for: a shape has no colour.
    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, _: &Fragment<L, ShapeVarying<L>>) -> Rgba<L> {
        l.vec3([0.0; 3]).rgba(1.0)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, ShapeVarying<L>>) -> Mask<L> {
        self.surface.is_kept(l, &footprint(f), f.alpha)
    }

    fn discards(&self) -> bool {
        self.surface.coverage != Coverage::Opaque
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, f: &Fragment<L, ShapeVarying<L>>) -> SurfaceLanes<L> {
        let [x, y, z, w] = self.eye;
        let point = SurfacePoint {
            position: f.position,
            dx: f.dx.position,
            dy: f.dy.position,
            to_eye: (l.vec3([x, y, z]) - f.position * w).normalize(),
            normal: f.normal,
            tangent: l.vec4([0.0; 4]),
            color: l.vec4([1.0; 4]),
            footprint: footprint(f),
        };
        let is_flat = self.mesh.normals.is_empty();
        let normals = NormalSource { is_flat, is_point: false, has_tangents: false, normal: None, bump: None };
        SurfaceLanes { position: f.position, normal: normals.normal(l, &point), uv: f.uv }
    }
}

#[inline(always)]
fn footprint<L: Lanes>(f: &Fragment<L, ShapeVarying<L>>) -> Footprint<L> {
    Footprint { uv: f.uv, dx: f.dx.uv, dy: f.dy.uv }
}
