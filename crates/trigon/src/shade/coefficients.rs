//! From visible triangles to interpolation coefficients.
//!
//! In: up to sixteen triangles of one draw and their vertices' varyings. Out: a record per triangle, its coefficients
//! side by side. Made once per tile for triangles that are visible there, and for no others. Sixteen fragments of any
//! triangles then turn their records into rows, one register per coefficient.
//!
//! With `L1 = b1/w`, `L2 = b2/w` and `W = 1/w` linear in the framebuffer (Blinn, "Hyperbolic Interpolation", 1992), a
//! fragment needs one division for `b1`, `b2`; every varying is then `a + (b1 * d1 + b2 * d2)`, and its derivatives
//! follow from those of `b1` and `b2`, exactly, without looking at neighbours.

use super::shader::{Fragment, Shader};
use super::varying::{CornerSink, FragmentSource, Varying};
use crate::geometry::{SUBPIXEL, ScreenTriangle};
use crate::lanes::{F32, LANES, Lanes, Quad, U32, Vec2, Vec3, columns, outline, store_records};

/// Rows that every shader has, before those of its varyings.
const ROW_CORNER: usize = 0;
const ROW_L1: usize = 2;
const ROW_L2: usize = 5;
const ROW_W: usize = 8;
const ROW_DEPTH: usize = 11;
const ROW_TAGS: usize = 14;
const ROW_PRIMITIVE: usize = 15;
const ROW_VARYINGS: usize = 16;

/// Rows per varying component: the value at corner 0, and the differences to it at corners 1 and 2.
const ROWS_PER_COMPONENT: usize = 3;

/// Numbers of one triangle, in quads: the length of a record.
#[inline(always)]
pub(crate) fn record_quads(components: usize) -> usize {
    (ROW_VARYINGS + ROWS_PER_COMPONENT * components).div_ceil(4)
}

/// Most rows of any shader.
const MAX_ROWS: usize = ROW_VARYINGS + ROWS_PER_COMPONENT * MAX_COMPONENTS;

/// One row per coefficient, lane by lane.
pub type Rows = [[f32; LANES]; MAX_ROWS];

/// How attributes vary over a triangle between its corners.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Interpolation {
    /// Linearly over the surface, so that they look right in perspective.
    #[default]
    Perspective,
    /// Linearly over the picture, as if all corners were equally far away: what early hardware and first programs do.
    /// Triangles that reach far into the picture look bent along their edges.
    Affine,
}

/// Up to sixteen triangles of one draw.
pub struct TriangleGroup {
    /// Missing ones repeat the last.
    pub(crate) triangles: [ScreenTriangle; LANES],
    /// The vertices that the weights belong to.
    pub(crate) vertices: [[u32; LANES]; 3],
    /// Weights of vertices 1 and 2 at the corners: `[corner][vertex - 1]`.
    pub(crate) weights: [[[f32; LANES]; 2]; 3],
}

