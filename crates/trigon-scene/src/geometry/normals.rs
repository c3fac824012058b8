//! Normals for meshes that have none: positions and triangles in, a normal for each corner out.
//!
//! The corners around a position share a normal if they belong to one smoothing group, or, where no groups are given,
//! if their faces meet at less than the crease angle. Faces are weighted by sin(angle) / (product of the adjacent edge
//! lengths), which is exact for vertices on a sphere and needs no trigonometry (Max, "Weights for Computing Vertex
//! Normals from Facet Normals", 1999).

use crate::load::parallel_map;
use crate::math::vec3::{self, Vec3};

/// Which faces around a position are smooth with each other.
#[derive(Clone, Copy)]
pub(crate) enum Smoothing<'a> {
    /// Those whose normals have at least this cosine between them.
    Angle(f64),
    /// Those of the same group, by triangle; group 0 is smooth with nothing.
    Groups(&'a [u32]),
}

/// Normals and which corner has which.
pub(crate) struct GeneratedNormals {
    /// Unit normals; zero where all faces around are degenerate.
    pub(crate) normals: Vec<[f32; 3]>,
    /// For each corner of each triangle, the index of its normal.
    pub(crate) corners: Vec<[u32; 3]>,
}

/// Makes normals for all corners. Corners of a position that share a normal share its index. Every index in `triangles`
/// must be less than `positions.len()`.
pub(crate) fn generate_normals(
    threads: usize,
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
    smoothing: Smoothing<'_>,
) -> GeneratedNormals {
    let facets = facets(threads, positions, triangles);
    let rings = Rings::new(positions.len(), triangles);
    let around = Around { facets: &facets, smoothing };

    // Each piece of positions numbers its normals from zero ...
    let mut slots = vec![0_u32; rings.corners.len()];
    let pieces = rings.pieces(&mut slots);
    let normals =
        parallel_map(threads, pieces, |_, (ring_ends, corners, slots)| around.normals(ring_ends, corners, slots));
    // ... and the pieces are strung together.
    let mut corners = vec![[0_u32; 3]; triangles.len()];
    let (mut base, mut at) = (0, 0);
    let flat = corners.as_flattened_mut();
    for (piece, piece_normals) in rings.piece_corners().zip(&normals) {
        for (corner, slot) in piece.iter().zip(&slots[at..at + piece.len()]) {
            flat[*corner as usize] = base + slot;
        }
        at += piece.len();
        base += u32::try_from(piece_normals.len()).unwrap_or(0);
    }
    GeneratedNormals { normals: normals.concat(), corners }
}

/// A triangle's unit normal (zero if degenerate) and the weight of each corner.
#[derive(Clone, Copy, Default)]
struct Facet {
    normal: [f32; 3],
    weights: [f64; 3],
}

