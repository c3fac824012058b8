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

/// Shapes in a chunk.
const CHUNK: usize = 32;

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
}

/// What one thread makes chunks with.
struct Worker<'a> {
    /// For shapes of samples, and for those with crisp edges.
    builders: [EdgeBuilder<'a>; 2],
    strokes: StrokeMemory,
    /// The first and last band that each edge of a shape meets.
    bands: Vec<[u32; 2]>,
}

/// The edges of up to [`CHUNK`] shapes.
#[derive(Default)]
struct Chunk {
    edges: Vec<Edge>,
    /// Where the edges of each band of each shape end.
    ends: Vec<u32>,
    shapes: Vec<ShapeEdges>,
}

/// Where one shape's edges lie within its chunk.
struct ShapeEdges {
    bounds: Bounds,
    /// Of its first band's edges.
    first_edge: u32,
    /// Of its first band, in `ends`.
    first_end: u32,
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
        let mut chunks: Vec<Chunk> = Vec::new();
        chunks.resize_with(shapes.len().div_ceil(CHUNK), Chunk::default);
        let worker = |_| Worker {
            builders: [samples, SampleRows::centers()].map(|samples| EdgeBuilder::new(samples, size)),
            strokes: StrokeMemory::default(),
            bands: Vec::new(),
        };
        let mut workers: Vec<Worker<'_>> = (0..renderer.threads.clamp(1, chunks.len().max(1))).map(worker).collect();
        let work = chunks.iter_mut().zip(shapes.chunks(CHUNK));
        trigon::schedule::share(&mut workers, work, |worker, (chunk, shapes): (&mut Chunk, &[Outlined<'_>])| {
            for shape in shapes {
                let builder = &mut worker.builders[usize::from(shape.is_crisp)];
                builder.clear();
                // After the deadline shapes are empty; nobody sees them.
                if !renderer.deadline.is_over() {
                    build(shape, &mut worker.strokes, builder);
                }
                chunk.add(builder, shape.is_crisp, &mut worker.bands);
            }
        });
        Self { chunks }
    }

    /// The shape with this number, in the order given.
    pub(crate) fn shape(&self, number: usize) -> ShapeRef<'_> {
        let chunk = &self.chunks[number / CHUNK];
        ShapeRef { chunk, shape: &chunk.shapes[number % CHUNK] }
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
        let index =
            if self.shape.is_sorted { self.shape.first_end + (band - bands.start) } else { self.shape.first_end };
        let start =
            if index == self.shape.first_end { self.shape.first_edge } else { self.chunk.ends[index as usize - 1] };
        &self.chunk.edges[start as usize..self.chunk.ends[index as usize] as usize]
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

impl Chunk {
    /// Takes over the shape that a builder holds.
    fn add(&mut self, builder: &EdgeBuilder<'_>, is_crisp: bool, met: &mut Vec<[u32; 2]>) {
        let edges = builder.edges();
        let bounds = Bounds { columns: builder.columns(), rows: builder.rows() };
        let (first_edge, first_end) = (self.edges.len() as u32, self.ends.len() as u32);
        let is_sorted = self.sort(edges, builder.rows_per_band(), bands(&bounds), met);
        if !is_sorted {
            self.edges.extend_from_slice(edges);
            self.ends.push(self.edges.len() as u32);
        }
        self.shapes.push(ShapeEdges { bounds, first_edge, first_end, is_sorted, is_crisp });
    }

    /// Copies each edge into each band that it meets, in order. Gives up, with nothing changed, if there would be far
    /// more copies than edges.
    fn sort(&mut self, edges: &[Edge], rows_per_band: u32, bands: Range<u32>, met: &mut Vec<[u32; 2]>) -> bool {
        if bands.len() <= 1 {
            self.edges.extend_from_slice(edges);
            self.ends.push(self.edges.len() as u32);
            return true;
        }
        met.clear();
        met.extend(edges.iter().map(|edge| {
            [edge.first as u32 / rows_per_band - bands.start, (edge.end as u32 - 1) / rows_per_band - bands.start]
        }));
        let first_end = self.ends.len();
        self.ends.resize(first_end + bands.len(), 0);
        let ends = &mut self.ends[first_end..];
        let mut copies = 0;
        for &[first, last] in met.iter() {
            for end in &mut ends[first as usize..=last as usize] {
                *end += 1;
            }
            copies += (last - first + 1) as usize;
        }
        if copies > 16 * edges.len() + 4096 {
            self.ends.truncate(first_end);
            return false;
        }
        // Counts become starts; each copy moves its band's start up, until it is the end.
        let mut next = self.edges.len() as u32;
        for end in ends.iter_mut() {
            next += core::mem::replace(end, next);
        }
        let Some(filler) = edges.first() else { return true };
        self.edges.resize(next as usize, *filler);
        for (edge, &[first, last]) in edges.iter().zip(met.iter()) {
            for end in &mut ends[first as usize..=last as usize] {
                self.edges[*end as usize] = *edge;
                *end += 1;
            }
        }
        true
    }
}