impl TriangleGroup {
    /// Weights where corner k is vertex k.
    pub(crate) const UNCLIPPED: [[f32; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    /// Rows before any were made.
    pub(crate) const NO_ROWS: Rows = [[0.0; LANES]; MAX_ROWS];

    /// Puts a triangle in a lane. Affine interpolation is that of a triangle whose corners have the same w.
    #[inline(always)]
    pub(crate) fn set_triangle(&mut self, lane: usize, triangle: &ScreenTriangle, interpolation: Interpolation) {
        self.triangles[lane] = *triangle;
        if interpolation == Interpolation::Affine {
            self.triangles[lane].inv_w = [1.0; 3];
        }
    }
}

impl Default for TriangleGroup {
    fn default() -> Self {
        Self {
            triangles: [ScreenTriangle::default(); LANES],
            vertices: [[0; LANES]; 3],
            weights: [[[0.0; LANES]; 2]; 3],
        }
    }
}

/// Fills the rows of a shader's sixteen triangles.
#[inline(always)]
pub(crate) fn compute<L: Lanes, S: Shader>(l: L, shader: &S, group: &TriangleGroup, rows: &mut Rows) {
    planes(l, group, rows);
    let corners = [
        shader.vertex(l, l.u32_array(&group.vertices[0])).varying,
        shader.vertex(l, l.u32_array(&group.vertices[1])).varying,
        shader.vertex(l, l.u32_array(&group.vertices[2])).varying,
    ];
    Varying::write(corners, &mut RowSink { rows, next: ROW_VARYINGS });
}

/// Turns the first rows into sixteen records of `quads` quads, one after the other.
#[inline(always)]
pub(crate) fn store_rows<L: Lanes>(l: L, rows: &Rows, records: &mut [Quad], quads: usize) {
    for (q, four) in rows.as_chunks::<4>().0.iter().take(quads).enumerate() {
        let columns = [l.f32_array(&four[0]), l.f32_array(&four[1]), l.f32_array(&four[2]), l.f32_array(&four[3])];
        store_records(l, columns, &mut records[q..], quads);
    }
}

/// The rows before the varyings.
#[inline(always)]
fn planes<L: Lanes>(l: L, group: &TriangleGroup, rows: &mut Rows) {
    let mut c = CornerArrays::default();
    for (lane, t) in group.triangles.iter().enumerate() {
        c.set(lane, t);
        rows[ROW_TAGS][lane] = f32::from_bits(t.tags.0);
        rows[ROW_PRIMITIVE][lane] = f32::from_bits(t.primitive);
        for i in 0..3 {
            rows[ROW_DEPTH + i][lane] = t.depth[i];
        }
    }
    let to_pixels = 1.0 / SUBPIXEL as f32;
    let (x0, y0) = (l.f32_array(&c.x[0]), l.f32_array(&c.y[0]));
    let (dx1, dy1) = (l.f32_array(&c.x[1]) - x0, l.f32_array(&c.y[1]) - y0);
    let (dx2, dy2) = (l.f32_array(&c.x[2]) - x0, l.f32_array(&c.y[2]) - y0);
    (x0 * to_pixels).store(&mut rows[ROW_CORNER]);
    (y0 * to_pixels).store(&mut rows[ROW_CORNER + 1]);
    let solve = PlaneSolver { dx1, dy1, dx2, dy2, scale: SUBPIXEL as f32 / l.f32_array(&c.area) };
    let w = [l.f32_array(&c.inv_w[0]), l.f32_array(&c.inv_w[1]), l.f32_array(&c.inv_w[2])];
    solve.store(w, &mut rows[ROW_W..]);
    for (v, row) in [ROW_L1, ROW_L2].into_iter().enumerate() {
        let mut values = w;
        for k in 0..3 {
            values[k] = w[k] * l.f32_array(&group.weights[k][v]);
        }
        solve.store(values, &mut rows[row..]);
    }
}

/// Corners of sixteen triangles by component; coordinates in 1/256 px, which are exact in `f32`.
#[derive(Default)]
struct CornerArrays {
    x: [[f32; LANES]; 3],
    y: [[f32; LANES]; 3],
    inv_w: [[f32; LANES]; 3],
    area: [f32; LANES],
}

impl CornerArrays {
    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "coordinates have at most 23 bits; the area is rounded once")]
    fn set(&mut self, lane: usize, t: &ScreenTriangle) {
        for k in 0..3 {
            self.x[k][lane] = t.x[k] as f32;
            self.y[k][lane] = t.y[k] as f32;
            self.inv_w[k][lane] = t.inv_w[k];
        }
        let (dx1, dy1) = (i64::from(t.x[1] - t.x[0]), i64::from(t.y[1] - t.y[0]));
        let (dx2, dy2) = (i64::from(t.x[2] - t.x[0]), i64::from(t.y[2] - t.y[0]));
        self.area[lane] = (dx1 * dy2 - dx2 * dy1) as f32;
    }
}

/// Finds the plane through three values at the corners.
struct PlaneSolver<L: Lanes> {
    dx1: F32<L>,
    dy1: F32<L>,
    dx2: F32<L>,
    dy2: F32<L>,
    /// 256 / area: from per subpixel to per pixel.
    scale: F32<L>,
}

