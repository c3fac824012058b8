//! Looks inside: attributes and ids as colours.
//!
//! Values are shown as 8-bit codes: what is 0..=1 becomes the code `round(255 v)` of the stored picture.

use super::blinn_phong::BlinnPhong;
use super::display::displayed;
use super::vertex::{Attributes, Layout};
use crate::render::shader_kind::ShaderKind;
use trigon::lanes::{F32, Lanes, Mask, Rgba, U32, Vec3};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws a mesh as `kind` says; cut-outs are those of the material.
pub(in crate::render) struct Overlay<'a, A> {
    pub(in crate::render) base: BlinnPhong<'a, A>,
    pub(in crate::render) kind: ShaderKind,
    /// Number of the object that is drawn.
    pub(in crate::render) object: u32,
}

/// Display values of the mip levels, from the full image on; the last one stands for all smaller ones.
const LEVEL_COLORS: [[f32; 3]; 9] = [
    [0.90, 0.20, 0.17],
    [0.96, 0.55, 0.14],
    [0.98, 0.85, 0.20],
    [0.42, 0.78, 0.26],
    [0.15, 0.68, 0.60],
    [0.20, 0.52, 0.90],
    [0.40, 0.34, 0.83],
    [0.72, 0.34, 0.78],
    [0.92, 0.55, 0.72],
];

impl<A: Layout> Overlay<'_, A> {
    /// Levels by colour, mixed as the sampler mixes them, a little shaded so that the shape can be seen.
    #[inline(always)]
    fn mip_level<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Vec3<L> {
        let point = self.base.point(l, f);
        let facing = 0.35 + 0.65 * self.base.normal(l, &point).dot(point.to_eye).saturate();
        let Some(map) = self.base.surface.diffuse_map() else {
            return l.vec3([0.6; 3]) * facing;
        };
        let (dx, dy, scale) = (f.dx.uv(), f.dy.uv(), l.vec2(map.scale));
        let lod = map.texture.lod(l, &map.sampler, dx * scale, dy * scale);
        let last = (LEVEL_COLORS.len() - 1) as f32;
        l.note("level of detail", lod);
        let level = lod.clamp(0.0, last).floor();
        let below = (level + 1.0).min(last);
        let a = level.to_i32_within(0.0, last).as_u32().gather_vec3(&LEVEL_COLORS);
        let b = below.to_i32_within(0.0, last).as_u32().gather_vec3(&LEVEL_COLORS);
        a.mix(b, (lod - level).saturate()) * facing
    }

    /// Display values of a fragment.
    #[inline(always)]
    fn value<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Vec3<L> {
        let one = l.f32(1.0);
        match self.kind {
            ShaderKind::Normal => self.base.normal(l, &self.base.point(l, f)) * 0.5 + l.vec3([0.5; 3]),
            ShaderKind::Depth => {
                let [x, y, z, offset] = self.base.frame.depth_axis;
                let t = (f.position().dot(l.vec3([x, y, z])) + l.f32(offset)).saturate();
                grey(1.0 - t * 0.9)
            }
            ShaderKind::Occlusion => match &self.base.frame.occlusion {
                Some(map) => grey(map.openness(l, f.pixel, f.position())),
                None => grey(one),
            },
            ShaderKind::Uv if self.base.mesh.uvs.is_empty() => l.vec3([0.2; 3]),
            ShaderKind::Uv => {
                let uv = f.uv();
                let v_up = 1.0 - uv.y;
                Vec3 { x: uv.x - uv.x.floor(), y: v_up - v_up.floor(), z: l.f32(0.0) }
            }
            ShaderKind::Barycentric => f.barycentric,
            ShaderKind::MipLevel => self.mip_level(l, f),
            ShaderKind::Ids => id_color(l, f.primitive ^ l.u32(self.object.wrapping_mul(0x9E37_79B1))),
            ShaderKind::Objects => id_color(l, l.u32(self.object)),
            _ => grey(one),
        }
    }
}

#[inline(always)]
fn grey<L: Lanes>(v: F32<L>) -> Vec3<L> {
    Vec3 { x: v, y: v, z: v }
}

/// A colour that neighbouring numbers do not share: neither dark nor pale.
#[inline(always)]
fn id_color<L: Lanes>(l: L, id: U32<L>) -> Vec3<L> {
    let mut h = (id + l.u32(1)) * l.u32(0x9E37_79B1);
    h = (h ^ (h >> 15)) * l.u32(0x85EB_CA77);
    h = (h ^ (h >> 13)) * l.u32(0xC2B2_AE3D);
    h = h ^ (h >> 16);
    let byte = l.u32(0xff);
    let channel = l.f32(0.62 / 255.0);
    let (r, g, b) = (h & byte, (h >> 8) & byte, (h >> 16) & byte);
    Vec3 { x: r.to_f32() * channel, y: g.to_f32() * channel, z: b.to_f32() * channel } + l.vec3([0.28; 3])
}

impl<A: Layout> Shader for Overlay<'_, A> {
    type Varying<L: Lanes> = A::Varying<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, A::Varying<L>> {
        self.base.vertex(l, index)
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Rgba<L> {
        let v = self.value(l, f);
        l.note("value shown", v);
        displayed(v, self.base.frame.color_space)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> Mask<L> {
        self.base.keep(l, f)
    }

    fn discards(&self) -> bool {
        self.base.discards()
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, f: &Fragment<L, A::Varying<L>>) -> SurfaceLanes<L> {
        self.base.surface(l, f)
    }
}
