//! Edge functions of one triangle in one tile, in `i32`, exactly.
//!
//! With differences A, B in 1/256 px an edge function at pixel (i, j) is E = c + 256 (A i + B j), so E < 0 if and only
//! if floor(c / 256) + A i + B j < 0. The base floor(c / 256) is computed in `i64` per sample and clamped to +-2^30: as
//! |A| + |B| <= 2^24 inside the guard band, 63 steps change it by less than 2^30; so a clamped base keeps its sign
//! all over the tile, and no sum leaves `i32`.

use super::tile::{BLOCK_SIZE, GROUPS};
use crate::geometry::{SUBPIXEL, ScreenTriangle};
use crate::lanes::{I32, Lanes};
use crate::target::TILE_SIZE;

const BASE_LIMIT: i64 = 1 << 30;

/// Most samples that a pixel can have.
pub(crate) const MAX_SAMPLES: usize = 16;

/// The three edges at a tile's first pixel.
pub(crate) struct TileEdges {
    /// Change per pixel to the right (A) and down (B).
    pub(crate) step_x: [i32; 3],
    pub(crate) step_y: [i32; 3],
    /// Per sample, at the tile's first pixel.
    pub(crate) base: [[i32; 3]; MAX_SAMPLES],
    /// Smallest and largest base over the samples.
    base_min: [i32; 3],
    base_max: [i32; 3],
}

impl TileEdges {
    #[inline(always)]
    pub(crate) fn new(t: &ScreenTriangle, origin: [i32; 2], samples: &[[i16; 2]]) -> Self {
        let mut edges = Self {
            step_x: [0; 3],
            step_y: [0; 3],
            base: [[0; 3]; MAX_SAMPLES],
            base_min: [i32::MAX; 3],
            base_max: [i32::MIN; 3],
        };
        for k in 0..3 {
            let next = (k + 1) % 3;
            let (dx, dy) = (t.x[next] - t.x[k], t.y[next] - t.y[k]);
            // Top-left rule: left edges go up, top edges go right; the others lose samples that lie on them.
            let bias = if dy < 0 || (dy == 0 && dx > 0) { 0 } else { -1 };
            let left = i64::from(origin[0] * SUBPIXEL - t.x[k]);
            let top = i64::from(origin[1] * SUBPIXEL - t.y[k]);
            (edges.step_x[k], edges.step_y[k]) = (-dy, dx);
            for (s, [sx, sy]) in samples.iter().enumerate() {
                let (x, y) = (left + i64::from(*sx), top + i64::from(*sy));
                let e = i64::from(dx) * y - i64::from(dy) * x + bias;
                let base = (e >> 8).clamp(-BASE_LIMIT, BASE_LIMIT) as i32;
                edges.base[s][k] = base;
                edges.base_min[k] = edges.base_min[k].min(base);
                edges.base_max[k] = edges.base_max[k].max(base);
            }
        }
        edges
    }

    /// Which of the tile's 64 blocks the triangle may touch, and which it covers whole.
    #[inline(always)]
    pub(crate) fn block_masks<L: Lanes>(&self, l: L) -> BlockMasks {
        const REACH: i32 = BLOCK_SIZE as i32 - 1;
        let mut masks = BlockMasks { touched: 0, covered: 0 };
        let mut steps = [l.i32(0); 3];
        for k in 0..3 {
            steps[k] = group_steps(l, self.step_x[k] * BLOCK_SIZE as i32, self.step_y[k] * BLOCK_SIZE as i32);
        }
        for g in 0..GROUPS {
            let (mut outside, mut partial) = (l.i32(0), l.i32(0));
            for k in 0..3 {
                let rows = self.step_y[k] * (BLOCK_SIZE * 2 * g) as i32;
                let (ax, by) = (self.step_x[k] * REACH, self.step_y[k] * REACH);
                let highest = self.base_max[k] + ax.max(0) + by.max(0) + rows;
                let lowest = self.base_min[k] + ax.min(0) + by.min(0) + rows;
                outside = outside | (steps[k] + l.i32(highest));
                partial = partial | (steps[k] + l.i32(lowest));
            }
            let zero = l.i32(0);
            masks.touched |= u64::from(outside.ge(zero).bits()) << (16 * g);
            masks.covered |= u64::from(partial.ge(zero).bits()) << (16 * g);
        }
        masks
    }

    /// Steps from a block's first pixel to the sixteen of lane group 0.
    #[inline(always)]
    pub(crate) fn pixel_steps<L: Lanes>(&self, l: L) -> [I32<L>; 3] {
        let mut steps = [l.i32(0); 3];
        for k in 0..3 {
            steps[k] = group_steps(l, self.step_x[k], self.step_y[k]);
        }
        steps
    }

    /// Value of sample `s` of the pixel at (`x`, `y`) in the tile.
    #[inline(always)]
    pub(crate) fn at(&self, s: usize, k: usize, x: usize, y: usize) -> i32 {
        debug_assert!(x < TILE_SIZE && y < TILE_SIZE);
        self.base[s][k] + self.step_x[k] * x as i32 + self.step_y[k] * y as i32
    }
}

/// One bit per block, row by row.
#[derive(Clone, Copy, Debug)]
#[expect(missing_docs, reason = "named after what they hold")]
pub struct BlockMasks {
    pub touched: u64,
    pub covered: u64,
}

/// `column * dx + row * dy` for two rows of eight.
#[inline(always)]
fn group_steps<L: Lanes>(l: L, dx: i32, dy: i32) -> I32<L> {
    const COLUMNS: [i32; 16] = [0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7];
    const ROWS: [i32; 16] = [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1];
    l.i32_array(&COLUMNS) * l.i32(dx) + l.i32_array(&ROWS) * l.i32(dy)
}