fn facets(threads: usize, positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<Facet> {
    const PIECE: usize = 1 << 15;
    let mut facets = vec![Facet::default(); triangles.len()];
    let pieces: Vec<_> = facets.chunks_mut(PIECE).zip(triangles.chunks(PIECE)).collect();
    parallel_map(threads, pieces, |_, (facets, triangles)| {
        for (facet, triangle) in facets.iter_mut().zip(triangles) {
            *facet = Facet::of(triangle.map(|i| vec3::widen(positions[i as usize])));
        }
    });
    facets
}

impl Facet {
    fn of([a, b, c]: [Vec3; 3]) -> Self {
        let (ab, bc, ca) = (vec3::sub(b, a), vec3::sub(c, b), vec3::sub(a, c));
        let cross = vec3::cross(ab, vec3::sub(c, a));
        let area = vec3::length(cross);
        // Squares of f32 differences stay within f64.
        if !(area > 0.0 && area.is_finite()) {
            return Self::default();
        }
        let (ab, bc, ca) = (vec3::dot(ab, ab), vec3::dot(bc, bc), vec3::dot(ca, ca));
        Self {
            normal: vec3::narrow(vec3::scale(cross, 1.0 / area)),
            weights: [area / (ab * ca), area / (ab * bc), area / (bc * ca)],
        }
    }
}

/// The corners around each position: corner numbers are `3 * triangle + corner`, ascending.
struct Rings {
    /// End of each position's corners in `corners`.
    ends: Vec<u32>,
    corners: Vec<u32>,
}

/// Positions per parallel piece.
const RINGS_PER_PIECE: usize = 1 << 14;

impl Rings {
    /// A counting sort of the corners by position.
    fn new(positions: usize, triangles: &[[u32; 3]]) -> Self {
        let flat = triangles.as_flattened();
        let mut ends = vec![0_u32; positions];
        for &position in flat {
            ends[position as usize] += 1;
        }
        let mut total = 0;
        for end in &mut ends {
            let count = *end;
            *end = total;
            total += count;
        }
        let mut corners = vec![0_u32; flat.len()];
        for (corner, &position) in (0_u32..).zip(flat) {
            let place = &mut ends[position as usize];
            corners[*place as usize] = corner;
            *place += 1;
        }
        Self { ends, corners }
    }

    /// Start and end of the corners of each piece.
    fn piece_bounds(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let mut start = 0;
        self.ends.chunks(RINGS_PER_PIECE).map(move |ends| {
            let end = ends.last().map_or(start, |&end| end as usize);
            (std::mem::replace(&mut start, end), end)
        })
    }

    fn piece_corners(&self) -> impl Iterator<Item = &[u32]> + '_ {
        self.piece_bounds().map(|(start, end)| &self.corners[start..end])
    }

    /// Pieces of positions: their ring ends, their corners, and the part of `slots` (one per corner) that is theirs.
    fn pieces<'a>(&'a self, mut slots: &'a mut [u32]) -> Vec<(&'a [u32], &'a [u32], &'a mut [u32])> {
        let mut pieces = Vec::new();
        for (ends, corners) in self.ends.chunks(RINGS_PER_PIECE).zip(self.piece_corners()) {
            let (own, rest) = std::mem::take(&mut slots).split_at_mut(corners.len());
            slots = rest;
            pieces.push((ends, corners, own));
        }
        pieces
    }
}

/// What the normals of a ring are made from.
struct Around<'a> {
    facets: &'a [Facet],
    smoothing: Smoothing<'a>,
}

