//! Edges: line segments between points snapped to 1/256 px, ready to be met with sample rows.
//!
//! In: points in pixels, relative to the top left corner of what is drawn. Out: [`Edge`]s. A sample is right of an edge
//! where its x is at or past the exact crossing, and an edge counts for sample rows from its upper end, inclusive, to
//! its lower end, exclusive: so a sample on an edge that two shapes share belongs to exactly one of them.

use super::samples::SampleRows;
use std::ops::Range;

/// Where points may lie, in pixels, on either side of the origin: beyond, segments are cut.
const LIMIT: f64 = 32_000.0;

/// `value + ROUND` has `value`, rounded to an integer (halves to even), in its lowest 32 bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Added before rounding by [`Edge::crossing`]: half less a little.
const CEIL_BIAS: f64 = 0.5 - 1.0 / 67_108_864.0;

/// One segment, upper end first. Small, because large drawings have millions and read each from memory once a band.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Edge {
    /// The upper end, in 1/256 px.
    x: i32,
    y: i32,
    /// Change of x per change of y.
    slope: f64,
    /// The first sample row met.
    first: u32,
    /// Twice the row after the last one met, and 1 more if the path runs up.
    end_and_direction: u32,
}

impl Edge {
    /// Sample rows met: `first..end`, in 32 bits.
    #[inline(always)]
    pub(crate) fn rows(&self) -> [i32; 2] {
        [self.first as i32, (self.end_and_direction >> 1) as i32]
    }

    /// 1 if the path runs down along it, -1 if up.
    #[inline(always)]
    pub(crate) fn direction(&self) -> i32 {
        1 - 2 * (self.end_and_direction & 1) as i32
    }

    /// The smallest integer x, in 1/256 px, at or right of the edge in the row of samples at `y`; exact.
    ///
    /// With integer ends no more than 2^24 apart, `t = (y - y0) * slope` is off by less than 2^-27, and the true value is
    /// an integer or at least 2^-24 away from one. So `t - 2^-26` lies strictly between the answer and the integer below
    /// it, and half more than that rounds to the answer.
    #[inline(always)]
    pub(crate) fn crossing(&self, y: i32) -> i32 {
        let t = f64::from(y - self.y) * self.slope;
        self.x.wrapping_add(((t + CEIL_BIAS) + ROUND).to_bits() as i32)
    }
}

/// Collects the edges of shapes, one after the other.
pub(crate) struct EdgeBuilder<'a> {
    samples: &'a SampleRows,
    edges: Vec<Edge>,
    /// Where the edges of the shape at hand begin.
    first: usize,
    /// Width and height of what is drawn, in pixels.
    size: [u32; 2],
    /// Smallest and largest x of the ends of edges, in 1/256 px.
    extent_x: [i32; 2],
    /// Smallest and largest sample row met.
    extent_rows: [i32; 2],
    start: Point,
    last: Point,
}

/// A point in pixels, and snapped to 1/256 px if it lies within limits.
#[derive(Clone, Copy, Default)]
struct Point {
    exact: [f64; 2],
    snapped: Option<[i32; 2]>,
}

impl Point {
    #[inline(always)]
    fn new(exact: [f64; 2]) -> Self {
        let inside = exact[0].abs() <= LIMIT && exact[1].abs() <= LIMIT;
        Self { exact, snapped: inside.then(|| exact.map(snap)) }
    }
}

/// To 1/256 px, halves to even; for values within limits.
#[inline(always)]
fn snap(value: f64) -> i32 {
    (value * 256.0 + ROUND).to_bits() as i32
}

impl<'a> EdgeBuilder<'a> {
    /// A builder for shapes in a picture of `size` pixels.
    pub(crate) fn new(samples: &'a SampleRows, size: [u32; 2]) -> Self {
        Self {
            samples,
            edges: Vec::new(),
            first: 0,
            size,
            extent_x: [i32::MAX, i32::MIN],
            extent_rows: [i32::MAX, i32::MIN],
            start: Point::default(),
            last: Point::default(),
        }
    }

