//! One triangle in one tile: descent from the tile to its blocks, and the opaque depth test.
//!
//! In: a triangle, a tile. Out: the tile, with the triangle's id and depth where it is nearer. Blocks are rejected or
//! accepted at their corners, and by the depth bounds that every block keeps.

use super::edges::{BlockMasks, TileEdges};
use super::tile::{BLOCK_SIZE, BLOCKS_PER_SIDE, BlockState, DepthPlane, GROUPS, Tile, TriangleLookup, from_corner};
use crate::geometry::{PixelBox, ScreenTriangle};
use crate::lanes::{I32, Lanes, Mask, outline};
use crate::target::TILE_SIZE;

/// Which depths replace the stored one.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum DepthCompare {
    /// Strictly nearer.
    #[default]
    Nearer,
    /// Nearer or at the same depth.
    NearerOrEqual,
    /// All.
    Always,
}

/// How a draw uses the depth of what was drawn before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DepthTest {
    /// Which fragments pass.
    pub compare: DepthCompare,
    /// Whether those that pass store their depth.
    pub write: bool,
}

impl DepthTest {
    /// Nearer fragments pass and store their depth.
    pub const NEARER_WRITE: Self = Self { compare: DepthCompare::Nearer, write: true };
    /// Nearer fragments pass and leave the depth alone.
    pub const NEARER: Self = Self { compare: DepthCompare::Nearer, write: false };
    /// Depth is neither tested nor stored.
    pub const OFF: Self = Self { compare: DepthCompare::Always, write: false };
}

impl Default for DepthTest {
    fn default() -> Self {
        Self::NEARER_WRITE
    }
}

/// A triangle prepared for one tile.
pub struct TileTriangle<'a, L: Lanes> {
    pub(crate) triangle: &'a ScreenTriangle,
    edges: TileEdges,
    steps: [I32<L>; 3],
    bounds: PixelBox,
}

impl<'a, L: Lanes> TileTriangle<'a, L> {
    /// Prepares `triangle` for `tile`; `None` if it touches none of its pixels.
    #[inline(always)]
    pub fn new(l: L, tile: &Tile, triangle: &'a ScreenTriangle, extent: [(i32, i32); 2]) -> Option<Self> {
        let all = triangle.pixel_box(extent);
        let in_tile = PixelBox {
            x0: all.x0 - tile.origin[0],
            y0: all.y0 - tile.origin[1],
            x1: all.x1 - tile.origin[0],
            y1: all.y1 - tile.origin[1],
        };
        let bounds = in_tile.clip(TILE_SIZE as i32, TILE_SIZE as i32)?;
        let edges = TileEdges::new(triangle, tile.origin, tile.samples);
        let steps = edges.pixel_steps(l);
        Some(Self { triangle, edges, steps, bounds })
    }

    /// The blocks to look at.
    #[inline(always)]
    pub fn blocks(&self, l: L) -> BlockMasks {
        let size = BLOCK_SIZE as i32;
        let PixelBox { x0, y0, x1, y1 } = self.bounds;
        let (x0, x1, y0, y1) = (x0 / size, x1 / size, y0 / size, y1 / size);
        let columns = (0xffu64 >> (7 - (x1 - x0))) << x0;
        let rows = (u64::MAX >> (8 * (7 - (y1 - y0)))) << (8 * y0);
        let in_box = (columns * 0x0101_0101_0101_0101) & rows;
        // Two blocks or fewer: testing their pixels costs less than testing all corners.
        if in_box.count_ones() <= 2 {
            return BlockMasks { touched: in_box, covered: 0 };
        }
        let masks = self.edges.block_masks(l);
        BlockMasks { touched: masks.touched & in_box, covered: masks.covered & in_box }
    }

    /// Edge values of sample `s` at the first pixel of block `b`.
    #[inline(always)]
    pub(crate) fn block_bases(&self, b: usize, s: usize) -> [i32; 3] {
        let (x, y) = (b % BLOCKS_PER_SIDE * BLOCK_SIZE, b / BLOCKS_PER_SIDE * BLOCK_SIZE);
        self.edge_values(s, x, y)
    }

    /// Edge values of sample `s` of the pixel at (`x`, `y`) in the tile; none is negative where it is covered.
    #[inline(always)]
    pub(crate) fn edge_values(&self, s: usize, x: usize, y: usize) -> [i32; 3] {
        [self.edges.at(s, 0, x, y), self.edges.at(s, 1, x, y), self.edges.at(s, 2, x, y)]
    }

