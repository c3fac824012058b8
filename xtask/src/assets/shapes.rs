//! Shapes that the still life is made of: surfaces of revolution, blocks, polygons, the faceted ball.

use super::bezier::Curve;
use super::mesh::{Corner, Face, grid};
use super::vector::{V2, V3, add, cross, length, lerp, normalize, scale, sub};

/// One stretch of the profile of a surface of revolution.
///
/// A profile runs with the inside of the body to its left, where x is the distance from the axis and y the height:
/// outwards along the bottom, up the outer wall, back along the top.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stretch {
    pub(crate) curve: Curve,
    /// Rows of quads along the curve.
    pub(crate) rows: u32,
    /// The texture's v at both ends.
    pub(crate) v: [f64; 2],
}

impl Stretch {
    pub(crate) fn new(curve: Curve, rows: u32, v: [f64; 2]) -> Self {
        Self { curve, rows, v }
    }

    pub(crate) fn line(a: V2, b: V2, v: [f64; 2]) -> Self {
        Self::new(Curve::line(a, b), 1, v)
    }
}

/// The profile turned about the y axis; u runs once around, times `u_repeats`, counter-clockwise seen from above.
pub(crate) fn revolve(profile: &[Stretch], columns: u32, u_repeats: f64) -> Vec<Face> {
    let mut faces = Vec::new();
    for stretch in profile {
        faces.extend(grid(columns, stretch.rows, |s, t| {
            let ([radius, height], slope) = (stretch.curve.point(t), stretch.curve.derivative(t));
            let (sin, cos) = libm::sincos(s * std::f64::consts::TAU);
            let outward = normalize([slope[1], -slope[0], 0.0]);
            Corner {
                position: [radius * cos, height, -radius * sin],
                uv: [s * u_repeats, lerp(stretch.v[0], stretch.v[1], t)],
                normal: [outward[0] * cos, outward[1], -outward[0] * sin],
            }
        }));
    }
    faces
}

/// A flat polygon with n corners on a circle, looking up (`facing` 1) or down (-1); its texture is seen from above
/// and repeats every `1 / uv_scale` units, with (0, 0) at the back left corner of the circle's square.
pub(crate) fn disc(radius: f64, height: f64, n: u32, facing: f64, uv_scale: f64) -> Vec<Face> {
    let corner = |index: u32| {
        let (sin, cos) = libm::sincos(f64::from(index) / f64::from(n) * std::f64::consts::TAU * facing);
        let position = [radius * cos, height, -radius * sin];
        let uv = [(position[0] + radius) * uv_scale, (radius - position[2]) * uv_scale];
        Corner { position, uv, normal: [0.0, facing, 0.0] }
    };
    vec![(0..n).map(corner).collect()]
}

/// One flat quad from `origin` along `right` and `up`, seen from right x up; its texture is `uv_size` wide and high.
pub(crate) fn quad(origin: V3, right: V3, up: V3, uv_size: V2) -> Face {
    let normal = normalize(cross(right, up));
    let corner = |s: f64, t: f64| Corner {
        position: add(origin, add(scale(right, s), scale(up, t))),
        uv: [s * uv_size[0], t * uv_size[1]],
        normal,
    };
    vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)]
}

/// A box between two corners; one unit of length is `uv_scale` of the texture, which runs along the longest side.
pub(crate) fn block(low: V3, high: V3, uv_scale: f64) -> Vec<Face> {
    let [w, h, d] = sub(high, low);
    let (x, y, z) = ([w, 0.0, 0.0], [0.0, h, 0.0], [0.0, 0.0, d]);
    let minus = |v: V3| scale(v, -1.0);
    let sides = [
        (add(low, z), x, y),
        (add(low, x), minus(x), y),
        (add(low, add(x, z)), minus(z), y),
        (low, z, y),
        (add(low, add(y, z)), x, minus(z)),
        (low, x, z),
    ];
    let mut faces = Vec::new();
    for (origin, right, up) in sides {
        let (across, along) = (length(right) * uv_scale, length(up) * uv_scale);
        let mut face = quad(origin, right, up, [across, along]);
        if along > across {
            for corner in &mut face {
                corner.uv.swap(0, 1);
            }
        }
        faces.push(face);
    }
    faces
}

