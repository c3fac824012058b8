//! A fragment of any layout as one type: what the steps of shading read.
//!
//! In: an interpolated fragment. Out: a [`SurfacePoint`]. Steps from here on know no layout, so that each is compiled
//! once per SIMD level and not again for every shader; they are functions of their own (never inlined), because a
//! sampler copied into every shader would make the library minutes slower to compile and no picture faster.

use super::maps::Footprint;
use super::vertex::Attributes;
use crate::render::frame::FrameUniforms;
use trigon::lanes::{Lanes, Vec3, Vec4};
use trigon::shade::Fragment;

/// Sixteen points of a surface, in world space.
pub(super) struct SurfacePoint<L: Lanes> {
    pub(super) position: Vec3<L>,
    /// The change of position per pixel to the right and down.
    pub(super) dx: Vec3<L>,
    pub(super) dy: Vec3<L>,
    /// The unit vector to the eye.
    pub(super) to_eye: Vec3<L>,
    /// As interpolated: of any length.
    pub(super) normal: Vec3<L>,
    pub(super) tangent: Vec4<L>,
    /// Linear, straight alpha; white where the mesh has none.
    pub(super) color: Vec4<L>,
    pub(super) footprint: Footprint<L>,
}

impl<L: Lanes> SurfacePoint<L> {
    #[inline(always)]
    pub(super) fn new<V: Attributes<L>>(l: L, frame: &FrameUniforms, f: &Fragment<L, V>) -> Self {
        let position = f.position();
        let [x, y, z, w] = frame.eye;
        Self {
            position,
            dx: f.dx.position(),
            dy: f.dy.position(),
            to_eye: (l.vec3([x, y, z]) - position * w).normalize(),
            normal: f.normal(),
            tangent: f.tangent(l),
            color: f.color(l),
            footprint: footprint(f),
        }
    }

    /// A normal of the triangle's plane, on the side that is seen; as long as a pixel's area on it.
    #[inline(always)]
    pub(super) fn plane(&self) -> Vec3<L> {
        let plane = self.dx.cross(self.dy);
        plane.dot(self.to_eye).lt(0.0).select(-plane, plane)
    }
}

/// Where textures are read.
#[inline(always)]
pub(super) fn footprint<L: Lanes, V: Attributes<L>>(f: &Fragment<L, V>) -> Footprint<L> {
    Footprint { uv: f.uv(), dx: f.dx.uv(), dy: f.dy.uv() }
}
