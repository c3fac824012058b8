//! One tile from its first triangle to its pixels.
//!
//! In: the tile's triangles in submission order. Out: its pixels in every image. Opaque triangles only leave their
//! depth and number; what is visible is shaded when a draw needs the colours beneath it, or at the end.

use super::draw::{Draw, Frame};
use super::output::{TileOfPicture, TilePixels};
use super::shading::{Shading, TileView};
use super::story::{FragmentStory, ResolveStory, TriangleStory};
use super::visible::VisibleTriangles;
use super::witness::{Candidate, Witness};
use crate::geometry::{Chunk, Segment, Tags};
use crate::lanes::{LANES, Lanes, dispatch, outline};
use crate::raster::{
    BLOCK_SIZE, BLOCKS, BLOCKS_PER_SIDE, BlockState, Tile, TileTriangle, commit, draw_micro, draw_opaque, fill_masks,
};
use crate::resolve::{ColorBlock, encode_srgb8, resolve};
use crate::target::{ColorSpace, TILE_SIZE};
use fearless_simd::Level;

/// What every tile of a frame needs.
pub(crate) struct TileInput<'a> {
    pub(crate) level: Level,
    pub(crate) frame: &'a Frame,
    pub(crate) draws: &'a [Draw<'a>],
    pub(crate) chunks: &'a [Chunk],
}

/// One thread's memory for drawing tiles.
#[derive(Default)]
pub(crate) struct TileWorker {
    state: Option<TileState>,
}

struct TileState {
    tile: Tile,
    visible: VisibleTriangles,
    shading: Shading,
    /// One block, or one per block of the tile where draws are ordered.
    colors: Vec<ColorBlock>,
    pixels: TilePixels,
    samples: &'static [[i16; 2]],
    outputs: super::draw::Outputs,
    /// Looks on where a pixel is explained.
    witness: Option<Witness>,
}

impl TileWorker {
    /// Draws the tile at (`column`, `row`) and stores it in its part of the picture.
    pub(crate) fn draw(
        &mut self,
        input: &TileInput<'_>,
        segments: &[(u32, Segment)],
        place: [u32; 2],
        tile_of_picture: TileOfPicture<'_>,
    ) {
        self.gather(input, segments, place);
        if let Some(state) = &self.state {
            tile_of_picture.store(&state.pixels);
        }
    }

    /// Draws the tile at (`column`, `row`) into memory of its own.
    fn gather(&mut self, input: &TileInput<'_>, segments: &[(u32, Segment)], [column, row]: [u32; 2]) {
        let frame = input.frame;
        let samples = frame.samples.positions();
        let fits = |s: &TileState| s.samples == samples && s.outputs == frame.outputs;
        if !self.state.as_ref().is_some_and(fits) {
            self.state = Some(TileState::new(frame));
        }
        if let Some(state) = &mut self.state {
            state.tile.clear([(column as usize * TILE_SIZE) as i32, (row as usize * TILE_SIZE) as i32], 0.0);
            dispatch!(input.level, l => draw_tile(l, state, input, segments));
        }
    }

    /// Draws the tile at (`column`, `row`) at the plain level and tells what is seen at `pixel` of it.
    pub(crate) fn explain(
        &mut self,
        input: &TileInput<'_>,
        segments: &[(u32, Segment)],
        [column, row]: [u32; 2],
        pixel: [usize; 2],
    ) -> (Vec<TriangleStory>, Vec<FragmentStory>, ResolveStory) {
        let witness = Witness::new(pixel);
        let state = self.state.insert(TileState::new(input.frame));
        state.shading.witness = Some(witness.of_fragments());
        state.witness = Some(witness);
        self.gather(input, segments, [column, row]);
        let Some(TileState { witness: Some(witness), shading, pixels, .. }) = &mut self.state else {
            unreachable!("drawing keeps the state that fits")
        };
        let fragments = shading.witness.take().map_or(Vec::new(), |fragments| fragments.into_stories(witness));
        let at = witness.index_in_tile();
        let (clear, count) = (input.frame.clear, input.frame.samples.count());
        let resolve = witness.resolve_story(clear, count, pixels.color_f32.values[at], pixels.color.values[at]);
        (core::mem::take(&mut witness.triangles), fragments, resolve)
    }
}

impl TileState {
    fn new(frame: &Frame) -> Self {
        let samples = frame.samples.positions();
        Self {
            tile: Tile::new(samples),
            visible: VisibleTriangles::default(),
            shading: Shading::new(samples),
            colors: Vec::new(),
            pixels: TilePixels::new(frame.outputs, samples.len()),
            samples,
            outputs: frame.outputs,
            witness: None,
        }
    }

    /// Where a pixel is explained, the other blocks need no colours.
    #[inline(always)]
    fn is_beside<L: Lanes>(&self, l: L, b: usize) -> bool {
        match &self.witness {
            Some(witness) if l.can_explain() => witness.block != b,
            _ => false,
        }
    }

