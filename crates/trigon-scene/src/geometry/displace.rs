//! Displacement: a mesh and height maps in, the mesh that these heights make of it out.
//!
//! Edges are halved until all are short enough where they lie after displacement, so that a relief gets triangles where
//! it is steep and a silhouette where it stands out. Then every place moves along the mean normal of all vertices there,
//! by the mean of their heights: a seam of texture coordinates or a hard edge moves as one and does not break open. Last,
//! normals are made anew from the displaced triangles; vertices share one where they shared one before.
//!
//! Robert L. Cook, "Shade Trees", 1984, section "Displacement Maps", and Cook, Carpenter, Catmull, "The Reyes Image
//! Rendering Architecture", 1987, which dices surfaces to the size of pixels as is done here.

use super::height_map::HeightMap;
use super::subdivide::{Edge, Surface};
use crate::math::vec3::{self, Vec3};
use crate::scene::Mesh;
use std::collections::HashMap;

/// What moves a mesh.
pub(crate) struct Relief<'a> {
    /// For each submesh, its heights.
    pub(crate) maps: Vec<Option<&'a HeightMap>>,
    /// How far a height of 1 moves, in model space.
    pub(crate) scale: f32,
    /// The height that moves nothing.
    pub(crate) middle: f32,
}

/// Edges this part of the right length before displacement are short enough, however long they are after it: where the two
/// sides of a seam disagree about the height there is a cliff, which no halving makes less steep.
const STEEPEST: f64 = 0.25;
/// More halvings than this no mesh needs: an edge is then a millionth of what it was.
const MOST_PASSES: usize = 20;

/// The displaced mesh, and whether all edges got as short as they should within `max_triangles`.
///
/// `excess` tells how many times too long the edge between two points is, 1 for just right.
pub(crate) fn displace(
    mesh: &Mesh,
    relief: &Relief<'_>,
    max_triangles: usize,
    excess: &dyn Fn([f32; 3], [f32; 3]) -> f64,
) -> (Mesh, bool) {
    let mut surface = Surface::new(mesh.clone());
    let mut passes_left = MOST_PASSES;
    loop {
        let moved = relief.moved(&surface);
        if passes_left == 0 {
            return (relief.finish(surface, moved), false);
        }
        passes_left -= 1;
        let mut edges = relief.long_edges(&surface, &moved, excess);
        // Each edge that is halved costs two triangles, one on either side.
        let room = max_triangles.saturating_sub(surface.mesh.triangles.len()) / 2;
        if edges.is_empty() || room == 0 {
            let is_fine = edges.is_empty();
            return (relief.finish(surface, moved), is_fine);
        }
        if edges.len() > room {
            passes_left = 0;
            edges.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
            edges.truncate(room);
        }
        let mut edges: Vec<Edge> = edges.into_iter().map(|(edge, _)| edge).collect();
        edges.sort_unstable();
        surface.split(&edges);
    }
}

