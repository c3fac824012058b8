//! Between visibility and colour: the tile's triangles, their coefficients, and the packing of fragments.
//!
//! In: which triangle every sample shows. Out: colours of blocks. Coefficients are made once per tile and visible
//! triangle; fragments of many triangles are packed into full lanes, one shader call per block and draw.

use super::draw::Draw;
use super::output::TileImages;
use super::tile::TileInput;
use crate::geometry::{Chunk, ScreenTriangle, Tags};
use crate::lanes::LANES;
use crate::raster::{
    BLOCK_PIXELS, BLOCK_SIZE, BLOCKS, BLOCKS_PER_SIDE, BlockState, NO_TRIANGLE, PassMasks, Tile, TriangleLookup,
};
use crate::resolve::{Blend, ColorBlock};
use crate::shade::{ColorGroup, Destination, FragmentBatch, FragmentList, FragmentRows, SurfaceGroup, TriangleGroup};
use crate::target::ShadingRate;

/// The triangles listed for a tile, by id, and the coefficients of those that are visible.
#[derive(Default)]
pub(crate) struct VisibleTriangles {
    /// Chunk and triangle number, by id.
    refs: Vec<(u32, u32)>,
    /// By id: where its coefficients are, or one of the constants below.
    slots: Vec<u32>,
    rows: Vec<[f32; LANES]>,
    group: Box<TriangleGroup>,
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
}

impl TriangleLookup for Lookup<'_> {
    #[inline(always)]
    fn triangle(&self, id: u32) -> &ScreenTriangle {
        self.get(id)
    }
}

impl VisibleTriangles {
    pub(crate) fn clear(&mut self) {
        self.refs.clear();
        self.slots.clear();
        self.rows.clear();
        self.first_unshaded = 0;
    }

    /// Number of triangles listed so far, which is the next id.
    pub(crate) fn len(&self) -> u32 {
        self.refs.len() as u32
    }

    /// Lists triangles of a chunk; returns the id of the first.
    pub(crate) fn extend(&mut self, chunk: u32, entries: &[u32]) -> u32 {
        let first = self.len();
        self.refs.extend(entries.iter().map(|&triangle| (chunk, triangle)));
        self.slots.resize(self.refs.len(), UNSEEN);
        first
    }

    pub(crate) fn lookup<'a>(&'a self, input: &TileInput<'a>) -> Lookup<'a> {
        Lookup { refs: &self.refs, chunks: input.chunks }
    }

    pub(crate) fn has_unshaded(&self) -> bool {
        self.first_unshaded < self.len()
    }

    pub(crate) fn mark_shaded(&mut self) {
        self.first_unshaded = self.len();
    }

    fn draw_number(&self, input: &TileInput<'_>, id: u32) -> u32 {
        input.chunks[self.refs[id as usize].0 as usize].draw
    }

    /// Makes the coefficients of every triangle that the tile shows.
    pub(crate) fn prepare(&mut self, input: &TileInput<'_>, tile: &Tile) {
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
        self.make_wanted(input);
    }

    /// Makes the coefficients of every triangle from `first` on.
    pub(crate) fn prepare_from(&mut self, input: &TileInput<'_>, first: u32) {
        for id in first..self.len() {
            self.want(id);
        }
        self.make_wanted(input);
    }

    #[inline(always)]
    fn want(&mut self, id: u32) {
        if let Some(slot @ &mut UNSEEN) = self.slots.get_mut(id as usize) {
            *slot = WANTED;
        }
    }

    /// Sixteen triangles of one draw at a time, in order of their ids.
    fn make_wanted(&mut self, input: &TileInput<'_>) {
        let mut ids = [0u32; LANES];
        let (mut count, mut draw) = (0, 0);
        for id in 0..self.len() {
            if self.slots[id as usize] != WANTED {
                continue;
            }
            let its_draw = self.draw_number(input, id);
            if count == LANES || (count > 0 && its_draw != draw) {
                self.make_group(input, &input.draws[draw as usize], &ids[..count]);
                count = 0;
            }
            draw = its_draw;
            ids[count] = id;
            count += 1;
        }
        if count > 0 {
            self.make_group(input, &input.draws[draw as usize], &ids[..count]);
        }
    }

