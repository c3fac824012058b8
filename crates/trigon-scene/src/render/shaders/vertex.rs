//! Vertices: numbers in, clip positions and world-space attributes out.
//!
//! Two layouts: most meshes have positions, normals and uv alone, and interpolating what is not there would cost them
//! a third more.

use crate::math::Mat4;
use crate::scene::{Instance, Mesh};
use trigon::lanes::{self, F32, Lanes, U32, Vec2, Vec3, Vec4};
use trigon::math::linear_to_srgb8;
use trigon::shade::{Varying, Vertex};
use trigon::target::ColorSpace;

trigon::varying! {
    /// Position, normal and uv.
    pub(in crate::render) struct PlainVarying {
        /// World space.
        position: Vec3,
        /// World space, any length.
        normal: Vec3,
        /// v down.
        uv: Vec2,
    }
}

trigon::varying! {
    /// Every attribute.
    pub(in crate::render) struct FullVarying {
        /// World space.
        position: Vec3,
        /// World space, any length.
        normal: Vec3,
        /// v down.
        uv: Vec2,
        /// Linear, straight alpha.
        color: Vec4,
        /// World space, and the sign of the bitangent.
        tangent: Vec4,
    }
}

/// Which attributes are interpolated.
pub(in crate::render) trait Layout: Send + Sync + 'static {
    /// The attributes.
    type Varying<L: Lanes>: Varying<L> + Attributes<L>;

    /// Fetches sixteen vertices.
    fn fetch<L: Lanes>(l: L, mesh: &MeshView<'_>, index: U32<L>) -> Self::Varying<L>;
}

/// Reads attributes of any layout; where a layout lacks them, colours are white and tangents zero.
pub(in crate::render) trait Attributes<L: Lanes>: Copy {
    fn position(&self) -> Vec3<L>;
    fn normal(&self) -> Vec3<L>;
    fn uv(&self) -> Vec2<L>;
    fn color(&self, l: L) -> Vec4<L>;
    fn tangent(&self, l: L) -> Vec4<L>;
}

/// Positions, normals, uv.
pub(in crate::render) struct Plain;

/// Colours and tangents too.
pub(in crate::render) struct Full;

/// A mesh placed in the world and seen by a camera.
#[derive(Clone, Copy)]
pub(in crate::render) struct MeshView<'a> {
    pub(in crate::render) positions: &'a [[f32; 3]],
    pub(in crate::render) normals: &'a [[f32; 3]],
    pub(in crate::render) uvs: &'a [[f32; 2]],
    pub(in crate::render) colors: &'a [[f32; 4]],
    pub(in crate::render) tangents: &'a [[f32; 4]],
    clip_from_model: lanes::Mat4,
    world_from_model: lanes::Mat4,
    /// The columns of the matrix for normals.
    normal_from_model: lanes::Mat4,
    /// -1 for a transform that mirrors: it turns the bitangent around, which is a cross product.
    handedness: f32,
    /// What vertex colours, which are linear, are turned into.
    color_space: ColorSpace,
}

impl<'a> MeshView<'a> {
    pub(in crate::render) fn new(mesh: &'a Mesh, instance: &Instance, clip_from_world: &Mat4) -> Self {
        let world = instance.world_from_model;
        let [x, y, z] = world.normal_from_model().map(|[x, y, z]| [x, y, z, 0.0]);
        // A product with the identity would be exact as well, but not with infinities in it.
        let clip = if world == Mat4::IDENTITY { *clip_from_world } else { *clip_from_world * world };
        Self {
            positions: &mesh.positions,
            normals: &mesh.normals,
            uvs: &mesh.uvs,
            colors: &mesh.colors,
            tangents: &mesh.tangents,
            clip_from_model: lanes::Mat4 { columns: clip.columns },
            world_from_model: lanes::Mat4 { columns: world.columns },
            normal_from_model: lanes::Mat4 { columns: [x, y, z, [0.0, 0.0, 0.0, 1.0]] },
            handedness: if world.linear_determinant() < 0.0 { -1.0 } else { 1.0 },
            color_space: ColorSpace::Linear,
        }
    }

    /// The same with vertex colours in `space`.
    pub(in crate::render) fn with_colors_in(self, space: ColorSpace) -> Self {
        Self { color_space: space, ..self }
    }

