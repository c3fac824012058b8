//! Lines over surfaces: one colour, or that of the vertices, a little nearer to the eye than the surface they lie on.
//!
//! The positions are computed exactly as those of the surface; only clip z differs.

use super::vertex::MeshView;
use trigon::lanes::{Lanes, Rgba, U32, Vec4};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws the edges of a mesh, or its line elements.
pub(in crate::render) struct Stroke<'a> {
    pub(in crate::render) mesh: MeshView<'a>,
    /// Linear, premultiplied; vertex colours multiply it.
    pub(in crate::render) color: [f32; 4],
    pub(in crate::render) uses_vertex_colors: bool,
    /// Added to clip z.
    pub(in crate::render) clip_z_offset: f32,
}

impl Shader for Stroke<'_> {
    type Varying<L: Lanes> = Vec4<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Vec4<L>> {
        let p = self.mesh.clip_position(l, index);
        // Not beyond the near plane, where the line would be cut off.
        let z = (p.z + l.f32(self.clip_z_offset)).min(p.w).max(p.z);
        let mut color = l.vec4(self.color);
        if self.uses_vertex_colors {
            let [r, g, b, a] = self.color;
            let c = self.mesh.color(index);
            color = Vec4 { x: (c.x * c.w) * r, y: (c.y * c.w) * g, z: (c.z * c.w) * b, w: c.w * a };
        }
        Vertex { position: Vec4 { z, ..p }, varying: color }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, _: L, f: &Fragment<L, Vec4<L>>) -> Rgba<L> {
        f.varying.xyz().rgba(f.varying.w)
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, _: &Fragment<L, Vec4<L>>) -> SurfaceLanes<L> {
        SurfaceLanes { position: l.vec3([0.0; 3]), normal: l.vec3([0.0; 3]), uv: l.vec2([0.0; 2]) }
    }
}
