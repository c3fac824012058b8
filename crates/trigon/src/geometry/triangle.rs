//! The product of the geometry stage: triangles in the framebuffer, ready to be rasterized.
//!
//! Records are one cache line each. They hold what the depth test needs; attributes stay with their vertices and are
//! fetched only for triangles that turn out to be visible.

/// Bits of subpixel precision: positions are 24.8 fixed point.
pub(crate) const SUBPIXEL_BITS: u32 = 8;

/// One pixel in fixed point.
pub const SUBPIXEL: i32 = 1 << SUBPIXEL_BITS;

/// Largest magnitude of a snapped coordinate: the guard band, +-16 384 px.
///
/// With it |A| + |B| <= 2^24 for every edge, and 63 steps of them stay below 2^30, so that a base clamped to +-2^30
/// keeps every sum within a 64 x 64 tile in `i32` and its sign true.
pub const GUARD_BAND: i32 = 16_384 << SUBPIXEL_BITS;

/// A triangle in framebuffer space.
///
/// Invariants: corner 0 is the topmost, leftmost of equals; the signed area
/// `(x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0)` is positive; coordinates lie within [`GUARD_BAND`].
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
pub struct ScreenTriangle {
    /// Corners, in 1/256 px; x right.
    pub x: [i32; 3],
    /// Corners, in 1/256 px; y down.
    pub y: [i32; 3],
    /// Depth at corner 0 and its change per pixel along x and y.
    pub depth: [f32; 3],
    /// 1/w at the corners.
    pub inv_w: [f32; 3],
    /// Number of the primitive within its draw.
    pub primitive: u32,
    /// Index of the micro-triangle's coverage, or of the clipped triangle's corners; see [`Tags`].
    pub side: u32,
    /// Everything that fits in a few bits.
    pub tags: Tags,
}

/// Small facts about a [`ScreenTriangle`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tags(pub u32);

impl Tags {
    /// The pixels touched fit in a 4 x 4 box, and `side` is the index of its coverage masks.
    pub const MICRO: u32 = 1 << 6;
    /// The corners are not vertices; `side` is the index of their [`ClippedCorners`].
    pub const CLIPPED: u32 = 1 << 7;
    /// The vertices appear counter-clockwise, as submitted.
    pub const FRONT: u32 = 1 << 8;

    /// Tags for a triangle whose corner k is vertex `vertices[k]` (0, 1 or 2) of its primitive.
    pub fn corners(vertices: [u32; 3]) -> u32 {
        vertices[0] | vertices[1] << 2 | vertices[2] << 4
    }

    /// Which vertex of the primitive corner `k` is.
    #[inline(always)]
    pub fn vertex_of_corner(self, k: usize) -> usize {
        (self.0 >> (2 * k) & 3) as usize
    }

    /// True if all of `bits` are set.
    #[inline(always)]
    pub fn has(self, bits: u32) -> bool {
        self.0 & bits == bits
    }
}

/// Weights of vertices 1 and 2 of the primitive at the three corners of a clipped piece.
#[derive(Clone, Copy, Debug, Default)]
pub struct ClippedCorners(pub [[f32; 2]; 3]);

impl ScreenTriangle {
    /// Pixels whose samples may be covered: inclusive ranges of columns and rows.
    ///
    /// `extent` are the smallest and largest sample offsets along x and y. Empty ranges have `first > last`.
    #[inline(always)]
    pub fn pixel_box(&self, extent: [(i32, i32); 2]) -> PixelBox {
        let (x0, x1) = pixel_range(self.x, extent[0]);
        let (y0, y1) = pixel_range(self.y, extent[1]);
        PixelBox { x0, y0, x1, y1 }
    }
}

/// First pixel whose last sample is not before the triangle, and last pixel whose first sample is not past it.
#[inline(always)]
fn pixel_range(c: [i32; 3], (first, last): (i32, i32)) -> (i32, i32) {
    let low = c[0].min(c[1]).min(c[2]);
    let high = c[0].max(c[1]).max(c[2]);
    ((low - last + SUBPIXEL - 1) >> SUBPIXEL_BITS, (high - first) >> SUBPIXEL_BITS)
}

/// Inclusive ranges of pixel columns and rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "first and last column and row")]
pub struct PixelBox {
    pub x0: i32,
    pub y0: i32,
    pub x1: i32,
    pub y1: i32,
}

impl PixelBox {
    /// The part inside a picture of `width` x `height` pixels; `None` if there is none.
    #[inline(always)]
    pub fn clip(self, width: i32, height: i32) -> Option<Self> {
        let clipped =
            Self { x0: self.x0.max(0), y0: self.y0.max(0), x1: self.x1.min(width - 1), y1: self.y1.min(height - 1) };
        (clipped.x0 <= clipped.x1 && clipped.y0 <= clipped.y1).then_some(clipped)
    }
}
