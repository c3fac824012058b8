//! One chunk of primitives through the geometry stage.
//!
//! In: a draw, a range of its primitives, and their clip positions. Out: a [`Chunk`]: triangles, coverage of the micro
//! ones, and each touched tile's list. Chunks are independent: any thread can take any, in any order.

use super::assemble::{Cull, Primitives, VertexNumbering};
use super::bins::{Binner, Segment, TileGrid};
use super::clip::{ClipPlanes, ClipVertex, clip_segment, clip_triangle};
use super::micro::{self, LaneBoxes};
use super::project::{ClipPositions, ScreenVertex, ScreenVertices, Viewport, code, project_all, project_one};
use super::setup::{Corners, LaneSetup, setup_one};
use super::stroke::{MAX_STROKE, RECTANGLE, line_corners, point_corners};
use super::triangle::{ClippedCorners, PixelBox, ScreenTriangle, Tags};
use crate::lanes::{LANES, Lanes, Mask, U32};
use crate::target::SamplePattern;

/// Primitives in a full chunk.
pub const CHUNK_PRIMITIVES: usize = 1024;

/// What the geometry stage made of a range of primitives. Reused from frame to frame.
#[derive(Default)]
#[expect(missing_docs, reason = "named after what they hold")]
pub struct Chunk {
    pub draw: u32,
    pub triangles: Vec<ScreenTriangle>,
    /// Coverage of micro-triangles: per triangle one mask per sample.
    pub masks: Vec<u16>,
    pub clipped: Vec<ClippedCorners>,
    /// Triangles by tile; see [`Segment`].
    pub entries: Vec<u32>,
    pub segments: Vec<Segment>,
    pub statistics: GeometryStatistics,
}

/// What became of a draw's primitives. Sums over chunks do not depend on threads.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug)]
pub struct GeometryStatistics {
    /// Primitives submitted.
    pub submitted: u64,
    /// Dropped because a corner is not a finite number or cannot be projected.
    pub dropped: u64,
    /// Outside the view.
    pub outside: u64,
    /// Culled for the side they show.
    pub culled: u64,
    /// Without area, or covering no sample.
    pub empty: u64,
    /// Cut by the near plane or the guard band.
    pub clipped: u64,
    /// Triangles sent to the rasterizer (a clipped primitive may send several).
    pub drawn: u64,
}

impl core::ops::AddAssign for GeometryStatistics {
    fn add_assign(&mut self, o: Self) {
        self.submitted += o.submitted;
        self.dropped += o.dropped;
        self.outside += o.outside;
        self.culled += o.culled;
        self.empty += o.empty;
        self.clipped += o.clipped;
        self.drawn += o.drawn;
    }
}

/// What to work on.
#[derive(Clone, Copy)]
#[expect(missing_docs, reason = "named after what they hold")]
pub struct ChunkInput<'a> {
    pub primitives: Primitives<'a>,
    pub first: usize,
    pub count: usize,
    pub cull: Cull,
    pub viewport: Viewport,
    pub samples: SamplePattern,
}

/// Working memory of one thread.
#[derive(Default)]
pub struct ChunkScratch {
    numbering: VertexNumbering,
    clip: ClipPositions,
    screen: ScreenVertices,
    binner: Binner,
}

impl ChunkScratch {
    /// First step: numbers the chunk's vertices. Returns them, and the place for their clip positions.
    pub fn assemble(&mut self, input: &ChunkInput<'_>) -> (&[u32], &mut ClipPositions) {
        self.numbering.run(&input.primitives, input.first, input.count);
        self.clip.resize(self.numbering.unique.len());
        (&self.numbering.unique, &mut self.clip)
    }
}

/// Second step: with the clip positions in `scratch`, makes the chunk.
#[inline(always)]
pub fn process_chunk<L: Lanes>(l: L, input: &ChunkInput<'_>, scratch: &mut ChunkScratch, out: &mut Chunk) {
    out.triangles.clear();
    out.masks.clear();
    out.clipped.clear();
    out.statistics = GeometryStatistics { submitted: input.count as u64, ..Default::default() };
    project_all(l, &scratch.clip, input.viewport, &mut scratch.screen);
    let mut emitter = Emitter {
        input,
        grid: TileGrid::new(input.viewport.width),
        extent: [input.samples.extent(0), input.samples.extent(1)],
        half: input.viewport.half_subpixels(),
        clip: &scratch.clip,
        screen: &scratch.screen,
        corners: &scratch.numbering.corners,
        vertices: &scratch.numbering.unique,
        binner: &mut scratch.binner,
        out,
    };
    match input.primitives {
        Primitives::Triangles(_) => emitter.triangles(l),
        Primitives::Lines { width_px, .. } => emitter.lines(width_px),
        Primitives::Points { size_px, .. } => emitter.points(size_px),
    }
    out.statistics.drawn = out.triangles.len() as u64;
    scratch.binner.sort_into(&mut out.entries, &mut out.segments);
}

