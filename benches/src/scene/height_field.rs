//! `small`: small triangles. A wavy, textured sheet that fills the view, two quads' sides of two pixels each.

use super::grid::{Mesh, PatchPoint};
use super::orbit::half_view_at_origin;
use trigon::math::host::{cos, sin};

/// Side of a quad, in pixels.
const CELL_PX: f32 = 2.0;

/// A sheet over the section of the view frustum at z = 0, for a picture of `size` pixels.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive, at most 8192")]
#[expect(clippy::cast_precision_loss, reason = "picture sizes are below 2^24")]
pub(super) fn build(size: [u32; 2]) -> Mesh {
    let [half_width, half_height] = half_view_at_origin(size);
    let quads = size.map(|pixels| (pixels as f32 / CELL_PX).round().max(1.0) as u32);
    let mut mesh = Mesh::default();
    mesh.push_patch(quads[0], quads[1], |a, b| {
        let (x, y) = ((2.0 * a - 1.0) * half_width, (1.0 - 2.0 * b) * half_height);
        PatchPoint { position: [x, y, 0.02 * sin(12.0 * x) * cos(11.0 * y)], uv: [x, y] }
    });
    mesh
}
