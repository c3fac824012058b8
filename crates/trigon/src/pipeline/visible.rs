//! The triangles of a tile: which there are, and the coefficients of those that are visible.
//!
//! In: the tile's lists, and what every sample shows. Out: records of coefficients, made once per tile and visible
//! triangle, sixteen triangles at a time; hidden triangles never cost more than their depth test.

use super::draw::Draw;
use super::tile::TileInput;
use crate::geometry::{Chunk, ScreenTriangle, Tags};
use crate::lanes::{LANES, Lanes, Quad, outline};
use crate::raster::{BLOCKS, BlockState, Tile, TriangleLookup};
use crate::shade::{Rows, TriangleGroup, store_rows};

/// The triangles listed for a tile, by id: their number in the order of submission.
pub(crate) struct VisibleTriangles {
    /// Chunk and triangle number.
    refs: Vec<(u32, u32)>,
    /// Number of the draw.
    draws: Vec<u32>,
    /// True if they belong to more than one draw.
    is_mixed: bool,
    /// Where its record begins, or one of the constants below.
    slots: Vec<u32>,
    records: Vec<Quad>,
    group: Box<TriangleGroup>,
    rows: Box<Rows>,
    /// Ids below this are in the tile's colours already.
    first_unshaded: u32,
}

/// No coefficients, and none wanted.
const UNSEEN: u32 = u32::MAX;
/// Visible, coefficients not made yet.
const WANTED: u32 = u32::MAX - 1;

/// Finds a tile's triangles by id.
#[derive(Clone, Copy)]
pub(crate) struct Lookup<'a> {
    refs: &'a [(u32, u32)],
    chunks: &'a [Chunk],
}

impl<'a> Lookup<'a> {
    #[inline(always)]
    pub(crate) fn get(&self, id: u32) -> &'a ScreenTriangle {
        let (chunk, triangle) = self.refs[id as usize];
        &self.chunks[chunk as usize].triangles[triangle as usize]
    }

    /// The chunk that the triangle belongs to.
    pub(crate) fn chunk(&self, id: u32) -> &'a Chunk {
        &self.chunks[self.refs[id as usize].0 as usize]
    }
}

impl TriangleLookup for Lookup<'_> {
    #[inline(always)]
    fn triangle(&self, id: u32) -> &ScreenTriangle {
        self.get(id)
    }
}

impl Default for VisibleTriangles {
    fn default() -> Self {
        Self {
            refs: Vec::new(),
            draws: Vec::new(),
            is_mixed: false,
            slots: Vec::new(),
            records: Vec::new(),
            group: Box::default(),
            rows: Box::new(TriangleGroup::NO_ROWS),
            first_unshaded: 0,
        }
    }
}

impl VisibleTriangles {
    pub(crate) fn clear(&mut self) {
        self.refs.clear();
        self.draws.clear();
        self.is_mixed = false;
        self.slots.clear();
        self.records.clear();
        self.first_unshaded = 0;
    }

    /// Number of triangles listed so far, which is the next id.
    pub(crate) fn len(&self) -> u32 {
        self.refs.len() as u32
    }

    /// Lists triangles of a chunk; returns the id of the first.
    pub(crate) fn extend(&mut self, chunk: u32, draw: u32, entries: &[u32]) -> u32 {
        let first = self.len();
        self.is_mixed |= self.draws.last().is_some_and(|last| *last != draw);
        self.refs.extend(entries.iter().map(|&triangle| (chunk, triangle)));
        self.draws.resize(self.refs.len(), draw);
        self.slots.resize(self.refs.len(), UNSEEN);
        first
    }

    pub(crate) fn lookup<'a>(&'a self, input: &TileInput<'a>) -> Lookup<'a> {
        Lookup { refs: &self.refs, chunks: input.chunks }
    }

    pub(crate) fn has_unshaded(&self) -> bool {
        self.first_unshaded < self.len()
    }

    pub(crate) fn first_unshaded(&self) -> u32 {
        self.first_unshaded
    }

    pub(crate) fn mark_shaded(&mut self) {
        self.first_unshaded = self.len();
    }

