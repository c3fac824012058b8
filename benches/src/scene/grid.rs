//! Meshes made of patches: a function over the unit square in, a grid of quads out, each cut into two triangles.
//!
//! Vertex normals are the normalised sum of the unnormalised normals of the patch's faces around a vertex: large faces
//! count more.

use trigon_scene::math::vec3;

/// Triangles over shared vertices, in world space.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// World-space positions.
    pub positions: Vec<[f32; 3]>,
    /// World-space normals, one per position.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates, v down; one per position.
    pub uvs: Vec<[f32; 2]>,
    /// Vertex numbers.
    pub triangles: Vec<[u32; 3]>,
}

/// A point of a patch.
pub(super) struct PatchPoint {
    pub(super) position: [f32; 3],
    pub(super) uv: [f32; 2],
}

impl Mesh {
    /// Appends a patch of `columns` x `rows` quads: `point(a, b)` for a and b in 0..=1, a along the columns.
    #[expect(clippy::cast_precision_loss, reason = "grids have fewer than 2^24 lines")]
    pub(super) fn push_patch(&mut self, columns: u32, rows: u32, point: impl Fn(f32, f32) -> PatchPoint) {
        let (first_vertex, first_triangle) = (self.positions.len(), self.triangles.len());
        for row in 0..=rows {
            for column in 0..=columns {
                let at = point(column as f32 / columns as f32, row as f32 / rows as f32);
                self.positions.push(at.position);
                self.uvs.push(at.uv);
            }
        }
        let base = u32::try_from(first_vertex).expect("benchmark scenes have fewer than 2^32 vertices");
        for row in 0..rows {
            for column in 0..columns {
                let a = base + row * (columns + 1) + column;
                let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
                self.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
        self.push_normals(first_vertex, first_triangle);
    }

    /// Makes the normals of the vertices from `first_vertex` on, from the triangles from `first_triangle` on.
    fn push_normals(&mut self, first_vertex: usize, first_triangle: usize) {
        let mut sums = vec![[0.0f32; 3]; self.positions.len() - first_vertex];
        for triangle in &self.triangles[first_triangle..] {
            let [p, q, r] = triangle.map(|vertex| self.positions[vertex as usize]);
            let normal = cross(subtract(q, p), subtract(r, p));
            for vertex in triangle {
                let sum = &mut sums[*vertex as usize - first_vertex];
                *sum = core::array::from_fn(|k| sum[k] + normal[k]);
            }
        }
        let unit = |sum: [f32; 3]| vec3::normalized(vec3::widen(sum)).map_or([0.0, 1.0, 0.0], vec3::narrow);
        self.normals.extend(sums.into_iter().map(unit));
    }

    /// Appends another mesh.
    pub(super) fn append(&mut self, other: &Self) {
        let base = u32::try_from(self.positions.len()).expect("benchmark scenes have fewer than 2^32 vertices");
        self.positions.extend_from_slice(&other.positions);
        self.normals.extend_from_slice(&other.normals);
        self.uvs.extend_from_slice(&other.uvs);
        self.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|vertex| vertex + base)));
    }
}

fn subtract(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    core::array::from_fn(|k| a[k] - b[k])
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flat_patch_has_one_normal_and_covers_its_area() {
        let mut mesh = Mesh::default();
        mesh.push_patch(5, 3, |a, b| PatchPoint { position: [4.0 * a, 2.0 - 2.0 * b, 0.0], uv: [a, b] });
        assert_eq!(mesh.triangles.len(), 2 * 5 * 3);
        assert!(mesh.normals.iter().all(|normal| *normal == [0.0, 0.0, 1.0]), "{:?}", mesh.normals);
        let doubled = |t: &[u32; 3]| {
            let [p, q, r] = t.map(|vertex| mesh.positions[vertex as usize]);
            cross(subtract(q, p), subtract(r, p))[2]
        };
        let area: f32 = mesh.triangles.iter().map(doubled).sum::<f32>() / 2.0;
        assert!((area - 8.0).abs() < 1e-4, "{area}");
    }

    #[test]
    fn appended_triangles_keep_their_vertices() {
        let mut one = Mesh::default();
        one.push_patch(2, 2, |a, b| PatchPoint { position: [a, b, 1.0], uv: [a, b] });
        let mut both = one.clone();
        both.append(&one);
        let corner = |mesh: &Mesh, t: usize| mesh.triangles[t].map(|vertex| mesh.positions[vertex as usize]);
        assert_eq!(corner(&both, 8 + 3), corner(&one, 3));
    }
}
