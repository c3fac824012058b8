//! The tile: depth and visible triangle of every sample of 64 x 64 pixels, in 8 x 8 blocks.
//!
//! A block is in one of three states. `Clear` and `Single` (one triangle covers every sample) are descriptions of a few
//! bytes; `Full` keeps planar samples: `[block][sample][pixel]`, sixteen pixels (two rows of eight) to a lane group. So
//! a clear costs nothing, and interiors of large triangles cost one decision per block.

use crate::geometry::ScreenTriangle;
use crate::lanes::{LANES, Lanes, outline};
use crate::target::TILE_SIZE;

/// Pixels along a side of a block.
pub const BLOCK_SIZE: usize = 8;
/// Blocks along a side of a tile.
pub const BLOCKS_PER_SIDE: usize = TILE_SIZE / BLOCK_SIZE;
/// Blocks in a tile.
pub const BLOCKS: usize = BLOCKS_PER_SIDE * BLOCKS_PER_SIDE;
/// Pixels in a block.
pub const BLOCK_PIXELS: usize = BLOCK_SIZE * BLOCK_SIZE;
/// Lane groups in a sample plane of a block.
pub(crate) const GROUPS: usize = BLOCK_PIXELS / LANES;

/// The id of samples that no triangle covers.
pub const NO_TRIANGLE: u32 = u32::MAX;

/// What is known of a block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum BlockState {
    /// No triangle yet, depth as cleared.
    Clear,
    /// Every sample shows this triangle.
    Single(u32),
    /// Sample by sample.
    Full,
}

/// One block's description. `farthest <= depth <= nearest` holds for every sample (1 is near, 0 is far).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Block {
    pub(crate) state: BlockState,
    pub(crate) nearest: f32,
    pub(crate) farthest: f32,
}

/// Depth and triangle per sample of one tile. Reused from tile to tile.
pub struct Tile {
    /// Framebuffer position of the top-left pixel.
    pub(crate) origin: [i32; 2],
    pub(crate) samples: &'static [[i16; 2]],
    pub(crate) blocks: [Block; BLOCKS],
    pub(crate) depth: Vec<[f32; LANES]>,
    pub(crate) ids: Vec<[u32; LANES]>,
    clear_depth: f32,
}

impl Tile {
    /// A tile whose pixels have these samples.
    #[must_use]
    pub fn new(samples: &'static [[i16; 2]]) -> Self {
        let clear = Block { state: BlockState::Clear, nearest: 0.0, farthest: 0.0 };
        let groups = BLOCKS * GROUPS * samples.len();
        Self {
            origin: [0, 0],
            samples,
            blocks: [clear; BLOCKS],
            depth: vec![[0.0; LANES]; groups],
            ids: vec![[NO_TRIANGLE; LANES]; groups],
            clear_depth: 0.0,
        }
    }

    /// Forgets everything; the tile's top-left pixel is now `origin`.
    pub fn clear(&mut self, origin: [i32; 2], depth: f32) {
        self.origin = origin;
        self.clear_depth = depth;
        self.blocks.fill(Block { state: BlockState::Clear, nearest: depth, farthest: depth });
    }

    /// Makes every block but `b` one that nothing is in front of: opaque triangles pass it by.
    pub(crate) fn close_all_but(&mut self, b: usize) {
        for (other, block) in self.blocks.iter_mut().enumerate() {
            if other != b {
                (block.nearest, block.farthest) = (f32::INFINITY, f32::INFINITY);
            }
        }
    }

    /// How many samples a pixel has.
    #[must_use]
    pub fn sample_count(&self) -> usize {
        self.samples.len()
    }

    /// What is known of block `b`.
    #[must_use]
    pub fn state(&self, b: usize) -> BlockState {
        self.blocks[b].state
    }

    /// Framebuffer position of the top-left pixel of block `b`.
    #[must_use]
    pub fn block_origin(&self, b: usize) -> [i32; 2] {
        let (x, y) = (b % BLOCKS_PER_SIDE * BLOCK_SIZE, b / BLOCKS_PER_SIDE * BLOCK_SIZE);
        [self.origin[0] + x as i32, self.origin[1] + y as i32]
    }

    /// The triangles of sample `s` of a `Full` block, pixel by pixel.
    #[must_use]
    pub fn block_ids(&self, b: usize, s: usize) -> &[u32] {
        let at = self.group(b, s);
        self.ids[at..at + GROUPS].as_flattened()
    }

    /// The triangles of all samples of a `Full` block: lane group `g` of sample `s` is element `s * GROUPS + g`.
    #[inline(always)]
    pub(crate) fn block_planes(&self, b: usize) -> &[[u32; LANES]] {
        let at = self.group(b, 0);
        &self.ids[at..at + GROUPS * self.samples.len()]
    }

    /// The depths of sample `s` of a `Full` block, pixel by pixel.
    #[must_use]
    pub fn block_depth(&self, b: usize, s: usize) -> &[f32] {
        let at = self.group(b, s);
        self.depth[at..at + GROUPS].as_flattened()
    }

