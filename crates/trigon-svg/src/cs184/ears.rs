//! Ear clipping: a simple polygon in, triangles out, in the order of the course's program.
//!
//! The classic by J. Ratcliff (2000): go round, cut off a corner that turns the right way and holds no other vertex. A
//! polygon that crosses itself is filled in part.

type Point = [f64; 2];

/// Steps after which a polygon is given up: far beyond any drawn by hand.
const MAX_STEPS: u64 = 1 << 31;

/// The corners of the triangles.
pub(super) fn triangulate(points: &[Point]) -> Vec<[Point; 3]> {
    let mut triangles = Vec::new();
    if points.len() < 3 {
        return triangles;
    }
    let mut left: Vec<Point> = points.to_vec();
    if doubled_area(points) <= 0.0 {
        left.reverse();
    }
    let mut tries = 2 * left.len();
    let mut steps = 0u64;
    let mut at = left.len() - 1;
    while left.len() > 2 && tries > 0 && steps < MAX_STEPS {
        tries -= 1;
        let n = left.len();
        let wrapped = |index: usize| if index >= n { 0 } else { index };
        let first = wrapped(at);
        let middle = wrapped(first + 1);
        let last = wrapped(middle + 1);
        at = middle;
        steps += n as u64;
        if is_ear(&left, first, middle, last) {
            triangles.push([left[first], left[middle], left[last]]);
            left.remove(middle);
            tries = 2 * left.len();
        }
    }
    triangles
}

fn doubled_area(points: &[Point]) -> f64 {
    let mut sum = 0.0;
    let mut before = points[points.len() - 1];
    for &point in points {
        sum += before[0] * point[1] - point[0] * before[1];
        before = point;
    }
    sum
}

fn is_ear(points: &[Point], first: usize, middle: usize, last: usize) -> bool {
    let (a, b, c) = (points[first], points[middle], points[last]);
    let is_corner = |index: usize| index == first || index == middle || index == last;
    let holds = |point: Point| cross(a, b, point) >= 0.0 && cross(b, c, point) >= 0.0 && cross(c, a, point) >= 0.0;
    cross(a, b, c) > 1e-10 && !points.iter().enumerate().any(|(index, point)| !is_corner(index) && holds(*point))
}

/// Twice the area of the triangle a, b, c, positive where it turns as the polygon.
fn cross(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(points: &[Point]) -> f64 {
        triangulate(points).iter().map(|[a, b, c]| cross(*a, *b, *c) / 2.0).sum()
    }

    #[test]
    fn areas_add_up_whatever_the_winding() {
        let mut arrow = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]];
        assert_eq!(area(&arrow), 10.0);
        arrow.reverse();
        assert_eq!(area(&arrow), 10.0);
        assert_eq!(triangulate(&arrow).len(), 3);
    }

    #[test]
    fn what_is_no_polygon_gives_nothing() {
        assert!(triangulate(&[]).is_empty());
        assert!(triangulate(&[[0.0, 0.0], [1.0, 1.0]]).is_empty());
        assert!(triangulate(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).is_empty());
        assert!(triangulate(&[[f64::NAN, 0.0], [1.0, 1.0], [2.0, 0.0]]).is_empty());
    }
}
