//! Ear clipping: a simple polygon in the plane in, triangles out.
//!
//! An ear is a convex corner whose triangle holds no other corner; cutting it off leaves a smaller polygon (Meisters,
//! "Polygons have ears", 1975). Only reflex corners can lie in a triangle, so only they are tested, found through a
//! grid. A budget of tests bounds the time for hostile polygons.

use super::grid::Grid;
use super::triangulate::Cut;

/// A point in the plane of the polygon.
pub(super) type Point = [f64; 2];

/// Tests of a corner against a triangle that are granted per corner of the polygon.
const TESTS_PER_CORNER: usize = 512;

/// Twice the signed area of a triangle; positive if it turns counterclockwise.
#[inline]
pub(super) fn orientation(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Ear clipping with memory kept between calls.
#[derive(Default)]
pub(super) struct EarClipper {
    /// Neighbours in the polygon that is left.
    previous: Vec<usize>,
    next: Vec<usize>,
    reflex: Grid,
    tests_left: usize,
}

impl EarClipper {
    /// Appends `points.len() - 2` triangles that cover the counterclockwise polygon.
    pub(super) fn clip(&mut self, points: &[Point], triangles: &mut Vec<[usize; 3]>) -> Cut {
        let n = points.len();
        self.previous.clear();
        self.previous.extend((0..n).map(|i| (i + n - 1) % n));
        self.next.clear();
        self.next.extend((0..n).map(|i| (i + 1) % n));
        let is_reflex = |&i: &usize| orientation(points[(i + n - 1) % n], points[i], points[(i + 1) % n]) <= 0.0;
        self.reflex.fill(points, (0..n).filter(is_reflex));
        self.tests_left = n.saturating_mul(TESTS_PER_CORNER);

        let mut cut = Cut::Exact;
        let mut at = 0;
        for left in (3..=n).rev() {
            let ear = match self.find_ear(points, at, left) {
                Some(ear) => ear,
                None => {
                    cut = Cut::BestEffort;
                    at
                }
            };
            let (before, after) = (self.previous[ear], self.next[ear]);
            triangles.push([before, ear, after]);
            self.next[before] = after;
            self.previous[after] = before;
            // Going on behind the neighbour makes rounder triangles than eating one corner after the other.
            at = self.next[after];
        }
        cut
    }

    /// The first corner from `start` on that can be cut off: an ear, or else one in a straight line. `None` if there is
    /// none, or none that can be found within the budget.
    fn find_ear(&mut self, points: &[Point], start: usize, left: usize) -> Option<usize> {
        let mut straight = None;
        let mut at = start;
        for _ in 0..left {
            let triangle = [points[self.previous[at]], points[at], points[self.next[at]]];
            let area = orientation(triangle[0], triangle[1], triangle[2]);
            if left == 3 && area >= 0.0 {
                return Some(at);
            }
            self.tests_left = self.tests_left.checked_sub(1)?;
            if area > 0.0 && !self.holds_corner(points, triangle) {
                return Some(at);
            }
            if area == 0.0 && straight.is_none() {
                straight = Some(at);
            }
            at = self.next[at];
        }
        straight
    }

    /// Whether a corner that is left lies in the triangle or on its border, its own corners and their doubles apart.
    fn holds_corner(&mut self, points: &[Point], triangle: [Point; 3]) -> bool {
        let [a, b, c] = triangle;
        let (next, previous) = (&self.next, &self.previous);
        let mut tests = 0;
        let holds = self.reflex.near(triangle).any(|i| {
            tests += 1;
            let p = points[i];
            // Corners cut off are no longer linked.
            let is_left = next[previous[i]] == i;
            is_left
                && p != a
                && p != b
                && p != c
                && orientation(a, b, p) >= 0.0
                && orientation(b, c, p) >= 0.0
                && orientation(c, a, p) >= 0.0
        });
        self.tests_left = self.tests_left.saturating_sub(tests);
        holds
    }
}
