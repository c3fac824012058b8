//! From paths to edges sorted by band: the part of drawing that looks at each shape once, whole.
//!
//! In: outlines with their transforms ([`Outlined`]). Out: [`Geometry`]: for each, its bounds and, for each band of
//! [`BAND_ROWS`] pixel rows, the edges that meet it. Shapes are worked on in chunks, each by one thread.

use super::coverage::{BAND_ROWS, Bounds};
use super::edge::{Edge, EdgeBuilder};
use super::flatten::{LineSink, TOLERANCE, flatten};
use super::samples::SampleRows;
use super::stroke::{self, Hairline, StrokeMemory};
use crate::canvas::{FillRule, Outline, Path, Renderer, Transform};
use std::ops::Range;
use trigon::schedule::Deadline;

/// Most shapes in a chunk.
const MAX_CHUNK: usize = 256;

/// A shape before it is flattened.
pub(crate) struct Outlined<'a> {
    pub(crate) path: &'a Path,
    pub(crate) outline: &'a Outline,
    /// Set if the outline is too thin a stroke to be drawn as it is.
    pub(crate) hairline: Option<Hairline>,
    /// Pixels from path space.
    pub(crate) transform: Transform,
    /// Tested at the centres of pixels alone.
    pub(crate) is_crisp: bool,
}

/// The edges of all shapes of a drawing.
pub(crate) struct Geometry {
    chunks: Vec<Chunk>,
    /// Shapes in a chunk, as a power of two.
    chunk_bits: u32,
}

/// What one thread makes chunks with.
struct Worker<'a> {
    /// For shapes of samples, and for those with crisp edges.
    builders: [EdgeBuilder<'a>; 2],
    strokes: StrokeMemory,
    /// Where the edges of each shape lie in its builder.
    built: Vec<Range<usize>>,
    /// By band: the number of edges in the chunk, then where the next shape's edges go.
    totals: Vec<u32>,
}

/// The edges of up to [`MAX_CHUNK`] shapes, those of a band side by side, shape by shape: bands are drawn one after the
/// other, and what is read in order is in the cache in time.
#[derive(Default)]
struct Chunk {
    edges: Vec<Edge>,
    /// For each band of each shape: where its edges begin and end.
    ranges: Vec<[u32; 2]>,
    shapes: Vec<ShapeEdges>,
}

/// Where one shape's edges lie within its chunk.
struct ShapeEdges {
    bounds: Bounds,
    /// Of its first band, in `ranges`.
    first_range: u32,
    /// False if each band has to look at all edges of the shape.
    is_sorted: bool,
    is_crisp: bool,
}

/// A shape by its number.
#[derive(Clone, Copy)]
pub(crate) struct ShapeRef<'a> {
    chunk: &'a Chunk,
    shape: &'a ShapeEdges,
}

impl Geometry {
    /// Flattens, snaps and sorts the shapes, for a picture of `size` pixels.
    pub(crate) fn new(shapes: &[Outlined<'_>], samples: &SampleRows, size: [u32; 2], renderer: &Renderer) -> Self {
        let threads = renderer.threads.max(1);
        // Some chunks for each thread, so that all end at about the same time.
        let chunk_len = (shapes.len() / (16 * threads)).clamp(1, MAX_CHUNK).next_power_of_two();
        let mut chunks: Vec<Chunk> = Vec::new();
        chunks.resize_with(shapes.len().div_ceil(chunk_len), Chunk::default);
        let worker = |_| Worker::new(samples, size);
        let mut workers: Vec<Worker<'_>> = (0..threads.min(chunks.len().max(1))).map(worker).collect();
        let work = chunks.iter_mut().zip(shapes.chunks(chunk_len));
        trigon::schedule::share(&mut workers, work, |worker, (chunk, shapes): (&mut Chunk, &[Outlined<'_>])| {
            worker.build(shapes, renderer.deadline, chunk);
        });
        Self { chunks, chunk_bits: chunk_len.trailing_zeros() }
    }

    /// The shape with this number, in the order given.
    pub(crate) fn shape(&self, number: usize) -> ShapeRef<'_> {
        let chunk = &self.chunks[number >> self.chunk_bits];
        ShapeRef { chunk, shape: &chunk.shapes[number & ((1 << self.chunk_bits) - 1)] }
    }
}

impl<'a> ShapeRef<'a> {
    /// The pixels that it may touch.
    pub(crate) fn bounds(self) -> Bounds {
        self.shape.bounds
    }

    /// True if its edges are those for samples at the centres of pixels.
    pub(crate) fn is_crisp(self) -> bool {
        self.shape.is_crisp
    }

    /// The edges that meet a band; where sorting was given up, some that do not.
    pub(crate) fn edges_in(self, band: u32) -> &'a [Edge] {
        let bands = bands(&self.shape.bounds);
        if !bands.contains(&band) {
            return &[];
        }
        let band = if self.shape.is_sorted { band - bands.start } else { 0 };
        let [start, end] = self.chunk.ranges[(self.shape.first_range + band) as usize];
        &self.chunk.edges[start as usize..end as usize]
    }
}

