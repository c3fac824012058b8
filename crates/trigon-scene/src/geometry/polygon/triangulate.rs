//! The entry to triangulation: quick ways for the usual polygons, the projection to a plane for the others.

use super::ears::{EarClipper, Point};
use crate::math::vec3::{self, Vec3};

/// How well a polygon could be cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cut {
    /// The triangles cover the polygon.
    Exact,
    /// The polygon crosses itself, has no area, or is too intricate: the triangles use every corner, but may overlap.
    BestEffort,
}

/// Cuts polygons into triangles; keeps its memory between calls.
#[derive(Default)]
pub(crate) struct Triangulator {
    points: Vec<Point>,
    clipper: EarClipper,
}

impl Triangulator {
    /// Appends `n - 2` triangles with the orientation of the polygon, as corner numbers `0..n`.
    ///
    /// `position(i)` is corner `i`. Fewer than three corners give nothing. Takes time in proportion to `n` log `n` for
    /// usual polygons and to a fixed multiple of `n` at worst.
    pub(crate) fn cut(
        &mut self,
        n: usize,
        position: impl Fn(usize) -> [f32; 3],
        triangles: &mut Vec<[usize; 3]>,
    ) -> Cut {
        match n {
            0..=2 => Cut::BestEffort,
            3 => {
                triangles.push([0, 1, 2]);
                Cut::Exact
            }
            4 => {
                let (cut, two) = cut_quad([position(0), position(1), position(2), position(3)]);
                triangles.extend(two);
                cut
            }
            _ => self.cut_polygon(n, position, triangles),
        }
    }

    fn cut_polygon(&mut self, n: usize, position: impl Fn(usize) -> [f32; 3], triangles: &mut Vec<[usize; 3]>) -> Cut {
        let corner = |i: usize| vec3::widen(position(i));
        let fan = (1..n - 1).map(|i| [0, i, i + 1]);
        let Some(normal) = newell_normal(n, &corner) else {
            triangles.extend(fan);
            return Cut::BestEffort;
        };
        let origin = corner(0);
        let (x, y) = plane_axes(normal);
        self.points.clear();
        self.points.extend((0..n).map(|i| {
            let p = vec3::sub(corner(i), origin);
            [p[x], p[y]]
        }));
        if is_convex(&self.points) {
            triangles.extend(fan);
            return Cut::Exact;
        }
        let start = triangles.len();
        let cut = self.clipper.clip(&self.points, triangles);
        if cut == Cut::Exact {
            return cut;
        }
        // A warped polygon may overlap itself seen along an axis, but not along its normal.
        let along_x = vec3::normalized(vec3::cross(least_axis(normal), normal)).unwrap_or([1.0, 0.0, 0.0]);
        let along_y = vec3::cross(normal, along_x);
        for (i, point) in self.points.iter_mut().enumerate() {
            let p = vec3::sub(corner(i), origin);
            *point = [vec3::dot(p, along_x), vec3::dot(p, along_y)];
        }
        triangles.truncate(start);
        self.clipper.clip(&self.points, triangles)
    }
}

/// The coordinate axis that the normal points along least.
fn least_axis(normal: Vec3) -> Vec3 {
    let size = normal.map(f64::abs);
    match size {
        [x, y, z] if x <= y && x <= z => [1.0, 0.0, 0.0],
        [_, y, z] if y <= z => [0.0, 1.0, 0.0],
        _ => [0.0, 0.0, 1.0],
    }
}

/// A quad is cut along the diagonal from its first corner, or along the other one where only that lies inside.
fn cut_quad(corners: [[f32; 3]; 4]) -> (Cut, [[usize; 3]; 2]) {
    let [a, b, c, d] = corners.map(vec3::widen);
    let (ac, bd) = (vec3::sub(c, a), vec3::sub(d, b));
    let normal = vec3::cross(ac, bd);
    // The diagonal is inside if the two other corners lie on different sides of it.
    let side = |from: Vec3, along: Vec3, p: Vec3| vec3::dot(vec3::cross(along, vec3::sub(p, from)), normal);
    let first = [[0, 1, 2], [0, 2, 3]];
    let second = [[0, 1, 3], [1, 2, 3]];
    if side(a, ac, b) <= 0.0 && side(a, ac, d) >= 0.0 {
        (Cut::Exact, first)
    } else if side(b, bd, c) <= 0.0 && side(b, bd, a) >= 0.0 {
        (Cut::Exact, second)
    } else {
        (Cut::BestEffort, first)
    }
}

/// Twice the vector area (Newell's method), if it is finite and not zero.
fn newell_normal(n: usize, corner: &impl Fn(usize) -> Vec3) -> Option<Vec3> {
    let origin = corner(0);
    let mut normal = [0.0; 3];
    let mut previous = vec3::sub(corner(n - 1), origin);
    for i in 0..n {
        let current = vec3::sub(corner(i), origin);
        normal = vec3::add(normal, vec3::cross(previous, current));
        previous = current;
    }
    vec3::normalized(normal)
}

/// The two coordinates that are left when the dominant one is dropped, ordered so that the polygon turns
/// counterclockwise.
fn plane_axes(normal: Vec3) -> (usize, usize) {
    let size = normal.map(f64::abs);
    let (drop, x, y) = match size {
        [nx, ny, nz] if nz >= nx && nz >= ny => (2, 0, 1),
        [nx, ny, _] if ny >= nx => (1, 2, 0),
        _ => (0, 1, 2),
    };
    if normal[drop] < 0.0 { (y, x) } else { (x, y) }
}

