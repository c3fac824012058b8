//! Triangle setup: three projected vertices in, one [`ScreenTriangle`] out.
//!
//! Corners are put into a canonical order first (topmost, then leftmost; positive area), so that a rotated index list
//! draws the same bits. Sixteen triangles at a time where their extent lets the area fit `i32`; the rest one by one.

use super::project::ScreenVertex;
use super::triangle::{SUBPIXEL, ScreenTriangle, Tags};
use crate::lanes::{F32, I32, Lanes, Mask, U32};

/// Extent, in 1/256 px, below which products of two differences and their sum fit `i32`: 127 px.
pub(crate) const SMALL_EXTENT: i32 = (1 << 15) - 1;

/// Sixteen triangles, corners by component.
#[derive(Clone, Copy)]
pub(crate) struct Corners<L: Lanes> {
    pub(crate) x: [I32<L>; 3],
    pub(crate) y: [I32<L>; 3],
    pub(crate) depth: [F32<L>; 3],
    pub(crate) inv_w: [F32<L>; 3],
    /// Which vertex each corner is.
    pub(crate) vertex: [U32<L>; 3],
}

/// Sixteen triangles in canonical order.
pub(crate) struct LaneSetup<L: Lanes> {
    pub(crate) corners: Corners<L>,
    /// Depth at corner 0, and per pixel along x and y.
    pub(crate) depth: [F32<L>; 3],
    /// True where the vertices appear counter-clockwise.
    pub(crate) front: Mask<L>,
    /// True where the area is not zero.
    pub(crate) has_area: Mask<L>,
    /// True where the extent is small enough for this setup to hold.
    pub(crate) is_small: Mask<L>,
}

impl<L: Lanes> LaneSetup<L> {
    #[inline(always)]
    pub(crate) fn new(l: L, corners: Corners<L>) -> Self {
        let mut c = rotate(corners);
        let (dx1, dy1) = (c.x[1] - c.x[0], c.y[1] - c.y[0]);
        let (dx2, dy2) = (c.x[2] - c.x[0], c.y[2] - c.y[0]);
        let limit = l.i32(SMALL_EXTENT);
        let lowest = l.i32(-SMALL_EXTENT);
        // The third difference is no longer than the extent along either axis.
        let is_small = limit.ge(dx1.max(dx2))
            & dx1.min(dx2).ge(lowest)
            & limit.ge(dy1.max(dy2))
            & limit.ge(dx1 - dx2)
            & limit.ge(dx2 - dx1);
        let area = dx1 * dy2 - dx2 * dy1;
        let front = area.lt(l.i32(0));
        let has_area = !area.eq(l.i32(0));
        swap_where(&mut c, front);
        let area = front.select(-area, area).to_f32();
        let depth = depth_plane(&c, area);
        Self { corners: c, depth, front, has_area, is_small }
    }
}

/// Brings the topmost, leftmost of equals, to the front.
#[inline(always)]
fn rotate<L: Lanes>(c: Corners<L>) -> Corners<L> {
    let one = precedes(&c, 1, 0) & !precedes(&c, 2, 1);
    let two = precedes(&c, 2, 0) & precedes(&c, 2, 1);
    let mut out = c;
    for k in 0..3 {
        let (a, b) = ((k + 1) % 3, (k + 2) % 3);
        out.x[k] = two.select(c.x[b], one.select(c.x[a], c.x[k]));
        out.y[k] = two.select(c.y[b], one.select(c.y[a], c.y[k]));
        out.depth[k] = two.select(c.depth[b], one.select(c.depth[a], c.depth[k]));
        out.inv_w[k] = two.select(c.inv_w[b], one.select(c.inv_w[a], c.inv_w[k]));
        out.vertex[k] = two.select(c.vertex[b], one.select(c.vertex[a], c.vertex[k]));
    }
    out
}

#[inline(always)]
fn precedes<L: Lanes>(c: &Corners<L>, a: usize, b: usize) -> Mask<L> {
    c.y[a].lt(c.y[b]) | (c.y[a].eq(c.y[b]) & c.x[a].lt(c.x[b]))
}

/// Swaps corners 1 and 2 where `mask` is true.
#[inline(always)]
fn swap_where<L: Lanes>(c: &mut Corners<L>, mask: Mask<L>) {
    let old = *c;
    for (k, other) in [(1, 2), (2, 1)] {
        c.x[k] = mask.select(old.x[other], old.x[k]);
        c.y[k] = mask.select(old.y[other], old.y[k]);
        c.depth[k] = mask.select(old.depth[other], old.depth[k]);
        c.inv_w[k] = mask.select(old.inv_w[other], old.inv_w[k]);
        c.vertex[k] = mask.select(old.vertex[other], old.vertex[k]);
    }
}

/// Depth at corner 0 and its change per pixel.
#[inline(always)]
fn depth_plane<L: Lanes>(c: &Corners<L>, area: F32<L>) -> [F32<L>; 3] {
    let (dx1, dy1) = ((c.x[1] - c.x[0]).to_f32(), (c.y[1] - c.y[0]).to_f32());
    let (dx2, dy2) = ((c.x[2] - c.x[0]).to_f32(), (c.y[2] - c.y[0]).to_f32());
    let (d1, d2) = (c.depth[1] - c.depth[0], c.depth[2] - c.depth[0]);
    let scale = SUBPIXEL as f32 / area;
    [c.depth[0], (d1 * dy2 - d2 * dy1) * scale, (d2 * dx1 - d1 * dx2) * scale]
}

/// One triangle of any extent, in canonical order; the second value says which given corner each new one is. `None`
/// if it has no area.
#[expect(clippy::cast_precision_loss, reason = "differences are at most 2^23; the area is rounded once, as in lanes")]
pub(crate) fn setup_one(corners: [ScreenVertex; 3]) -> Option<(ScreenTriangle, [usize; 3])> {
    let first = (0..3).min_by_key(|&k| (corners[k].y, corners[k].x))?;
    let mut order = [first, (first + 1) % 3, (first + 2) % 3];
    let area_of = |[a, b, c]: [usize; 3]| {
        let d = |p: usize| (i64::from(corners[p].x - corners[a].x), i64::from(corners[p].y - corners[a].y));
        let ((dx1, dy1), (dx2, dy2)) = (d(b), d(c));
        dx1 * dy2 - dx2 * dy1
    };
    let area = area_of(order);
    if area == 0 {
        return None;
    }
    let front = area < 0;
    if front {
        order.swap(1, 2);
    }
    let [a, b, c] = order.map(|k| corners[k]);
    let (dx1, dy1) = ((b.x - a.x) as f32, (b.y - a.y) as f32);
    let (dx2, dy2) = ((c.x - a.x) as f32, (c.y - a.y) as f32);
    let (d1, d2) = (b.depth - a.depth, c.depth - a.depth);
    let scale = SUBPIXEL as f32 / area.unsigned_abs() as f32;
    let triangle = ScreenTriangle {
        x: [a.x, b.x, c.x],
        y: [a.y, b.y, c.y],
        depth: [a.depth, (d1 * dy2 - d2 * dy1) * scale, (d2 * dx1 - d1 * dx2) * scale],
        inv_w: [a.inv_w, b.inv_w, c.inv_w],
        tags: Tags(if front { Tags::FRONT } else { 0 }),
        ..ScreenTriangle::default()
    };
    Some((triangle, order))
}
