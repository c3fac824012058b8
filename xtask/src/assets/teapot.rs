//! The Utah teapot: Martin Newell's 32 bicubic patches of 1975, to quads with exact normals.
//!
//! The published control points have much symmetry, and only what is left of it is in the tables. Body, lid and
//! bottom are six profiles turned about the axis: in each quarter a control point (r, q, h) of the profile becomes
//! (r, 0), (r, q), (q, r), (0, r) at height h, with q = 0.56 r where an exact circle would need 0.5523 r. Handle and spout are two
//! patches each and their mirror images. Heights are those of the teapot as it is usually drawn, three quarters of
//! the first one; the bottom was added later (F. Crow, "The Origins of the Teapot", 1987).

use super::bezier::{Curve, Patch};
use super::mesh::{Corner, Face, Form, Object, Part, grid};
use super::vector::{V2, V3, lerp};

/// Control points (r, q, h) of a profile, its place in the glaze, and its rows of quads.
struct Ring {
    points: [V3; 4],
    v: [f64; 2],
    rows: u32,
}

/// From the knob down over the lid.
const LID: [Ring; 2] = [
    Ring {
        points: [[0.0, 0.0, 3.15], [0.8, 0.45, 3.15], [0.0, 0.0, 2.85], [0.2, 0.112, 2.7]],
        v: [0.83, 0.77],
        rows: 7,
    },
    Ring {
        points: [[0.2, 0.112, 2.7], [0.4, 0.224, 2.55], [1.3, 0.728, 2.55], [1.3, 0.728, 2.4]],
        v: [0.77, 0.62],
        rows: 5,
    },
];

/// From inside the rim down the wall to under the foot.
const BODY: [Ring; 4] = [
    Ring {
        points: [[1.4, 0.784, 2.4], [1.3375, 0.749, 2.53125], [1.4375, 0.805, 2.53125], [1.5, 0.84, 2.4]],
        v: [0.61, 0.58],
        rows: 4,
    },
    Ring {
        points: [[1.5, 0.84, 2.4], [1.75, 0.98, 1.875], [2.0, 1.12, 1.35], [2.0, 1.12, 0.9]],
        v: [0.58, 0.27],
        rows: 6,
    },
    Ring {
        points: [[2.0, 1.12, 0.9], [2.0, 1.12, 0.45], [1.5, 0.84, 0.225], [1.5, 0.84, 0.15]],
        v: [0.27, 0.06],
        rows: 5,
    },
    Ring {
        points: [[1.5, 0.84, 0.15], [1.5, 0.84, 0.075], [1.425, 0.798, 0.0], [0.0, 0.0, 0.0]],
        v: [0.06, 0.0],
        rows: 3,
    },
];

/// One side of a handle or spout: four rows along its length, each across from one edge to the other, as
/// (x, distance from the plane of symmetry, height).
type HalfTube = [[V3; 4]; 4];

const HANDLE: [HalfTube; 2] = [
    [
        [[-1.6, 0.0, 2.025], [-1.6, 0.3, 2.025], [-1.5, 0.3, 2.25], [-1.5, 0.0, 2.25]],
        [[-2.3, 0.0, 2.025], [-2.3, 0.3, 2.025], [-2.5, 0.3, 2.25], [-2.5, 0.0, 2.25]],
        [[-2.7, 0.0, 2.025], [-2.7, 0.3, 2.025], [-3.0, 0.3, 2.25], [-3.0, 0.0, 2.25]],
        [[-2.7, 0.0, 1.8], [-2.7, 0.3, 1.8], [-3.0, 0.3, 1.8], [-3.0, 0.0, 1.8]],
    ],
    [
        [[-2.7, 0.0, 1.8], [-2.7, 0.3, 1.8], [-3.0, 0.3, 1.8], [-3.0, 0.0, 1.8]],
        [[-2.7, 0.0, 1.575], [-2.7, 0.3, 1.575], [-3.0, 0.3, 1.35], [-3.0, 0.0, 1.35]],
        [[-2.5, 0.0, 1.125], [-2.5, 0.3, 1.125], [-2.65, 0.3, 0.9375], [-2.65, 0.0, 0.9375]],
        [[-2.0, 0.0, 0.9], [-2.0, 0.3, 0.9], [-1.9, 0.3, 0.6], [-1.9, 0.0, 0.6]],
    ],
];