/// A square tile of the given half width, its top narrower by `bevel`: the top carries the texture `repeats` times
/// each way, the bevel and the sides its border.
pub(crate) fn tile(half: f64, height: f64, bevel: f64, repeats: f64) -> Vec<Face> {
    let inner = half - bevel;
    let top = quad([-inner, height, inner], [2.0 * inner, 0.0, 0.0], [0.0, 0.0, -2.0 * inner], [repeats; 2]);
    let bottom = quad([-half, 0.0, -half], [2.0 * half, 0.0, 0.0], [0.0, 0.0, 2.0 * half], [1.0, 1.0]);
    let mut faces = vec![top, bottom];
    let shoulder = height - bevel;
    let directions =
        [([1.0, 0.0], [0.0, 1.0]), ([0.0, -1.0], [1.0, 0.0]), ([-1.0, 0.0], [0.0, -1.0]), ([0.0, 1.0], [-1.0, 0.0])];
    for (along, out) in directions {
        // A corner at the given share of the half width along the side, and distance from the centre.
        let corner = |a: f64, o: f64, y: f64, v: f64, normal: V3| Corner {
            position: [along[0] * a + out[0] * o, y, along[1] * a + out[1] * o],
            uv: [(a / half + 1.0) / 2.0, v],
            normal,
        };
        let (side, slope) = ([out[0], 0.0, out[1]], normalize([out[0], 1.0, out[1]]));
        faces.push(vec![
            corner(-half, half, 0.0, 0.0, side),
            corner(half, half, 0.0, 0.0, side),
            corner(half, half, shoulder, 0.02, side),
            corner(-half, half, shoulder, 0.02, side),
        ]);
        faces.push(vec![
            corner(-half, half, shoulder, 0.0, slope),
            corner(half, half, shoulder, 0.0, slope),
            corner(inner, inner, height, 0.02, slope),
            corner(-inner, inner, height, 0.02, slope),
        ]);
    }
    faces
}

/// A ball of 80 flat triangles around the origin: the icosahedron, each face cut in four, pushed out to `radius`.
pub(crate) fn faceted_ball(radius: f64) -> Vec<Face> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut corners: Vec<V3> = Vec::new();
    for a in [-1.0, 1.0] {
        for b in [-golden, golden] {
            corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
        }
    }
    let corners: Vec<V3> = corners.into_iter().map(normalize).collect();
    // Corners of the icosahedron that are neighbours are nearer than its radius times 1.1.
    let near = |a: V3, b: V3| length(sub(a, b)) < 1.1;
    let mut faces = Vec::new();
    for (i, &a) in corners.iter().enumerate() {
        for (j, &b) in corners.iter().enumerate().skip(i + 1) {
            for &c in corners.iter().skip(j + 1) {
                if near(a, b) && near(b, c) && near(c, a) {
                    faces.extend(quartered(a, b, c, radius));
                }
            }
        }
    }
    faces
}

/// Four triangles for one, all corners at `radius`, wound to look away from the origin.
fn quartered(a: V3, b: V3, c: V3, radius: f64) -> Vec<Face> {
    let is_outward = super::vector::dot(cross(sub(b, a), sub(c, a)), a) > 0.0;
    let (b, c) = if is_outward { (b, c) } else { (c, b) };
    let middle = |p: V3, q: V3| normalize(add(p, q));
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    let corner = |p: V3| Corner { position: scale(p, radius), uv: [0.0; 2], normal: p };
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]].map(|triangle| triangle.map(corner).to_vec()).to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::mesh::checks::{assert_sound, open_edges};
    use crate::assets::mesh::{Form, Part};

    fn assert_closed_and_sound(faces: Vec<Face>, form: Form) {
        assert_eq!(open_edges(&faces), 0);
        assert_sound(&Part::new("shape", "", form, faces), 4.0);
    }

    #[test]
    fn solids_are_closed_and_look_outwards() {
        let barrel = [
            Stretch::line([0.0, 0.0], [1.0, 0.0], [0.0, 0.2]),
            Stretch::new(Curve([[1.0, 0.0], [1.5, 0.3], [1.5, 0.7], [1.0, 1.0]]), 4, [0.2, 0.8]),
            Stretch::line([1.0, 1.0], [0.0, 1.0], [0.8, 1.0]),
        ];
        assert_closed_and_sound(revolve(&barrel, 12, 3.0), Form::Full);
        assert_closed_and_sound(block([-1.0, 0.0, -2.0], [1.0, 3.0, 2.0], 1.0), Form::Full);
        assert_closed_and_sound(tile(1.0, 0.5, 0.1, 3.0), Form::Full);
        assert_closed_and_sound(faceted_ball(1.0), Form::Position);
    }

    #[test]
    fn the_ball_has_eighty_faces() {
        assert_eq!(faceted_ball(1.0).len(), 80);
    }

    #[test]
    fn discs_look_up_or_down() {
        for facing in [1.0, -1.0] {
            assert_sound(&Part::new("disc", "", Form::Full, disc(2.0, 0.0, 16, facing, 0.25)), 1.0);
        }
    }
}
