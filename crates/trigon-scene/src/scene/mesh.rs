//! Geometry: indexed triangles, line segments and points over shared vertex attributes.
//!
//! Structure of arrays: one `Vec` per attribute, all of the same length or empty, because the vertex stage reads each
//! attribute as a stream. A mesh is cut into [`Submesh`]es, each with one material and one named [`Part`].

use super::MaterialId;
use crate::math::Aabb;
use std::fmt;
use std::ops::Range;

/// Indexed geometry in model space.
///
/// Invariants ([`Mesh::validate`] checks them, loaders guarantee them): an attribute other than `positions` is empty
/// or as long as `positions`; every index is less than `positions.len()`; submesh ranges lie inside their lists and
/// cover them in order without overlap. Attribute values may be anything, infinities and NaN included.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Model-space positions.
    pub positions: Vec<[f32; 3]>,
    /// Unit vertex normals; zero where the file's is unusable.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates: u right, v down from the top row of the texture.
    pub uvs: Vec<[f32; 2]>,
    /// Linear-light RGB and straight alpha.
    pub colors: Vec<[f32; 4]>,
    /// Unit tangents along increasing u, and in the fourth component the sign (+1 or -1) `s` of the bitangent
    /// `s * cross(normal, tangent)`, which points along **decreasing** v (the picture's up), as normal maps expect.
    pub tangents: Vec<[f32; 4]>,
    /// Triangles; counterclockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Line segments.
    pub segments: Vec<[u32; 2]>,
    /// Points.
    pub points: Vec<u32>,
    /// Names of the parts that submeshes belong to.
    pub parts: Vec<Part>,
    /// Runs of primitives with one material and part, in drawing order.
    pub submeshes: Vec<Submesh>,
}

/// A named piece of a mesh; in OBJ the object (`o`) and group (`g`) statements in force.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Part {
    /// Object name; may be empty.
    pub object: String,
    /// Group names as written, separated by single blanks; may be empty.
    pub group: String,
}

/// A run of primitives that share a material and a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Submesh {
    /// Index into [`Mesh::parts`].
    pub part: u32,
    /// The surface.
    pub material: MaterialId,
    /// Range of [`Mesh::triangles`].
    pub triangles: Range<usize>,
    /// Range of [`Mesh::segments`].
    pub segments: Range<usize>,
    /// Range of [`Mesh::points`].
    pub points: Range<usize>,
}

impl Submesh {
    /// A submesh without primitives.
    #[must_use]
    pub fn new(part: u32, material: MaterialId) -> Self {
        Self { part, material, triangles: 0..0, segments: 0..0, points: 0..0 }
    }
}

/// The invariant of [`Mesh`] that does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MeshError {
    /// An attribute array is neither empty nor as long as `positions`.
    AttributeLength {
        /// Name of the attribute.
        attribute: &'static str,
        /// Its length.
        len: usize,
        /// The length of `positions`.
        positions: usize,
    },
    /// A primitive refers to a vertex that does not exist.
    IndexOutOfRange {
        /// Which list: `triangles`, `segments` or `points`.
        list: &'static str,
        /// The primitive in that list.
        primitive: usize,
    },
    /// Submesh ranges do not cover a primitive list in order.
    SubmeshRange {
        /// Which list: `triangles`, `segments` or `points`.
        list: &'static str,
    },
    /// A submesh names a part that does not exist.
    PartOutOfRange,
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AttributeLength { attribute, len, positions } => {
                write!(f, "mesh has {len} {attribute} for {positions} positions; give one each or none")
            }
            Self::IndexOutOfRange { list, primitive } => {
                write!(f, "entry {primitive} of mesh {list} refers to a vertex that does not exist")
            }
            Self::SubmeshRange { list } => write!(f, "submeshes do not cover the mesh's {list} in order"),
            Self::PartOutOfRange => write!(f, "a submesh refers to a part that does not exist"),
        }
    }
}

impl std::error::Error for MeshError {}