    /// One cleared block of colours for each of the tile's where colours are kept, else one for all.
    fn prepare_colors(&mut self, keeps_colors: bool, frame: &Frame) {
        let blocks = if keeps_colors { BLOCKS } else { 1 };
        self.colors.resize_with(blocks, || ColorBlock::new(frame.samples.count()));
        if keeps_colors {
            self.colors.iter_mut().for_each(|block| block.clear(frame.clear));
        }
    }
}

#[inline(always)]
fn draw_tile<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>, segments: &[(u32, Segment)]) {
    let frame = input.frame;
    let extent = [frame.samples.extent(0), frame.samples.extent(1)];
    let shades = frame.outputs.any_color();
    state.visible.clear();
    let keeps_colors = shades && has_ordered(input, segments);
    state.prepare_colors(keeps_colors, frame);
    if l.can_explain()
        && let Some(witness) = &state.witness
    {
        state.tile.close_all_but(witness.block);
    }

    for (chunk_number, segment) in segments {
        let chunk = &input.chunks[*chunk_number as usize];
        let draw = &input.draws[chunk.draw as usize];
        let entries = &chunk.entries[segment.start as usize..(segment.start + segment.len) as usize];
        let first = state.visible.extend(*chunk_number, chunk.draw, entries);
        if draw.is_ordered() {
            if shades {
                flush(l, state, input);
            }
            draw_ordered(l, state, input, draw, first, extent);
        } else if draw.shader.can_discard() {
            draw_ordered(l, state, input, draw, first, extent);
        } else {
            draw_opaque_run(l, state, input, chunk, entries, first, extent);
        }
    }
    if shades {
        state.visible.prepare(l, input, &state.tile);
        finish_colors(l, state, input, keeps_colors);
    }
    if frame.outputs.any_beside_color() {
        state.visible.prepare(l, input, &state.tile);
        beside_color(l, state, input);
    }
}

/// Opaque triangles: depth and id only.
#[inline(always)]
fn draw_opaque_run<L: Lanes>(
    l: L,
    state: &mut TileState,
    input: &TileInput<'_>,
    chunk: &Chunk,
    entries: &[u32],
    first: u32,
    extent: [(i32, i32); 2],
) {
    let lookup = state.visible.lookup(input);
    let samples = state.samples.len();
    for (id, entry) in (first..).zip(entries) {
        let triangle = &chunk.triangles[*entry as usize];
        if l.can_explain()
            && let Some(witness) = &mut state.witness
        {
            let candidate = Candidate { id, draw: chunk.draw, chunk, triangle };
            if !witness.before(l, &state.tile, input, &lookup, &candidate) {
                continue;
            }
        }
        if triangle.tags.has(Tags::MICRO) {
            let at = triangle.side as usize;
            let masks = &chunk.masks[at..at + samples];
            draw_micro(l, &mut state.tile, triangle, masks, id, extent, &lookup);
        } else {
            draw_opaque(l, &mut state.tile, triangle, id, extent, &lookup);
        }
        if l.can_explain()
            && let Some(witness) = &mut state.witness
        {
            witness.after(l, &state.tile, id, &lookup);
        }
    }
}

/// True if a draw of the tile must be shaded in submission order.
fn has_ordered(input: &TileInput<'_>, segments: &[(u32, Segment)]) -> bool {
    segments.iter().any(|(chunk, _)| input.draws[input.chunks[*chunk as usize].draw as usize].is_ordered())
}

/// Shades what is visible and not shaded yet, into the tile's colours.
#[inline(always)]
fn flush<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>) {
    if state.visible.has_unshaded() {
        state.visible.prepare(l, input, &state.tile);
        for b in 0..BLOCKS {
            if !state.is_beside(l, b) {
                shade_block(l, state, input, b, b);
            }
        }
        state.visible.mark_shaded();
    }
}

/// Shades block `b` into `colors[to]`.
#[inline(never)]
fn shade_block<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>, b: usize, to: usize) {
    let TileState { tile, visible, shading, colors, .. } = state;
    outline!(l => shading.shade_block(l, TileView { input, tile, visible, b }, &mut colors[to]));
}