struct Emitter<'a> {
    input: &'a ChunkInput<'a>,
    grid: TileGrid,
    extent: [(i32, i32); 2],
    half: [f32; 2],
    clip: &'a ClipPositions,
    screen: &'a ScreenVertices,
    corners: &'a [[u32; 3]],
    vertices: &'a [u32],
    binner: &'a mut Binner,
    out: &'a mut Chunk,
}

/// What happens to a triangle, decided for sixteen at once.
struct LaneDecisions {
    dropped: u16,
    outside: u16,
    clipped: u16,
    micro: u16,
    small: u16,
    culled: u16,
    empty: u16,
}

impl Emitter<'_> {
    #[inline(always)]
    fn triangles<L: Lanes>(&mut self, l: L) {
        let mut masks = [0u16; LANES * 16];
        for group in 0..self.corners.len().div_ceil(LANES) {
            let at = group * LANES;
            let count = (self.corners.len() - at).min(LANES);
            self.triangle_group(l, at, count, &mut masks);
        }
    }

    #[inline(always)]
    fn triangle_group<L: Lanes>(&mut self, l: L, at: usize, count: usize, masks: &mut [u16; LANES * 16]) {
        let (corners, codes) = self.fetch(l, at, count);
        let setup = LaneSetup::new(l, corners);
        let boxes = LaneBoxes::new(l, &setup.corners, self.extent);
        let decisions = self.decide(l, &setup, &boxes, codes, masks);
        let records = Records::new(&setup, &boxes);
        for lane in 0..count {
            self.emit_lane(&decisions, &records, masks, lane, at + lane);
        }
    }

    /// Corners of sixteen triangles; missing ones repeat the last.
    #[inline(always)]
    fn fetch<L: Lanes>(&self, l: L, at: usize, count: usize) -> (Corners<L>, [U32<L>; 3]) {
        let mut numbers = [[0u32; LANES]; 3];
        for lane in 0..LANES {
            let corners = self.corners[at + lane.min(count - 1)];
            for k in 0..3 {
                numbers[k][lane] = corners[k];
            }
        }
        let screen = self.screen;
        let n = [l.u32_array(&numbers[0]), l.u32_array(&numbers[1]), l.u32_array(&numbers[2])];
        let corners = Corners {
            x: [n[0].gather_i32(&screen.x), n[1].gather_i32(&screen.x), n[2].gather_i32(&screen.x)],
            y: [n[0].gather_i32(&screen.y), n[1].gather_i32(&screen.y), n[2].gather_i32(&screen.y)],
            depth: [n[0].gather_f32(&screen.depth), n[1].gather_f32(&screen.depth), n[2].gather_f32(&screen.depth)],
            inv_w: [n[0].gather_f32(&screen.inv_w), n[1].gather_f32(&screen.inv_w), n[2].gather_f32(&screen.inv_w)],
            vertex: [l.u32(0), l.u32(1), l.u32(2)],
        };
        (corners, [n[0].gather_u32(&screen.code), n[1].gather_u32(&screen.code), n[2].gather_u32(&screen.code)])
    }

    #[inline(always)]
    fn decide<L: Lanes>(
        &self,
        l: L,
        setup: &LaneSetup<L>,
        boxes: &LaneBoxes<L>,
        codes: [U32<L>; 3],
        masks: &mut [u16; LANES * 16],
    ) -> LaneDecisions {
        let any = codes[0] | codes[1] | codes[2];
        let all = codes[0] & codes[1] & codes[2];
        let dropped = has_any(any, code::BROKEN);
        let outside = has_any(all, code::LEFT | code::RIGHT | code::BELOW | code::ABOVE | code::NEAR | code::FAR);
        let clipped = has_any(any, code::CLIP);
        let culled = match self.input.cull {
            Cull::None => l.mask(false),
            Cull::Back => !setup.front,
            Cull::Front => setup.front,
        };
        let ready = !(dropped | outside | clipped | culled);
        let mut empty = boxes.is_empty(l) | (setup.is_small & !setup.has_area);
        let micro = ready & setup.is_small & boxes.is_micro(l) & !empty;
        let mut micro_bits = micro.bits();
        if micro_bits != 0 {
            let covering =
                micro::cover(l, &setup.corners, boxes, micro, self.input.samples.positions(), &mut masks[..]);
            empty |= l.mask_from_bits(micro_bits & !covering);
            micro_bits &= covering;
        }
        LaneDecisions {
            dropped: dropped.bits(),
            outside: outside.bits(),
            clipped: clipped.bits(),
            micro: micro_bits,
            small: setup.is_small.bits(),
            culled: culled.bits(),
            empty: empty.bits(),
        }
    }

    #[inline(always)]
    fn emit_lane(
        &mut self,
        decisions: &LaneDecisions,
        records: &Records,
        masks: &[u16; LANES * 16],
        lane: usize,
        primitive: usize,
    ) {
        let has = |bits: u16| bits >> lane & 1 == 1;
        if has(decisions.dropped) {
            self.out.statistics.dropped += 1;
        } else if has(decisions.outside) {
            self.out.statistics.outside += 1;
        } else if has(decisions.clipped) {
            self.clip_and_emit(primitive);
        } else if !has(decisions.small) {
            self.emit_large(primitive);
        } else if has(decisions.empty) {
            self.out.statistics.empty += 1;
        } else if has(decisions.culled) {
            self.out.statistics.culled += 1;
        } else {
            let mut triangle = records.triangle(lane);
            triangle.primitive = self.primitive_number(primitive);
            if has(decisions.micro) {
                let n = self.input.samples.count();
                triangle.tags.0 |= Tags::MICRO;
                triangle.side = self.out.masks.len() as u32;
                self.out.masks.extend_from_slice(&masks[lane * n..(lane + 1) * n]);
            }
            self.push(triangle, records.pixel_box(lane));
        }
    }

    fn primitive_number(&self, in_chunk: usize) -> u32 {
        (self.input.first + in_chunk) as u32
    }

    #[inline(always)]
    fn push(&mut self, triangle: ScreenTriangle, bounds: PixelBox) {
        let viewport = self.input.viewport;
        let Some(inside) = bounds.clip(viewport.width as i32, viewport.height as i32) else {
            if triangle.tags.has(Tags::MICRO) {
                self.out.masks.truncate(triangle.side as usize);
            }
            self.out.statistics.outside += 1;
            return;
        };
        self.binner.push(self.grid, self.out.triangles.len() as u32, &triangle, inside);
        self.out.triangles.push(triangle);
    }

    fn screen_vertex(&self, number: u32) -> ScreenVertex {
        let (s, i) = (self.screen, number as usize);
        ScreenVertex { x: s.x[i], y: s.y[i], depth: s.depth[i], inv_w: s.inv_w[i] }
    }

    /// A triangle too large for the lanes' 32-bit area.
    fn emit_large(&mut self, primitive: usize) {
        let corners = self.corners[primitive].map(|n| self.screen_vertex(n));
        let Some((mut triangle, order)) = setup_one(corners) else {
            self.out.statistics.empty += 1;
            return;
        };
        if self.input.cull.drops(triangle.tags.has(Tags::FRONT)) {
            self.out.statistics.culled += 1;
            return;
        }
        triangle.tags.0 |= Tags::corners(order.map(|k| k as u32));
        triangle.primitive = self.primitive_number(primitive);
        self.push(triangle, triangle.pixel_box(self.extent));
    }

    /// A triangle that crosses the near plane or leaves the guard band.
    fn clip_and_emit(&mut self, primitive: usize) {
        let numbers = self.corners[primitive];
        // The smallest vertex number first, so that a rotated triangle is cut alike.
        let first = (0..3).min_by_key(|&k| self.vertices[numbers[k] as usize]).unwrap_or(0);
        let order = [first, (first + 1) % 3, (first + 2) % 3];
        let positions = order.map(|k| self.clip.vertex(numbers[k] as usize));
        let polygon = clip_triangle(positions, &ClipPlanes::new(self.input.viewport, 0.0));
        let corners = polygon.corners();
        if corners.len() < 3 {
            self.out.statistics.outside += 1;
            return;
        }
        self.out.statistics.clipped += 1;
        let vertices = order.map(|k| k as u32);
        for i in 1..corners.len() - 1 {
            self.emit_piece([corners[0], corners[i], corners[i + 1]], vertices, primitive, self.input.cull);
        }
    }

    /// One triangle whose corners are not vertices. `vertices[k]` is the vertex that weight `k` belongs to.
    fn emit_piece(&mut self, corners: [ClipVertex; 3], vertices: [u32; 3], primitive: usize, cull: Cull) {
        let projected = corners.map(|c| project_one(c.position.map(|v| v as f32), self.half));
        let [Some(a), Some(b), Some(c)] = projected else {
            self.out.statistics.dropped += 1;
            return;
        };
        let weights = corners.map(|c| c.weights.map(|w| w as f32));
        self.emit_weighted([a, b, c], weights, vertices, primitive, cull);
    }

    fn emit_weighted(
        &mut self,
        corners: [ScreenVertex; 3],
        weights: [[f32; 2]; 3],
        vertices: [u32; 3],
        primitive: usize,
        cull: Cull,
    ) {
        let Some((mut triangle, order)) = setup_one(corners) else { return };
        if cull.drops(triangle.tags.has(Tags::FRONT)) {
            return;
        }
        triangle.tags.0 |= Tags::CLIPPED | Tags::corners(vertices);
        triangle.side = self.out.clipped.len() as u32;
        triangle.primitive = self.primitive_number(primitive);
        self.out.clipped.push(ClippedCorners(order.map(|k| weights[k])));
        self.push(triangle, triangle.pixel_box(self.extent));
    }

    fn lines(&mut self, width_px: f32) {
        let planes = ClipPlanes::new(self.input.viewport, f64::from(MAX_STROKE));
        for primitive in 0..self.corners.len() {
            let [a, b, _] = self.corners[primitive].map(|n| n as usize);
            if (self.screen.code[a] | self.screen.code[b]) & code::BROKEN != 0 {
                self.out.statistics.dropped += 1;
                continue;
            }
            let Some(ends) = clip_segment([self.clip.vertex(a), self.clip.vertex(b)], &planes) else {
                self.out.statistics.outside += 1;
                continue;
            };
            let projected = ends.map(|e| project_one(e.position.map(|v| v as f32), self.half));
            let [Some(pa), Some(pb)] = projected else {
                self.out.statistics.dropped += 1;
                continue;
            };
            let weights = ends.map(|e| [e.weights[0] as f32, 0.0]);
            let corner_weights = [weights[0], weights[1], weights[1], weights[0]];
            self.rectangle(line_corners(pa, pb, width_px), corner_weights, primitive);
        }
    }

    fn points(&mut self, size_px: f32) {
        for primitive in 0..self.corners.len() {
            let number = self.corners[primitive][0];
            let code = self.screen.code[number as usize];
            if code & code::BROKEN != 0 {
                self.out.statistics.dropped += 1;
            } else if code & (code::CLIP | code::NEAR | code::FAR) != 0 {
                self.out.statistics.outside += 1;
            } else {
                self.rectangle(point_corners(self.screen_vertex(number), size_px), [[0.0; 2]; 4], primitive);
            }
        }
    }

    fn rectangle(&mut self, corners: [ScreenVertex; 4], weights: [[f32; 2]; 4], primitive: usize) {
        for piece in RECTANGLE {
            self.emit_weighted(piece.map(|k| corners[k]), piece.map(|k| weights[k]), [0, 1, 2], primitive, Cull::None);
        }
    }
}

