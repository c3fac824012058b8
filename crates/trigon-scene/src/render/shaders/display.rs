//! Display values as what a shader returns.
//!
//! Looks inside and the programs of courses compute bytes. In linear light they are drawn by the value that is stored
//! as the nearest byte; in encoded colours they stay what they are.

use trigon::lanes::{F32, Lanes, Rgba, Vec3};
use trigon::math::srgb8_to_linear;
use trigon::target::ColorSpace;

/// The opaque colour of `space` that is stored as `255 v`, rounded.
#[inline(always)]
pub(super) fn displayed<L: Lanes>(v: Vec3<L>, space: ColorSpace) -> Rgba<L> {
    match space {
        ColorSpace::Linear => Vec3 { x: decoded(v.x), y: decoded(v.y), z: decoded(v.z) },
        ColorSpace::Encoded => Vec3 { x: v.x.saturate(), y: v.y.saturate(), z: v.z.saturate() },
    }
    .rgba(1.0)
}

/// The linear value that is stored as the code nearest to `255 v`.
#[inline(always)]
fn decoded<L: Lanes>(v: F32<L>) -> F32<L> {
    srgb8_to_linear((v.saturate() * 255.0 + 0.5).to_i32_within(0.0, 255.0).as_u32())
}
