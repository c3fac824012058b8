//! Binning: which tiles a triangle touches, and each tile's triangles in submission order.
//!
//! In: the triangles of one chunk. Out: one run of entries per touched tile. A counting sort keeps the order.

use super::triangle::{PixelBox, SUBPIXEL, ScreenTriangle};
use crate::target::TILE_SIZE;

/// The entries of one tile in a chunk: `entries[start .. start + len]`.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    /// Number of the tile, row by row.
    pub tile: u32,
    /// First entry.
    pub start: u32,
    /// Number of entries.
    pub len: u32,
}

/// Collects (tile, triangle) pairs and sorts them by tile.
#[derive(Default)]
pub(crate) struct Binner {
    pairs: Vec<(u32, u32)>,
    counts: Vec<u32>,
}

/// The tiles of a target.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TileGrid {
    columns: u32,
}

impl TileGrid {
    pub(crate) fn new(width: u32) -> Self {
        Self { columns: width.div_ceil(TILE_SIZE as u32) }
    }
}

impl Binner {
    /// Lists triangle `index` in every tile that it may touch. `bounds` lies inside the target.
    #[inline(always)]
    pub(crate) fn push(&mut self, grid: TileGrid, index: u32, triangle: &ScreenTriangle, bounds: PixelBox) {
        let size = TILE_SIZE as i32;
        let (x0, x1) = (bounds.x0 / size, bounds.x1 / size);
        let (y0, y1) = (bounds.y0 / size, bounds.y1 / size);
        let tile = |x: i32, y: i32| y as u32 * grid.columns + x as u32;
        if x0 == x1 && y0 == y1 {
            self.pairs.push((tile(x0, y0), index));
            return;
        }
        let is_wide = x1 - x0 > 1 || y1 - y0 > 1;
        for y in y0..=y1 {
            for x in x0..=x1 {
                if !is_wide || may_touch(triangle, x, y) {
                    self.pairs.push((tile(x, y), index));
                }
            }
        }
    }

    /// Writes the collected pairs, sorted by tile, and forgets them.
    pub(crate) fn sort_into(&mut self, entries: &mut Vec<u32>, segments: &mut Vec<Segment>) {
        entries.clear();
        segments.clear();
        let first = self.pairs.iter().map(|p| p.0).min().unwrap_or(0);
        let last = self.pairs.iter().map(|p| p.0).max().unwrap_or(0);
        self.counts.clear();
        self.counts.resize((last - first + 1) as usize, 0);
        for (tile, _) in &self.pairs {
            self.counts[(tile - first) as usize] += 1;
        }
        let mut start = 0;
        for (tile, count) in (first..).zip(&mut self.counts) {
            if *count > 0 {
                segments.push(Segment { tile, start, len: *count });
                (start, *count) = (start + *count, start);
            }
        }
        entries.resize(self.pairs.len(), 0);
        for (tile, index) in &self.pairs {
            let at = &mut self.counts[(tile - first) as usize];
            entries[*at as usize] = *index;
            *at += 1;
        }
        self.pairs.clear();
    }
}

/// False only if one edge has the whole tile on its outer side.
fn may_touch(t: &ScreenTriangle, tile_x: i32, tile_y: i32) -> bool {
    let size = i64::from(TILE_SIZE as i32 * SUBPIXEL);
    let (left, top) = (i64::from(tile_x) * size, i64::from(tile_y) * size);
    (0..3).all(|k| {
        let n = (k + 1) % 3;
        let (dx, dy) = (i64::from(t.x[n] - t.x[k]), i64::from(t.y[n] - t.y[k]));
        // The corner of the tile where this edge function is largest.
        let x = if dy < 0 { left + size } else { left } - i64::from(t.x[k]);
        let y = if dx > 0 { top + size } else { top } - i64::from(t.y[k]);
        dx * y - dy * x >= 0
    })
}
