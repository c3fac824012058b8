//! Tangents for normal maps: positions, normals and texture coordinates in, a tangent per vertex out, vertices split
//! where the corners that meet there need different ones.
//!
//! The algorithm is MikkTSpace (Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008), because baking tools use
//! it: only with the same tangents does a baked normal map give back the surface it was baked from.

use super::unify::{ABSENT, Unifier};
use crate::scene::{MaterialId, Mesh};
use bevy_mikktspace::{Geometry, Ops, TangentSpace, generate_tangents};
use std::collections::HashMap;

impl Mesh {
    /// Makes tangents for the triangles of the materials that `needs_tangents` selects; all others get zero. Vertices
    /// are split where needed, so indices change; the order of primitives does not.
    ///
    /// Does nothing if the mesh has tangents already, has no normals or texture coordinates, or no triangle is
    /// selected. Triangles with coordinates that are not finite get zero tangents.
    pub fn generate_tangents(&mut self, mut needs_tangents: impl FnMut(MaterialId) -> bool) {
        if !self.tangents.is_empty() || self.normals.is_empty() || self.uvs.is_empty() {
            return;
        }
        let submeshes = self.submeshes.iter().filter(|submesh| needs_tangents(submesh.material));
        let selected: Vec<usize> = submeshes.flat_map(|submesh| submesh.triangles.clone()).collect();
        let faces: Vec<usize> = selected.into_iter().filter(|&triangle| self.has_finite_corners(triangle)).collect();
        if faces.is_empty() {
            return;
        }
        let mut corners = Corners { mesh: self, tangents: vec![[0.0; 4]; 3 * faces.len()], faces };
        // The error type has no values.
        if generate_tangents(&mut corners).is_ok() {
            let Corners { faces, tangents, .. } = corners;
            self.split_by_tangent(&faces, &tangents);
        }
    }

    fn has_finite_corners(&self, triangle: usize) -> bool {
        self.triangles[triangle].iter().all(|&index| {
            let index = index as usize;
            let position = self.positions[index].iter().chain(&self.normals[index]).chain(&self.uvs[index]);
            position.copied().all(f32::is_finite)
        })
    }

    /// Gives each corner of `faces` its tangent, making new vertices where corners of one vertex differ.
    fn split_by_tangent(&mut self, faces: &[usize], tangents: &[[f32; 4]]) {
        let mut ids: HashMap<[u32; 4], u32> = HashMap::new();
        let mut distinct: Vec<[f32; 4]> = Vec::new();
        let mut corner_ids = vec![[ABSENT; 3]; self.triangles.len()];
        for (&face, tangents) in faces.iter().zip(tangents.as_chunks::<3>().0) {
            corner_ids[face] = tangents.map(|tangent| {
                *ids.entry(tangent.map(f32::to_bits)).or_insert_with(|| {
                    distinct.push(tangent);
                    u32::try_from(distinct.len() - 1).unwrap_or(ABSENT)
                })
            });
        }
        let mut unifier = Unifier::new(self.positions.len());
        for (triangle, ids) in self.triangles.iter_mut().zip(&corner_ids) {
            for (index, &id) in triangle.iter_mut().zip(ids) {
                *index = unifier.vertex([*index, id, ABSENT]);
            }
        }
        for index in self.segments.as_flattened_mut().iter_mut().chain(&mut self.points) {
            *index = unifier.vertex([*index, ABSENT, ABSENT]);
        }
        let vertices = unifier.into_vertices();
        let old = |vertex: &[u32; 3]| vertex[0] as usize;
        self.positions = vertices.iter().map(|vertex| self.positions[old(vertex)]).collect();
        self.normals = vertices.iter().map(|vertex| self.normals[old(vertex)]).collect();
        self.uvs = vertices.iter().map(|vertex| self.uvs[old(vertex)]).collect();
        if !self.colors.is_empty() {
            self.colors = vertices.iter().map(|vertex| self.colors[old(vertex)]).collect();
        }
        let tangent = |vertex: &[u32; 3]| distinct.get(vertex[1] as usize).copied().unwrap_or([0.0; 4]);
        self.tangents = vertices.iter().map(tangent).collect();
    }
}

/// Some triangles of a mesh, as MikkTSpace wants to see them.
struct Corners<'a> {
    mesh: &'a Mesh,
    faces: Vec<usize>,
    /// Three per face.
    tangents: Vec<[f32; 4]>,
}