/// Where one of the `flags` is set.
#[inline(always)]
fn has_any<L: Lanes>(bits: U32<L>, flags: u32) -> Mask<L> {
    let l = bits.token();
    !(bits & l.u32(flags)).eq(l.u32(0))
}

/// Sixteen set-up triangles, ready to be written out one by one.
struct Records {
    x: [[i32; LANES]; 3],
    y: [[i32; LANES]; 3],
    depth: [[f32; LANES]; 3],
    inv_w: [[f32; LANES]; 3],
    tags: [u32; LANES],
    first: [[i32; LANES]; 2],
    size: [[i32; LANES]; 2],
}

impl Records {
    #[inline(always)]
    fn new<L: Lanes>(setup: &LaneSetup<L>, boxes: &LaneBoxes<L>) -> Self {
        let c = &setup.corners;
        let l = c.x[0].token();
        let vertices = c.vertex[0] | (c.vertex[1] << 2) | (c.vertex[2] << 4);
        let tags = vertices | setup.front.select(l.u32(Tags::FRONT), l.u32(0));
        Self {
            x: [c.x[0].to_array(), c.x[1].to_array(), c.x[2].to_array()],
            y: [c.y[0].to_array(), c.y[1].to_array(), c.y[2].to_array()],
            depth: [setup.depth[0].to_array(), setup.depth[1].to_array(), setup.depth[2].to_array()],
            inv_w: [c.inv_w[0].to_array(), c.inv_w[1].to_array(), c.inv_w[2].to_array()],
            tags: tags.to_array(),
            first: [boxes.first[0].to_array(), boxes.first[1].to_array()],
            size: [boxes.size[0].to_array(), boxes.size[1].to_array()],
        }
    }

    #[inline(always)]
    fn triangle(&self, i: usize) -> ScreenTriangle {
        ScreenTriangle {
            x: [self.x[0][i], self.x[1][i], self.x[2][i]],
            y: [self.y[0][i], self.y[1][i], self.y[2][i]],
            depth: [self.depth[0][i], self.depth[1][i], self.depth[2][i]],
            inv_w: [self.inv_w[0][i], self.inv_w[1][i], self.inv_w[2][i]],
            primitive: 0,
            side: 0,
            tags: Tags(self.tags[i]),
        }
    }

    #[inline(always)]
    fn pixel_box(&self, i: usize) -> PixelBox {
        let [x0, y0] = [self.first[0][i], self.first[1][i]];
        PixelBox { x0, y0, x1: x0 + self.size[0][i] - 1, y1: y0 + self.size[1][i] - 1 }
    }
}
