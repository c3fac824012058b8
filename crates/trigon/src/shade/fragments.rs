//! Lists of fragments: what is to be shaded, in full lanes, and where its colours go.
//!
//! In: visible (pixel, triangle) pairs of a block. Out: groups of sixteen positions and records. Where most of sixteen
//! neighbouring pixels are wanted they stay in place, so that colours are stored by a masked write; the others are
//! packed, across triangles and rows, so that tiny triangles and silhouettes cost few idle lanes.

use crate::lanes::{F32, LANES, Lanes, U32};

/// Colours of sixteen fragments: red, green, blue, alpha.
pub type ColorGroup = [[f32; LANES]; 4];

/// Surfaces of sixteen fragments: position, normal, uv.
pub type SurfaceGroup = [[f32; LANES]; 8];

/// Fewest wanted pixels of sixteen that stay in place: an idle lane is weighed against the packing of the others. The
/// choice is not sharp: with 10, 13 and 16 the benchmark scenes take the same time within 5 %, which is their noise.
const IN_PLACE: u32 = 13;

/// Where the colours of sixteen fragments go.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Placement {
    /// Lane k is pixel `LANES * group + k`.
    InPlace {
        /// Rows `2 * group` and `2 * group + 1` of the block.
        group: usize,
        /// First of the group's masks: one per sample, one bit per lane.
        masks: usize,
    },
    /// Each lane has its own destination.
    Packed {
        /// Of the first lane.
        first: usize,
        /// Lanes in use.
        count: usize,
    },
}

/// Pixel and samples of a packed fragment.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Destination(u32);

impl Destination {
    /// `first` is the lowest of `samples`, which has a bit per sample.
    pub(crate) fn new(pixel: usize, samples: u32, first: usize) -> Self {
        Self(pixel as u32 | samples << 8 | (first as u32) << 24)
    }

    /// Pixel in the block, `8 * row + column`.
    #[inline(always)]
    pub(crate) fn pixel(self) -> usize {
        (self.0 & 0xff) as usize
    }

    /// One bit per sample.
    #[inline(always)]
    pub(crate) fn samples(self) -> u32 {
        self.0 >> 8 & 0xffff
    }
}

/// Where in a block's pixels shading happens.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadingPoints<'a> {
    /// Framebuffer position of the block's top-left corner.
    pub(crate) origin: [f32; 2],
    /// Offsets by sample along x and y; `None` for pixel centres.
    pub(crate) samples: Option<&'a [[f32; LANES]; 2]>,
}

/// Fragments of one block and one draw.
#[derive(Default)]
pub(crate) struct FragmentList {
    x: Vec<[f32; LANES]>,
    y: Vec<[f32; LANES]>,
    slots: Vec<[u32; LANES]>,
    placements: Vec<Placement>,
    masks: Vec<u16>,
    /// Destinations and triangles of the packed ones; as many as `packed`, and room for sixteen more.
    words: Vec<u32>,
    ids: Vec<u32>,
    packed: usize,
}

/// Groups of fragments to shade.
#[derive(Clone, Copy)]
pub struct FragmentRange<'a> {
    pub(crate) x: &'a [[f32; LANES]],
    pub(crate) y: &'a [[f32; LANES]],
    pub(crate) slots: &'a [[u32; LANES]],
}

/// Sixteen neighbouring pixels, some of which show triangles that are to be shaded.
pub(crate) struct Candidates<'a, L: Lanes> {
    /// Rows `2 * group` and `2 * group + 1` of the block.
    pub(crate) group: usize,
    /// The sample at which they were found, the lowest of each fragment.
    pub(crate) sample: usize,
    /// Triangles.
    pub(crate) ids: U32<L>,
    /// Which of them, one bit per lane; not zero.
    pub(crate) wanted: u16,
    /// The wanted ones by sample.
    pub(crate) masks: &'a [u16],
}

impl FragmentList {
    pub(crate) fn clear(&mut self) {
        self.x.clear();
        self.y.clear();
        self.slots.clear();
        self.placements.clear();
        self.masks.clear();
        self.packed = 0;
    }

    /// Adds sixteen neighbours; `slots` are the triangles' records.
    #[inline(always)]
    pub(crate) fn push<L: Lanes>(&mut self, l: L, at: &Candidates<'_, L>, points: &ShadingPoints<'_>, slots: &[u32]) {
        if at.wanted.count_ones() >= IN_PLACE {
            self.keep_in_place(l, at, points, slots);
        } else {
            self.pack(l, at);
        }
    }