    /// Which of the sixteen pixels of lane group `g` are covered.
    #[inline(always)]
    pub(crate) fn covered(&self, l: L, bases: &[i32; 3], g: usize) -> Mask<L> {
        let mut signs = l.i32(0);
        for k in 0..3 {
            signs = signs | (self.steps[k] + l.i32(bases[k] + self.edges.step_y[k] * (2 * g) as i32));
        }
        signs.ge(l.i32(0))
    }

    /// Farthest and nearest depth of the triangle's plane over block `b`'s samples.
    ///
    /// The plane's evaluation is monotone in x and in y, rounding included; so the corners bound it exactly.
    #[inline(always)]
    pub(crate) fn depth_bounds(&self, tile: &Tile, b: usize, extent: [(i32, i32); 2]) -> (f32, f32) {
        const REACH: i32 = BLOCK_SIZE as i32 - 1;
        let (t, origin) = (self.triangle, tile.block_origin(b));
        let x0 = from_corner(origin[0], extent[0].0 as i16, t.x[0]);
        let x1 = from_corner(origin[0] + REACH, extent[0].1 as i16, t.x[0]);
        let y0 = from_corner(origin[1], extent[1].0 as i16, t.y[0]);
        let y1 = from_corner(origin[1] + REACH, extent[1].1 as i16, t.y[0]);
        let [z0, zx, zy] = t.depth;
        let (far_x, near_x) = if zx > 0.0 { (x0, x1) } else { (x1, x0) };
        let (far_y, near_y) = if zy > 0.0 { (y0, y1) } else { (y1, y0) };
        (z0 + (far_x * zx + far_y * zy), z0 + (near_x * zx + near_y * zy))
    }
}

/// Draws an opaque triangle: where it is nearer, its id and depth are stored.
#[inline(always)]
pub fn draw_opaque<L: Lanes, T: TriangleLookup>(
    l: L,
    tile: &mut Tile,
    triangle: &ScreenTriangle,
    id: u32,
    extent: [(i32, i32); 2],
    triangles: &T,
) {
    let Some(t) = TileTriangle::new(l, tile, triangle, extent) else { return };
    let masks = t.blocks(l);
    let mut rest = masks.touched;
    while rest != 0 {
        let b = rest.trailing_zeros() as usize;
        rest &= rest - 1;
        let is_covered = masks.covered >> b & 1 == 1;
        let (farthest, nearest) = t.depth_bounds(tile, b, extent);
        let block = tile.blocks[b];
        if nearest <= block.farthest {
            continue;
        }
        if is_covered && farthest > block.nearest {
            tile.blocks[b] = super::tile::Block { state: BlockState::Single(id), nearest, farthest };
            continue;
        }
        tile.expand(l, b, triangles);
        if is_covered {
            test_and_write::<L, true>(l, tile, b, &t, id);
        } else {
            test_and_write::<L, false>(l, tile, b, &t, id);
        }
        let block = &mut tile.blocks[b];
        block.nearest = if nearest > block.nearest { nearest } else { block.nearest };
    }
}

/// Depth-tests the covered samples of an expanded block and stores those that are nearer.
#[inline(never)]
fn test_and_write<L: Lanes, const COVERED: bool>(l: L, tile: &mut Tile, b: usize, t: &TileTriangle<'_, L>, id: u32) {
    outline!(l => test_samples::<L, COVERED>(l, tile, b, t, id));
}

#[inline(always)]
fn test_samples<L: Lanes, const COVERED: bool>(l: L, tile: &mut Tile, b: usize, t: &TileTriangle<'_, L>, id: u32) {
    let origin = tile.block_origin(b);
    let mut farthest = l.f32(f32::INFINITY);
    for s in 0..tile.samples.len() {
        let plane = DepthPlane::new(l, t.triangle, origin, tile.samples[s]);
        let bases = t.block_bases(b, s);
        let at = tile.group(b, s);
        let depths = &mut tile.depth[at..at + GROUPS];
        let ids = &mut tile.ids[at..at + GROUPS];
        for g in 0..GROUPS {
            let old = l.f32_array(&depths[g]);
            let depth = plane.at(l, g);
            let mut pass = depth.gt(old);
            if !COVERED {
                pass &= t.covered(l, &bases, g);
            }
            let new = pass.select(depth, old);
            farthest = farthest.min(new);
            new.store(&mut depths[g]);
            pass.select(l.u32(id), l.u32_array(&ids[g])).store(&mut ids[g]);
        }
    }
    tile.blocks[b].farthest = farthest.smallest_lane();
}
