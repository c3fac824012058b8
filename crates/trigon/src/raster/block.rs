//! Coverage and depth of one block, sixteen pixels at a time, for draws that are shaded before they are written.
//!
//! In: a triangle and a block. Out: per sample, which pixels are covered and pass the depth test. Nothing is written
//! until [`commit`]: the shader may still discard.

use super::edges::MAX_SAMPLES;
use super::tile::{DepthPlane, GROUPS, Tile};
use super::triangle::{DepthCompare, TileTriangle};
use crate::lanes::{LANES, Lanes, outline};

/// One bit per pixel of a block, per sample.
#[derive(Clone, Copy, Debug)]
pub struct PassMasks {
    /// Bit `8 * row + column`.
    pub samples: [u64; MAX_SAMPLES],
    /// Pixels with any sample.
    pub any: u64,
}

/// Which samples of block `b` the triangle covers and that pass the depth test. The block must be expanded.
#[inline(never)]
pub fn fill_masks<L: Lanes>(l: L, tile: &Tile, b: usize, t: &TileTriangle<'_, L>, compare: DepthCompare) -> PassMasks {
    outline!(l => pass_masks(l, tile, b, t, compare))
}

#[inline(always)]
fn pass_masks<L: Lanes>(l: L, tile: &Tile, b: usize, t: &TileTriangle<'_, L>, compare: DepthCompare) -> PassMasks {
    let mut masks = PassMasks { samples: [0; MAX_SAMPLES], any: 0 };
    let origin = tile.block_origin(b);
    for s in 0..tile.samples.len() {
        let plane = DepthPlane::new(l, t.triangle, origin, tile.samples[s]);
        let bases = t.block_bases(b, s);
        let at = tile.group(b, s);
        for g in 0..GROUPS {
            let covered = t.covered(l, &bases, g);
            if !covered.any() {
                continue;
            }
            let (depth, old) = (plane.at(l, g), l.f32_array(&tile.depth[at + g]));
            let pass = match compare {
                DepthCompare::Nearer => depth.gt(old),
                DepthCompare::NearerOrEqual => depth.ge(old),
                DepthCompare::Always => l.mask(true),
            };
            masks.samples[s] |= u64::from((covered & pass).bits()) << (LANES * g);
        }
        masks.any |= masks.samples[s];
    }
    masks
}

/// Writes depth (if `write_depth`) and `id` (if any) of the samples in `masks`.
#[inline(never)]
pub fn commit<L: Lanes>(
    l: L,
    tile: &mut Tile,
    b: usize,
    t: &TileTriangle<'_, L>,
    masks: &PassMasks,
    id: Option<u32>,
    write_depth: bool,
) {
    outline!(l => {
        write_masked(l, tile, b, t, masks, id, write_depth);
        if write_depth {
            tile.refresh_bounds(l, b);
        }
    });
}

#[inline(always)]
fn write_masked<L: Lanes>(
    l: L,
    tile: &mut Tile,
    b: usize,
    t: &TileTriangle<'_, L>,
    masks: &PassMasks,
    id: Option<u32>,
    write_depth: bool,
) {
    let origin = tile.block_origin(b);
    for s in 0..tile.samples.len() {
        let plane = DepthPlane::new(l, t.triangle, origin, tile.samples[s]);
        let at = tile.group(b, s);
        for g in 0..GROUPS {
            let mask = l.mask_from_bits((masks.samples[s] >> (LANES * g) & 0xffff) as u16);
            if !mask.any() {
                continue;
            }
            if write_depth {
                let old = l.f32_array(&tile.depth[at + g]);
                tile.depth[at + g] = mask.select(plane.at(l, g), old).to_array();
            }
            if let Some(id) = id {
                let old = l.u32_array(&tile.ids[at + g]);
                tile.ids[at + g] = mask.select(l.u32(id), old).to_array();
            }
        }
    }
}

impl Tile {
    /// Measures the nearest and farthest depth of an expanded block anew.
    #[inline(always)]
    fn refresh_bounds<L: Lanes>(&mut self, l: L, b: usize) {
        let at = self.group(b, 0);
        let groups = &self.depth[at..at + GROUPS * self.samples.len()];
        let (mut low, mut high) = (l.f32(f32::INFINITY), l.f32(f32::NEG_INFINITY));
        for group in groups {
            let depth = l.f32_array(group);
            low = low.min(depth);
            high = high.max(depth);
        }
        self.blocks[b].farthest = low.smallest_lane();
        self.blocks[b].nearest = -(-high).smallest_lane();
    }
}
