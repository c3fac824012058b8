//! The shader interface: what a user writes to place vertices and to colour fragments.
//!
//! In: vertex numbers; interpolated fragments. Out: clip positions; linear colours. A shader is a Rust type whose two
//! functions are generic over the lanes: written once, compiled for every SIMD level, sixteen vertices or fragments a
//! call. Only the part of `vertex` that a stage needs survives inlining: positions in the geometry stage, varyings
//! later and for visible triangles only.

use super::varying::Varying;
use crate::lanes::{F32, Lanes, Mask, Rgba, U32, Vec2, Vec3, Vec4};
use core::ops::Deref;

/// A programmable vertex and fragment stage.
///
/// Implementations put `#[inline(always)]` on every method and use operators and methods of the lanes, no closures and
/// no platform functions such as `f32::sin` (see [`crate::math`] instead): then the picture is the same everywhere.
pub trait Shader: Sync {
    /// What is interpolated between the corners of a triangle.
    type Varying<L: Lanes>: Varying<L>;

    /// Places sixteen vertices, whose numbers are `index`. A shader fetches its own attributes, for example
    /// `index.gather_vec3(self.positions)`.
    ///
    /// The position is in clip space: x right, y up, depth reversed (z = w at the near plane, 0 at the far plane).
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Self::Varying<L>>;

    /// Colours sixteen fragments: linear light, premultiplied by alpha.
    fn fragment<L: Lanes>(&self, l: L, fragment: &Fragment<L, Self::Varying<L>>) -> Rgba<L>;

    /// Which of sixteen fragments exist at all (alpha test). Called only where [`Shader::discards`] says so, before
    /// the depth test; a fragment that is not kept leaves no trace.
    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, _fragment: &Fragment<L, Self::Varying<L>>) -> Mask<L> {
        l.mask(true)
    }

    /// True if [`Shader::keep`] can be false anywhere.
    fn discards(&self) -> bool {
        false
    }

    /// The surface behind sixteen fragments, for the normal, position and uv outputs.
    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, _fragment: &Fragment<L, Self::Varying<L>>) -> SurfaceLanes<L> {
        SurfaceLanes { position: l.vec3([0.0; 3]), normal: l.vec3([0.0; 3]), uv: l.vec2([0.0; 2]) }
    }
}

/// Sixteen placed vertices.
#[derive(Clone, Copy)]
pub struct Vertex<L: Lanes, V> {
    /// In clip space.
    pub position: Vec4<L>,
    /// Interpolated for the fragments.
    pub varying: V,
}

/// Sixteen surface points, as the outputs beside colour show them.
#[derive(Clone, Copy)]
pub struct SurfaceLanes<L: Lanes> {
    /// In world space.
    pub position: Vec3<L>,
    /// In world space, unit length.
    pub normal: Vec3<L>,
    /// Texture coordinates, v down.
    pub uv: Vec2<L>,
}

/// Sixteen fragments. Dereferences to the varying: `fragment.uv`.
#[derive(Clone, Copy)]
pub struct Fragment<L: Lanes, V> {
    /// The varying at the shading point.
    pub varying: V,
    /// Its change per pixel to the right: exact, from the triangle's planes, not from neighbours.
    pub dx: V,
    /// Its change per pixel down.
    pub dy: V,
    /// Weights of the primitive's corners; they sum to one. Corners are numbered as submitted, up to rotation.
    pub barycentric: Vec3<L>,
    /// Framebuffer position of the shading point, in pixels.
    pub pixel: Vec2<L>,
    /// NDC depth of the shading point: 1 near, 0 far.
    pub depth: F32<L>,
    /// True on the side whose vertices appear counter-clockwise.
    pub front_facing: Mask<L>,
    /// Number of the primitive within its draw.
    pub primitive: U32<L>,
}

impl<L: Lanes, V> Deref for Fragment<L, V> {
    type Target = V;

    #[inline(always)]
    fn deref(&self) -> &V {
        &self.varying
    }
}