impl Relief<'_> {
    /// Edges to halve, and how much too long they are; sorted, each once.
    fn long_edges(
        &self,
        surface: &Surface,
        moved: &Moved,
        excess: &dyn Fn([f32; 3], [f32; 3]) -> f64,
    ) -> Vec<(Edge, f64)> {
        let (flat, positions) = (&surface.mesh.positions, &moved.positions);
        let triangles: Vec<[u32; 3]> = surface
            .mesh
            .submeshes
            .iter()
            .zip(&self.maps)
            .filter(|(_, map)| map.is_some())
            .flat_map(|(submesh, _)| surface.mesh.triangles.get(submesh.triangles.clone()).unwrap_or_default())
            .copied()
            .collect();
        let edges = UniqueEdges::new(surface, &triangles);
        let is_long = |&(_, [from, to]): &(Edge, [usize; 2])| {
            excess(positions[from], positions[to]) > 1.0 && excess(flat[from], flat[to]) > STEEPEST
        };
        let mut is_marked: Vec<bool> = edges.list.iter().map(is_long).collect();
        // With any edge its triangle's longest one is halved, in the neighbours too: else slivers would arise whose
        // diagonals stay long for ever (Rivara, "Algorithms for Refining Triangular Grids", 1984).
        let longest: Vec<u32> = triangles
            .iter()
            .zip(&edges.of_triangles)
            .map(|(triangle, its)| its[longest_side(flat, *triangle)])
            .collect();
        let mut is_growing = true;
        while is_growing {
            is_growing = false;
            for (its_edges, longest) in edges.of_triangles.iter().zip(&longest) {
                let longest = *longest as usize;
                if !is_marked[longest] && its_edges.iter().any(|edge| is_marked[*edge as usize]) {
                    is_marked[longest] = true;
                    is_growing = true;
                }
            }
        }
        let marked = edges.list.into_iter().zip(is_marked).filter(|(_, is_marked)| *is_marked);
        marked.map(|((edge, [from, to]), _)| (edge, excess(positions[from], positions[to]))).collect()
    }

    /// Where every vertex goes.
    fn moved(&self, surface: &Surface) -> Moved {
        let mesh = &surface.mesh;
        let places = surface.place_count as usize;
        let mut heights = vec![(0.0_f64, 0_u32); places];
        let mut is_seen = vec![false; mesh.positions.len()];
        for (submesh, map) in mesh.submeshes.iter().zip(&self.maps) {
            let Some(map) = map else { continue };
            is_seen.fill(false);
            for vertex in mesh.triangles.get(submesh.triangles.clone()).unwrap_or_default().as_flattened() {
                let vertex = *vertex as usize;
                if !std::mem::replace(&mut is_seen[vertex], true) {
                    let (sum, count) = &mut heights[surface.places[vertex] as usize];
                    *sum += f64::from(map.at(mesh.uvs[vertex]));
                    *count += 1;
                }
            }
        }
        let mut directions = vec![[0.0; 3]; places];
        if mesh.normals.is_empty() {
            for triangle in &mesh.triangles {
                let normal = face_normal(&mesh.positions, *triangle);
                for vertex in triangle {
                    let direction = &mut directions[surface.places[*vertex as usize] as usize];
                    *direction = vec3::add(*direction, normal);
                }
            }
        } else {
            for (place, normal) in surface.places.iter().zip(&mesh.normals) {
                let direction = &mut directions[*place as usize];
                *direction = vec3::add(*direction, vec3::widen(*normal));
            }
        }
        let is_moved = heights.iter().map(|(_, count)| *count > 0).collect();
        let steps: Vec<Vec3> = heights
            .into_iter()
            .zip(directions)
            .map(|((sum, count), direction)| {
                let height = if count > 0 { sum / f64::from(count) - f64::from(self.middle) } else { 0.0 };
                let unit = vec3::normalized(direction).unwrap_or([0.0; 3]);
                vec3::scale(unit, height * f64::from(self.scale))
            })
            .collect();
        let position = |(position, place): (&[f32; 3], &u32)| {
            vec3::narrow(vec3::add(vec3::widen(*position), steps[*place as usize]))
        };
        Moved { positions: mesh.positions.iter().zip(&surface.places).map(position).collect(), is_moved }
    }

    /// The mesh with its vertices moved and their normals made anew.
    fn finish(&self, surface: Surface, moved: Moved) -> Mesh {
        let Surface { mut mesh, places, .. } = surface;
        mesh.positions = moved.positions;
        if mesh.normals.is_empty() {
            return mesh;
        }
        // One sum for each place and each normal that vertices had there.
        let mut numbers = HashMap::new();
        let groups: Vec<usize> = places
            .iter()
            .zip(&mesh.normals)
            .map(|(place, normal)| {
                let next = numbers.len();
                *numbers.entry((*place, normal.map(f32::to_bits))).or_insert(next)
            })
            .collect();
        let mut sums = vec![[0.0; 3]; numbers.len()];
        for triangle in &mesh.triangles {
            let normal = face_normal(&mesh.positions, *triangle);
            for vertex in triangle {
                let sum = &mut sums[groups[*vertex as usize]];
                *sum = vec3::add(*sum, normal);
            }
        }
        for (vertex, normal) in mesh.normals.iter_mut().enumerate() {
            if moved.is_moved[places[vertex] as usize]
                && let Some(unit) = vec3::normalized(sums[groups[vertex]])
            {
                *normal = vec3::narrow(unit);
            }
        }
        for (tangent, normal) in mesh.tangents.iter_mut().zip(&mesh.normals) {
            let ([x, y, z, sign], normal) = (*tangent, vec3::widen(*normal));
            let along = vec3::widen([x, y, z]);
            let level = vec3::sub(along, vec3::scale(normal, vec3::dot(along, normal)));
            if let Some(unit) = vec3::normalized(level) {
                let [x, y, z] = vec3::narrow(unit);
                *tangent = [x, y, z, sign];
            }
        }
        mesh
    }
}