    /// The draw that triangle `id` belongs to.
    #[inline(always)]
    pub(crate) fn draw_number(&self, id: u32) -> u32 {
        self.draws[id as usize]
    }

    /// Draws by id, if there are several.
    pub(crate) fn draws(&self) -> Option<&[u32]> {
        self.is_mixed.then_some(&self.draws)
    }

    /// First quads of the records, by id.
    pub(crate) fn slots(&self) -> &[u32] {
        &self.slots
    }

    pub(crate) fn records(&self) -> &[Quad] {
        &self.records
    }

    /// Makes the coefficients of every triangle that the tile shows.
    pub(crate) fn prepare<L: Lanes>(&mut self, l: L, input: &TileInput<'_>, tile: &Tile) {
        for b in 0..BLOCKS {
            match tile.state(b) {
                BlockState::Clear => {}
                BlockState::Single(id) => self.want(id),
                BlockState::Full => {
                    for s in 0..tile.sample_count() {
                        for id in tile.block_ids(b, s) {
                            self.want(*id);
                        }
                    }
                }
            }
        }
        self.make_wanted(l, input, 0);
    }

    /// Makes the coefficients of every triangle from `first` on.
    pub(crate) fn prepare_from<L: Lanes>(&mut self, l: L, input: &TileInput<'_>, first: u32) {
        for id in first..self.len() {
            self.want(id);
        }
        self.make_wanted(l, input, first);
    }

    #[inline(always)]
    fn want(&mut self, id: u32) {
        if let Some(slot @ &mut UNSEEN) = self.slots.get_mut(id as usize) {
            *slot = WANTED;
        }
    }

    /// Sixteen triangles of one draw at a time, in order of their ids; none is wanted before `first`.
    fn make_wanted<L: Lanes>(&mut self, l: L, input: &TileInput<'_>, first: u32) {
        let mut ids = [0u32; LANES];
        let (mut count, mut draw) = (0, 0);
        for id in first..self.len() {
            if self.slots[id as usize] != WANTED {
                continue;
            }
            let its_draw = self.draw_number(id);
            if count == LANES || (count > 0 && its_draw != draw) {
                self.make_group(l, input, &input.draws[draw as usize], &ids[..count]);
                count = 0;
            }
            draw = its_draw;
            ids[count] = id;
            count += 1;
        }
        if count > 0 {
            self.make_group(l, input, &input.draws[draw as usize], &ids[..count]);
        }
    }

    fn make_group<L: Lanes>(&mut self, l: L, input: &TileInput<'_>, draw: &Draw<'_>, ids: &[u32]) {
        let (first, quads) = (self.records.len(), draw.shader.quads());
        for lane in 0..LANES {
            let id = ids[lane.min(ids.len() - 1)];
            let (chunk, triangle) = self.refs[id as usize];
            let chunk = &input.chunks[chunk as usize];
            let triangle = &chunk.triangles[triangle as usize];
            self.group.set_triangle(lane, triangle, input.frame.interpolation);
            fill_lane(&mut self.group, lane, draw, chunk, triangle);
        }
        for (lane, id) in ids.iter().enumerate() {
            self.slots[*id as usize] = (first + lane * quads) as u32;
        }
        draw.shader.coefficients(input.level, &self.group, &mut self.rows);
        self.records.resize(first + ids.len() * quads, [0.0; 4]);
        outline!(l => store_rows(l, &self.rows, &mut self.records[first..], quads));
    }
}

#[inline(always)]
fn fill_lane(group: &mut TriangleGroup, lane: usize, draw: &Draw<'_>, chunk: &Chunk, triangle: &ScreenTriangle) {
    let vertices = draw.primitives.vertices(triangle.primitive as usize);
    let is_clipped = triangle.tags.has(Tags::CLIPPED);
    let weights = if is_clipped { chunk.clipped[triangle.side as usize].0 } else { TriangleGroup::UNCLIPPED };
    for k in 0..3 {
        group.vertices[k][lane] = vertices[triangle.tags.vertex_of_corner(k)];
        for v in 0..2 {
            group.weights[k][v][lane] = weights[k][v];
        }
    }
}