/// The bands that hold a row of `bounds`.
pub(crate) fn bands(bounds: &Bounds) -> Range<u32> {
    if bounds.is_empty() { 0..0 } else { bounds.rows[0] / BAND_ROWS..bounds.rows[1].div_ceil(BAND_ROWS) }
}

/// The edges of one shape, into `builder`.
fn build(shape: &Outlined<'_>, strokes: &mut StrokeMemory, builder: &mut EdgeBuilder<'_>) {
    if !shape.transform.is_finite() {
        return;
    }
    match shape.outline {
        Outline::Fill(_) => flatten(shape.path, &shape.transform, TOLERANCE, builder),
        Outline::Stroke(style) => {
            stroke::stroke(shape.path, style, shape.hairline.as_ref(), &shape.transform, strokes, builder);
        }
    }
    builder.close();
}

impl Outline {
    /// The rule by which its edges are filled: a stroke covers what any of its parts covers.
    pub(crate) fn rule(&self) -> FillRule {
        if let Self::Fill(rule) = self { *rule } else { FillRule::NonZero }
    }
}

impl LineSink for EdgeBuilder<'_> {
    #[inline(always)]
    fn move_to(&mut self, point: [f64; 2]) {
        EdgeBuilder::move_to(self, point);
    }

    #[inline(always)]
    fn line_to(&mut self, point: [f64; 2]) {
        EdgeBuilder::line_to(self, point);
    }

    #[inline(always)]
    fn close(&mut self) {
        EdgeBuilder::close(self);
    }

    #[inline(always)]
    fn is_out_of_sight(&self, low: [f64; 2], high: [f64; 2]) -> bool {
        EdgeBuilder::is_out_of_sight(self, low, high)
    }
}

impl<'a> Worker<'a> {
    fn new(samples: &'a SampleRows, size: [u32; 2]) -> Self {
        Self {
            builders: [samples, SampleRows::centers()].map(|samples| EdgeBuilder::new(samples, size)),
            strokes: StrokeMemory::default(),
            built: Vec::new(),
            totals: vec![0; size[1].div_ceil(BAND_ROWS) as usize],
        }
    }

    /// Fills a chunk. After the deadline its shapes are empty; nobody sees them.
    fn build(&mut self, shapes: &[Outlined<'_>], deadline: Deadline, chunk: &mut Chunk) {
        self.builders.iter_mut().for_each(EdgeBuilder::clear);
        self.built.clear();
        for shape in shapes {
            let builder = &mut self.builders[usize::from(shape.is_crisp)];
            builder.begin_shape();
            if !deadline.is_over() {
                build(shape, &mut self.strokes, builder);
            }
            let bounds = Bounds { columns: builder.columns(), rows: builder.rows() };
            // Beside the picture nothing is drawn.
            let built = if bounds.is_empty() { 0..0 } else { builder.shape() };
            let first_range = chunk.ranges.len() as u32;
            let counter = BandCounter { rows: BandOfRow::new(builder.rows_per_band()), bands: bands(&bounds) };
            let is_sorted = counter.count(&builder.edges()[built.clone()], &mut chunk.ranges);
            self.built.push(built);
            chunk.shapes.push(ShapeEdges { bounds, first_range, is_sorted, is_crisp: shape.is_crisp });
        }
        self.place(chunk);
        self.copy(chunk);
    }

    /// Counts become places: band by band, and in a band shape by shape; unsorted shapes come last.
    fn place(&mut self, chunk: &mut Chunk) {
        self.totals.fill(0);
        for shape in chunk.shapes.iter().filter(|shape| shape.is_sorted) {
            for (total, range) in self.totals[usize_range(bands(&shape.bounds))].iter_mut().zip(chunk.ranges_of(shape))
            {
                *total += range[1];
            }
        }
        let mut end = 0;
        for total in &mut self.totals {
            end += core::mem::replace(total, end);
        }
        for index in 0..chunk.shapes.len() {
            let shape = &chunk.shapes[index];
            let (is_sorted, bands, first) =
                (shape.is_sorted, usize_range(bands(&shape.bounds)), shape.first_range as usize);
            if is_sorted {
                for (next, range) in self.totals[bands].iter_mut().zip(&mut chunk.ranges[first..]) {
                    let start = *next;
                    *next += range[1];
                    *range = [start, start];
                }
            } else {
                let start = end;
                end += chunk.ranges[first][1];
                chunk.ranges[first] = [start, start];
            }
        }
        if let Some(filler) = self.builders.iter().find_map(|builder| builder.edges().first()) {
            chunk.edges.resize(end as usize, *filler);
        }
    }

    /// Copies each edge to each of its places; the ends of ranges move up.
    fn copy(&mut self, chunk: &mut Chunk) {
        for (shape, built) in chunk.shapes.iter().zip(&self.built) {
            let builder = &self.builders[usize::from(shape.is_crisp)];
            let edges = &builder.edges()[built.clone()];
            let bands = bands(&shape.bounds);
            let first = shape.first_range as usize;
            if bands.len() == 1 || !shape.is_sorted {
                let range = &mut chunk.ranges[first];
                let start = range[0] as usize;
                range[1] += edges.len() as u32;
                chunk.edges[start..start + edges.len()].copy_from_slice(edges);
                continue;
            }
            let rows = BandOfRow::new(builder.rows_per_band());
            for edge in edges {
                let [from, to] = rows.bands_of(edge).map(|band| first + (band - bands.start) as usize);
                for range in &mut chunk.ranges[from..=to] {
                    chunk.edges[range[1] as usize] = *edge;
                    range[1] += 1;
                }
            }
        }
    }
}

impl Chunk {
    /// Those of a sorted shape, and of the shapes after it.
    fn ranges_of(&self, shape: &ShapeEdges) -> &[[u32; 2]] {
        &self.ranges[shape.first_range as usize..]
    }
}

/// Counts the edges of a shape by band.
struct BandCounter {
    rows: BandOfRow,
    bands: Range<u32>,
}

impl BandCounter {
    /// Adds a range for each band, its number of edges at its end. Where there would be far more copies than edges, adds
    /// one range for all and is false.
    fn count(&self, edges: &[Edge], ranges: &mut Vec<[u32; 2]>) -> bool {
        let first = ranges.len();
        if self.bands.len() == 1 {
            ranges.push([0, edges.len() as u32]);
            return true;
        }
        ranges.resize(first + self.bands.len(), [0, 0]);
        let mut copies = 0;
        for edge in edges {
            let [from, to] = self.rows.bands_of(edge).map(|band| first + (band - self.bands.start) as usize);
            for range in &mut ranges[from..=to] {
                range[1] += 1;
            }
            copies += to - from + 1;
        }
        if copies > 16 * edges.len() + 4096 {
            ranges.truncate(first);
            ranges.push([0, edges.len() as u32]);
            return false;
        }
        true
    }
}

/// Divides sample rows by those of a band: `row * reciprocal / 2^32`, exact for `row * rows_per_band < 2^32`.
#[derive(Clone, Copy)]
struct BandOfRow {
    reciprocal: u64,
}

impl BandOfRow {
    fn new(rows_per_band: u32) -> Self {
        Self { reciprocal: (1 << 32) / u64::from(rows_per_band) + 1 }
    }