impl Around<'_> {
    /// The normals of one piece; `slots` receives each corner's index among them.
    fn normals(&self, ring_ends: &[u32], corners: &[u32], slots: &mut [u32]) -> Vec<[f32; 3]> {
        let mut normals = Vec::with_capacity(ring_ends.len());
        let count: u32 = u32::try_from(corners.len()).unwrap_or(u32::MAX);
        let first = ring_ends.last().map_or(0, |&end| end - count) as usize;
        let mut start = 0;
        for &end in ring_ends {
            let end = end as usize - first;
            let (ring, slots) = (&corners[start..end], &mut slots[start..end]);
            if ring.len() <= 64 {
                self.small_ring(ring, slots, &mut normals);
            } else {
                self.large_ring(ring, slots, &mut normals);
            }
            start = end;
        }
        normals
    }

    fn facet(&self, corner: u32) -> (&Facet, f64) {
        let facet = &self.facets[(corner / 3) as usize];
        (facet, facet.weights[(corner % 3) as usize])
    }

    /// Whether the faces of two corners share a normal.
    fn joins(&self, a: u32, b: u32) -> bool {
        match self.smoothing {
            Smoothing::Angle(cosine) => {
                let (a, b) = (self.facet(a).0.normal, self.facet(b).0.normal);
                let dot = vec3::dot(vec3::widen(a), vec3::widen(b));
                // Unit vectors in f32 may miss the cosine by their rounding; degenerate faces join everything.
                dot >= cosine - 1e-6 || a == [0.0; 3] || b == [0.0; 3]
            }
            Smoothing::Groups(groups) => {
                let group = |corner: u32| groups.get((corner / 3) as usize).copied().unwrap_or(0);
                group(a) != 0 && group(a) == group(b)
            }
        }
    }

    fn sum(&self, corners: impl Iterator<Item = u32>) -> [f32; 3] {
        let sum = corners.fold([0.0; 3], |sum, corner| {
            let (facet, weight) = self.facet(corner);
            vec3::add(sum, vec3::scale(vec3::widen(facet.normal), weight))
        });
        vec3::normalized(sum).map_or([0.0; 3], vec3::narrow)
    }

    /// Every corner sums exactly the faces it joins; corners with equal sets share the normal.
    fn small_ring(&self, ring: &[u32], slots: &mut [u32], normals: &mut Vec<[f32; 3]>) {
        let mut sets = [0_u64; 64];
        for (i, &a) in ring.iter().enumerate() {
            sets[i] |= 1 << i;
            for (j, &b) in ring.iter().enumerate().skip(i + 1) {
                if self.joins(a, b) {
                    sets[i] |= 1 << j;
                    sets[j] |= 1 << i;
                }
            }
        }
        for i in 0..ring.len() {
            slots[i] = match sets[..i].iter().position(|set| *set == sets[i]) {
                Some(same) => slots[same],
                None => {
                    let joined = ring.iter().enumerate().filter(|(j, _)| sets[i] >> j & 1 == 1);
                    normals.push(self.sum(joined.map(|(_, &corner)| corner)));
                    index_of_last(normals)
                }
            };
        }
    }

    /// Rings of very many corners, such as the hub of a fan: corners are assigned to the first of a few leaders they
    /// join, in time proportional to their number.
    fn large_ring(&self, ring: &[u32], slots: &mut [u32], normals: &mut Vec<[f32; 3]>) {
        const MAX_LEADERS: usize = 16;
        let mut leaders: Vec<u32> = Vec::new();
        let mut leader_of = vec![0_usize; ring.len()];
        for (leader, &corner) in leader_of.iter_mut().zip(ring) {
            *leader = match leaders.iter().position(|&leader| self.joins(leader, corner)) {
                Some(found) => found,
                None if leaders.len() < MAX_LEADERS => {
                    leaders.push(corner);
                    leaders.len() - 1
                }
                None => MAX_LEADERS - 1,
            };
        }
        for leader in 0..leaders.len() {
            let joined = || ring.iter().zip(&leader_of).filter(|(_, l)| **l == leader);
            normals.push(self.sum(joined().map(|(&corner, _)| corner)));
            let index = index_of_last(normals);
            slots.iter_mut().zip(&leader_of).filter(|(_, l)| **l == leader).for_each(|(slot, _)| *slot = index);
        }
    }
}

fn index_of_last(normals: &[[f32; 3]]) -> u32 {
    u32::try_from(normals.len() - 1).unwrap_or(u32::MAX)
}

/// The unit vector of a stored normal; as it is if it is one already, zero if there is none.
pub(crate) fn unit_normal(normal: [f32; 3]) -> [f32; 3] {
    let wide = vec3::widen(normal);
    if (vec3::dot(wide, wide) - 1.0).abs() < 1e-4 {
        return normal;
    }
    vec3::normalized(wide).map_or([0.0; 3], vec3::narrow)
}

#[cfg(test)]
mod tests {
    use super::*;

    const RIGHT_ANGLE: f64 = 0.0;

    fn cube() -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
        let positions = (0..8_u8).map(|i| [0, 1, 2].map(|axis| f32::from(i >> axis & 1))).collect();
        let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        (positions, quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
    }

    #[test]
    fn a_cube_is_creased_at_45_degrees_and_smooth_at_90() {
        let (positions, triangles) = cube();
        let sharp = generate_normals(1, &positions, &triangles, Smoothing::Angle(libm::cos(0.785)));
        assert_eq!(sharp.normals.len(), 24);
        for (triangle, corners) in triangles.iter().zip(&sharp.corners) {
            let facet = Facet::of(triangle.map(|i| vec3::widen(positions[i as usize])));
            assert!(corners.iter().all(|&n| sharp.normals[n as usize] == facet.normal));
        }
        let smooth = generate_normals(1, &positions, &triangles, Smoothing::Angle(RIGHT_ANGLE));
        assert_eq!(smooth.normals.len(), 8);
        for (corner, position) in smooth.corners.as_flattened().iter().zip(triangles.as_flattened()) {
            let outward = positions[*position as usize].map(|c| f64::from(c) - 0.5);
            let normal = vec3::widen(smooth.normals[*corner as usize]);
            assert!(vec3::dot(normal, vec3::normalized(outward).unwrap()) > 0.99999, "{normal:?}");
        }
    }

