//! One tile from its first triangle to its pixels.
//!
//! In: the tile's triangles in submission order. Out: its pixels in every image. Opaque triangles only leave their
//! depth and number; what is visible is shaded when a draw needs the colours beneath it, or at the end.

use super::draw::{Draw, Frame};
use super::output::TileImages;
use super::shading::{Shading, VisibleTriangles};
use crate::geometry::{Chunk, Segment, Tags};
use crate::lanes::{LANES, Lanes, dispatch, outline};
use crate::raster::{
    BLOCK_SIZE, BLOCKS, BLOCKS_PER_SIDE, TILE_SIZE, Tile, TileTriangle, commit, draw_micro, draw_opaque, fill_masks,
};
use crate::resolve::{ColorBlock, encode_srgb8, resolve};
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
    images: TileImages,
    samples: &'static [[i16; 2]],
    outputs: super::draw::Outputs,
}

impl TileWorker {
    /// Draws the tile at (`column`, `row`).
    pub(crate) fn draw(&mut self, input: &TileInput<'_>, segments: &[(u32, Segment)], column: u32, row: u32) {
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

    /// The pixels of the last tile drawn.
    pub(crate) fn images(&self) -> &TileImages {
        match &self.state {
            Some(state) => &state.images,
            None => unreachable!("a tile is stored after it is drawn"),
        }
    }
}

impl TileState {
    fn new(frame: &Frame) -> Self {
        let samples = frame.samples.positions();
        Self {
            tile: Tile::new(samples),
            visible: VisibleTriangles::default(),
            shading: Shading::default(),
            colors: Vec::new(),
            images: TileImages::new(frame.outputs, samples.len()),
            samples,
            outputs: frame.outputs,
        }
    }
}

#[inline(always)]
fn draw_tile<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>, segments: &[(u32, Segment)]) {
    let frame = input.frame;
    let extent = [frame.samples.extent(0), frame.samples.extent(1)];
    let shades = frame.outputs.any_color();
    state.visible.clear();
    let is_ordered = |&(chunk, _): &(u32, Segment)| {
        let draw = &input.draws[input.chunks[chunk as usize].draw as usize];
        shades && draw.is_ordered()
    };
    let keeps_colors = segments.iter().any(is_ordered);
    let blocks = if keeps_colors { BLOCKS } else { 1 };
    state.colors.resize_with(blocks, || ColorBlock::new(frame.samples.count()));
    if keeps_colors {
        state.colors.iter_mut().for_each(|block| block.clear(frame.clear));
    }

    for (chunk_number, segment) in segments {
        let chunk = &input.chunks[*chunk_number as usize];
        let draw = &input.draws[chunk.draw as usize];
        let entries = &chunk.entries[segment.start as usize..(segment.start + segment.len) as usize];
        let first = state.visible.extend(*chunk_number, entries);
        if draw.is_ordered() {
            if shades {
                flush(state, input);
            }
            draw_ordered(l, state, input, draw, first, extent);
        } else if draw.shader.can_discard() {
            draw_ordered(l, state, input, draw, first, extent);
        } else {
            draw_opaque_run(l, state, input, chunk, entries, first, extent);
        }
    }
    if shades {
        state.visible.prepare(input, &state.tile);
        finish_colors(l, state, input, keeps_colors);
    }
    if frame.outputs.any_beside_color() {
        state.visible.prepare(input, &state.tile);
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
        if triangle.tags.has(Tags::MICRO) {
            let at = triangle.side as usize;
            let masks = &chunk.masks[at..at + samples];
            draw_micro(l, &mut state.tile, triangle, masks, id, extent, &lookup);
        } else {
            draw_opaque(l, &mut state.tile, triangle, id, extent, &lookup);
        }
    }
}

/// Shades what is visible and not shaded yet, into the tile's colours.
fn flush(state: &mut TileState, input: &TileInput<'_>) {
    if state.visible.has_unshaded() {
        state.visible.prepare(input, &state.tile);
        for b in 0..BLOCKS {
            state.shading.shade_block(input, &state.tile, &state.visible, b, &mut state.colors[b]);
        }
        state.visible.mark_shaded();
    }
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
        state.visible.prepare_from(input, first);
    }
    for id in first..state.visible.len() {
        let triangle = *state.visible.lookup(input).get(id);
        let Some(t) = outline!(l => TileTriangle::new(l, &state.tile, &triangle, extent)) else { continue };
        let mut rest = outline!(l => t.blocks(l)).touched;
        while rest != 0 {
            let b = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            state.tile.expand(l, b, &state.visible.lookup(input));
            let mut masks = fill_masks(l, &state.tile, b, &t, draw.depth.compare);
            if masks.any == 0 {
                continue;
            }
            if discards {
                state.shading.discard(input, &state.tile, &state.visible, b, id, &mut masks);
            }
            let shown = (!draw.is_ordered()).then_some(id);
            commit(l, &mut state.tile, b, &t, &masks, shown, draw.depth.write);
            if shades {
                let colors = &mut state.colors[b];
                state.shading.blend_block(input, &state.tile, &state.visible, b, id, &masks, colors, draw.blend);
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
    for b in 0..BLOCKS {
        let colors = if keeps_colors { &mut state.colors[b] } else { &mut state.colors[0] };
        if !keeps_colors {
            colors.clear(input.frame.clear);
        }
        state.shading.shade_block(input, &state.tile, &state.visible, b, colors);
        store_block(l, colors, &mut state.images, b);
    }
}

/// Writes a block's pixels to the tile's colour images.
#[inline(always)]
fn store_block<L: Lanes>(l: L, colors: &ColorBlock, images: &mut TileImages, b: usize) {
    let (x, y) = (b % BLOCKS_PER_SIDE * BLOCK_SIZE, b / BLOCKS_PER_SIDE * BLOCK_SIZE);
    for g in 0..BLOCK_SIZE * BLOCK_SIZE / LANES {
        let color = resolve(l, colors, g);
        let at = (y + 2 * g) * TILE_SIZE + x;
        if !images.color.values.is_empty() {
            let pixels = encode_srgb8(l, color);
            images.color.values[at..at + BLOCK_SIZE].copy_from_slice(&pixels[..BLOCK_SIZE]);
            let at = at + TILE_SIZE;
            images.color.values[at..at + BLOCK_SIZE].copy_from_slice(&pixels[BLOCK_SIZE..]);
        }
        if !images.color_f32.values.is_empty() {
            let [r, g, b, a] = [color.r.to_array(), color.g.to_array(), color.b.to_array(), color.a.to_array()];
            for i in 0..LANES {
                let at = at + i / BLOCK_SIZE * TILE_SIZE + i % BLOCK_SIZE;
                images.color_f32.values[at] = [r[i], g[i], b[i], a[i]];
            }
        }
    }
}

/// Depth, ids and surfaces of every pixel or sample.
#[inline(never)]
fn beside_color<L: Lanes>(l: L, state: &mut TileState, input: &TileInput<'_>) {
    for b in 0..BLOCKS {
        state.tile.expand(l, b, &state.visible.lookup(input));
        state.shading.beside_color(input, &state.tile, &state.visible, b, &mut state.images);
    }
}