    fn make_group(&mut self, input: &TileInput<'_>, draw: &Draw<'_>, ids: &[u32]) {
        let first_row = self.rows.len();
        for lane in 0..LANES {
            let id = ids[lane.min(ids.len() - 1)];
            let (chunk, triangle) = self.refs[id as usize];
            let chunk = &input.chunks[chunk as usize];
            fill_lane(&mut self.group, lane, draw, chunk, &chunk.triangles[triangle as usize]);
            self.slots[id as usize] = (first_row * LANES + lane.min(ids.len() - 1)) as u32;
        }
        self.rows.resize(first_row + draw.shader.rows(), [0.0; LANES]);
        draw.shader.coefficients(input.level, &self.group, &mut self.rows[first_row..]);
    }
}

#[inline(always)]
fn fill_lane(group: &mut TriangleGroup, lane: usize, draw: &Draw<'_>, chunk: &Chunk, triangle: &ScreenTriangle) {
    group.triangles[lane] = *triangle;
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

/// Packs fragments and runs shaders over them.
#[derive(Default)]
pub(crate) struct Shading {
    pending: Vec<Destination>,
    list: FragmentList,
    colors: Vec<ColorGroup>,
    surfaces: Vec<SurfaceGroup>,
    kept: Vec<u16>,
    fetched: FragmentRows,
}

impl Shading {
    /// Shades what block `b` shows and the tile's colours lack.
    pub(crate) fn shade_block(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        colors: &mut ColorBlock,
    ) {
        self.pending.clear();
        match tile.state(b) {
            BlockState::Clear => return,
            BlockState::Single(id) if id < visible.first_unshaded => return,
            BlockState::Single(id) => {
                if input.frame.shading == ShadingRate::Pixel || tile.sample_count() == 1 {
                    self.shade_single(input, tile, visible, b, id, colors);
                    return;
                }
                list_all_samples(tile, id, &mut self.pending);
            }
            BlockState::Full => list_visible(input, tile, visible.first_unshaded, b, &mut self.pending),
        }
        while let Some(first) = self.pending.first() {
            let draw = visible.draw_number(input, first.id);
            self.take_draw(input, tile, visible, b, draw);
            self.run(input, visible, draw);
            colors.store(&self.list.destinations, &self.colors);
        }
    }

    /// A block that one triangle covers whole.
    fn shade_single(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        id: u32,
        colors: &mut ColorBlock,
    ) {
        self.list.clear();
        let origin = tile.block_origin(b);
        self.list.fill_block([origin[0] as f32 + 0.5, origin[1] as f32 + 0.5], visible.slots[id as usize]);
        self.run(input, visible, visible.draw_number(input, id));
        colors.fill(&self.colors);
    }

    /// Moves the pending fragments of one draw to the list.
    fn take_draw(&mut self, input: &TileInput<'_>, tile: &Tile, visible: &VisibleTriangles, b: usize, draw: u32) {
        self.list.clear();
        let mut kept = 0;
        for i in 0..self.pending.len() {
            let d = self.pending[i];
            if visible.draw_number(input, d.id) == draw {
                let [x, y] = shading_point(input, tile, b, &d);
                self.list.push(x, y, visible.slots[d.id as usize], d);
            } else {
                self.pending[kept] = d;
                kept += 1;
            }
        }
        self.pending.truncate(kept);
    }

    /// Colours of the listed fragments.
    fn run(&mut self, input: &TileInput<'_>, visible: &VisibleTriangles, draw: u32) {
        self.colors.resize(self.list.group_count(), [[0.0; LANES]; 4]);
        let shader = input.draws[draw as usize].shader;
        let mut batch = FragmentBatch { rows: &visible.rows, fragments: self.list.range(), fetched: &mut self.fetched };
        shader.shade(input.level, &mut batch, &mut self.colors);
    }

    /// Lists the fragments of one triangle in one block.
    fn list_triangle(&mut self, input: &TileInput<'_>, tile: &Tile, slot: u32, b: usize, id: u32, masks: &PassMasks) {
        self.list.clear();
        let per_sample = input.frame.shading == ShadingRate::Sample;
        let mut rest = masks.any;
        while rest != 0 {
            let pixel = rest.trailing_zeros();
            rest &= rest - 1;
            let mut samples = 0u16;
            for s in 0..tile.sample_count() {
                samples |= ((masks.samples[s] >> pixel & 1) as u16) << s;
            }
            let mut left = samples;
            while left != 0 {
                let taken = if per_sample { left & left.wrapping_neg() } else { left };
                left &= !taken;
                let d = Destination { pixel: pixel as u8, samples: taken, id };
                let [x, y] = shading_point(input, tile, b, &d);
                self.list.push(x, y, slot, d);
            }
        }
    }

    /// Takes away the samples whose fragments the shader discards.
    pub(crate) fn discard(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        id: u32,
        masks: &mut PassMasks,
    ) {
        self.list_triangle(input, tile, visible.slots[id as usize], b, id, masks);
        self.kept.resize(self.list.group_count(), 0);
        let shader = input.draws[visible.draw_number(input, id) as usize].shader;
        let mut batch = FragmentBatch { rows: &visible.rows, fragments: self.list.range(), fetched: &mut self.fetched };
        shader.keep(input.level, &mut batch, &mut self.kept);
        for (i, d) in self.list.destinations.iter().enumerate() {
            if self.kept[i / LANES] >> (i % LANES) & 1 == 0 {
                for s in 0..tile.sample_count() {
                    if d.samples >> s & 1 == 1 {
                        masks.samples[s] &= !(1 << d.pixel);
                    }
                }
            }
        }
        masks.any = masks.samples.iter().fold(0, |any, mask| any | mask);
    }

    /// Shades one triangle's fragments in one block and blends them.
    #[expect(clippy::too_many_arguments, reason = "one triangle, one block, and where they belong")]
    pub(crate) fn blend_block(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        id: u32,
        masks: &PassMasks,
        colors: &mut ColorBlock,
        blend: Blend,
    ) {
        self.list_triangle(input, tile, visible.slots[id as usize], b, id, masks);
        self.run(input, visible, visible.draw_number(input, id));
        colors.blend(&self.list.destinations, &self.colors, blend);
    }

    /// Writes the outputs beside colour of an expanded block.
    pub(crate) fn beside_color(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        images: &mut TileImages,
    ) {
        let outputs = input.frame.outputs;
        let planes = if outputs.per_sample { tile.sample_count() } else { 1 };
        self.pending.clear();
        for plane in 0..planes {
            for pixel in 0..BLOCK_PIXELS {
                let s = if outputs.per_sample { plane } else { nearest_sample(tile, b, pixel) };
                let id = tile.block_ids(b, s)[pixel];
                let (x, y) = pixel_in_tile(b, pixel);
                images.depth.set(plane, x, y, tile.block_depth(b, s)[pixel]);
                let (primitive, object) = if id == NO_TRIANGLE {
                    (u32::MAX, u32::MAX)
                } else {
                    let draw = &input.draws[visible.draw_number(input, id) as usize];
                    (visible.lookup(input).get(id).primitive, draw.object)
                };
                images.primitive.set(plane, x, y, primitive);
                images.object.set(plane, x, y, object);
                images.normal.set(plane, x, y, [0.0; 3]);
                images.position.set(plane, x, y, [0.0; 3]);
                images.uv.set(plane, x, y, [0.0; 2]);
                if id != NO_TRIANGLE {
                    self.pending.push(Destination { pixel: pixel as u8, samples: 1 << s, id });
                }
            }
        }
        if outputs.any_surface() {
            self.surfaces(input, tile, visible, b, images);
        }
    }

    /// Surfaces of the pending fragments.
    fn surfaces(
        &mut self,
        input: &TileInput<'_>,
        tile: &Tile,
        visible: &VisibleTriangles,
        b: usize,
        images: &mut TileImages,
    ) {
        while let Some(first) = self.pending.first() {
            let draw = visible.draw_number(input, first.id);
            self.take_draw(input, tile, visible, b, draw);
            self.surfaces.resize(self.list.group_count(), [[0.0; LANES]; 8]);
            let shader = input.draws[draw as usize].shader;
            let mut batch =
                FragmentBatch { rows: &visible.rows, fragments: self.list.range(), fetched: &mut self.fetched };
            shader.surfaces(input.level, &mut batch, &mut self.surfaces);
            for (i, d) in self.list.destinations.iter().enumerate() {
                let s = self.surfaces[i / LANES].map(|component| component[i % LANES]);
                let (x, y) = pixel_in_tile(b, usize::from(d.pixel));
                let plane = if input.frame.outputs.per_sample { d.samples.trailing_zeros() as usize } else { 0 };
                images.position.set(plane, x, y, [s[0], s[1], s[2]]);
                images.normal.set(plane, x, y, [s[3], s[4], s[5]]);
                images.uv.set(plane, x, y, [s[6], s[7]]);
            }
        }
    }
}

/// Where a fragment is shaded, in framebuffer pixels: the pixel centre, or the sample.
#[inline(always)]
fn shading_point(input: &TileInput<'_>, tile: &Tile, b: usize, d: &Destination) -> [f32; 2] {
    let origin = tile.block_origin(b);
    let (column, row) = (usize::from(d.pixel) % BLOCK_SIZE, usize::from(d.pixel) / BLOCK_SIZE);
    let (x, y) = (origin[0] as f32 + column as f32, origin[1] as f32 + row as f32);
    match input.frame.shading {
        ShadingRate::Pixel => [x + 0.5, y + 0.5],
        ShadingRate::Sample => {
            let [sx, sy] = tile.samples[d.samples.trailing_zeros() as usize];
            [x + f32::from(sx) / 256.0, y + f32::from(sy) / 256.0]
        }
    }
}

/// Every sample of a block, shown by one triangle, each a fragment.
fn list_all_samples(tile: &Tile, id: u32, out: &mut Vec<Destination>) {
    for pixel in 0..BLOCK_PIXELS as u8 {
        out.extend((0..tile.sample_count()).map(|s| Destination { pixel, samples: 1 << s, id }));
    }
}

/// The fragments of a block: one per pixel and visible triangle, or one per sample.
fn list_visible(input: &TileInput<'_>, tile: &Tile, first_unshaded: u32, b: usize, out: &mut Vec<Destination>) {
    let per_sample = input.frame.shading == ShadingRate::Sample;
    let is_wanted = |id: u32| id != NO_TRIANGLE && id >= first_unshaded;
    let samples = tile.sample_count();
    for pixel in 0..BLOCK_PIXELS {
        let first = out.len();
        for s in 0..samples {
            let id = tile.block_ids(b, s)[pixel];
            if !is_wanted(id) {
                continue;
            }
            let known = if per_sample { None } else { out[first..].iter_mut().find(|d| d.id == id) };
            match known {
                Some(d) => d.samples |= 1 << s,
                None => out.push(Destination { pixel: pixel as u8, samples: 1 << s, id }),
            }
        }
    }
}

/// The sample with the nearest depth; the first of equals.
fn nearest_sample(tile: &Tile, b: usize, pixel: usize) -> usize {
    let mut nearest = 0;
    for s in 1..tile.sample_count() {
        if tile.block_depth(b, s)[pixel] > tile.block_depth(b, nearest)[pixel] {
            nearest = s;
        }
    }
    nearest
}

/// Position of a block's pixel in the tile.
fn pixel_in_tile(b: usize, pixel: usize) -> (usize, usize) {
    let (x, y) = (b % BLOCKS_PER_SIDE * BLOCK_SIZE, b / BLOCKS_PER_SIDE * BLOCK_SIZE);
    (x + pixel % BLOCK_SIZE, y + pixel / BLOCK_SIZE)
}
