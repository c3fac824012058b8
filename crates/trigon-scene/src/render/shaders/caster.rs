//! What casts shadows: a surface seen from a light, without a colour.
//!
//! Cut-out surfaces cast the shadow of what is left of them, blended ones that of what is at least half opaque.

use super::maps::Footprint;
use super::vertex::MeshView;
use crate::render::material::{Coverage, Surface};
use trigon::lanes::{Lanes, Mask, Rgba, U32, Vec2, Vec3};
use trigon::shade::{Fragment, Shader, Vertex};

/// Draws the depth of one material on one mesh.
pub(in crate::render) struct Caster<'a> {
    mesh: MeshView<'a>,
    surface: &'a Surface<'a>,
}

impl<'a> Caster<'a> {
    /// `mesh` is placed as the light sees it.
    pub(in crate::render) fn new(mesh: MeshView<'a>, surface: &'a Surface<'a>) -> Self {
        Self { mesh, surface }
    }
}

impl Shader for Caster<'_> {
    /// Texture coordinates, and the alpha of vertex colours.
    type Varying<L: Lanes> = Vec3<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Vec3<L>> {
        let uv = index.gather_vec2(self.mesh.uvs);
        let alpha = if self.mesh.colors.is_empty() { l.f32(1.0) } else { index.gather_vec4(self.mesh.colors).w };
        Vertex { position: self.mesh.clip_position(l, index), varying: Vec3 { x: uv.x, y: uv.y, z: alpha } }
    }

    /// Never asked for: depth is all that is drawn.
    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, _: &Fragment<L, Vec3<L>>) -> Rgba<L> {
        l.vec3([0.0; 3]).rgba(1.0)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, Vec3<L>>) -> Mask<L> {
        let footprint = Footprint { uv: uv(f.varying), dx: uv(f.dx), dy: uv(f.dy) };
        self.surface.is_kept(l, &footprint, f.varying.z)
    }

    fn discards(&self) -> bool {
        self.surface.coverage != Coverage::Opaque
    }
}

#[inline(always)]
fn uv<L: Lanes>(v: Vec3<L>) -> Vec2<L> {
    Vec2 { x: v.x, y: v.y }
}
