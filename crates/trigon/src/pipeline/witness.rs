//! Looks at one pixel of a tile while the tile is drawn.
//!
//! In: the tile, before and after each triangle; lists of fragments, before and after they are shaded. Out: the parts of
//! a [`PixelStory`](super::story::PixelStory). A witness computes nothing that decides anything: what was drawn is
//! read from the tile and the colours themselves. There is one at the plain level only, and only where a pixel is explained.

use super::shading::TileView;
use super::story::{FragmentStory, Outcome, ResolveStory, SampleTest, TriangleStory};
use super::tile::TileInput;
use super::visible::Lookup;
use crate::explain;
use crate::geometry::{Chunk, ClipPositions, PixelBox, ScreenTriangle, Tags};
use crate::lanes::{LANES, Lanes};
use crate::raster::{BLOCK_SIZE, BLOCKS_PER_SIDE, BlockState, PassMasks, Tile, TileTriangle};
use crate::resolve::ColorBlock;
use crate::shade::{ColorGroup, ErasedShader, FragmentBatch, FragmentList, Placement};
use crate::target::TILE_SIZE;

/// What is seen of the triangles of a pixel.
pub(crate) struct Witness {
    /// In the tile.
    pixel: [usize; 2],
    /// Number of the block that the pixel lies in, and its number there.
    pub(crate) block: usize,
    at: usize,
    pub(crate) triangles: Vec<TriangleStory>,
    /// By triangle.
    ids: Vec<u32>,
    pub(crate) samples: Vec<[f32; 4]>,
}

/// What is seen of the fragments of a pixel.
pub(crate) struct FragmentWitness {
    block: usize,
    at: usize,
    /// With ids in place of numbers of triangles.
    pub(crate) fragments: Vec<FragmentStory>,
    /// Group, lane and samples of those that are being shaded.
    lanes: Vec<(usize, usize, u32)>,
    before: Vec<[f32; 4]>,
}

/// A triangle about to be drawn.
pub(crate) struct Candidate<'a> {
    pub(crate) id: u32,
    pub(crate) draw: u32,
    pub(crate) chunk: &'a Chunk,
    pub(crate) triangle: &'a ScreenTriangle,
}

impl Witness {
    /// Looks at the pixel in column `x` and row `y` of the tile.
    pub(crate) fn new([x, y]: [usize; 2]) -> Self {
        Self {
            pixel: [x, y],
            block: y / BLOCK_SIZE * BLOCKS_PER_SIDE + x / BLOCK_SIZE,
            at: y % BLOCK_SIZE * BLOCK_SIZE + x % BLOCK_SIZE,
            triangles: Vec::new(),
            ids: Vec::new(),
            samples: Vec::new(),
        }
    }

    /// The witness of the fragments of the same pixel.
    pub(crate) fn of_fragments(&self) -> FragmentWitness {
        FragmentWitness { block: self.block, at: self.at, fragments: Vec::new(), lanes: Vec::new(), before: Vec::new() }
    }

    /// Position of the pixel in the tile's images.
    pub(crate) fn index_in_tile(&self) -> usize {
        self.pixel[1] * TILE_SIZE + self.pixel[0]
    }

    /// The number of a triangle in the story.
    fn number(&self, id: u32) -> Option<usize> {
        self.ids.iter().position(|other| *other == id)
    }