const SPOUT: [HalfTube; 2] = [
    [
        [[1.7, 0.0, 1.425], [1.7, 0.66, 1.425], [1.7, 0.66, 0.6], [1.7, 0.0, 0.6]],
        [[2.6, 0.0, 1.425], [2.6, 0.66, 1.425], [3.1, 0.66, 0.825], [3.1, 0.0, 0.825]],
        [[2.3, 0.0, 2.1], [2.3, 0.25, 2.1], [2.4, 0.25, 2.025], [2.4, 0.0, 2.025]],
        [[2.7, 0.0, 2.4], [2.7, 0.25, 2.4], [3.3, 0.25, 2.4], [3.3, 0.0, 2.4]],
    ],
    [
        [[2.7, 0.0, 2.4], [2.7, 0.25, 2.4], [3.3, 0.25, 2.4], [3.3, 0.0, 2.4]],
        [[2.8, 0.0, 2.475], [2.8, 0.25, 2.475], [3.525, 0.25, 2.49375], [3.525, 0.0, 2.49375]],
        [[2.9, 0.0, 2.475], [2.9, 0.15, 2.475], [3.45, 0.15, 2.5125], [3.45, 0.0, 2.5125]],
        [[2.8, 0.0, 2.4], [2.8, 0.15, 2.4], [3.2, 0.15, 2.4], [3.2, 0.0, 2.4]],
    ],
];

/// Where handle and spout take their colour: u along their length, v across, from one edge to the other.
const TUBE_V: [f64; 2] = [0.87, 0.985];
/// The glaze repeats so often in a quarter of the circumference.
const REPEATS_PER_QUARTER: f64 = 2.0;

/// How finely the patches are cut.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fineness {
    /// Quads in a quarter of the circumference.
    pub(crate) quarter: u32,
    /// Rows of a profile, in halves of what its table says.
    pub(crate) row_halves: u32,
    /// Quads along and across half of a handle or spout patch.
    pub(crate) tube: u32,
}

/// The whole teapot on y = 0, its axis at the origin, the spout towards +x, 6.4 wide and 3.15 high.
pub(crate) fn teapot(fineness: Fineness) -> Object {
    let part = |group, faces| Part::new(group, "glaze", Form::Full, faces);
    Object::new(
        "teapot",
        vec![
            part("body", rings(&BODY, fineness)),
            part("lid", rings(&LID, fineness)),
            part("handle", tube(&HANDLE, [0.0, 1.5, 3.0], fineness)),
            part("spout", tube(&SPOUT, [0.0, 1.5, 2.0], fineness)),
        ],
    )
}

fn rings(rings: &[Ring], fineness: Fineness) -> Vec<Face> {
    let mut faces = Vec::new();
    for ring in rings {
        let rows = (ring.rows * fineness.row_halves).div_ceil(2);
        for quarter in 0..4_u8 {
            let patch = quarter_patch(ring, quarter);
            faces.extend(grid(fineness.quarter, rows, |s, t| {
                let u = (f64::from(quarter) + s) * REPEATS_PER_QUARTER;
                corner(&patch, s, t, [u, lerp(ring.v[0], ring.v[1], along(ring, t))])
            }));
        }
    }
    faces
}

/// The quarter of the turned profile that begins `quarter` right angles from +x, towards +z: clockwise from above,
/// because the profiles run downwards.
fn quarter_patch(ring: &Ring, quarter: u8) -> Patch {
    let row = |[r, q, h]: V3| {
        [[r, 0.0], [r, q], [q, r], [0.0, r]].map(|[a, b]| match quarter {
            0 => [a, h, b],
            1 => [-b, h, a],
            2 => [-a, h, -b],
            _ => [b, h, -a],
        })
    };
    Patch(ring.points.map(row))
}

