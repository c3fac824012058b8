//! Clip space to the framebuffer: divide by w, viewport, snap to 24.8.
//!
//! In: clip positions, sixteen at a time. Out: fixed-point positions, depth, 1/w, and a code that says which planes a
//! vertex lies beyond. Snapping rounds half to even, which makes coverage equal lavapipe's, bit for bit.

use super::triangle::{GUARD_BAND, SUBPIXEL};
use crate::lanes::{F32, I32, LANES, Lanes, U32};

/// The framebuffer rectangle that NDC -1..1 maps to: the whole target.
#[derive(Clone, Copy, Debug)]
pub struct Viewport {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Viewport {
    /// Half the size, in 1/256 px: scale and offset from NDC to fixed point.
    #[expect(clippy::cast_precision_loss, reason = "at most 2^14 * 2^7")]
    pub(crate) fn half_subpixels(self) -> [f32; 2] {
        [(self.width * SUBPIXEL as u32 / 2) as f32, (self.height * SUBPIXEL as u32 / 2) as f32]
    }
}

/// Clip positions of a chunk's unique vertices, by component; padded to whole groups of lanes.
#[derive(Default)]
#[expect(missing_docs, reason = "the coordinates")]
pub struct ClipPositions {
    pub x: Vec<[f32; LANES]>,
    pub y: Vec<[f32; LANES]>,
    pub z: Vec<[f32; LANES]>,
    pub w: Vec<[f32; LANES]>,
}

impl ClipPositions {
    /// Makes room for `count` vertices.
    pub fn resize(&mut self, count: usize) {
        let groups = count.div_ceil(LANES);
        for component in [&mut self.x, &mut self.y, &mut self.z, &mut self.w] {
            component.resize(groups, [0.0; LANES]);
        }
    }

    /// Vertex `i`.
    #[inline(always)]
    pub(crate) fn vertex(&self, i: usize) -> [f32; 4] {
        let (group, lane) = (i / LANES, i % LANES);
        [self.x[group][lane], self.y[group][lane], self.z[group][lane], self.w[group][lane]]
    }
}

/// Bits of a vertex code.
pub(crate) mod code {
    /// Beyond a side plane of the view volume; a triangle whose corners share one of these is outside.
    pub(crate) const LEFT: u32 = 1;
    pub(crate) const RIGHT: u32 = 2;
    pub(crate) const BELOW: u32 = 4;
    pub(crate) const ABOVE: u32 = 8;
    pub(crate) const NEAR: u32 = 16;
    pub(crate) const FAR: u32 = 32;
    /// Cannot be projected, or leaves the guard band: the triangle must be clipped.
    pub(crate) const CLIP: u32 = 64;
    /// Not a number, or infinite: the triangle is dropped.
    pub(crate) const BROKEN: u32 = 128;
}

/// Projected vertices of a chunk, by component.
#[derive(Default)]
pub(crate) struct ScreenVertices {
    pub(crate) x: Vec<i32>,
    pub(crate) y: Vec<i32>,
    pub(crate) depth: Vec<f32>,
    pub(crate) inv_w: Vec<f32>,
    pub(crate) code: Vec<u32>,
}

/// One projected vertex.
#[derive(Clone, Copy, Default)]
pub(crate) struct ScreenVertex {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) depth: f32,
    pub(crate) inv_w: f32,
}

impl ScreenVertices {
    fn resize(&mut self, groups: usize) {
        let count = groups * LANES;
        self.x.resize(count, 0);
        self.y.resize(count, 0);
        self.depth.resize(count, 0.0);
        self.inv_w.resize(count, 0.0);
        self.code.resize(count, 0);
    }
}

/// Projects every vertex of `clip`.
#[inline(always)]
pub(crate) fn project_all<L: Lanes>(l: L, clip: &ClipPositions, viewport: Viewport, out: &mut ScreenVertices) {
    let half = viewport.half_subpixels();
    out.resize(clip.x.len());
    for group in 0..clip.x.len() {
        let x = l.f32_array(&clip.x[group]);
        let y = l.f32_array(&clip.y[group]);
        let z = l.f32_array(&clip.z[group]);
        let w = l.f32_array(&clip.w[group]);
        let at = group * LANES;
        let v = project(l, [x, y, z, w], half);
        out.x[at..at + LANES].copy_from_slice(&v.x.to_array());
        out.y[at..at + LANES].copy_from_slice(&v.y.to_array());
        out.depth[at..at + LANES].copy_from_slice(&v.depth.to_array());
        out.inv_w[at..at + LANES].copy_from_slice(&v.inv_w.to_array());
        out.code[at..at + LANES].copy_from_slice(&v.code.to_array());
    }
}

struct Projected<L: Lanes> {
    x: I32<L>,
    y: I32<L>,
    depth: F32<L>,
    inv_w: F32<L>,
    code: U32<L>,
}

#[inline(always)]
fn project<L: Lanes>(l: L, [x, y, z, w]: [F32<L>; 4], half: [f32; 2]) -> Projected<L> {
    let limit = GUARD_BAND as f32;
    let inv_w = 1.0 / w;
    let sx = ((x * inv_w) * half[0] + half[0]).round_ties_even();
    let sy = (half[1] - (y * inv_w) * half[1]).round_ties_even();

    let zero = l.u32(0);
    let mut code = x.lt(-w).select(l.u32(code::LEFT), zero);
    code = code | x.gt(w).select(l.u32(code::RIGHT), zero);
    code = code | y.lt(-w).select(l.u32(code::BELOW), zero);
    code = code | y.gt(w).select(l.u32(code::ABOVE), zero);
    code = code | z.gt(w).select(l.u32(code::NEAR | code::CLIP), zero);
    code = code | z.lt(0.0).select(l.u32(code::FAR), zero);
    // Written so that a NaN, from w = 0 or a huge quotient, asks for clipping.
    let in_band = sx.abs().le(limit) & sy.abs().le(limit) & w.gt(0.0) & inv_w.lt(f32::INFINITY);
    code = code | in_band.select(zero, l.u32(code::CLIP));
    // Zero times a finite number is zero; times infinity or NaN it is NaN.
    let finite = (((x + y) * 0.0 + z * 0.0) + w * 0.0).eq(0.0) & (x * 0.0 + y * 0.0).eq(0.0);
    code = code | finite.select(zero, l.u32(code::BROKEN));

    Projected { x: sx.to_i32_within(-limit, limit), y: sy.to_i32_within(-limit, limit), depth: z * inv_w, inv_w, code }
}

/// Projects one clipped vertex; the same arithmetic as for sixteen.
pub(crate) fn project_one([x, y, z, w]: [f32; 4], half: [f32; 2]) -> Option<ScreenVertex> {
    let limit = GUARD_BAND as f32;
    let inv_w = 1.0 / w;
    let sx = ((x * inv_w) * half[0] + half[0]).round_ties_even();
    let sy = (half[1] - (y * inv_w) * half[1]).round_ties_even();
    let fits = sx.abs() <= limit && sy.abs() <= limit && w > 0.0 && inv_w < f32::INFINITY;
    fits.then_some(ScreenVertex { x: sx as i32, y: sy as i32, depth: z * inv_w, inv_w })
}
