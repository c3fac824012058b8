//! Meshes of formats that store triangles over plain vertices, some with values per face: STL and PLY.
//!
//! Vertices are kept as they are unless something forces them apart: generated normals with a crease between, or
//! colours and texture coordinates that belong to faces.

use super::normals::{Smoothing, generate_normals};
use super::unify::{ABSENT, Corner, Unifier, gather};
use crate::load::LoadOptions;
use crate::scene::{MaterialId, Mesh, Part, Submesh};

/// What a file stores. Attribute lists are empty or as long as `positions`; indices are valid.
#[derive(Default)]
pub(crate) struct Facets {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) uvs: Vec<[f32; 2]>,
    /// Linear.
    pub(crate) colors: Vec<[f32; 4]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    /// For each corner of each triangle an entry of `extras`; empty if there are none.
    pub(crate) triangle_extras: Vec<[u32; 3]>,
    /// Values of corners that do not belong to the vertex: texture coordinates and linear colour.
    pub(crate) extras: Vec<Extra>,
    pub(crate) segments: Vec<[u32; 2]>,
    pub(crate) points: Vec<u32>,
    /// Parts: name and the triangle at which it begins.
    pub(crate) parts: Vec<(String, usize)>,
}

/// Values of a corner that replace those of its vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Extra {
    pub(crate) uv: Option<[f32; 2]>,
    pub(crate) color: Option<[f32; 4]>,
}

impl Facets {
    /// The mesh, all of one material.
    pub(crate) fn into_mesh(mut self, material: MaterialId, options: &LoadOptions) -> Mesh {
        let submeshes = self.submeshes(material);
        let parts = self.parts.iter().map(|(name, _)| Part { object: name.clone(), group: String::new() }).collect();
        let needs_normals = self.normals.is_empty() && !self.triangles.is_empty();
        if !needs_normals && self.triangle_extras.is_empty() {
            return Mesh {
                positions: self.positions,
                normals: self.normals,
                uvs: self.uvs,
                colors: self.colors,
                tangents: Vec::new(),
                triangles: self.triangles,
                segments: self.segments,
                points: self.points,
                parts,
                submeshes,
            };
        }
        let threads = options.thread_count();
        let mut corner_normals = Vec::new();
        if needs_normals {
            let smoothing = Smoothing::Angle(options.crease_cosine());
            let made = generate_normals(threads, &self.positions, &self.triangles, smoothing);
            self.normals = made.normals;
            corner_normals = made.corners;
        }
        let is_by_vertex = !needs_normals;
        let mut unifier = Unifier::new(self.positions.len());
        for (i, triangle) in self.triangles.iter_mut().enumerate() {
            let extras = self.triangle_extras.get(i).copied().unwrap_or([ABSENT; 3]);
            let normals = if is_by_vertex { *triangle } else { corner_normals[i] };
            for ((index, extra), normal) in triangle.iter_mut().zip(extras).zip(normals) {
                *index = unifier.vertex([*index, extra, normal]);
            }
        }
        for index in self.segments.as_flattened_mut().iter_mut().chain(&mut self.points) {
            *index = unifier.vertex([*index, ABSENT, if is_by_vertex { *index } else { ABSENT }]);
        }
        let vertices = unifier.into_vertices();
        Mesh {
            positions: gather(threads, &vertices, 0, &self.positions, [0.0; 3], |p| p),
            normals: gather(threads, &vertices, 2, &self.normals, [0.0; 3], |n| n),
            uvs: self.gather_extra(&vertices, &self.uvs, [0.0; 2], |extra| extra.uv),
            colors: self.gather_extra(&vertices, &self.colors, [1.0; 4], |extra| extra.color),
            tangents: Vec::new(),
            triangles: self.triangles,
            segments: self.segments,
            points: self.points,
            parts,
            submeshes,
        }
    }

    /// The values of extras where corners have them, else those of the vertices; empty if there are neither.
    fn gather_extra<const N: usize>(
        &self,
        vertices: &[Corner],
        values: &[[f32; N]],
        missing: [f32; N],
        pick: impl Fn(&Extra) -> Option<[f32; N]>,
    ) -> Vec<[f32; N]> {
        if values.is_empty() && !self.extras.iter().any(|extra| pick(extra).is_some()) {
            return Vec::new();
        }
        let value = |[position, extra, _]: &Corner| {
            let extra = self.extras.get(*extra as usize).and_then(&pick);
            extra.or_else(|| values.get(*position as usize).copied()).unwrap_or(missing)
        };
        vertices.iter().map(value).collect()
    }

    fn submeshes(&self, material: MaterialId) -> Vec<Submesh> {
        let mut submeshes = Vec::new();
        for (i, &(_, start)) in self.parts.iter().enumerate() {
            let end = self.parts.get(i + 1).map_or(self.triangles.len(), |&(_, start)| start);
            let part = u32::try_from(i).unwrap_or(u32::MAX);
            submeshes.push(Submesh { triangles: start..end, ..Submesh::new(part, material) });
        }
        if submeshes.is_empty() {
            submeshes.push(Submesh { triangles: 0..self.triangles.len(), ..Submesh::new(0, material) });
        }
        submeshes[0].segments = 0..self.segments.len();
        submeshes[0].points = 0..self.points.len();
        submeshes
    }
}