/// The share of the profile's length up to `t`, so that the glaze is not stretched along the wall.
fn along(ring: &Ring, t: f64) -> f64 {
    let [a, b, c, d] = ring.points.map(|[r, _, h]| [r, h]);
    let between = |p: V2, q: V2| [lerp(p[0], q[0], t), lerp(p[1], q[1], t)];
    // The first part of the curve by de Casteljau's construction.
    let (ab, bc, cd) = (between(a, b), between(b, c), between(c, d));
    let (abc, bcd) = (between(ab, bc), between(bc, cd));
    let first = Curve([a, ab, abc, between(abc, bcd)]);
    first.length() / Curve([a, b, c, d]).length()
}

/// Both sides of a handle or spout; `u` is the glaze's at its beginning, between the patches and at its end.
fn tube(halves: &[HalfTube; 2], u: [f64; 3], fineness: Fineness) -> Vec<Face> {
    let mut faces = Vec::new();
    for (index, half) in halves.iter().enumerate() {
        // The second half holds the tight bends: the lip of the spout, the foot of the handle.
        let rows = if index == 0 { fineness.tube } else { fineness.tube * 4 / 3 };
        for side in [1.0, -1.0] {
            // Both sides must be wound alike: the mirrored one runs across from the other edge.
            let row = |points: [V3; 4]| {
                let [a, b, c, d] = points.map(|[x, z, h]| [x, h, z * side]);
                if side > 0.0 { [a, b, c, d] } else { [d, c, b, a] }
            };
            let patch = Patch(half.map(row));
            faces.extend(grid(fineness.tube, rows, |s, t| {
                let across = if side > 0.0 { s } else { 1.0 - s };
                corner(&patch, s, t, [lerp(u[index], u[index + 1], t), lerp(TUBE_V[0], TUBE_V[1], across)])
            }));
        }
    }
    faces
}

fn corner(patch: &Patch, s: f64, t: f64, uv: V2) -> Corner {
    Corner { position: patch.point(s, t), uv, normal: patch.normal(s, t) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::mesh::checks::{assert_sound, open_edges};

    const COARSE: Fineness = Fineness { quarter: 6, row_halves: 2, tube: 6 };

    #[test]
    fn every_part_looks_outwards_and_stays_in_the_glaze() {
        for part in teapot(COARSE).parts {
            assert_sound(&part, 8.0);
        }
    }

    #[test]
    fn it_is_as_large_as_published() {
        let teapot = teapot(COARSE);
        let positions = teapot.parts.iter().flat_map(|part| part.faces.iter().flatten()).map(|corner| corner.position);
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        for position in positions {
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let near = |a: f64, b: f64| (a - b).abs() < 0.03;
        assert!(near(low[0], -3.0) && near(high[0], 3.43) && near(low[1], 0.0) && near(high[1], 3.15));
        assert!(near(low[2], -2.0) && near(high[2], 2.0), "{low:?} {high:?}");
    }

    #[test]
    fn only_the_designed_borders_are_open() {
        // The body ends at the rim and the lid at its edge: two circles; handle and spout at both ends.
        let open: Vec<usize> = teapot(COARSE).parts.iter().map(|part| open_edges(&part.faces)).collect();
        assert_eq!(open, [24, 24, 24, 24]);
    }

    #[test]
    fn v_grows_with_the_length_of_the_wall() {
        let ring = &BODY[1];
        assert!(along(ring, 0.0).abs() < 1e-12 && (along(ring, 1.0) - 1.0).abs() < 1e-12);
        assert!((0..20).all(|step| along(ring, f64::from(step) / 20.0) < along(ring, f64::from(step + 1) / 20.0)));
    }
}