impl<L: Lanes> PlaneSolver<L> {
    #[inline(always)]
    fn store(&self, values: [F32<L>; 3], rows: &mut [[f32; LANES]]) {
        let (d1, d2) = (values[1] - values[0], values[2] - values[0]);
        values[0].store(&mut rows[0]);
        ((d1 * self.dy2 - d2 * self.dy1) * self.scale).store(&mut rows[1]);
        ((d2 * self.dx1 - d1 * self.dx2) * self.scale).store(&mut rows[2]);
    }
}

struct RowSink<'a> {
    rows: &'a mut [[f32; LANES]],
    next: usize,
}

impl<L: Lanes> CornerSink<L> for RowSink<'_> {
    #[inline(always)]
    fn push(&mut self, [a, b, c]: [F32<L>; 3]) {
        a.store(&mut self.rows[self.next]);
        (b - a).store(&mut self.rows[self.next + 1]);
        (c - a).store(&mut self.rows[self.next + 2]);
        self.next += ROWS_PER_COMPONENT;
    }
}

/// Most varying components of a shader.
pub(crate) const MAX_COMPONENTS: usize = 32;

/// The rows of sixteen fragments, each lane from its own triangle.
///
/// Fragments of one triangle and of many then read alike, and the shader is compiled once for both.
pub struct FragmentRows {
    rows: Rows,
    /// The one triangle that every lane shows, if it is one.
    single: Option<u32>,
}

impl Default for FragmentRows {
    fn default() -> Self {
        Self { rows: [[0.0; LANES]; MAX_ROWS], single: None }
    }
}

impl FragmentRows {
    /// Forgets which triangle was fetched: slots now mean other triangles.
    pub(crate) fn forget(&mut self) {
        self.single = None;
    }

    /// Fetches the records of sixteen fragments. A slot is the number of a record's first quad in `records`.
    ///
    /// Never inlined: it is the same for all shaders.
    #[inline(never)]
    pub(crate) fn fetch<L: Lanes>(&mut self, l: L, records: &[Quad], slots: &[u32; LANES], quads: usize) {
        let first = slots[0];
        let is_single = slots.iter().fold(0, |differ, slot| differ | (slot ^ first)) == 0; // tidy: allow(lane-closure): integers of one lane
        if is_single && self.single == Some(first) {
            return;
        }
        self.single = is_single.then_some(first);
        if is_single {
            outline!(l => self.spread(l, &records[first as usize..first as usize + quads]));
        } else {
            outline!(l => self.transpose(l, records, slots, quads));
        }
    }

    /// One record in every lane.
    #[inline(always)]
    fn spread<L: Lanes>(&mut self, l: L, record: &[Quad]) {
        for (to, from) in self.rows.iter_mut().zip(record.as_flattened()) {
            l.f32(*from).store(to);
        }
    }

    /// A record per lane.
    #[inline(always)]
    fn transpose<L: Lanes>(&mut self, l: L, records: &[Quad], slots: &[u32; LANES], quads: usize) {
        let mut starts: [&[Quad]; LANES] = [&[]; LANES];
        for (start, slot) in starts.iter_mut().zip(slots) {
            *start = &records[*slot as usize..*slot as usize + quads];
        }
        for (q, four) in self.rows.as_chunks_mut::<4>().0.iter_mut().take(quads).enumerate() {
            let mut quad = [&[0.0; 4]; LANES];
            for (quad, start) in quad.iter_mut().zip(starts) {
                *quad = &start[q];
            }
            for (row, column) in four.iter_mut().zip(columns(l, &quad)) {
                column.store(row);
            }
        }
    }

    /// Row `row`, lane by lane.
    #[inline(always)]
    fn row<L: Lanes>(&self, l: L, row: usize) -> F32<L> {
        l.f32_array(&self.rows[row])
    }
}

