//! One vertex for each distinct combination of attributes: corners with an index per attribute in, one index per
//! corner out, in order of first use.
//!
//! The vertices of one position form a chain (`heads` by position, `next` by vertex), walked comparing the other two
//! indices. Chains are short, since few corners share a position and differ otherwise; unlike a hash table this needs
//! one lookup, near the previous one when the mesh is coherent.

use crate::load::parallel_map;

/// The three indices of one corner: position, texture coordinates, normal.
pub(crate) type Corner = [u32; 3];

/// "No index": the attribute is not given.
pub(crate) const ABSENT: u32 = u32::MAX;

/// Numbers distinct corners.
pub(crate) struct Unifier {
    /// First vertex of each position, or [`ABSENT`].
    heads: Vec<u32>,
    /// The next vertex of the same position, by vertex.
    next: Vec<u32>,
    vertices: Vec<Corner>,
}

impl Unifier {
    /// For corners whose position index is less than `positions`.
    pub(crate) fn new(positions: usize) -> Self {
        let capacity = positions + positions / 4;
        Self {
            heads: vec![ABSENT; positions],
            next: Vec::with_capacity(capacity),
            vertices: Vec::with_capacity(capacity),
        }
    }

    /// The number of the vertex with these indices; a new one if they are new.
    #[inline]
    pub(crate) fn vertex(&mut self, corner: Corner) -> u32 {
        let [position, uv, normal] = corner;
        let Some(head) = usize::try_from(position).ok().and_then(|p| self.heads.get_mut(p)) else { return 0 };
        let mut link: &mut u32 = head;
        while *link != ABSENT {
            let vertex = *link;
            let at = vertex as usize;
            if self.vertices[at][1] == uv && self.vertices[at][2] == normal {
                return vertex;
            }
            link = &mut self.next[at];
        }
        let new = u32::try_from(self.vertices.len()).unwrap_or(ABSENT);
        *link = new;
        self.vertices.push(corner);
        self.next.push(ABSENT);
        new
    }

    /// The corners that the vertices stand for, in order.
    pub(crate) fn into_vertices(self) -> Vec<Corner> {
        self.vertices
    }
}

/// The attribute of each vertex: `values` at the index that `pick` takes of a corner, through `map`; `missing` where
/// there is none.
pub(crate) fn gather<T, const N: usize>(
    threads: usize,
    vertices: &[Corner],
    pick: usize,
    values: &[[T; N]],
    missing: [T; N],
    map: impl Fn([T; N]) -> [T; N] + Sync,
) -> Vec<[T; N]>
where
    T: Copy + Send + Sync,
{
    const PIECE: usize = 1 << 16;
    let mut gathered = vec![missing; vertices.len()];
    let pieces: Vec<_> = gathered.chunks_mut(PIECE).zip(vertices.chunks(PIECE)).collect();
    parallel_map(threads, pieces, |_, (out, vertices)| {
        for (out, vertex) in out.iter_mut().zip(vertices) {
            if let Some(&value) = values.get(vertex[pick] as usize) {
                *out = map(value);
            }
        }
    });
    gathered
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn equal_corners_share_a_vertex_in_order_of_first_use() {
        let mut state = 7_u32;
        let mut random = |range: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) % range
        };
        let corners: Vec<Corner> =
            (0..5000).map(|_| [random(40), if random(3) == 0 { ABSENT } else { random(5) }, random(3)]).collect();
        let mut unifier = Unifier::new(40);
        let mut expected: HashMap<Corner, u32> = HashMap::new();
        for &corner in &corners {
            let next = u32::try_from(expected.len()).unwrap();
            assert_eq!(unifier.vertex(corner), *expected.entry(corner).or_insert(next));
        }
        let vertices = unifier.into_vertices();
        assert_eq!(vertices.len(), expected.len());
        assert!(vertices.iter().enumerate().all(|(i, corner)| expected[corner] as usize == i));
    }

    #[test]
    fn gathering_fills_gaps() {
        let vertices = [[1, 0, ABSENT], [0, ABSENT, ABSENT]];
        let uvs = [[0.5_f32, 0.25]];
        assert_eq!(gather(2, &vertices, 1, &uvs, [0.0; 2], |v| v), [[0.5, 0.25], [0.0, 0.0]]);
    }
}