    #[test]
    fn groups_decide_where_they_are_given() {
        let (positions, triangles) = cube();
        let one = vec![1; 12];
        assert_eq!(generate_normals(1, &positions, &triangles, Smoothing::Groups(&one)).normals.len(), 8);
        let none = vec![0; 12];
        assert_eq!(generate_normals(1, &positions, &triangles, Smoothing::Groups(&none)).normals.len(), 36);
        let sides: Vec<u32> = (0..12).map(|t| t / 2 + 1).collect();
        assert_eq!(generate_normals(1, &positions, &triangles, Smoothing::Groups(&sides)).normals.len(), 24);
    }

    #[test]
    fn a_sphere_gets_its_exact_normals_on_any_number_of_threads() {
        let (rings, sectors) = (80_u32, 300_u32);
        let at = |ring: u32, sector: u32| {
            let theta = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
            let phi = std::f64::consts::TAU * f64::from(sector) / f64::from(sectors);
            vec3::narrow([libm::sin(theta) * libm::cos(phi), libm::cos(theta), -libm::sin(theta) * libm::sin(phi)])
        };
        let positions: Vec<_> = (0..=rings).flat_map(|r| (0..sectors).map(move |s| at(r, s))).collect();
        let index = |ring: u32, sector: u32| ring * sectors + sector % sectors;
        let triangles: Vec<_> = (0..rings)
            .flat_map(|r| {
                (0..sectors).flat_map(move |s| {
                    let (a, b, c, d) = (index(r, s), index(r + 1, s), index(r + 1, s + 1), index(r, s + 1));
                    [[a, b, c], [a, c, d]]
                })
            })
            .collect();
        let smoothing = Smoothing::Angle(libm::cos(0.7));
        let one = generate_normals(1, &positions, &triangles, smoothing);
        for (&corner, &position) in one.corners.as_flattened().iter().zip(triangles.as_flattened()) {
            let (normal, position) = (one.normals[corner as usize], positions[position as usize]);
            assert!(vec3::dot(vec3::widen(normal), vec3::widen(position)) > 0.999, "{normal:?} {position:?}");
        }
        let many = generate_normals(5, &positions, &triangles, smoothing);
        assert_eq!(one.normals, many.normals);
        assert_eq!(one.corners, many.corners);
    }

    #[test]
    fn the_hub_of_a_large_fan_is_smooth() {
        let n = 1000_u32;
        let mut positions = vec![[0.0, 0.1, 0.0]];
        positions.extend((0..n).map(|i| {
            let phi = std::f64::consts::TAU * f64::from(i) / f64::from(n);
            vec3::narrow([libm::cos(phi), 0.0, -libm::sin(phi)])
        }));
        let triangles: Vec<_> = (0..n).map(|i| [0, i + 1, (i + 1) % n + 1]).collect();
        let fan = generate_normals(1, &positions, &triangles, Smoothing::Angle(libm::cos(0.785)));
        let hub = fan.normals[fan.corners[0][0] as usize];
        assert!(hub[1] > 0.9999, "{hub:?}");
        assert!(fan.corners.iter().all(|c| c[0] == fan.corners[0][0]));
    }

    #[test]
    fn degenerate_faces_give_zero_or_their_neighbours_normal() {
        let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [f32::NAN; 3]];
        let made = generate_normals(1, &positions, &[[0, 0, 1], [0, 1, 2], [0, 1, 3]], Smoothing::Angle(0.5));
        assert_eq!(made.normals[made.corners[1][0] as usize], [0.0, 0.0, 1.0]);
        assert_eq!(made.normals[made.corners[0][0] as usize], [0.0, 0.0, 1.0]);
        let made = generate_normals(1, &positions, &[[0, 0, 0]], Smoothing::Angle(0.5));
        assert_eq!(made.normals, [[0.0; 3]]);
    }
}