/// Interpolates sixteen fragments at framebuffer positions `pixel`.
#[inline(always)]
pub(crate) fn interpolate<L: Lanes, V: Varying<L>>(l: L, reader: &FragmentRows, pixel: Vec2<L>) -> Fragment<L, V> {
    let fx = pixel.x - reader.row(l, ROW_CORNER);
    let fy = pixel.y - reader.row(l, ROW_CORNER + 1);
    let (l1, l2, w) = (Plane::read(l, reader, ROW_L1), Plane::read(l, reader, ROW_L2), Plane::read(l, reader, ROW_W));
    let depth = Plane::read(l, reader, ROW_DEPTH);
    let inv = 1.0 / w.at(fx, fy);
    let (b1, b2) = (l1.at(fx, fy) * inv, l2.at(fx, fy) * inv);
    let mut source = Interpolator {
        l,
        reader,
        next: ROW_VARYINGS,
        b: [b1, b2],
        dx: [(l1.x - b1 * w.x) * inv, (l2.x - b2 * w.x) * inv],
        dy: [(l1.y - b1 * w.y) * inv, (l2.y - b2 * w.y) * inv],
    };
    let [varying, dx, dy] = V::read(&mut source);
    let tags = reader.row(l, ROW_TAGS).to_bits();
    Fragment {
        varying,
        dx,
        dy,
        barycentric: by_vertex(l, tags, [(1.0 - b1) - b2, b1, b2]),
        pixel,
        depth: depth.at(fx, fy),
        front_facing: !(tags & l.u32(crate::geometry::Tags::FRONT)).eq(l.u32(0)),
        primitive: reader.row(l, ROW_PRIMITIVE).to_bits(),
    }
}

/// 1/w of sixteen fragments, as [`interpolate`] divides by it.
#[inline(always)]
pub(crate) fn inverse_w<L: Lanes>(l: L, reader: &FragmentRows, pixel: Vec2<L>) -> F32<L> {
    let fx = pixel.x - reader.row(l, ROW_CORNER);
    let fy = pixel.y - reader.row(l, ROW_CORNER + 1);
    Plane::read(l, reader, ROW_W).at(fx, fy)
}

/// Weights of the corners, put in the order in which the primitive's vertices were submitted.
#[inline(always)]
fn by_vertex<L: Lanes>(l: L, tags: U32<L>, b: [F32<L>; 3]) -> Vec3<L> {
    let three = l.u32(3);
    let (v1, v2) = ((tags >> 2) & three, (tags >> 4) & three);
    let mut out = [b[0]; 3];
    for (v, out) in out.iter_mut().enumerate() {
        let v = l.u32(v as u32);
        *out = v1.eq(v).select(b[1], v2.eq(v).select(b[2], b[0]));
    }
    Vec3 { x: out[0], y: out[1], z: out[2] }
}

#[derive(Clone, Copy)]
struct Plane<L: Lanes> {
    value: F32<L>,
    x: F32<L>,
    y: F32<L>,
}

impl<L: Lanes> Plane<L> {
    #[inline(always)]
    fn read(l: L, reader: &FragmentRows, row: usize) -> Self {
        Self { value: reader.row(l, row), x: reader.row(l, row + 1), y: reader.row(l, row + 2) }
    }

    #[inline(always)]
    fn at(self, fx: F32<L>, fy: F32<L>) -> F32<L> {
        self.value + (fx * self.x + fy * self.y)
    }
}

struct Interpolator<'a, L: Lanes> {
    l: L,
    reader: &'a FragmentRows,
    next: usize,
    b: [F32<L>; 2],
    dx: [F32<L>; 2],
    dy: [F32<L>; 2],
}

impl<L: Lanes> FragmentSource<L> for Interpolator<'_, L> {
    #[inline(always)]
    fn next(&mut self) -> [F32<L>; 3] {
        let a = self.reader.row(self.l, self.next);
        let d1 = self.reader.row(self.l, self.next + 1);
        let d2 = self.reader.row(self.l, self.next + 2);
        self.next += ROWS_PER_COMPONENT;
        [a + (self.b[0] * d1 + self.b[1] * d2), self.dx[0] * d1 + self.dx[1] * d2, self.dy[0] * d1 + self.dy[1] * d2]
    }
}