    /// Forgets all shapes.
    pub(crate) fn clear(&mut self) {
        self.edges.clear();
    }

    /// Starts a shape.
    pub(crate) fn begin_shape(&mut self) {
        self.first = self.edges.len();
        self.extent_x = [i32::MAX, i32::MIN];
        self.extent_rows = [i32::MAX, i32::MIN];
    }

    /// Where the edges of the shape lie in [`edges`](Self::edges), in the order of its contours.
    pub(crate) fn shape(&self) -> Range<usize> {
        self.first..self.edges.len()
    }

    /// The edges of all shapes.
    pub(crate) fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// Sample rows in a band.
    pub(crate) fn rows_per_band(&self) -> u32 {
        super::coverage::BAND_ROWS * self.samples.rows() as u32
    }

    /// Pixel columns `start..end` that the shape may touch, within the picture; empty if none.
    pub(crate) fn columns(&self) -> [u32; 2] {
        let last = i64::from(self.size[0]);
        let column = |x: i64| x.clamp(0, last) as u32;
        if self.shape().is_empty() { [0, 0] } else { self.extent_x.map(i64::from).map_ends(column) }
    }

    /// Pixel rows `start..end` that the shape may touch, within the picture; empty if none.
    pub(crate) fn rows(&self) -> [u32; 2] {
        let rows = self.samples.rows() as i32;
        if self.shape().is_empty() {
            [0, 0]
        } else {
            [(self.extent_rows[0] / rows) as u32, (self.extent_rows[1] + rows - 1) as u32 / rows as u32]
        }
    }

    /// Starts a contour; the one before is closed by a line.
    #[inline]
    pub(crate) fn move_to(&mut self, point: [f64; 2]) {
        self.close();
        self.start = Point::new(point);
        self.last = self.start;
    }

    /// Adds a segment.
    #[inline]
    pub(crate) fn line_to(&mut self, point: [f64; 2]) {
        let point = Point::new(point);
        self.segment(self.last, point);
        self.last = point;
    }

    /// Closes the contour by a line.
    #[inline]
    pub(crate) fn close(&mut self) {
        self.segment(self.last, self.start);
        self.last = self.start;
    }

    /// True if a box, in pixels, lies beside the picture. Above, below and right of it nothing changes a winding number
    /// inside; left of it, all that counts is from which row to which row a line runs.
    #[inline(always)]
    pub(crate) fn is_out_of_sight(&self, low: [f64; 2], high: [f64; 2]) -> bool {
        let [width, height] = self.size.map(f64::from);
        // A pixel more than snapping could move.
        high[0] < -1.0 || high[1] < -1.0 || low[0] > width + 1.0 || low[1] > height + 1.0
    }

    #[inline(always)]
    fn segment(&mut self, a: Point, b: Point) {
        match (a.snapped, b.snapped) {
            (Some(a), Some(b)) => self.snapped_segment(a, b),
            _ => self.far_segment(a.exact, b.exact),
        }
    }

    #[inline(always)]
    fn snapped_segment(&mut self, a: [i32; 2], b: [i32; 2]) {
        let (upper, lower, runs_up) = if a[1] < b[1] { (a, b, 0) } else { (b, a, 1) };
        let end_of_picture = self.size[1] as i32 * self.samples.rows() as i32;
        let first = self.samples.first_row(upper[1]).max(0);
        let end = self.samples.first_row(lower[1]).min(end_of_picture);
        if first >= end {
            return;
        }
        let (left, right) = (upper[0].min(lower[0]), upper[0].max(lower[0]));
        self.extent_x = [self.extent_x[0].min(left), self.extent_x[1].max(right)];
        // What lies right of the picture changes no winding number in it.
        if i64::from(left) >= i64::from(self.size[0]) << 8 {
            return;
        }
        let slope = f64::from(lower[0] - upper[0]) / f64::from(lower[1] - upper[1]);
        let (first_row, end_and_direction) = (first as u32, 2 * end as u32 + runs_up);
        self.edges.push(Edge { x: upper[0], y: upper[1], slope, first: first_row, end_and_direction });
        self.extent_rows = [self.extent_rows[0].min(first), self.extent_rows[1].max(end)];
    }

