//! Between visibility and colour: which fragments a block has, and what the shaders make of them.
//!
//! In: which triangle every sample shows. Out: colours of blocks. A fragment is a pixel and a triangle with all the
//! samples at which the pixel shows it; the fragments of a block and a draw are shaded by one call.

use super::output::TilePixels;
use super::tile::TileInput;
use super::visible::VisibleTriangles;
use super::witness::FragmentWitness;
use crate::lanes::{LANES, Lanes, U32};
use crate::raster::{
    BLOCK_PIXELS, BLOCK_SIZE, BLOCKS_PER_SIDE, BlockState, GROUPS, MAX_SAMPLES, NO_TRIANGLE, PassMasks, Tile,
};
use crate::resolve::{Blend, ColorBlock};
use crate::shade::{
    Candidates, ColorGroup, Destination, FragmentBatch, FragmentList, FragmentRows, Placement, ShadingPoints,
    SurfaceGroup,
};
use crate::target::ShadingRate;

/// Lists fragments and runs shaders over them.
#[derive(Default)]
pub(crate) struct Shading {
    list: FragmentList,
    colors: Vec<ColorGroup>,
    surfaces: Vec<SurfaceGroup>,
    kept: Vec<u16>,
    fetched: FragmentRows,
    /// Sample positions in a pixel, by axis.
    offsets: [[f32; LANES]; 2],
    /// Looks on where a pixel is explained.
    pub(crate) witness: Option<FragmentWitness>,
}

/// No draw has this number.
const NO_DRAW: u32 = u32::MAX;

/// One block of a tile whose triangles have their coefficients.
#[derive(Clone, Copy)]
pub(crate) struct TileView<'a> {
    pub(crate) input: &'a TileInput<'a>,
    pub(crate) tile: &'a Tile,
    pub(crate) visible: &'a VisibleTriangles,
    /// Number of the block.
    pub(crate) b: usize,
}

impl TileView<'_> {
    fn shades_samples(&self) -> bool {
        self.input.frame.shading == ShadingRate::Sample && self.tile.sample_count() > 1
    }

    fn points<'o>(&self, offsets: &'o [[f32; LANES]; 2]) -> ShadingPoints<'o> {
        let [x, y] = self.tile.block_origin(self.b);
        ShadingPoints { origin: [x as f32, y as f32], samples: self.shades_samples().then_some(offsets) }
    }
}

impl Shading {
    /// For pixels with these samples.
    pub(crate) fn new(samples: &[[i16; 2]]) -> Self {
        let mut shading = Self::default();
        for (s, position) in samples.iter().enumerate() {
            for axis in 0..2 {
                shading.offsets[axis][s] = f32::from(position[axis]) / 256.0;
            }
        }
        shading
    }

    /// Shades what the block shows and the tile's colours lack.
    #[inline(always)]
    pub(crate) fn shade_block<L: Lanes>(&mut self, l: L, view: TileView<'_>, colors: &mut ColorBlock) {
        let visible = view.visible;
        match view.tile.state(view.b) {
            BlockState::Clear => {}
            BlockState::Single(id) => {
                if id >= visible.first_unshaded() {
                    colors.forget();
                    self.list_whole(l, view, id);
                    self.shade(l, view, visible.draw_number(id), colors, Blend::Replace);
                }
            }
            BlockState::Full => {
                let mut draw = if visible.draws().is_some() { 0 } else { NO_DRAW };
                loop {
                    let (listed, next) = self.list_visible(l, view, draw);
                    if let Some(listed) = listed {
                        self.shade(l, view, listed, colors, Blend::Replace);
                    }
                    if next == NO_DRAW {
                        break;
                    }
                    draw = next;
                }
            }
        }
    }

    /// Lists a block that one triangle covers whole.
    #[inline(always)]
    fn list_whole<L: Lanes>(&mut self, l: L, view: TileView<'_>, id: u32) {
        self.list.clear();
        let samples = view.tile.sample_count();
        let points = view.points(&self.offsets);
        let passes = if view.shades_samples() { samples } else { 1 };
        for sample in 0..passes {
            let mut masks = [if passes == 1 { u16::MAX } else { 0 }; MAX_SAMPLES];
            masks[sample] = u16::MAX;
            for group in 0..GROUPS {
                let at = Candidates { group, sample, ids: l.u32(id), wanted: u16::MAX, masks: &masks[..samples] };
                self.list.push(l, &at, &points, view.visible.slots());
            }
        }
    }