    /// Depth and triangle of sample `s` of one pixel of block `b`, whatever the block's state is.
    pub(crate) fn sample<L: Lanes, T: TriangleLookup>(
        &self,
        l: L,
        [b, pixel, s]: [usize; 3],
        triangles: &T,
    ) -> (f32, u32) {
        match self.blocks[b].state {
            BlockState::Clear => (self.clear_depth, NO_TRIANGLE),
            BlockState::Single(id) => (self.plane_depth(l, [b, pixel, s], triangles.triangle(id)), id),
            BlockState::Full => (self.block_depth(b, s)[pixel], self.block_ids(b, s)[pixel]),
        }
    }

    /// The depth of a triangle's plane at sample `s` of one pixel of block `b`.
    pub(crate) fn plane_depth<L: Lanes>(&self, l: L, [b, pixel, s]: [usize; 3], triangle: &ScreenTriangle) -> f32 {
        let plane = DepthPlane::new(l, triangle, self.block_origin(b), self.samples[s]);
        plane.at(l, pixel / LANES).to_array()[pixel % LANES]
    }

    /// Index of the first lane group of a block's sample plane.
    #[inline(always)]
    pub(crate) fn group(&self, block: usize, sample: usize) -> usize {
        (block * self.samples.len() + sample) * GROUPS
    }

    /// Makes block `b` `Full`. `triangle` finds a triangle by its id.
    #[inline(always)]
    pub fn expand<L: Lanes, T: TriangleLookup>(&mut self, l: L, b: usize, triangles: &T) {
        if self.blocks[b].state != BlockState::Full {
            self.make_full(l, b, triangles);
        }
    }

    #[inline(never)]
    fn make_full<L: Lanes, T: TriangleLookup>(&mut self, l: L, b: usize, triangles: &T) {
        match self.blocks[b].state {
            BlockState::Full => {}
            BlockState::Clear => {
                let at = self.group(b, 0);
                let groups = GROUPS * self.samples.len();
                self.depth[at..at + groups].fill([self.clear_depth; LANES]);
                self.ids[at..at + groups].fill([NO_TRIANGLE; LANES]);
            }
            BlockState::Single(id) => outline!(l => self.expand_single(l, b, id, triangles.triangle(id))),
        }
        self.blocks[b].state = BlockState::Full;
    }

    #[inline(always)]
    fn expand_single<L: Lanes>(&mut self, l: L, b: usize, id: u32, triangle: &ScreenTriangle) {
        let origin = self.block_origin(b);
        for s in 0..self.samples.len() {
            let plane = DepthPlane::new(l, triangle, origin, self.samples[s]);
            let at = self.group(b, s);
            for g in 0..GROUPS {
                self.depth[at + g] = plane.at(l, g).to_array();
                self.ids[at + g] = [id; LANES];
            }
        }
    }
}

/// Finds triangles by the ids that a tile stores.
pub trait TriangleLookup {
    /// The triangle with this id.
    fn triangle(&self, id: u32) -> &ScreenTriangle;
}

/// A triangle's depth over one block, for one sample position.
pub(crate) struct DepthPlane<L: Lanes> {
    base: f32,
    /// Change per pixel, times the distance from corner 0, for the columns.
    along_x: crate::lanes::F32<L>,
    slope_y: f32,
    distance_y: crate::lanes::F32<L>,
}

impl<L: Lanes> DepthPlane<L> {
    #[inline(always)]
    pub(crate) fn new(l: L, t: &ScreenTriangle, origin: [i32; 2], sample: [i16; 2]) -> Self {
        let [column, row] = pixel_offsets(l);
        let x = column + from_corner(origin[0], sample[0], t.x[0]);
        let y = row + from_corner(origin[1], sample[1], t.y[0]);
        Self { base: t.depth[0], along_x: x * t.depth[1], slope_y: t.depth[2], distance_y: y }
    }

    /// Depth of the sixteen pixels of lane group `g`.
    #[inline(always)]
    pub(crate) fn at(&self, _l: L, g: usize) -> crate::lanes::F32<L> {
        let y = self.distance_y + (2 * g) as f32;
        self.base + (self.along_x + y * self.slope_y)
    }
}

/// Column and row of the sixteen pixels of lane group 0: two rows of eight.
#[inline(always)]
pub(crate) fn pixel_offsets<L: Lanes>(l: L) -> [crate::lanes::F32<L>; 2] {
    [
        l.f32_array(&[0., 1., 2., 3., 4., 5., 6., 7., 0., 1., 2., 3., 4., 5., 6., 7.]),
        l.f32_array(&[0., 0., 0., 0., 0., 0., 0., 0., 1., 1., 1., 1., 1., 1., 1., 1.]),
    ]
}

/// Distance in pixels from a triangle's corner to a sample; exact, as both are multiples of 1/256 px below 2^16.
#[inline(always)]
#[expect(clippy::cast_precision_loss, reason = "at most 24 bits")]
pub(crate) fn from_corner(pixel: i32, sample: i16, corner: i32) -> f32 {
    (pixel * 256 + i32::from(sample) - corner) as f32 * (1.0 / 256.0)
}