/// Where vertices go, and which places do.
struct Moved {
    positions: Vec<[f32; 3]>,
    is_moved: Vec<bool>,
}

/// The edges of some triangles.
struct UniqueEdges {
    /// Sorted, each once, with the two vertices of one of its sides.
    list: Vec<(Edge, [usize; 2])>,
    /// For each triangle, where its edges are in the list.
    of_triangles: Vec<[u32; 3]>,
}

impl UniqueEdges {
    fn new(surface: &Surface, triangles: &[[u32; 3]]) -> Self {
        let mut sides: Vec<(Edge, u32, u8)> = Vec::with_capacity(3 * triangles.len());
        for (number, triangle) in (0_u32..).zip(triangles) {
            let [a, b, c] = surface.edges(*triangle);
            sides.extend([(a, number, 0), (b, number, 1), (c, number, 2)]);
        }
        sides.sort_unstable();
        let mut edges = Self { list: Vec::with_capacity(sides.len() / 2), of_triangles: vec![[0; 3]; triangles.len()] };
        for (edge, number, side) in sides {
            let (number, side) = (number as usize, usize::from(side));
            if edges.list.last().is_none_or(|(last, _)| *last != edge) {
                let [from, to] = [triangles[number][side], triangles[number][(side + 1) % 3]];
                edges.list.push((edge, [from as usize, to as usize]));
            }
            edges.of_triangles[number][side] = u32::try_from(edges.list.len() - 1).unwrap_or(u32::MAX);
        }
        edges
    }
}

/// The longest side of a triangle before displacement, 0 for that after the first corner: it decides about the shape of
/// triangles, not about their size.
fn longest_side(positions: &[[f32; 3]], triangle: [u32; 3]) -> usize {
    let [a, b, c] = triangle.map(|vertex| vec3::widen(positions[vertex as usize]));
    let lengths = [vec3::sub(b, a), vec3::sub(c, b), vec3::sub(a, c)].map(|side| vec3::dot(side, side));
    (1..3).fold(0, |best, i| if lengths[i] > lengths[best] { i } else { best })
}

