//! Lists of fragments: what is to be shaded, packed into full lanes across triangles.
//!
//! In: visible (pixel, triangle) pairs. Out: groups of sixteen positions and coefficient slots, sorted by draw, and for
//! each fragment the samples that its colour goes to.

use crate::lanes::LANES;

/// Colours of sixteen fragments: red, green, blue, alpha.
pub type ColorGroup = [[f32; LANES]; 4];

/// Surfaces of sixteen fragments: position, normal, uv.
pub type SurfaceGroup = [[f32; LANES]; 8];

/// A fragment's destination.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Destination {
    /// Pixel in the block, `8 * row + column`.
    pub(crate) pixel: u8,
    /// One bit per sample.
    pub(crate) samples: u16,
    /// Which triangle of the tile.
    pub(crate) id: u32,
}

/// Fragments of one block and one draw. A lane group that is not full repeats its last fragment.
#[derive(Default)]
pub(crate) struct FragmentList {
    x: Vec<[f32; LANES]>,
    y: Vec<[f32; LANES]>,
    slots: Vec<[u32; LANES]>,
    pub(crate) destinations: Vec<Destination>,
}

/// Groups of fragments to shade.
#[derive(Clone, Copy)]
pub struct FragmentRange<'a> {
    pub(crate) x: &'a [[f32; LANES]],
    pub(crate) y: &'a [[f32; LANES]],
    pub(crate) slots: &'a [[u32; LANES]],
}

impl FragmentList {
    pub(crate) fn clear(&mut self) {
        self.x.clear();
        self.y.clear();
        self.slots.clear();
        self.destinations.clear();
    }

    /// Appends a fragment at framebuffer position (`x`, `y`).
    #[inline(always)]
    pub(crate) fn push(&mut self, x: f32, y: f32, slot: u32, destination: Destination) {
        let lane = self.destinations.len() % LANES;
        if lane == 0 {
            self.x.push([x; LANES]);
            self.y.push([y; LANES]);
            self.slots.push([slot; LANES]);
        } else if let (Some(gx), Some(gy), Some(gs)) = (self.x.last_mut(), self.y.last_mut(), self.slots.last_mut()) {
            gx[lane..].fill(x);
            gy[lane..].fill(y);
            gs[lane..].fill(slot);
        }
        self.destinations.push(destination);
    }

    /// The 64 pixels of a block whose first pixel centre is `at`, all of one triangle. They have no destinations: the
    /// groups are in pixel order.
    pub(crate) fn fill_block(&mut self, at: [f32; 2], slot: u32) {
        for g in 0..4u8 {
            let (mut x, mut y) = ([at[0]; LANES], [at[1] + f32::from(2 * g); LANES]);
            for lane in 0..LANES {
                x[lane] += (lane % 8) as f32;
                y[lane] += (lane / 8) as f32;
            }
            self.x.push(x);
            self.y.push(y);
            self.slots.push([slot; LANES]);
        }
    }

    /// Groups of sixteen.
    pub(crate) fn group_count(&self) -> usize {
        self.x.len()
    }

    pub(crate) fn range(&self) -> FragmentRange<'_> {
        FragmentRange { x: &self.x, y: &self.y, slots: &self.slots }
    }
}