/// Whether the polygon turns left at every corner and around only once.
fn is_convex(points: &[Point]) -> bool {
    let n = points.len();
    let mut turns_in_x = 0;
    let mut last_sign = 0.0;
    for i in 0..n {
        let (a, b, c) = (points[i], points[(i + 1) % n], points[(i + 2) % n]);
        if super::ears::orientation(a, b, c) < 0.0 {
            return false;
        }
        // A convex outline changes its direction along x exactly twice.
        let sign = b[0] - a[0];
        if sign != 0.0 {
            if sign * last_sign < 0.0 {
                turns_in_x += 1;
            }
            last_sign = sign;
        }
    }
    turns_in_x <= 2
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(polygon: &[[f32; 3]]) -> (Cut, Vec<[usize; 3]>) {
        let mut triangles = Vec::new();
        let cut = Triangulator::default().cut(polygon.len(), |i| polygon[i], &mut triangles);
        (cut, triangles)
    }

    fn area_vector(polygon: &[[f32; 3]], triangle: [usize; 3]) -> Vec3 {
        let [a, b, c] = triangle.map(|i| vec3::widen(polygon[i]));
        vec3::scale(vec3::cross(vec3::sub(b, a), vec3::sub(c, a)), 0.5)
    }

    /// All triangles face the way of the polygon and their areas add up to its area: so they cover it exactly.
    fn assert_covers(polygon: &[[f32; 3]]) {
        let (cut, triangles) = cut(polygon);
        assert_eq!(cut, Cut::Exact, "{polygon:?}");
        assert_eq!(triangles.len(), polygon.len() - 2);
        let normal = newell_normal(polygon.len(), &|i| vec3::widen(polygon[i])).unwrap();
        let areas: Vec<f64> = triangles.iter().map(|&t| vec3::dot(area_vector(polygon, t), normal)).collect();
        let total: f64 = areas.iter().sum();
        assert!(areas.iter().all(|&a| a >= -1e-6 * total), "{areas:?}");
        let whole: f64 = (1..polygon.len() - 1).map(|i| vec3::dot(area_vector(polygon, [0, i, i + 1]), normal)).sum();
        assert!((total - whole).abs() <= 1e-5 * whole, "{total} {whole}");
    }

    fn flat(points: &[[f32; 2]]) -> Vec<[f32; 3]> {
        points.iter().map(|p| [p[0], p[1], 0.0]).collect()
    }

    #[test]
    fn convex_polygons_become_fans() {
        let square = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        assert_eq!(cut(&square), (Cut::Exact, vec![[0, 1, 2], [0, 2, 3]]));
        let hexagon = flat(&[[1.0, 0.0], [0.5, 0.9], [-0.5, 0.9], [-1.0, 0.0], [-0.5, -0.9], [0.5, -0.9]]);
        assert_eq!(cut(&hexagon).1, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]);
    }

    #[test]
    fn concave_polygons_are_covered_in_every_orientation_and_rotation() {
        let shapes: [&[[f32; 2]]; 5] = [
            &[[0.0, 0.0], [2.0, 0.0], [0.5, 0.5], [0.0, 2.0]],
            &[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [0.0, 4.0]],
            &[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [3.0, 2.0], [3.0, 3.0], [0.0, 3.0]],
            // A square with a hole, joined by a bridge walked twice.
            &[
                [0.0, 0.0],
                [9.0, 0.0],
                [9.0, 9.0],
                [0.0, 9.0],
                [0.0, 0.0],
                [3.0, 3.0],
                [3.0, 6.0],
                [6.0, 6.0],
                [6.0, 3.0],
                [3.0, 3.0],
            ],
            // Corners in a straight line.
            &[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 3.0], [1.5, 0.5], [0.0, 3.0]],
        ];
        for shape in shapes {
            for start in 0..shape.len() {
                let mut turned = shape.to_vec();
                turned.rotate_left(start);
                for reverse in [false, true] {
                    if reverse {
                        turned.reverse();
                    }
                    assert_covers(&flat(&turned));
                    let upright: Vec<_> = turned.iter().map(|p| [p[0] * 0.3, p[0] + 5.0, p[1]]).collect();
                    assert_covers(&upright);
                }
            }
        }
    }

    #[test]
    fn large_combs_and_spirals_are_cut_exactly() {
        let teeth = 500_u16;
        let comb = (0..teeth).flat_map(|i| [[f32::from(i), 10.0], [f32::from(i) + 0.5, 1.0]]);
        let mut points: Vec<[f32; 2]> = comb.collect();
        points.extend([[f32::from(teeth), 10.0], [f32::from(teeth), 0.0], [0.0, 0.0]]);
        points.reverse();
        assert_covers(&flat(&points));
        let arm = |radius: f64| {
            (0..2000_u16).map(move |i| {
                let angle = f64::from(i) * 0.02;
                let r = radius + angle;
                vec3::narrow([r * libm::cos(angle), r * libm::sin(angle), 0.0])
            })
        };
        let spiral: Vec<_> = arm(4.0).chain(arm(1.0).rev()).collect();
        assert_covers(&spiral);
    }

    #[test]
    fn hopeless_polygons_still_use_every_corner_and_end() {
        let mut state = 1_u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f32::from(u16::try_from(state >> 16).unwrap())
        };
        for n in [4, 5, 9, 60, 500, 5000] {
            let tangle: Vec<_> = (0..n).map(|_| [random(), random(), random()]).collect();
            assert_eq!(cut(&tangle).1.len(), n - 2);
        }
        for polygon in [vec![[1.0; 3]; 7], vec![[f32::NAN; 3]; 5], vec![[f32::INFINITY, 0.0, 0.0]; 6]] {
            let (quality, triangles) = cut(&polygon);
            assert_eq!((quality, triangles.len()), (Cut::BestEffort, polygon.len() - 2));
        }
    }
}
