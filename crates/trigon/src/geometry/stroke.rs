//! Lines and points: each becomes two triangles in the framebuffer, and from there on is one of them.
//!
//! In: projected ends and a width in pixels. Out: the corners of a rectangle, with the vertex that each corner takes
//! its attributes from. Lines have square ends that reach half a width past the end, so that strips join.

use super::project::ScreenVertex;
use super::triangle::{GUARD_BAND, SUBPIXEL};

/// Two triangles as indices into the four corners of a rectangle.
pub(crate) const RECTANGLE: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

/// Widest line and largest point, in pixels; also how far inside the guard band their centres must stay.
pub(crate) const MAX_STROKE: f32 = 4096.0;

/// The rectangle around a segment: corners 0 and 3 belong to `a`, 1 and 2 to `b`.
#[expect(clippy::cast_precision_loss, reason = "snapped coordinates are at most 2^22")]
pub(crate) fn line_corners(a: ScreenVertex, b: ScreenVertex, width_px: f32) -> [ScreenVertex; 4] {
    let half = stroke_half(width_px);
    let (dx, dy) = ((b.x - a.x) as f32, (b.y - a.y) as f32);
    let length = (dx * dx + dy * dy).sqrt();
    // A segment that projects to one point draws a square.
    let (ux, uy) = if length > 0.0 { (dx / length, dy / length) } else { (1.0, 0.0) };
    let (ax, ay) = (ux * half, uy * half);
    [moved(a, -ax + ay, -ay - ax), moved(b, ax + ay, ay - ax), moved(b, ax - ay, ay + ax), moved(a, -ax - ay, -ay + ax)]
}

/// The square around a point.
pub(crate) fn point_corners(p: ScreenVertex, size_px: f32) -> [ScreenVertex; 4] {
    let half = stroke_half(size_px);
    [moved(p, -half, -half), moved(p, half, -half), moved(p, half, half), moved(p, -half, half)]
}

/// Half a width in 1/256 px.
fn stroke_half(width_px: f32) -> f32 {
    let width = if width_px > 0.0 { width_px } else { 0.0 };
    (if width < MAX_STROKE { width } else { MAX_STROKE }) * (SUBPIXEL as f32 * 0.5)
}

fn moved(v: ScreenVertex, dx: f32, dy: f32) -> ScreenVertex {
    let snap = |c: i32, d: f32| (c + d.round_ties_even() as i32).clamp(-GUARD_BAND, GUARD_BAND);
    ScreenVertex { x: snap(v.x, dx), y: snap(v.y, dy), ..v }
}
