//! Curves to lines: a path, a transform and a tolerance in; points out.
//!
//! A curve is cut at equal steps of its parameter, as many as its second differences ask for (Wang's bound). The points
//! depend on the curve alone, and are the same bit for bit when it is run backwards: each sum below is unchanged if its
//! control points are taken in reverse. So shapes that share a curve share its points.

use crate::canvas::{Path, PathElement, Transform};

/// Largest distance between a curve and its lines, in pixels.
pub(crate) const TOLERANCE: f64 = 0.05;

/// Most lines that one curve is cut into.
const MAX_STEPS: usize = 4096;

/// Most lines that the curves of one path are cut into together; curves of paths that would need more get equal shares.
/// Only paths that are mostly invisible reach it: four million lines of a pixel fill the largest picture.
const MAX_PATH_LINES: usize = 1 << 22;

/// Receives the lines of a path.
pub(crate) trait LineSink {
    /// Starts a contour.
    fn move_to(&mut self, point: [f64; 2]);
    /// Adds a line.
    fn line_to(&mut self, point: [f64; 2]);
    /// Ends the contour by a line to its start.
    fn close(&mut self);
    /// A curve begins (true) or ends (false): points in between are not corners.
    fn curve(&mut self, _begins: bool) {}
    /// True if only the ends matter of a curve between these corners of a box.
    fn is_out_of_sight(&self, _low: [f64; 2], _high: [f64; 2]) -> bool {
        false
    }
}

/// Sends the lines of `path`, transformed. Contours with a coordinate that is not finite are left out.
pub(crate) fn flatten(path: &Path, transform: &Transform, tolerance: f64, sink: &mut impl LineSink) {
    let elements = path.elements();
    let max_steps = max_steps(elements);
    let mut walk = Walk { transform, tolerance, max_steps, start: [0.0; 2], last: [0.0; 2], is_open: false };
    let mut index = 0;
    while index < elements.len() {
        let contour = contour_at(elements, index);
        if contour.iter().all(is_finite) {
            for element in contour {
                walk.element(element, sink);
            }
        }
        index += contour.len();
    }
}

/// Most lines for each curve of a path.
fn max_steps(elements: &[PathElement]) -> f64 {
    let is_curve = |element: &&PathElement| matches!(element, PathElement::QuadTo(..) | PathElement::CubicTo(..));
    let curves = elements.iter().filter(is_curve).count();
    (MAX_PATH_LINES / curves.max(1)).clamp(1, MAX_STEPS) as f64
}

/// The elements from `index` on, up to the next move.
fn contour_at(elements: &[PathElement], index: usize) -> &[PathElement] {
    let rest = &elements[index + 1..];
    let len = rest.iter().position(|element| matches!(element, PathElement::MoveTo(_))).unwrap_or(rest.len());
    &elements[index..=index + len]
}

fn is_finite(element: &PathElement) -> bool {
    let finite = |points: &[[f32; 2]]| points.as_flattened().iter().all(|value| value.is_finite());
    match *element {
        PathElement::MoveTo(p) | PathElement::LineTo(p) => finite(&[p]),
        PathElement::QuadTo(a, p) => finite(&[a, p]),
        PathElement::CubicTo(a, b, p) => finite(&[a, b, p]),
        PathElement::Close => true,
    }
}

/// Where the walk along a path stands, in pixels.
struct Walk<'a> {
    transform: &'a Transform,
    tolerance: f64,
    max_steps: f64,
    start: [f64; 2],
    last: [f64; 2],
    /// False after a move or a close that nothing has followed yet: then the next line starts a contour.
    is_open: bool,
}

impl Walk<'_> {
    fn element(&mut self, element: &PathElement, sink: &mut impl LineSink) {
        match *element {
            PathElement::MoveTo(p) => {
                self.start = self.point(p);
                self.last = self.start;
                self.is_open = false;
            }
            PathElement::LineTo(p) => {
                self.open(sink);
                self.line_to(self.point(p), sink);
            }
            PathElement::QuadTo(a, p) => {
                self.open(sink);
                self.quad_to(self.point(a), self.point(p), sink);
            }
            PathElement::CubicTo(a, b, p) => {
                self.open(sink);
                self.cubic_to(self.point(a), self.point(b), self.point(p), sink);
            }
            PathElement::Close => {
                self.open(sink);
                sink.close();
                self.last = self.start;
                self.is_open = false;
            }
        }
    }

    #[inline(always)]
    fn point(&self, [x, y]: [f32; 2]) -> [f64; 2] {
        self.transform.apply([f64::from(x), f64::from(y)])
    }

    #[inline(always)]
    fn open(&mut self, sink: &mut impl LineSink) {
        if !self.is_open {
            self.start = self.last;
            sink.move_to(self.start);
            self.is_open = true;
        }
    }

    #[inline(always)]
    fn line_to(&mut self, point: [f64; 2], sink: &mut impl LineSink) {
        sink.line_to(point);
        self.last = point;
    }

    fn quad_to(&mut self, a: [f64; 2], end: [f64; 2], sink: &mut impl LineSink) {
        let p = self.last;
        if is_out_of_sight(&[p, a, end], sink) {
            return self.line_to(end, sink);
        }
        let steps = steps(squared(second_difference(p, a, end)) * (0.25 * 0.25), self.tolerance, self.max_steps);
        sink.curve(true);
        for i in 1..steps {
            let (t, u) = (f64::from(i) / f64::from(steps), f64::from(steps - i) / f64::from(steps));
            let at = |axis: usize| ((u * u) * p[axis] + (t * t) * end[axis]) + 2.0 * ((u * t) * a[axis]);
            sink.line_to([at(0), at(1)]);
        }
        sink.curve(false);
        self.line_to(end, sink);
    }

    fn cubic_to(&mut self, a: [f64; 2], b: [f64; 2], end: [f64; 2], sink: &mut impl LineSink) {
        let p = self.last;
        if is_out_of_sight(&[p, a, b, end], sink) {
            return self.line_to(end, sink);
        }
        let (first, second) = (squared(second_difference(p, a, b)), squared(second_difference(a, b, end)));
        let larger = if first > second { first } else { second };
        let steps = steps(larger * (0.75 * 0.75), self.tolerance, self.max_steps);
        sink.curve(true);
        for i in 1..steps {
            let (t, u) = (f64::from(i) / f64::from(steps), f64::from(steps - i) / f64::from(steps));
            let (tt, uu) = (t * t, u * u);
            let at = |axis: usize| {
                ((uu * u) * p[axis] + (tt * t) * end[axis]) + 3.0 * ((uu * t) * a[axis] + (tt * u) * b[axis])
            };
            sink.line_to([at(0), at(1)]);
        }
        sink.curve(false);
        self.line_to(end, sink);
    }
}

