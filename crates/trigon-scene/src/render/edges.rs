//! The edges of a mesh, each once: what a wireframe draws.
//!
//! In: triangles. Out: pairs of vertices. Vertices at one place count as one, or edges along seams of texture
//! coordinates would be drawn twice.

use crate::scene::Mesh;
use std::collections::HashMap;

/// The edges of all triangles of `mesh`, in order of their vertices.
pub(super) fn unique_edges(mesh: &Mesh) -> Vec<[u32; 2]> {
    let places = places(&mesh.positions);
    let place = |vertex: u32| usize::try_from(vertex).ok().and_then(|i| places.get(i)).copied();
    let mut edges = Vec::with_capacity(mesh.triangles.len() * 3);
    for [a, b, c] in &mesh.triangles {
        let [Some(a), Some(b), Some(c)] = [place(*a), place(*b), place(*c)] else { continue };
        for (from, to) in [(a, b), (b, c), (c, a)] {
            if from != to {
                edges.push([from.min(to), from.max(to)]);
            }
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// For each vertex, the first one at its place.
fn places(positions: &[[f32; 3]]) -> Vec<u32> {
    let mut first = HashMap::with_capacity(positions.len());
    (0u32..).zip(positions).map(|(i, p)| *first.entry(p.map(f32::to_bits)).or_insert(i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quad_with_a_seam_has_five_edges() {
        let mesh = Mesh {
            positions: vec![[0.; 3], [1., 0., 0.], [1., 1., 0.], [0.; 3], [1., 1., 0.], [0., 1., 0.]],
            triangles: vec![[0, 1, 2], [3, 4, 5], [5, 5, 5], [0, 1, 99]],
            ..Mesh::default()
        };
        assert_eq!(unique_edges(&mesh), [[0, 1], [0, 2], [0, 5], [1, 2], [2, 5]]);
    }
}
