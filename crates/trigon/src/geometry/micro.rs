//! Micro-triangles: coverage of sixteen triangles at once, for those whose pixels fit a 4 x 4 box.
//!
//! In: sixteen triangles in canonical order. Out: per triangle and sample a 16-bit mask, bit `4 * row + column` of the
//! box. A triangle that covers no sample is found here, before it costs a record or a place in a bin.

use super::setup::Corners;
use super::triangle::{SUBPIXEL, SUBPIXEL_BITS};
use crate::lanes::{I32, LANES, Lanes, Mask};

/// Side of the box, in pixels.
pub(crate) const MICRO_SIZE: i32 = 4;

/// Pixel boxes of sixteen triangles.
pub(crate) struct LaneBoxes<L: Lanes> {
    /// First column and row.
    pub(crate) first: [I32<L>; 2],
    /// Columns and rows; zero or less where no sample can be covered.
    pub(crate) size: [I32<L>; 2],
}

impl<L: Lanes> LaneBoxes<L> {
    #[inline(always)]
    pub(crate) fn new(l: L, c: &Corners<L>, extent: [(i32, i32); 2]) -> Self {
        let (x0, width) = range(l, c.x, extent[0]);
        let (y0, height) = range(l, c.y, extent[1]);
        Self { first: [x0, y0], size: [width, height] }
    }

    /// True where no sample can be covered.
    #[inline(always)]
    pub(crate) fn is_empty(&self, l: L) -> Mask<L> {
        self.size[0].lt(l.i32(1)) | self.size[1].lt(l.i32(1))
    }

    /// True where the box is at most 4 x 4.
    #[inline(always)]
    pub(crate) fn is_micro(&self, l: L) -> Mask<L> {
        let size = l.i32(MICRO_SIZE);
        size.ge(self.size[0]) & size.ge(self.size[1])
    }
}

#[inline(always)]
fn range<L: Lanes>(l: L, c: [I32<L>; 3], (first, last): (i32, i32)) -> (I32<L>, I32<L>) {
    let low = c[0].min(c[1]).min(c[2]);
    let high = c[0].max(c[1]).max(c[2]);
    let from = (low + l.i32(SUBPIXEL - 1 - last)) >> SUBPIXEL_BITS;
    let to = (high - l.i32(first)) >> SUBPIXEL_BITS;
    (from, to - from + l.i32(1))
}

/// Coverage of sixteen micro-triangles: `masks[lane * samples + sample]`, and which lanes cover anything.
///
/// Lanes outside `active` hold nothing of use.
#[inline(always)]
pub(crate) fn cover<L: Lanes>(
    l: L,
    corners: &Corners<L>,
    boxes: &LaneBoxes<L>,
    active: Mask<L>,
    samples: &[[i16; 2]],
    masks: &mut [u16],
) -> u16 {
    let edges = LaneEdges::new(l, corners, boxes);
    let (columns, rows) = (largest(l, boxes.size[0], active), largest(l, boxes.size[1], active));
    let mut covering = l.i32(0);
    for (s, position) in samples.iter().enumerate() {
        let covered = edges.cover_sample(l, *position, columns, rows);
        covering = covering | covered;
        let lanes = covered.to_array();
        for (lane, mask) in lanes.iter().enumerate() {
            masks[lane * samples.len() + s] = (mask & 0xffff) as u16;
        }
    }
    (!covering.eq(l.i32(0)) & active).bits()
}

#[inline(always)]
fn largest<L: Lanes>(l: L, sizes: I32<L>, active: Mask<L>) -> i32 {
    let sizes = active.select(sizes, l.i32(0)).to_array();
    let mut largest = 0;
    for lane in 0..LANES {
        largest = if sizes[lane] > largest { sizes[lane] } else { largest };
    }
    largest
}

/// Edge functions of sixteen triangles at their boxes' first pixel, with the top-left rule folded in.
struct LaneEdges<L: Lanes> {
    base: [I32<L>; 3],
    dx: [I32<L>; 3],
    dy: [I32<L>; 3],
}

impl<L: Lanes> LaneEdges<L> {
    #[inline(always)]
    fn new(l: L, c: &Corners<L>, boxes: &LaneBoxes<L>) -> Self {
        let (left, top) = (boxes.first[0] << SUBPIXEL_BITS, boxes.first[1] << SUBPIXEL_BITS);
        let zero = l.i32(0);
        let mut edges = Self { base: [zero; 3], dx: [zero; 3], dy: [zero; 3] };
        for k in 0..3 {
            let next = (k + 1) % 3;
            let (dx, dy) = (c.x[next] - c.x[k], c.y[next] - c.y[k]);
            let owns_edge = dy.lt(zero) | (dy.eq(zero) & zero.lt(dx));
            let bias = owns_edge.select(zero, l.i32(-1));
            edges.base[k] = dx * (top - c.y[k]) - dy * (left - c.x[k]) + bias;
            (edges.dx[k], edges.dy[k]) = (dx, dy);
        }
        edges
    }

    /// One bit per covered pixel of the box.
    #[inline(always)]
    fn cover_sample(&self, l: L, [sx, sy]: [i16; 2], columns: i32, rows: i32) -> I32<L> {
        let (sx, sy) = (l.i32(i32::from(sx)), l.i32(i32::from(sy)));
        let mut row = self.base;
        for k in 0..3 {
            row[k] += self.dx[k] * sy - self.dy[k] * sx;
        }
        let (mut covered, outside) = (l.i32(0), l.i32(-1));
        for y in 0..rows {
            let mut e = row;
            for x in 0..columns {
                let any_negative = (e[0] | e[1] | e[2]) >> 31;
                covered = covered | ((any_negative ^ outside) & l.i32(1 << (MICRO_SIZE * y + x)));
                for k in 0..3 {
                    e[k] = e[k] - (self.dy[k] << SUBPIXEL_BITS);
                }
            }
            for k in 0..3 {
                row[k] += self.dx[k] << SUBPIXEL_BITS;
            }
        }
        covered
    }
}