    /// Whether vertices have more than position, normal and uv.
    pub(in crate::render) fn needs_full_layout(&self) -> bool {
        !self.colors.is_empty() || !self.tangents.is_empty()
    }

    /// Sixteen placed vertices.
    #[inline(always)]
    pub(super) fn vertex<L: Lanes, A: Layout>(&self, l: L, index: U32<L>) -> Vertex<L, A::Varying<L>> {
        Vertex { position: self.clip_position(l, index), varying: A::fetch(l, self, index) }
    }

    #[inline(always)]
    pub(super) fn clip_position<L: Lanes>(&self, l: L, index: U32<L>) -> Vec4<L> {
        self.clip_from_model.transform_point(l, index.gather_vec3(self.positions))
    }

    /// A normal of the model in the world, of any length.
    #[inline(always)]
    pub(super) fn world_normal<L: Lanes>(&self, normal: Vec3<L>) -> Vec3<L> {
        self.normal_from_model.transform_vector(normal)
    }

    /// The colours of sixteen vertices, straight alpha. Display values are rounded to bytes, as files hold them.
    #[inline(always)]
    pub(super) fn color<L: Lanes>(&self, index: U32<L>) -> Vec4<L> {
        let c = index.gather_vec4(self.colors);
        match self.color_space {
            ColorSpace::Linear => c,
            ColorSpace::Encoded => Vec4 { x: encoded(c.x), y: encoded(c.y), z: encoded(c.z), w: c.w },
        }
    }

    /// Position, normal and uv of sixteen vertices.
    #[inline(always)]
    pub(super) fn plain<L: Lanes>(&self, l: L, index: U32<L>) -> PlainVarying<L> {
        let model = index.gather_vec3(self.positions);
        PlainVarying {
            position: self.world_from_model.transform_point(l, model).xyz(),
            // Unit length again: instances may be scaled, and interpolation weighs by length.
            normal: self.normal_from_model.transform_vector(index.gather_vec3(self.normals)).normalize(),
            uv: index.gather_vec2(self.uvs),
        }
    }
}

/// The display value of linear light.
#[inline(always)]
fn encoded<L: Lanes>(c: F32<L>) -> F32<L> {
    linear_to_srgb8(c).to_f32() * (1.0 / 255.0)
}

impl Layout for Plain {
    type Varying<L: Lanes> = PlainVarying<L>;

    #[inline(always)]
    fn fetch<L: Lanes>(l: L, mesh: &MeshView<'_>, index: U32<L>) -> PlainVarying<L> {
        mesh.plain(l, index)
    }
}

impl Layout for Full {
    type Varying<L: Lanes> = FullVarying<L>;

    #[inline(always)]
    fn fetch<L: Lanes>(l: L, mesh: &MeshView<'_>, index: U32<L>) -> FullVarying<L> {
        let PlainVarying { position, normal, uv } = mesh.plain(l, index);
        let color = if mesh.colors.is_empty() { l.vec4([1.0; 4]) } else { mesh.color(index) };
        let tangent = index.gather_vec4(mesh.tangents);
        let along = mesh.world_from_model.transform_vector(tangent.xyz()).normalize();
        FullVarying { position, normal, uv, color, tangent: along.extend(tangent.w * mesh.handedness) }
    }
}

impl<L: Lanes> Attributes<L> for PlainVarying<L> {
    #[inline(always)]
    fn position(&self) -> Vec3<L> {
        self.position
    }
    #[inline(always)]
    fn normal(&self) -> Vec3<L> {
        self.normal
    }
    #[inline(always)]
    fn uv(&self) -> Vec2<L> {
        self.uv
    }
    #[inline(always)]
    fn color(&self, l: L) -> Vec4<L> {
        l.vec4([1.0; 4])
    }
    #[inline(always)]
    fn tangent(&self, l: L) -> Vec4<L> {
        l.vec4([0.0; 4])
    }
}

impl<L: Lanes> Attributes<L> for FullVarying<L> {
    #[inline(always)]
    fn position(&self) -> Vec3<L> {
        self.position
    }
    #[inline(always)]
    fn normal(&self) -> Vec3<L> {
        self.normal
    }
    #[inline(always)]
    fn uv(&self) -> Vec2<L> {
        self.uv
    }
    #[inline(always)]
    fn color(&self, _: L) -> Vec4<L> {
        self.color
    }
    #[inline(always)]
    fn tangent(&self, _: L) -> Vec4<L> {
        self.tangent
    }
}