impl Mesh {
    /// Checks the invariants of the type.
    ///
    /// # Errors
    ///
    /// The first invariant found broken.
    pub fn validate(&self) -> Result<(), MeshError> {
        let positions = self.positions.len();
        let attributes = [
            ("normals", self.normals.len()),
            ("uvs", self.uvs.len()),
            ("colors", self.colors.len()),
            ("tangents", self.tangents.len()),
        ];
        if let Some(&(attribute, len)) = attributes.iter().find(|(_, len)| *len != 0 && *len != positions) {
            return Err(MeshError::AttributeLength { attribute, len, positions });
        }
        check_indices("triangles", &self.triangles, positions)?;
        check_indices("segments", &self.segments, positions)?;
        check_indices("points", self.points.as_chunks::<1>().0, positions)?;
        self.check_ranges("triangles", self.triangles.len(), |submesh| &submesh.triangles)?;
        self.check_ranges("segments", self.segments.len(), |submesh| &submesh.segments)?;
        self.check_ranges("points", self.points.len(), |submesh| &submesh.points)?;
        let parts = self.parts.len().max(1);
        let has_part = |submesh: &Submesh| usize::try_from(submesh.part).is_ok_and(|part| part < parts);
        if self.submeshes.iter().all(has_part) { Ok(()) } else { Err(MeshError::PartOutOfRange) }
    }

    /// The smallest box around the vertices that primitives refer to, in model space.
    #[must_use]
    pub fn bounding_box(&self) -> Aabb {
        let used = self.used_vertices();
        Aabb::from_points(self.positions.iter().zip(&used).filter(|(_, used)| **used).map(|(position, _)| position))
    }

    /// For each vertex, whether a primitive refers to it.
    #[must_use]
    pub fn used_vertices(&self) -> Vec<bool> {
        let mut used = vec![false; self.positions.len()];
        let indices = self.triangles.as_flattened().iter().chain(self.segments.as_flattened()).chain(&self.points);
        for &index in indices {
            if let Some(flag) = usize::try_from(index).ok().and_then(|i| used.get_mut(i)) {
                *flag = true;
            }
        }
        used
    }

    fn check_ranges(
        &self,
        list: &'static str,
        len: usize,
        range: impl Fn(&Submesh) -> &Range<usize>,
    ) -> Result<(), MeshError> {
        let mut next = 0;
        for range in self.submeshes.iter().map(range).filter(|range| !range.is_empty()) {
            if range.start != next {
                return Err(MeshError::SubmeshRange { list });
            }
            next = range.end;
        }
        if next == len { Ok(()) } else { Err(MeshError::SubmeshRange { list }) }
    }
}

fn check_indices<const N: usize>(
    list: &'static str,
    primitives: &[[u32; N]],
    vertices: usize,
) -> Result<(), MeshError> {
    let is_bad = |primitive: &[u32; N]| primitive.iter().any(|&i| usize::try_from(i).map_or(true, |i| i >= vertices));
    match primitives.iter().position(is_bad) {
        Some(primitive) => Err(MeshError::IndexOutOfRange { list, primitive }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_broken_invariant_is_named() {
        let submesh = Submesh { triangles: 0..1, ..Submesh::new(0, MaterialId(0)) };
        let good = Mesh {
            positions: vec![[0.0; 3]; 3],
            triangles: vec![[0, 1, 2]],
            submeshes: vec![submesh],
            ..Mesh::default()
        };
        assert_eq!(good.validate(), Ok(()));
        let bad = Mesh { uvs: vec![[0.0; 2]], ..good.clone() };
        assert_eq!(bad.validate(), Err(MeshError::AttributeLength { attribute: "uvs", len: 1, positions: 3 }));
        let bad = Mesh { triangles: vec![[0, 1, 3]], ..good.clone() };
        assert_eq!(bad.validate(), Err(MeshError::IndexOutOfRange { list: "triangles", primitive: 0 }));
        let bad = Mesh { points: vec![0], ..good.clone() };
        assert_eq!(bad.validate(), Err(MeshError::SubmeshRange { list: "points" }));
        let bad = Mesh { submeshes: vec![Submesh { part: 7, ..good.submeshes[0].clone() }], ..good };
        assert_eq!(bad.validate(), Err(MeshError::PartOutOfRange));
    }
}