    /// Lists the fragments of one draw; of all draws where there is only one, `NO_DRAW`. Returns the draw that was
    /// listed, if there was anything, and the next one in the block.
    #[inline(always)]
    fn list_visible<L: Lanes>(&mut self, l: L, view: TileView<'_>, draw: u32) -> (Option<u32>, u32) {
        self.list.clear();
        let samples = view.tile.sample_count();
        let planes = view.tile.block_planes(view.b);
        let points = view.points(&self.offsets);
        let (mut listed, mut next) = (None, NO_DRAW);
        for group in 0..GROUPS {
            let mut claimed = [0u16; MAX_SAMPLES];
            for sample in 0..samples {
                let ids = l.u32_array(&planes[sample * GROUPS + group]);
                // Ids are far below 2^31, so that no triangle, all ones, is negative.
                let mut wanted = ids.as_i32().ge(l.i32(view.visible.first_unshaded() as i32)).bits() & !claimed[sample];
                if let Some(draws) = view.visible.draws() {
                    wanted = of_draw(ids, draws, draw, wanted, &mut next);
                }
                if wanted == 0 {
                    continue;
                }
                listed = Some(ids.to_array()[wanted.trailing_zeros() as usize]);
                let mut masks = [0u16; MAX_SAMPLES];
                masks[sample] = wanted;
                if !view.shades_samples() {
                    for other in sample + 1..samples {
                        let same = ids.eq(l.u32_array(&planes[other * GROUPS + group])).bits() & wanted;
                        masks[other] = same;
                        claimed[other] |= same;
                    }
                }
                let at = Candidates { group, sample, ids, wanted, masks: &masks[..samples] };
                self.list.push(l, &at, &points, view.visible.slots());
            }
        }
        self.list.finish(l, &points, view.visible.slots());
        (listed.map(|id| view.visible.draw_number(id)), next) // tidy: allow(lane-closure): one number
    }

    /// Shades the listed fragments and combines them with the block's colours.
    #[inline(always)]
    fn shade<L: Lanes>(&mut self, l: L, view: TileView<'_>, draw: u32, colors: &mut ColorBlock, blend: Blend) {
        self.colors.resize(self.list.group_count(), [[0.0; LANES]; 4]);
        let shader = view.input.draws[draw as usize].shader;
        let records = view.visible.records();
        if l.can_explain()
            && let Some(witness) = &mut self.witness
        {
            witness.before(view, &self.list, Some(colors));
        }
        let mut batch = FragmentBatch { records, fragments: self.list.range(), fetched: &mut self.fetched };
        shader.shade(view.input.level, &mut batch, &mut self.colors);
        colors.merge(l, &self.list, &self.colors, blend);
        if l.can_explain()
            && let Some(witness) = &mut self.witness
        {
            witness.after(view, &mut batch, shader, Some((&self.colors, colors)));
        }
    }

    /// Lists the fragments of one triangle.
    #[inline(always)]
    fn list_triangle<L: Lanes>(&mut self, l: L, view: TileView<'_>, id: u32, pass: &PassMasks) {
        self.list.clear();
        let samples = view.tile.sample_count();
        let points = view.points(&self.offsets);
        let passes = if view.shades_samples() { samples } else { 1 };
        for group in 0..GROUPS {
            for sample in 0..passes {
                let mut masks = [0u16; MAX_SAMPLES];
                let mut wanted = 0;
                for s in 0..samples {
                    if passes == 1 || s == sample {
                        masks[s] = (pass.samples[s] >> (LANES * group) & 0xffff) as u16;
                        wanted |= masks[s];
                    }
                }
                if wanted != 0 {
                    let at = Candidates { group, sample, ids: l.u32(id), wanted, masks: &masks[..samples] };
                    self.list.push(l, &at, &points, view.visible.slots());
                }
            }
        }
        self.list.finish(l, &points, view.visible.slots());
    }

    /// Takes away the samples whose fragments the shader discards.
    #[inline(always)]
    pub(crate) fn discard<L: Lanes>(&mut self, l: L, view: TileView<'_>, id: u32, pass: &mut PassMasks) {
        self.list_triangle(l, view, id, pass);
        self.kept.resize(self.list.group_count(), 0);
        let shader = view.input.draws[view.visible.draw_number(id) as usize].shader;
        let records = view.visible.records();
        if l.can_explain()
            && let Some(witness) = &mut self.witness
        {
            witness.before(view, &self.list, None);
        }
        let mut batch = FragmentBatch { records, fragments: self.list.range(), fetched: &mut self.fetched };
        shader.keep(view.input.level, &mut batch, &mut self.kept);
        if l.can_explain()
            && let Some(witness) = &mut self.witness
        {
            witness.after(view, &mut batch, shader, None);
        }
        for (placement, kept) in self.list.placements().iter().zip(&self.kept) {
            match *placement {
                Placement::InPlace { group, masks } => {
                    let masks = self.list.masks(masks, view.tile.sample_count());
                    for (samples, mask) in pass.samples.iter_mut().zip(masks) {
                        *samples &= !(u64::from(mask & !kept) << (LANES * group));
                    }
                }
                Placement::Packed { first, count } => {
                    for lane in 0..count {
                        if kept >> lane & 1 == 0 {
                            drop_samples(pass, self.list.destination(first + lane));
                        }
                    }
                }
            }
        }
        pass.any = pass.samples.iter().fold(0, |any, mask| any | mask); // tidy: allow(lane-closure): bits
    }