    /// A segment with an end beyond the limits: cut to the rows of the picture, then moved in where it is too far left
    /// or right. Cut from the upper end, whatever the direction, so that neighbours are cut alike.
    #[cold]
    fn far_segment(&mut self, a: [f64; 2], b: [f64; 2]) {
        if !a.iter().chain(&b).all(|value| value.is_finite()) || a[1] == b[1] {
            return;
        }
        let (upper, lower, runs_down) = if a[1] < b[1] { (a, b, true) } else { (b, a, false) };
        let slope = (lower[0] - upper[0]) / (lower[1] - upper[1]);
        let (top, bottom) = (upper[1].max(-1.0), lower[1].min(f64::from(self.size[1]) + 1.0));
        if !slope.is_finite() || top >= bottom {
            return;
        }
        // Where it leaves the limits at the sides, it is bent.
        let mut ys = vec![top, bottom];
        ys.extend(
            [-LIMIT, LIMIT].map(|x| upper[1] + (x - upper[0]) / slope).iter().filter(|y| **y > top && **y < bottom),
        );
        ys.sort_unstable_by(f64::total_cmp);
        let point = |y: f64| [(upper[0] + (y - upper[1]) * slope).clamp(-LIMIT, LIMIT), y].map(snap);
        for pair in ys.windows(2) {
            let (from, to) = (point(pair[0]), point(pair[1]));
            if runs_down {
                self.snapped_segment(from, to);
            } else {
                self.snapped_segment(to, from);
            }
        }
    }
}

/// Maps the ends of a range of coordinates in 1/256 px to pixel columns, the end exclusive.
trait MapEnds {
    fn map_ends(self, column: impl Fn(i64) -> u32) -> [u32; 2];
}

impl MapEnds for [i64; 2] {
    fn map_ends(self, column: impl Fn(i64) -> u32) -> [u32; 2] {
        [column(self[0] >> 8), column((self[1] >> 8) + 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon::target::SamplePattern;

    #[test]
    fn crossings_are_exact() {
        let samples = SampleRows::new(SamplePattern::grid(16).unwrap());
        let mut random = 1u64;
        let mut next = |range: i64| {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((random >> 33) as i64 % range) as i32
        };
        for round in 0..200_000 {
            let reach = if round % 2 == 0 { 8_192_000 } else { 2_000 };
            let [a, b] = [[next(2 * reach) - reach as i32, next(reach)], [next(2 * reach) - reach as i32, next(reach)]];
            let mut builder = EdgeBuilder::new(&samples, [u32::MAX >> 9, 32_000]);
            builder.snapped_segment(a, b);
            let Some(edge) = builder.edges().first() else { continue };
            let (upper, lower) = if a[1] < b[1] { (a, b) } else { (b, a) };
            let (dx, dy) = (i128::from(lower[0] - upper[0]), i128::from(lower[1] - upper[1]));
            for y in [upper[1], lower[1], upper[1] + next(dy as i64)] {
                let numerator = i128::from(upper[0]) * dy + i128::from(y - upper[1]) * dx;
                let expected = -(-numerator).div_euclid(dy);
                assert_eq!(i128::from(edge.crossing(y)), expected, "{a:?} {b:?} at {y}");
            }
        }
    }

    #[test]
    fn far_and_broken_points_are_harmless() {
        let samples = SampleRows::new(SamplePattern::grid(16).unwrap());
        for far in [1e5, -1e9, 1e300, -1e308, f64::INFINITY, f64::NAN] {
            let mut builder = EdgeBuilder::new(&samples, [100, 100]);
            builder.move_to([10.0, 10.0]);
            builder.line_to([far, 20.0]);
            builder.line_to([20.0, far]);
            builder.close();
            for edge in builder.edges() {
                let [first, end] = edge.rows();
                for y in (first..end).map(|row| row * 64) {
                    assert!(edge.crossing(y).abs() <= 8_192_001, "{far} {edge:?}");
                }
            }
        }
    }
}
