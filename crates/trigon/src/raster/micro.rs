//! Micro-triangles in a tile: their coverage is known already, pixel by pixel.
//!
//! In: a triangle whose box is at most 4 x 4 pixels, and its masks. Out: the tile. Work is per covered sample.

use super::tile::{BLOCK_SIZE, BLOCKS_PER_SIDE, GROUPS, Tile, TriangleLookup, from_corner};
use crate::geometry::ScreenTriangle;
use crate::lanes::{LANES, Lanes};
use crate::target::TILE_SIZE;

/// Draws an opaque micro-triangle with one coverage mask per sample (see [`Tags::MICRO`](crate::geometry::Tags)).
#[inline(always)]
pub fn draw_micro<L: Lanes, T: TriangleLookup>(
    l: L,
    tile: &mut Tile,
    triangle: &ScreenTriangle,
    masks: &[u16],
    id: u32,
    extent: [(i32, i32); 2],
    triangles: &T,
) {
    let bounds = triangle.pixel_box(extent);
    let (left, top) = (bounds.x0 - tile.origin[0], bounds.y0 - tile.origin[1]);
    let [z0, zx, zy] = triangle.depth;
    for (s, mask) in masks.iter().enumerate() {
        let [sx, sy] = tile.samples[s];
        let fx = from_corner(bounds.x0, sx, triangle.x[0]);
        let fy = from_corner(bounds.y0, sy, triangle.y[0]);
        let mut rest = u32::from(*mask);
        while rest != 0 {
            let bit = rest.trailing_zeros();
            rest &= rest - 1;
            let (column, row) = ((bit & 3) as i32, (bit >> 2) as i32);
            let (x, y) = (left + column, top + row);
            if x as u32 >= TILE_SIZE as u32 || y as u32 >= TILE_SIZE as u32 {
                continue;
            }
            let depth = z0 + ((fx + column as f32) * zx + (fy + row as f32) * zy);
            draw_sample(l, tile, [x as usize, y as usize], s, depth, id, triangles);
        }
    }
}

#[inline(always)]
fn draw_sample<L: Lanes, T: TriangleLookup>(
    l: L,
    tile: &mut Tile,
    [x, y]: [usize; 2],
    sample: usize,
    depth: f32,
    id: u32,
    triangles: &T,
) {
    let b = y / BLOCK_SIZE * BLOCKS_PER_SIDE + x / BLOCK_SIZE;
    if depth <= tile.blocks[b].farthest {
        return;
    }
    tile.expand(l, b, triangles);
    let pixel = y % BLOCK_SIZE * BLOCK_SIZE + x % BLOCK_SIZE;
    let group = (b * tile.samples.len() + sample) * GROUPS + pixel / LANES;
    let stored = &mut tile.depth[group][pixel % LANES];
    if depth > *stored {
        *stored = depth;
        tile.ids[group][pixel % LANES] = id;
        let nearest = &mut tile.blocks[b].nearest;
        *nearest = if depth > *nearest { depth } else { *nearest };
    }
}