    /// A triangle is about to be drawn; false if it can be left out, because its box does not touch the pixel's block.
    ///
    /// Blocks do not depend on each other, so the story is that of the whole tile. Triangles whose box does not touch
    /// the pixel are drawn, for they decide with others how the block is kept, but are no part of the story.
    pub(crate) fn before<L: Lanes>(
        &mut self,
        l: L,
        tile: &Tile,
        input: &TileInput<'_>,
        lookup: &Lookup<'_>,
        candidate: &Candidate<'_>,
    ) -> bool {
        let triangle = candidate.triangle;
        let samples = input.frame.samples;
        let extent = [samples.extent(0), samples.extent(1)];
        let bounds = triangle.pixel_box(extent);
        let [left, top] = tile.block_origin(self.block);
        let last = BLOCK_SIZE as i32 - 1;
        if !overlap(bounds, PixelBox { x0: left, y0: top, x1: left + last, y1: top + last }) {
            return false;
        }
        let [x, y] = [tile.origin[0] + self.pixel[0] as i32, tile.origin[1] + self.pixel[1] as i32];
        if !overlap(bounds, PixelBox { x0: x, y0: y, x1: x, y1: y }) {
            return true;
        }
        let Some(t) = TileTriangle::new(l, tile, triangle, extent) else { return false };
        let mut story = story_of(input, candidate);
        for s in 0..samples.count() {
            let edges = t.edge_values(s, self.pixel[0], self.pixel[1]);
            let is_covered = if story.is_micro {
                let bit = 4 * (y - bounds.y0) + (x - bounds.x0);
                candidate.chunk.masks[triangle.side as usize + s] >> bit & 1 == 1
            } else {
                edges.iter().all(|edge| *edge >= 0) // tidy: allow(lane-closure): integers of one pixel
            };
            story.tests.push(SampleTest {
                edges,
                is_covered,
                depth: tile.plane_depth(l, [self.block, self.at, s], triangle),
                stored: tile.sample(l, [self.block, self.at, s], lookup).0,
                outcome: if is_covered { Outcome::Hidden } else { Outcome::Outside },
            });
        }
        self.triangles.push(story);
        self.ids.push(candidate.id);
        true
    }

    /// An opaque triangle was drawn: where the tile shows it, it passed.
    pub(crate) fn after<L: Lanes>(&mut self, l: L, tile: &Tile, id: u32, lookup: &Lookup<'_>) {
        if self.ids.last() != Some(&id) {
            return;
        }
        let Some(story) = self.triangles.last_mut() else { return };
        story.is_whole_block = tile.state(self.block) == BlockState::Single(id);
        for (s, test) in story.tests.iter_mut().enumerate() {
            if tile.sample(l, [self.block, self.at, s], lookup).1 == id {
                test.outcome = Outcome::Drawn;
            }
        }
    }

    /// A triangle of an ordered draw passed the depth test at `tested` of block `b`; the shader kept `kept`.
    pub(crate) fn ordered(&mut self, b: usize, id: u32, tested: &PassMasks, kept: &PassMasks) {
        if b != self.block || self.ids.last() != Some(&id) {
            return;
        }
        let Some(story) = self.triangles.last_mut() else { return };
        for (s, test) in story.tests.iter_mut().enumerate() {
            let is_in = |masks: &PassMasks| masks.samples[s] >> self.at & 1 == 1;
            match (is_in(tested), is_in(kept)) {
                (true, true) => test.outcome = Outcome::Drawn,
                (true, false) => test.outcome = Outcome::Discarded,
                _ => {}
            }
        }
    }

    /// Block `b` was shaded for the last time.
    pub(crate) fn resolved(&mut self, b: usize, colors: &ColorBlock) {
        if b == self.block {
            self.samples = colors.pixel(self.at);
        }
    }

    /// The end of the story.
    pub(crate) fn resolve_story(&self, clear: [f32; 4], count: usize, mean: [f32; 4], bytes: [u8; 4]) -> ResolveStory {
        // A block that nothing touched has no colours: it is cleared.
        let samples = if self.samples.is_empty() { vec![clear; count] } else { self.samples.clone() };
        ResolveStory { samples, mean, bytes }
    }
}

fn overlap(a: PixelBox, b: PixelBox) -> bool {
    a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1
}