/// A curve lies within the box around its control points.
#[inline(always)]
fn is_out_of_sight(points: &[[f64; 2]], sink: &impl LineSink) -> bool {
    let (mut low, mut high) = (points[0], points[0]);
    for point in points {
        for axis in 0..2 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    sink.is_out_of_sight(low, high)
}

/// `(p + r) - 2 q`.
#[inline(always)]
fn second_difference(p: [f64; 2], q: [f64; 2], r: [f64; 2]) -> [f64; 2] {
    [(p[0] + r[0]) - 2.0 * q[0], (p[1] + r[1]) - 2.0 * q[1]]
}

#[inline(always)]
fn squared([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
}

/// The smallest n with `bound / n^2 <= tolerance`, where `bound` is given squared; 1 to `max_steps`.
#[inline(always)]
fn steps(bound_squared: f64, tolerance: f64, max_steps: f64) -> u32 {
    let steps = (bound_squared.sqrt() / tolerance).sqrt();
    if steps >= max_steps {
        max_steps as u32
    } else if steps > 1.0 {
        // The cast truncates; one more rounds up, and at most one line more than needed does no harm.
        steps as u32 + 1
    } else {
        // NaN, too.
        1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Points(Vec<[f64; 2]>);

    impl LineSink for Points {
        fn move_to(&mut self, point: [f64; 2]) {
            self.0.push(point);
        }
        fn line_to(&mut self, point: [f64; 2]) {
            self.0.push(point);
        }
        fn close(&mut self) {}
    }

    fn points(path: &Path) -> Vec<[f64; 2]> {
        let mut points = Points::default();
        flatten(path, &Transform::new(3.1, 0.2, -0.7, 2.9, 5.5, 6.5), TOLERANCE, &mut points);
        points.0
    }

    #[test]
    fn curves_run_backwards_give_the_same_points() {
        let (mut there, mut back) = (Path::new(), Path::new());
        there.move_to(1.1, 2.3).cubic_to(50.7, 3.9, 7.3, 44.1, 33.3, 91.7).quad_to(60.1, 20.7, 80.9, 70.3);
        back.move_to(80.9, 70.3).quad_to(60.1, 20.7, 33.3, 91.7).cubic_to(7.3, 44.1, 50.7, 3.9, 1.1, 2.3);
        let reversed: Vec<[f64; 2]> = points(&back).into_iter().rev().collect();
        assert!(reversed.len() > 20);
        assert_eq!(points(&there), reversed);
    }

    #[test]
    fn lines_stay_within_the_tolerance_of_a_circle() {
        let mut circle = Points::default();
        flatten(&Path::circle(0.0, 0.0, 100.0), &Transform::IDENTITY, TOLERANCE, &mut circle);
        for pair in circle.0.windows(2) {
            let middle = [(pair[0][0] + pair[1][0]) / 2.0, (pair[0][1] + pair[1][1]) / 2.0];
            // Cubic circles are themselves up to 0.03 % off.
            assert!((squared(middle).sqrt() - 100.0).abs() < TOLERANCE + 0.03, "{middle:?}");
        }
    }

    #[test]
    fn the_lines_of_a_path_are_bounded() {
        struct Count(usize);
        impl LineSink for Count {
            fn move_to(&mut self, _: [f64; 2]) {}
            fn line_to(&mut self, _: [f64; 2]) {
                self.0 += 1;
            }
            fn close(&mut self) {}
        }
        for curves in [1, 1000, 10_000] {
            let mut path = Path::new();
            path.move_to(0.0, 0.0);
            for i in 0..curves {
                let end = if i % 2 == 0 { 1e30 } else { 0.0 };
                path.cubic_to(1e30, -1e30, -1e30, 1e30, end, end);
            }
            let mut count = Count(0);
            flatten(&path, &Transform::IDENTITY, TOLERANCE, &mut count);
            assert_eq!(count.0, curves * (MAX_PATH_LINES / curves).min(MAX_STEPS));
        }
    }

    #[test]
    fn broken_contours_are_left_out_and_the_rest_drawn() {
        let mut path = Path::new();
        path.move_to(0.0, 0.0).line_to(f32::NAN, 1.0).line_to(1.0, 1.0).close();
        path.move_to(5.0, 5.0).line_to(6.0, 5.0);
        assert_eq!(points(&path).len(), 2);
    }
}