    /// Shades one triangle's fragments and blends them.
    #[inline(always)]
    pub(crate) fn blend_block<L: Lanes>(
        &mut self,
        l: L,
        view: TileView<'_>,
        id: u32,
        pass: &PassMasks,
        colors: &mut ColorBlock,
    ) {
        self.list_triangle(l, view, id, pass);
        let draw = view.visible.draw_number(id);
        self.shade(l, view, draw, colors, view.input.draws[draw as usize].blend);
    }

    /// Writes the outputs beside colour of an expanded block.
    #[inline(always)]
    pub(crate) fn beside_color<L: Lanes>(&mut self, l: L, view: TileView<'_>, pixels: &mut TilePixels) {
        let outputs = view.input.frame.outputs;
        let planes = if outputs.per_sample { view.tile.sample_count() } else { 1 };
        for plane in 0..planes {
            for pixel in 0..BLOCK_PIXELS {
                let s = if outputs.per_sample { plane } else { nearest_sample(view.tile, view.b, pixel) };
                let id = view.tile.block_ids(view.b, s)[pixel];
                let (x, y) = pixel_in_tile(view.b, pixel);
                pixels.depth.set(plane, x, y, view.tile.block_depth(view.b, s)[pixel]);
                let (primitive, object) = if id == NO_TRIANGLE {
                    (u32::MAX, u32::MAX)
                } else {
                    let draw = &view.input.draws[view.visible.draw_number(id) as usize];
                    (view.visible.lookup(view.input).get(id).primitive, draw.object)
                };
                pixels.primitive.set(plane, x, y, primitive);
                pixels.object.set(plane, x, y, object);
                pixels.normal.set(plane, x, y, [0.0; 3]);
                pixels.position.set(plane, x, y, [0.0; 3]);
                pixels.uv.set(plane, x, y, [0.0; 2]);
            }
            if outputs.any_surface() {
                self.surfaces(l, view, plane, pixels);
            }
        }
    }

    /// Surfaces of one plane of the outputs, draw by draw.
    #[inline(always)]
    fn surfaces<L: Lanes>(&mut self, l: L, view: TileView<'_>, plane: usize, pixels: &mut TilePixels) {
        let mut draw = 0;
        while draw != NO_DRAW {
            let next = self.list_nearest(l, view, plane, draw);
            let shader = view.input.draws[draw as usize].shader;
            self.surfaces.resize(self.list.group_count(), [[0.0; LANES]; 8]);
            let records = view.visible.records();
            let mut batch = FragmentBatch { records, fragments: self.list.range(), fetched: &mut self.fetched };
            shader.surfaces(view.input.level, &mut batch, &mut self.surfaces);
            for (placement, surface) in self.list.placements().iter().zip(&self.surfaces) {
                let Placement::Packed { first, count } = *placement else { continue };
                for lane in 0..count {
                    let (x, y) = pixel_in_tile(view.b, self.list.destination(first + lane).pixel());
                    let s = surface.each_ref();
                    pixels.position.set(plane, x, y, [s[0][lane], s[1][lane], s[2][lane]]);
                    pixels.normal.set(plane, x, y, [s[3][lane], s[4][lane], s[5][lane]]);
                    pixels.uv.set(plane, x, y, [s[6][lane], s[7][lane]]);
                }
            }
            draw = next;
        }
    }

    /// Lists what one plane of the outputs shows of a draw; returns the next draw.
    #[inline(always)]
    fn list_nearest<L: Lanes>(&mut self, l: L, view: TileView<'_>, plane: usize, draw: u32) -> u32 {
        self.list.clear();
        let per_sample = view.input.frame.outputs.per_sample;
        let mut next = NO_DRAW;
        for pixel in 0..BLOCK_PIXELS {
            let s = if per_sample { plane } else { nearest_sample(view.tile, view.b, pixel) };
            let id = view.tile.block_ids(view.b, s)[pixel];
            if id == NO_TRIANGLE {
                continue;
            }
            let its_draw = view.visible.draw_number(id);
            if its_draw == draw {
                self.list.push_one(Destination::new(pixel, 1 << s, s), id);
            } else if its_draw > draw {
                next = next.min(its_draw);
            }
        }
        let points = view.points(&self.offsets);
        self.list.finish(l, &points, view.visible.slots());
        next
    }
}

/// The wanted lanes that belong to draw `draw`; `next` becomes the smallest later draw among the others.
#[inline(always)]
fn of_draw<L: Lanes>(ids: U32<L>, draws: &[u32], draw: u32, wanted: u16, next: &mut u32) -> u16 {
    let its_draws = ids.gather_u32(draws).to_array();
    let mut listed = 0;
    for (lane, its_draw) in its_draws.iter().enumerate() {
        if wanted >> lane & 1 == 1 {
            if *its_draw == draw {
                listed |= 1 << lane;
            } else if *its_draw > draw && *its_draw < *next {
                *next = *its_draw;
            }
        }
    }
    listed
}

fn drop_samples(pass: &mut PassMasks, destination: Destination) {
    for (s, samples) in pass.samples.iter_mut().enumerate() {
        if destination.samples() >> s & 1 == 1 {
            *samples &= !(1 << destination.pixel());
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