/// The triangle itself, before its tests.
fn story_of(input: &TileInput<'_>, candidate: &Candidate<'_>) -> TriangleStory {
    let (triangle, draw) = (candidate.triangle, &input.draws[candidate.draw as usize]);
    let vertices = draw.primitives.vertices(triangle.primitive as usize);
    TriangleStory {
        draw: candidate.draw,
        primitive: triangle.primitive,
        object: draw.object,
        vertices,
        clip: clip_positions(input, draw.shader, &vertices),
        corners: [0, 1, 2].map(|k| [triangle.x[k], triangle.y[k]]),
        vertex_of_corner: [0, 1, 2].map(|k| triangle.tags.vertex_of_corner(k)),
        inverse_w: triangle.inv_w,
        depth: triangle.depth,
        is_clipped: triangle.tags.has(Tags::CLIPPED),
        is_front: triangle.tags.has(Tags::FRONT),
        is_micro: triangle.tags.has(Tags::MICRO),
        is_whole_block: false,
        depth_test: draw.depth,
        blend: draw.blend,
        tests: Vec::new(),
    }
}

fn clip_positions(input: &TileInput<'_>, shader: &dyn ErasedShader, vertices: &[u32; 3]) -> [[f32; 4]; 3] {
    let mut out = ClipPositions::default();
    out.resize(vertices.len());
    shader.positions(input.level, vertices, &mut out);
    [out.vertex(0), out.vertex(1), out.vertex(2)]
}

impl FragmentWitness {
    /// What was seen, with the triangles' numbers in the story.
    pub(crate) fn into_stories(mut self, triangles: &Witness) -> Vec<FragmentStory> {
        for fragment in &mut self.fragments {
            let id = u32::try_from(fragment.triangle).ok();
            fragment.triangle = id.and_then(|id| triangles.number(id)).unwrap_or(usize::MAX);
        }
        self.fragments
    }

    /// The listed fragments are about to be shaded, or tested. Starts to watch the lanes of the pixel.
    pub(crate) fn before(&mut self, view: TileView<'_>, list: &FragmentList, colors: Option<&ColorBlock>) {
        self.lanes.clear();
        if view.b != self.block {
            return;
        }
        for (group, placement) in list.placements().iter().enumerate() {
            match *placement {
                Placement::InPlace { group: rows, masks } if rows == self.at / LANES => {
                    let lane = self.at % LANES;
                    let masks = list.masks(masks, view.tile.sample_count()).iter().enumerate();
                    let samples = masks.fold(0, |all, (s, mask)| all | u32::from(mask >> lane & 1) << s);
                    if samples != 0 {
                        self.lanes.push((group, lane, samples));
                    }
                }
                Placement::InPlace { .. } => {}
                Placement::Packed { first, count } => {
                    let destinations = (0..count).map(|lane| (lane, list.destination(first + lane)));
                    let here = destinations.filter(|(_, destination)| destination.pixel() == self.at);
                    self.lanes.extend(here.map(|(lane, destination)| (group, lane, destination.samples())));
                }
            }
        }
        let watched: Vec<(usize, usize)> = self.lanes.iter().map(|(group, lane, _)| (*group, *lane)).collect();
        self.before = colors.map_or(Vec::new(), |colors| colors.pixel(self.at));
        explain::watch(&watched);
    }

    /// They are done: ends watching. `results` are the shaded colours and what became of the block's; alpha tests have
    /// none.
    pub(crate) fn after(
        &mut self,
        view: TileView<'_>,
        batch: &mut FragmentBatch<'_>,
        shader: &dyn ErasedShader,
        results: Option<(&[ColorGroup], &ColorBlock)>,
    ) {
        if self.lanes.is_empty() {
            return;
        }
        let after = results.map_or(Vec::new(), |(_, colors)| colors.pixel(self.at));
        for ((group, lane, samples), notes) in self.lanes.drain(..).zip(explain::take()) {
            let slot = batch.fragments.slots[group][lane];
            let id = view.visible.slots().iter().position(|other| *other == slot);
            self.fragments.push(FragmentStory {
                triangle: id.unwrap_or(usize::MAX),
                samples,
                facts: shader.facts(batch, group, lane),
                notes,
                color: results.map(|(shaded, _)| shaded[group].map(|channel| channel[lane])),
                before: self.before.clone(),
                after: after.clone(),
            });
        }
    }
}