impl Corners<'_> {
    fn vertex(&self, face: usize, corner: usize) -> usize {
        self.mesh.triangles[self.faces[face]][corner] as usize
    }
}

/// Exact on every machine, unlike the platform's functions.
struct ExactOps;

impl Ops for ExactOps {
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }

    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    fn acos(x: f32) -> f32 {
        libm::acos(f64::from(x)) as f32
    }
}

impl Geometry<ExactOps> for Corners<'_> {
    fn num_faces(&self) -> usize {
        self.faces.len()
    }

    fn num_vertices_of_face(&self, _face: usize) -> usize {
        3
    }

    fn position(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.positions[self.vertex(face, corner)]
    }

    fn normal(&self, face: usize, corner: usize) -> [f32; 3] {
        self.mesh.normals[self.vertex(face, corner)]
    }

    /// With v up, so that the bitangent points up in the picture.
    fn tex_coord(&self, face: usize, corner: usize) -> [f32; 2] {
        let [u, v] = self.mesh.uvs[self.vertex(face, corner)];
        [u, 1.0 - v]
    }

    fn set_tangent(&mut self, tangent_space: Option<TangentSpace>, face: usize, corner: usize) {
        self.tangents[3 * face + corner] = tangent_space.map_or([0.0; 4], |space| space.tangent_encoded());
    }
}

#[cfg(test)]
mod tests {
    use crate::load::{LoadOptions, load_bytes};
    use crate::math::vec3;
    use crate::scene::{MaterialId, Mesh};

    fn mesh(text: &str) -> Mesh {
        load_bytes("a.obj", text.as_bytes(), &LoadOptions::default()).unwrap().scene.meshes.remove(0)
    }

    /// A square in the xy plane, facing +z, with u along x and v (up) along y.
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

    #[test]
    fn tangents_follow_u_and_bitangents_the_pictures_up() {
        let mut square = mesh(&format!("{SQUARE}f 1/1 2/2 3/3 4/4\n"));
        square.generate_tangents(|_| true);
        square.validate().unwrap();
        assert_eq!(square.tangents, [[1.0, 0.0, 0.0, 1.0]; 4]);
        let bitangent = vec3::cross(vec3::widen(square.normals[0]), [1.0, 0.0, 0.0]);
        assert_eq!(bitangent, [0.0, 1.0, 0.0]);
    }

    #[test]
    fn mirrored_textures_split_the_vertices_between() {
        // Two squares side by side; the second one's u runs backwards.
        let text = format!("{SQUARE}v 2 0 0\nv 2 1 0\nf 1/1 2/2 3/3 4/4\nf 2/2 5/1 6/4 3/3\n");
        let mut mirrored = mesh(&text);
        assert_eq!(mirrored.positions.len(), 6);
        mirrored.generate_tangents(|_| true);
        mirrored.validate().unwrap();
        assert_eq!(mirrored.positions.len(), 8);
        let of = |triangle: usize| mirrored.tangents[mirrored.triangles[triangle][0] as usize];
        assert_eq!((of(0), of(3)), ([1.0, 0.0, 0.0, 1.0], [-1.0, 0.0, 0.0, -1.0]));
    }

    #[test]
    fn only_selected_materials_and_finite_triangles_take_part() {
        let text =
            format!("{SQUARE}v nan 0 0\nusemtl a\nf 1/1 2/2 3/3\nf 1/1 2/2 5/3\nusemtl b\nf 1/1 3/3 4/4\nl 1 2\np 4\n");
        let before = mesh(&text);
        let mut after = before.clone();
        after.generate_tangents(|material| material == MaterialId(0));
        after.validate().unwrap();
        let is_zero =
            |triangle: usize| after.triangles[triangle].iter().all(|&index| after.tangents[index as usize] == [0.0; 4]);
        assert_eq!([is_zero(0), is_zero(1), is_zero(2)], [false, true, true]);
        let positions = |mesh: &Mesh| -> Vec<[u32; 3]> {
            let indices = mesh.triangles.as_flattened().iter().chain(mesh.segments.as_flattened()).chain(&mesh.points);
            indices.map(|&index| mesh.positions[index as usize].map(f32::to_bits)).collect()
        };
        assert_eq!(positions(&after), positions(&before));
        let mut none = before.clone();
        none.generate_tangents(|_| false);
        assert_eq!(none.tangents.len(), 0);
    }
}