/// A normal as long as twice the area of the triangle.
fn face_normal(positions: &[[f32; 3]], triangle: [u32; 3]) -> Vec3 {
    let [a, b, c] = triangle.map(|vertex| vec3::widen(positions[vertex as usize]));
    vec3::cross(vec3::sub(b, a), vec3::sub(c, a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{MaterialId, Submesh, TextureOptions};
    use std::collections::BTreeMap;
    use trigon_image::{DecodedImage, Rgba8Image};

    /// A cube whose six faces share no vertex: every edge is a seam of texture coordinates, and sharp.
    fn cube() -> Mesh {
        let mut mesh = Mesh::default();
        for axis in 0..3 {
            for side in [-1.0_f32, 1.0] {
                let first = u32::try_from(mesh.positions.len()).unwrap();
                for (u, v) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0_f32)] {
                    let mut position = [0.0; 3];
                    (position[axis], position[(axis + 1) % 3]) = (side, (2.0 * u - 1.0) * side);
                    position[(axis + 2) % 3] = 2.0 * v - 1.0;
                    let mut normal = [0.0; 3];
                    normal[axis] = side;
                    mesh.positions.push(position);
                    mesh.normals.push(normal);
                    mesh.uvs.push([u * 1.7, v * 0.9]);
                }
                mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
            }
        }
        mesh.submeshes = vec![
            Submesh { triangles: 0..6, ..Submesh::new(0, MaterialId(0)) },
            Submesh { triangles: 6..12, ..Submesh::new(0, MaterialId(1)) },
        ];
        mesh
    }

    fn bumpy() -> HeightMap {
        let pixels = (0..64_u8).map(|i| [i.wrapping_mul(37) ^ (i << 2); 3]).map(|[r, g, b]| [r, g, b, 255]).collect();
        HeightMap::new(&DecodedImage::Rgba8(Rgba8Image::from_pixels(8, 8, pixels).unwrap()), &TextureOptions::default())
    }

    fn longer_than(limit: f64) -> impl Fn([f32; 3], [f32; 3]) -> f64 {
        move |a, b| vec3::length(vec3::sub(vec3::widen(a), vec3::widen(b))) / limit
    }

    /// Each edge, in each direction, by the positions of its ends.
    fn assert_watertight(mesh: &Mesh) {
        let mut edges = BTreeMap::new();
        let bits = |vertex: u32| mesh.positions[vertex as usize].map(|c| (c + 0.0).to_bits());
        for [a, b, c] in &mesh.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((bits(*from), bits(*to))).or_insert(0) += 1;
            }
        }
        for ((from, to), count) in &edges {
            assert_eq!((count, edges.get(&(*to, *from))), (&1, Some(&1)), "an edge without its other side");
        }
    }

    #[test]
    fn seams_and_sharp_edges_do_not_break_open() {
        let (cube, map) = (cube(), bumpy());
        assert_watertight(&cube);
        // Both halves displaced, one of them, by another limit on triangles.
        for (maps, limit) in
            [([Some(&map), Some(&map)], 1 << 20), ([Some(&map), None], 1 << 20), ([Some(&map), Some(&map)], 501)]
        {
            let relief = Relief { maps: maps.to_vec(), scale: 0.4, middle: 0.5 };
            let (mesh, is_fine) = displace(&cube, &relief, limit, &longer_than(0.11));
            assert_eq!(mesh.validate(), Ok(()));
            assert_watertight(&mesh);
            assert!(mesh.triangles.len() > 400 && mesh.triangles.len() <= limit);
            assert_eq!(is_fine, limit > 501);
        }
    }

    #[test]
    fn edges_are_as_short_as_asked_and_heights_where_they_belong() {
        let map = bumpy();
        let relief = Relief { maps: vec![Some(&map); 2], scale: 0.3, middle: 0.25 };
        let (mesh, is_fine) = displace(&cube(), &relief, usize::MAX, &longer_than(0.2));
        assert!(is_fine);
        let position = |vertex: u32| mesh.positions[vertex as usize];
        // Away from seams, where there are cliffs.
        let is_inside = |p: [f32; 3]| p.iter().filter(|c| c.abs() < 0.8).count() == 2;
        for [a, b, c] in mesh.triangles.iter().filter(|t| t.iter().all(|vertex| is_inside(position(*vertex)))) {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                assert!(longer_than(0.2)(position(*from), position(*to)) <= 1.0);
            }
        }
        // On the face +x, inside of its border, points move along x alone.
        let mut seen = 0;
        for (p, uv) in mesh.positions.iter().zip(&mesh.uvs) {
            if p[0] > 0.85 && is_inside(*p) {
                assert!((p[0] - (1.0 + 0.3 * (map.at(*uv) - 0.25))).abs() < 1e-6);
                seen += 1;
            }
        }
        assert!(seen > 50, "{seen}");
        assert!(mesh.normals.iter().all(|n| (vec3::length(vec3::widen(*n)) - 1.0).abs() < 1e-6));
    }
}
