//! Polygons with texture coordinates and normals, in the order of an OBJ file: objects, parts, faces, corners.
//!
//! Winding is counter-clockwise seen from the side the normals point to.

use super::vector::{Placement, V2, V3, add, cross, length, normalize, sub};

/// One corner of a face.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) position: V3,
    pub(crate) uv: V2,
    /// Unit length.
    pub(crate) normal: V3,
}

/// A polygon.
pub(crate) type Face = Vec<Corner>;

/// Faces of one group and one material.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    pub(crate) group: &'static str,
    pub(crate) material: &'static str,
    pub(crate) form: Form,
    pub(crate) faces: Vec<Face>,
}

/// What the file says about each corner; between them the models use all four index forms of OBJ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Form {
    /// `f v v v`, and `s off`: the reader makes one normal per face.
    Position,
    /// `f v/vt v/vt v/vt`, and `s off`.
    PositionUv,
    /// `f v//vn v//vn v//vn`.
    PositionNormal,
    /// `f v/vt/vn v/vt/vn v/vt/vn`.
    Full,
}

impl Form {
    pub(crate) fn has_uv(self) -> bool {
        matches!(self, Self::PositionUv | Self::Full)
    }

    pub(crate) fn has_normal(self) -> bool {
        matches!(self, Self::PositionNormal | Self::Full)
    }
}

/// What stands on the table as one thing.
#[derive(Debug, Clone)]
pub(crate) struct Object {
    pub(crate) name: &'static str,
    pub(crate) parts: Vec<Part>,
}

impl Part {
    pub(crate) fn new(group: &'static str, material: &'static str, form: Form, faces: Vec<Face>) -> Self {
        Self { group, material, form, faces }
    }
}

impl Object {
    pub(crate) fn new(name: &'static str, parts: Vec<Part>) -> Self {
        Self { name, parts }
    }

    /// The object, moved to its place.
    pub(crate) fn placed(mut self, placement: Placement) -> Self {
        for part in &mut self.parts {
            part.faces = placed(std::mem::take(&mut part.faces), placement);
        }
        self
    }
}

/// The faces, moved to their place.
pub(crate) fn placed(mut faces: Vec<Face>, placement: Placement) -> Vec<Face> {
    for corner in faces.iter_mut().flatten() {
        corner.position = placement.point(corner.position);
        corner.normal = placement.direction(corner.normal);
    }
    faces
}

/// The faces with the normal of their plane at every corner.
pub(crate) fn faceted(mut faces: Vec<Face>) -> Vec<Face> {
    for face in &mut faces {
        let normal = normalize(area_normal(face));
        for corner in face {
            corner.normal = normal;
        }
    }
    faces
}

/// The normal of a polygon, as long as twice its area (Newell's method).
fn area_normal(face: &[Corner]) -> V3 {
    let mut sum = [0.0; 3];
    for (index, corner) in face.iter().enumerate() {
        let next = face[(index + 1) % face.len()];
        sum = add(sum, cross(sub(corner.position, face[0].position), sub(next.position, face[0].position)));
    }
    sum
}

/// Quads over a parameter square: `surface(s, t)` at (`columns` + 1) x (`rows` + 1) points of [0, 1] x [0, 1].
///
/// Counter-clockwise where ds x dt points to the viewer. A quad with an edge of no length becomes a triangle, whose
/// point at the pole takes the texture coordinate between those of the vanished edge.
pub(crate) fn grid(columns: u32, rows: u32, surface: impl Fn(f64, f64) -> Corner) -> Vec<Face> {
    let at = |column: u32, row: u32| surface(f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
    let mut faces = Vec::new();
    for row in 0..rows {
        for column in 0..columns {
            let quad = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
            faces.push(without_points(&quad));
        }
    }
    faces
}

/// The polygon without edges of no length.
fn without_points(corners: &[Corner]) -> Face {
    let mut face: Face = Vec::with_capacity(corners.len());
    for (index, corner) in corners.iter().enumerate() {
        let next = corners[(index + 1) % corners.len()];
        if is_same_place(corner.position, next.position) {
            continue;
        }
        let previous = corners[(index + corners.len() - 1) % corners.len()];
        let mut kept = *corner;
        if is_same_place(corner.position, previous.position) {
            kept.uv = [(corner.uv[0] + previous.uv[0]) / 2.0, (corner.uv[1] + previous.uv[1]) / 2.0];
        }
        face.push(kept);
    }
    face
}

fn is_same_place(a: V3, b: V3) -> bool {
    length(sub(a, b)) < 1e-6
}

#[cfg(test)]
pub(crate) mod checks {
    //! What every mesh of the generator must satisfy, for the tests of the shapes.

    use super::{Face, Part, area_normal};
    use crate::assets::vector::{V3, dot, length, normalize};
    use std::collections::HashMap;

    /// Faces have area, normals are unit and on the side of the winding, texture coordinates are in 0..=`uv_limit`.
    pub(crate) fn assert_sound(part: &Part, uv_limit: f64) {
        assert!(!part.faces.is_empty());
        for face in &part.faces {
            let face_normal = area_normal(face);
            assert!(face.len() >= 3 && length(face_normal) > 1e-6, "degenerate face in {}: {face:?}", part.group);
            for corner in face {
                if part.form.has_uv() {
                    let inside = corner.uv.iter().all(|x| (-1e-9..=uv_limit + 1e-9).contains(x));
                    assert!(inside, "uv in {}: {:?}", part.group, corner.uv);
                }
                if part.form.has_normal() {
                    let agreement = dot(corner.normal, normalize(face_normal));
                    assert!(
                        (length(corner.normal) - 1.0).abs() < 1e-6,
                        "normal in {}: {:?}",
                        part.group,
                        corner.normal
                    );
                    assert!(agreement > 0.1, "{agreement} between normal and winding in {} at {corner:?}", part.group);
                }
            }
        }
    }

    /// The position in steps of 1/10000, to compare by.
    #[expect(clippy::cast_possible_truncation, reason = "models are a few units large")]
    fn key(p: V3) -> [i64; 3] {
        p.map(|x| (x * 1e4).round() as i64)
    }

    /// The number of directed edges that no edge of another face runs against, by position.
    pub(crate) fn open_edges(faces: &[Face]) -> usize {
        let mut edges: HashMap<([i64; 3], [i64; 3]), i32> = HashMap::new();
        for face in faces {
            for (index, corner) in face.iter().enumerate() {
                let (a, b) = (key(corner.position), key(face[(index + 1) % face.len()].position));
                *edges.entry((a, b)).or_default() += 1;
                *edges.entry((b, a)).or_default() -= 1;
            }
        }
        edges.values().filter(|count| **count > 0).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_over_a_pole_ends_in_triangles() {
        let fan = grid(4, 2, |s, t| Corner { position: [t * (s - 0.5), t, 0.0], uv: [s, t], normal: [0.0, 0.0, -1.0] });
        assert_eq!(fan.iter().map(Vec::len).collect::<Vec<_>>(), [3, 3, 3, 3, 4, 4, 4, 4]);
        let pole = fan[0].iter().find(|corner| corner.position == [0.0; 3]).unwrap();
        assert!((pole.uv[0] - 0.125).abs() < 1e-12);
    }
}