    /// Unwanted lanes repeat a wanted one.
    #[inline(always)]
    fn keep_in_place<L: Lanes>(&mut self, l: L, at: &Candidates<'_, L>, points: &ShadingPoints<'_>, slots: &[u32]) {
        let pixels = (l.lane_numbers() + (LANES * at.group) as f32).to_i32_in_range().as_u32();
        let (mut x, mut y) = points.positions(l, pixels, l.u32(at.sample as u32));
        let mut slots = at.ids.gather_u32(slots);
        if at.wanted != u16::MAX {
            let (wanted, first) = (l.mask_from_bits(at.wanted), at.wanted.trailing_zeros() as usize);
            x = wanted.select(x, l.f32(x.to_array()[first]));
            y = wanted.select(y, l.f32(y.to_array()[first]));
            slots = wanted.select(slots, l.u32(slots.to_array()[first]));
        }
        self.append(x, y, slots, Placement::InPlace { group: at.group, masks: self.masks.len() });
        self.masks.extend_from_slice(at.masks);
    }

    #[inline(always)]
    fn pack<L: Lanes>(&mut self, l: L, at: &Candidates<'_, L>) {
        let pixels = (l.lane_numbers() + (LANES * at.group) as f32).to_i32_in_range().as_u32();
        let mut words = pixels | l.u32((at.sample as u32) << 24);
        for (s, mask) in at.masks.iter().enumerate() {
            words = words | l.mask_from_bits(*mask).select(l.u32(1 << (8 + s)), l.u32(0));
        }
        self.make_room();
        let wanted = l.mask_from_bits(at.wanted);
        if let Some(out) = self.words[self.packed..].first_chunk_mut() {
            wanted.pack(words).store(out);
        }
        if let Some(out) = self.ids[self.packed..].first_chunk_mut() {
            wanted.pack(at.ids).store(out);
        }
        self.packed += at.wanted.count_ones() as usize;
    }

    /// Adds one fragment, packed.
    pub(crate) fn push_one(&mut self, destination: Destination, id: u32) {
        self.make_room();
        self.words[self.packed] = destination.0;
        self.ids[self.packed] = id;
        self.packed += 1;
    }

    fn make_room(&mut self) {
        let needed = self.packed + LANES;
        if self.words.len() < needed {
            self.words.resize(2 * needed, 0);
            self.ids.resize(2 * needed, 0);
        }
    }

    /// Makes groups of the packed fragments; the last one repeats its last fragment. To be called when all are listed.
    #[inline(always)]
    pub(crate) fn finish<L: Lanes>(&mut self, l: L, points: &ShadingPoints<'_>, slots: &[u32]) {
        if self.packed == 0 {
            return;
        }
        self.make_room();
        let last = self.packed - 1;
        let (word, id) = (self.words[last], self.ids[last]);
        self.words[self.packed..self.packed + LANES].fill(word);
        self.ids[self.packed..self.packed + LANES].fill(id);
        for first in (0..self.packed).step_by(LANES) {
            let (Some(words), Some(ids)) = (self.words[first..].first_chunk(), self.ids[first..].first_chunk()) else {
                return;
            };
            let (words, ids) = (l.u32_array(words), l.u32_array(ids));
            let (x, y) = points.positions(l, words & l.u32(0xff), words >> 24);
            let count = (self.packed - first).min(LANES);
            self.append(x, y, ids.gather_u32(slots), Placement::Packed { first, count });
        }
    }

    #[inline(always)]
    fn append<L: Lanes>(&mut self, x: F32<L>, y: F32<L>, slots: U32<L>, placement: Placement) {
        self.x.push(x.to_array());
        self.y.push(y.to_array());
        self.slots.push(slots.to_array());
        self.placements.push(placement);
    }

    /// Groups of sixteen.
    pub(crate) fn group_count(&self) -> usize {
        self.x.len()
    }

    pub(crate) fn range(&self) -> FragmentRange<'_> {
        FragmentRange { x: &self.x, y: &self.y, slots: &self.slots }
    }

    pub(crate) fn placements(&self) -> &[Placement] {
        &self.placements
    }

    /// A mask per sample of a group that is in place.
    #[inline(always)]
    pub(crate) fn masks(&self, first: usize, samples: usize) -> &[u16] {
        &self.masks[first..first + samples]
    }

    /// Destination of packed fragment `i`.
    #[inline(always)]
    pub(crate) fn destination(&self, i: usize) -> Destination {
        Destination(self.words[i])
    }
}

impl ShadingPoints<'_> {
    /// Framebuffer positions of sixteen pixels of the block, at these samples.
    #[inline(always)]
    fn positions<L: Lanes>(&self, l: L, pixels: U32<L>, samples: U32<L>) -> (F32<L>, F32<L>) {
        let x = (pixels & l.u32(7)).to_f32() + self.origin[0];
        let y = (pixels >> 3).to_f32() + self.origin[1];
        match self.samples {
            None => (x + 0.5, y + 0.5),
            Some([along_x, along_y]) => (x + samples.gather_f32(along_x), y + samples.gather_f32(along_y)),
        }
    }
}