    /// The first and the last band that an edge meets.
    #[inline(always)]
    fn bands_of(self, edge: &Edge) -> [u32; 2] {
        let [first, end] = edge.rows();
        [first, end - 1].map(|row| ((row as u64 * self.reciprocal) >> 32) as u32)
    }
}

fn usize_range(range: Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon::target::{MAX_SIZE, SamplePattern};

    #[test]
    fn rows_are_divided_exactly() {
        for rows in [1, 2, 3, 4, 8, 16] {
            let per_band = rows * BAND_ROWS;
            let division = BandOfRow::new(per_band);
            for row in 0..MAX_SIZE * rows {
                let band = ((u64::from(row) * division.reciprocal) >> 32) as u32;
                assert_eq!(band, row / per_band);
            }
        }
    }

    #[test]
    fn a_band_has_the_edges_that_meet_it() {
        let samples = SampleRows::new(SamplePattern::grid(16).unwrap());
        let path = Path::circle(100.0, 100.0, 77.0);
        let outline = Outline::Fill(FillRule::NonZero);
        let shape = |is_crisp| {
            let transform = Transform::IDENTITY;
            Outlined { path: &path, outline: &outline, hairline: None, transform, is_crisp }
        };
        let shapes: Vec<Outlined<'_>> = (0..700).map(|number| shape(number % 3 == 0)).collect();
        let geometry = Geometry::new(&shapes, &samples, [200, 200], &Renderer { threads: 2, ..Renderer::new() });
        for number in 0..shapes.len() {
            let shape = geometry.shape(number);
            assert_eq!(shape.is_crisp(), number % 3 == 0);
            let rows_per_band = if shape.is_crisp() { 16 } else { 64 };
            for band in 0..14 {
                let edges = shape.edges_in(band);
                let range = (band * rows_per_band) as i32..((band + 1) * rows_per_band) as i32;
                assert!(edges.iter().all(|edge| edge.rows()[0] < range.end && edge.rows()[1] > range.start));
                // A closed outline goes up as often as down through every row.
                let turn = |row: i32| -> i32 {
                    let met = edges.iter().filter(|edge| edge.rows()[0] <= row && row < edge.rows()[1]);
                    met.map(Edge::direction).sum()
                };
                assert!(range.clone().all(|row| turn(row) == 0));
                assert_eq!(edges.is_empty(), !(1..=11).contains(&band), "{band}");
            }
        }
    }
}
