//! Subdivision: a mesh and a set of edges in, the same surface with these edges halved out.
//!
//! Edges are told by the places of their ends, not by vertices: where texture coordinates or normals differ on the two
//! sides of an edge, it is two edges of vertices, and still one line in space. Both sides are halved at the same point,
//! and so no crack and no T-junction can appear, whatever the edges are.

use super::Welder;
use crate::scene::Mesh;
use std::collections::HashMap;

/// A mesh, and which of its vertices are at one place.
pub(crate) struct Surface {
    pub(crate) mesh: Mesh,
    /// For each vertex, the number of its place.
    pub(crate) places: Vec<u32>,
    pub(crate) place_count: u32,
}

/// Two places, the smaller number first, as one sortable number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Edge(u64);

impl Edge {
    /// The edge between two places.
    pub(crate) fn new(a: u32, b: u32) -> Self {
        Self(u64::from(a.min(b)) << 32 | u64::from(a.max(b)))
    }
}

impl Surface {
    /// Vertices are at one place where their positions are equal.
    pub(crate) fn new(mesh: Mesh) -> Self {
        let mut welder = Welder::with_capacity(mesh.positions.len());
        let places = mesh.positions.iter().map(|position| welder.index(*position)).collect();
        let place_count = u32::try_from(welder.into_positions().len()).unwrap_or(u32::MAX);
        Self { mesh, places, place_count }
    }

    /// The three edges of a triangle, each opposite to the corner two further on.
    pub(crate) fn edges(&self, triangle: [u32; 3]) -> [Edge; 3] {
        let [a, b, c] = triangle.map(|vertex| self.places[vertex as usize]);
        [Edge::new(a, b), Edge::new(b, c), Edge::new(c, a)]
    }

    /// Halves `edges`, which are sorted and each there once.
    pub(crate) fn split(&mut self, edges: &[Edge]) {
        let mut midpoints = Midpoints { edges, first_place: self.place_count, of_vertices: HashMap::new() };
        let mut triangles = Vec::with_capacity(self.mesh.triangles.len() + 2 * edges.len());
        let mut submeshes = std::mem::take(&mut self.mesh.submeshes);
        let old = std::mem::take(&mut self.mesh.triangles);
        for submesh in &mut submeshes {
            let first = triangles.len();
            for triangle in old.get(submesh.triangles.clone()).unwrap_or_default() {
                let [a, b, c] = *triangle;
                let halves = [(a, b), (b, c), (c, a)].map(|(from, to)| midpoints.between(self, from, to));
                self.cut(*triangle, halves, &mut triangles);
            }
            submesh.triangles = first..triangles.len();
        }
        self.mesh.submeshes = submeshes;
        self.mesh.triangles = triangles;
        self.place_count += u32::try_from(edges.len()).unwrap_or(0);
    }

    /// The parts of a triangle with midpoints on some of its edges, wound as it is.
    fn cut(&self, triangle: [u32; 3], halves: [Option<u32>; 3], out: &mut Vec<[u32; 3]>) {
        let [a, b, c] = triangle;
        match halves {
            [None, None, None] => out.push(triangle),
            [Some(ab), Some(bc), Some(ca)] => out.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]),
            [Some(ab), None, None] => out.extend([[a, ab, c], [ab, b, c]]),
            [Some(ab), Some(bc), None] => {
                out.push([ab, b, bc]);
                // The rest is a quad; it is cut along its shorter diagonal.
                if self.distance(a, bc) <= self.distance(ab, c) {
                    out.extend([[a, ab, bc], [a, bc, c]]);
                } else {
                    out.extend([[a, ab, c], [ab, bc, c]]);
                }
            }
            // One of these two, with the corners renamed.
            [None, Some(_), _] => self.cut([b, c, a], [halves[1], halves[2], halves[0]], out),
            [_, None, Some(_)] => self.cut([c, a, b], [halves[2], halves[0], halves[1]], out),
        }
    }

    /// The square of the distance of two vertices.
    fn distance(&self, a: u32, b: u32) -> f32 {
        let (a, b) = (self.mesh.positions[a as usize], self.mesh.positions[b as usize]);
        let d = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        (d[0] * d[0] + d[1] * d[1]) + d[2] * d[2]
    }

    /// A vertex halfway between two, at the given place.
    fn add_midpoint(&mut self, a: u32, b: u32, place: u32) -> u32 {
        let vertex = u32::try_from(self.places.len()).unwrap_or(u32::MAX);
        let (a, b) = (a as usize, b as usize);
        let mesh = &mut self.mesh;
        // Sums do not depend on the order of the two: both sides of a seam get the same bits.
        push_mean(&mut mesh.positions, a, b);
        push_mean(&mut mesh.uvs, a, b);
        push_mean(&mut mesh.colors, a, b);
        if let (Some(a), Some(b)) = (mesh.normals.get(a), mesh.normals.get(b)) {
            mesh.normals.push(unit_sum(*a, *b));
        }
        if let (Some([ax, ay, az, sign]), Some([bx, by, bz, _])) = (mesh.tangents.get(a), mesh.tangents.get(b)) {
            let [x, y, z] = unit_sum([*ax, *ay, *az], [*bx, *by, *bz]);
            mesh.tangents.push([x, y, z, *sign]);
        }
        self.places.push(place);
        vertex
    }
}

/// The vertices that halve edges.
struct Midpoints<'a> {
    edges: &'a [Edge],
    /// The place of the first edge's midpoint; the others follow in order.
    first_place: u32,
    /// Those made so far, by the two vertices.
    of_vertices: HashMap<(u32, u32), u32>,
}

impl Midpoints<'_> {
    /// The vertex between two, if their edge is to be halved.
    fn between(&mut self, surface: &mut Surface, a: u32, b: u32) -> Option<u32> {
        let edge = Edge::new(surface.places[a as usize], surface.places[b as usize]);
        let number = self.edges.binary_search(&edge).ok()?;
        let key = (a.min(b), a.max(b));
        if let Some(vertex) = self.of_vertices.get(&key) {
            return Some(*vertex);
        }
        let place = self.first_place + u32::try_from(number).ok()?;
        let vertex = surface.add_midpoint(a, b, place);
        self.of_vertices.insert(key, vertex);
        Some(vertex)
    }
}

fn push_mean<const N: usize>(values: &mut Vec<[f32; N]>, a: usize, b: usize) {
    if let (Some(a), Some(b)) = (values.get(a), values.get(b)) {
        values.push(std::array::from_fn(|c| (a[c] + b[c]) * 0.5));
    }
}

/// The unit vector between two; zero if they are opposite.
fn unit_sum(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    let sum = crate::math::vec3::widen(std::array::from_fn(|c| a[c] + b[c]));
    crate::math::vec3::normalized(sum).map_or([0.0; 3], crate::math::vec3::narrow)
}