/// Triangles that blend or discard: one after the other, shaded (or at least tested) before they are written.
#[inline(never)]
fn draw_ordered<L: Lanes>(
    l: L,
    state: &mut TileState,
    input: &TileInput<'_>,
    draw: &Draw<'_>,
    first: u32,
    extent: [(i32, i32); 2],
) {
    let shades = draw.is_ordered() && input.frame.outputs.any_color();
    let discards = draw.shader.can_discard();
    if shades || discards {
        state.visible.prepare_from(l, input, first);
    }
    for id in first..state.visible.len() {
        let triangle = *state.visible.lookup(input).get(id);
        if l.can_explain()
            && let Some(witness) = &mut state.witness
        {
            let lookup = state.visible.lookup(input);
            let (chunk, draw) = (lookup.chunk(id), state.visible.draw_number(id));
            let candidate = Candidate { id, draw, chunk, triangle: &triangle };
            if !witness.before(l, &state.tile, input, &lookup, &candidate) {
                continue;
            }
        }
        let Some(t) = outline!(l => TileTriangle::new(l, &state.tile, &triangle, extent)) else { continue };
        let mut rest = outline!(l => t.blocks(l)).touched;
        while rest != 0 {
            let b = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            if state.is_beside(l, b) {
                continue;
            }
            state.tile.expand(l, b, &state.visible.lookup(input));
            let mut masks = fill_masks(l, &state.tile, b, &t, draw.depth.compare);
            if masks.any == 0 {
                continue;
            }
            let tested = masks;
            if discards {
                let TileState { tile, visible, shading, .. } = &mut *state;
                outline!(l => shading.discard(l, TileView { input, tile, visible, b }, id, &mut masks));
            }
            if l.can_explain()
                && let Some(witness) = &mut state.witness
            {
                witness.ordered(b, id, &tested, &masks);
            }
            let shown = (!draw.is_ordered()).then_some(id);
            commit(l, &mut state.tile, b, &t, &masks, shown, draw.depth.write);
            if shades {
                let TileState { tile, visible, shading, colors, .. } = &mut *state;
                let view = TileView { input, tile, visible, b };
                outline!(l => shading.blend_block(l, view, id, &masks, &mut colors[b]));
            }
        }
    }
    if draw.is_ordered() {
        state.visible.mark_shaded();
    }
}

/// Shades, resolves and encodes every block.
#[inline(always)]
fn finish_colors<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>, keeps_colors: bool) {
    let [r, g, b, a] = input.frame.clear;
    let clear = encode_srgb8(l, l.vec3([r, g, b]).rgba(a), input.frame.color_space)[0];
    for b in 0..BLOCKS {
        if state.is_beside(l, b) {
            continue;
        }
        let to = if keeps_colors { b } else { 0 };
        if !keeps_colors {
            if state.tile.state(b) == BlockState::Clear {
                clear_block(&mut state.pixels, b, clear, input.frame.clear);
                continue;
            }
            state.colors[to].clear(input.frame.clear);
        }
        shade_block(l, state, input, b, to);
        if l.can_explain()
            && let Some(witness) = &mut state.witness
        {
            witness.resolved(b, &state.colors[to]);
        }
        store_block(l, &state.colors[to], &mut state.pixels, b, input.frame.color_space);
    }
}

/// Writes the clear colour to a block's pixels.
fn clear_block(pixels: &mut TilePixels, b: usize, color: [u8; 4], floats: [f32; 4]) {
    let first = b / BLOCKS_PER_SIDE * BLOCK_SIZE * TILE_SIZE + b % BLOCKS_PER_SIDE * BLOCK_SIZE;
    for at in (first..).step_by(TILE_SIZE).take(BLOCK_SIZE) {
        if let Some(row) = pixels.color.values.get_mut(at..at + BLOCK_SIZE) {
            row.fill(color);
        }
        if let Some(row) = pixels.color_f32.values.get_mut(at..at + BLOCK_SIZE) {
            row.fill(floats);
        }
    }
}

/// Writes the colours of a block to the tile's pixels.
#[inline(always)]
fn store_block<L: Lanes>(l: L, colors: &ColorBlock, pixels: &mut TilePixels, b: usize, space: ColorSpace) {
    let (x, y) = (b % BLOCKS_PER_SIDE * BLOCK_SIZE, b / BLOCKS_PER_SIDE * BLOCK_SIZE);
    for g in 0..BLOCK_SIZE * BLOCK_SIZE / LANES {
        let color = resolve(l, colors, g);
        let at = (y + 2 * g) * TILE_SIZE + x;
        if !pixels.color.values.is_empty() {
            let encoded = encode_srgb8(l, color, space);
            pixels.color.values[at..at + BLOCK_SIZE].copy_from_slice(&encoded[..BLOCK_SIZE]);
            let at = at + TILE_SIZE;
            pixels.color.values[at..at + BLOCK_SIZE].copy_from_slice(&encoded[BLOCK_SIZE..]);
        }
        if !pixels.color_f32.values.is_empty() {
            let [r, g, b, a] = [color.r.to_array(), color.g.to_array(), color.b.to_array(), color.a.to_array()];
            for i in 0..LANES {
                let at = at + i / BLOCK_SIZE * TILE_SIZE + i % BLOCK_SIZE;
                pixels.color_f32.values[at] = [r[i], g[i], b[i], a[i]];
            }
        }
    }
}

/// Depth, ids and surfaces of every pixel or sample.
#[inline(never)]
fn beside_color<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>) {
    for b in 0..BLOCKS {
        state.tile.expand(l, b, &state.visible.lookup(input));
        let TileState { tile, visible, shading, pixels, .. } = &mut *state;
        outline!(l => shading.beside_color(l, TileView { input, tile, visible, b }, pixels));
    }
}
