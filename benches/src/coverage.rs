//! Coverage counts: triangles in pixel coordinates in, and how many of them cover each sample out.
//!
//! The counts come from the pipeline as everyone uses it: the primitive output, one value per sample. It shows one
//! triangle a sample, so the triangles are dealt into pictures in which no two bounding boxes share a pixel.

use core::fmt;
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::{Lanes, Mask, Rgba, U32, Vec4};
use trigon::pipeline::{Draw, Frame, FrameError, Outputs, Picture, Renderer};
use trigon::shade::{Fragment, Shader, Vertex};
use trigon::target::SamplePattern;

/// x and y of three corners, in pixels, y down.
pub type PixelTriangle = [[f32; 2]; 3];

/// Which of the rasterizer's two ways to write visibility is used. The counts are the same.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum CoveragePath {
    /// Depth and number only, small triangles sixteen at once.
    #[default]
    Opaque,
    /// One triangle after the other, each fragment asked whether it exists.
    Discarding,
}

/// Reads one triangle a line: six numbers, x and y by turns, separated by commas. Empty lines and lines that begin with
/// `#` are skipped.
///
/// # Errors
/// The number and text of a line that is no triangle.
pub fn parse_csv(text: &str) -> Result<Vec<PixelTriangle>, CsvError> {
    let mut triangles = Vec::new();
    for (line, text) in (1..).zip(text.lines()).filter(|(_, text)| !text.is_empty() && !text.starts_with('#')) {
        let numbers: Result<Vec<f32>, _> = text.split(',').map(|number| number.trim().parse()).collect();
        match numbers.as_deref() {
            Ok(&[x0, y0, x1, y1, x2, y2]) => triangles.push([[x0, y0], [x1, y1], [x2, y2]]),
            _ => return Err(CsvError { line, text: text.to_owned() }),
        }
    }
    Ok(triangles)
}

/// A line that is no triangle.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CsvError {
    /// From 1.
    pub line: usize,
    /// As it stands in the file.
    pub text: String,
}

impl fmt::Display for CsvError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: '{}' is not six numbers separated by commas", self.line, self.text)
    }
}

impl std::error::Error for CsvError {}

/// Counts the triangles that cover each sample: `[y][x][sample]`, byte c of a word is the number of triangles whose
/// index modulo 4 is c.
///
/// # Errors
/// The picture is too large.
pub fn count(
    renderer: &mut Renderer,
    triangles: &[PixelTriangle],
    size: [u32; 2],
    samples: SamplePattern,
    path: CoveragePath,
) -> Result<Vec<u32>, FrameError> {
    let mut frame = Frame::new(size[0], size[1]);
    frame.samples = samples;
    frame.outputs = Outputs { primitive: true, per_sample: true, ..Outputs::NONE };
    let mut picture = Picture::default();
    let mut counts = vec![0u32; size[0] as usize * size[1] as usize * samples.count()];
    for sheet in deal(triangles, size) {
        let positions = sheet.iter().flat_map(|&i| triangles[i]).map(|at| to_ndc(at, size)).collect();
        let shader = Silhouette { positions, path };
        let corners = u32::try_from(shader.positions.len()).unwrap_or(u32::MAX);
        let draw = Draw::new(&shader, Primitives::Triangles(Indices::Sequence(corners)));
        renderer.render(&frame, &[draw], &mut picture)?;
        let shown = picture.primitive.as_ref().map_or(&[][..], |plane| plane.values());
        add_counts(&mut counts, shown, &sheet, samples.count());
    }
    Ok(counts)
}

/// Adds what one picture shows, `[sample][y][x]`.
fn add_counts(counts: &mut [u32], shown: &[u32], sheet: &[usize], samples: usize) {
    for (s, plane) in shown.chunks_exact(shown.len() / samples).enumerate() {
        for (pixel, primitive) in plane.iter().enumerate() {
            if let Some(triangle) = sheet.get(*primitive as usize) {
                counts[pixel * samples + s] += 1 << (8 * (triangle % 4));
            }
        }
    }
}

/// NDC as the oracle has it: 2x/W - 1, rounded to `f32`. y is up there.
#[expect(clippy::cast_precision_loss, reason = "picture sizes are below 2^24")]
fn to_ndc([x, y]: [f32; 2], [width, height]: [u32; 2]) -> [f32; 2] {
    [2.0 * x / width as f32 - 1.0, 1.0 - 2.0 * y / height as f32]
}

/// Triangle numbers, sheet by sheet: the bounding boxes of a sheet share no pixel. Each triangle goes to the first
/// sheet that has room.
fn deal(triangles: &[PixelTriangle], size: [u32; 2]) -> Vec<Vec<usize>> {
    let mut sheets: Vec<(PixelSet, Vec<usize>)> = Vec::new();
    for (i, triangle) in triangles.iter().enumerate() {
        let Some(bounds) = PixelBounds::of(triangle, size) else { continue };
        let room = sheets.iter_mut().find(|(taken, _)| !taken.overlaps(&bounds));
        let (taken, sheet) = match room {
            Some(sheet) => sheet,
            None => {
                sheets.push((PixelSet::empty(size), Vec::new()));
                sheets.last_mut().expect("a sheet was just pushed")
            }
        };
        taken.insert(&bounds);
        sheet.push(i);
    }
    sheets.into_iter().map(|(_, sheet)| sheet).collect()
}

/// Columns and rows, the ends excluded.
struct PixelBounds {
    x: [u32; 2],
    y: [u32; 2],
}

impl PixelBounds {
    /// Every pixel that the triangle may touch: one more to each side than its corners say.
    fn of(triangle: &PixelTriangle, size: [u32; 2]) -> Option<Self> {
        let along = |axis: usize| {
            let values = triangle.map(|corner| corner[axis]);
            let low = values.iter().copied().fold(f32::INFINITY, f32::min);
            let high = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
            [pixel(low - 1.0, size[axis]), pixel(high + 2.0, size[axis])]
        };
        let (x, y) = (along(0), along(1));
        (x[0] < x[1] && y[0] < y[1]).then_some(Self { x, y })
    }
}

/// Rounded down and limited to 0..=`size`.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the picture")]
#[expect(clippy::cast_precision_loss, reason = "picture sizes are below 2^24")]
fn pixel(at: f32, size: u32) -> u32 {
    at.floor().clamp(0.0, size as f32) as u32
}

/// A set of pixels, one bit each.
struct PixelSet {
    words: Vec<u64>,
    words_per_row: usize,
}

impl PixelSet {
    fn empty(size: [u32; 2]) -> Self {
        let words_per_row = size[0].div_ceil(64) as usize;
        Self { words: vec![0; words_per_row * size[1] as usize], words_per_row }
    }

    fn overlaps(&self, bounds: &PixelBounds) -> bool {
        (bounds.y[0]..bounds.y[1]).any(|y| self.row(y, bounds).any(|(at, mask)| self.words[at] & mask != 0))
    }

    fn insert(&mut self, bounds: &PixelBounds) {
        for y in bounds.y[0]..bounds.y[1] {
            for (at, mask) in self.row(y, bounds) {
                self.words[at] |= mask;
            }
        }
    }

    /// The words of row `y` that the bounds touch, and the bits in each.
    fn row(&self, y: u32, bounds: &PixelBounds) -> impl Iterator<Item = (usize, u64)> + use<> {
        let first = y as usize * self.words_per_row;
        let [start, end] = bounds.x;
        (start / 64..end.div_ceil(64)).map(move |word| {
            let (from, to) = (start.max(word * 64) - word * 64, end.min(word * 64 + 64) - word * 64);
            (first + word as usize, (u64::MAX >> (64 - (to - from))) << from)
        })
    }
}

/// Triangles in NDC, at half depth, without colour.
struct Silhouette {
    positions: Vec<[f32; 2]>,
    path: CoveragePath,
}

impl Shader for Silhouette {
    type Varying<L: Lanes> = ();

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, ()> {
        let at = index.gather_vec2(&self.positions);
        Vertex { position: Vec4 { x: at.x, y: at.y, z: l.f32(0.5), w: l.f32(1.0) }, varying: () }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, _: &Fragment<L, ()>) -> Rgba<L> {
        l.vec3([1.0; 3]).rgba(1.0)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, _: &Fragment<L, ()>) -> Mask<L> {
        l.mask(true)
    }

    fn discards(&self) -> bool {
        self.path == CoveragePath::Discarding
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon::pipeline::RendererOptions;

    #[test]
    fn sheets_hold_every_triangle_once_without_overlap() {
        let at = |i: u8| (f32::from(i) * 7.3 % 60.0, f32::from(i) * 3.1 % 60.0);
        let triangles: Vec<PixelTriangle> =
            (0..50).map(at).map(|(x, y)| [[x, y], [x + 4.0, y + 1.0], [x, y + 9.0]]).collect();
        let sheets = deal(&triangles, [64, 64]);
        let mut all: Vec<_> = sheets.concat();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..50));
        for sheet in &sheets {
            let mut taken = PixelSet::empty([64, 64]);
            for i in sheet {
                let bounds = PixelBounds::of(&triangles[*i], [64, 64]).unwrap();
                assert!(!taken.overlaps(&bounds));
                taken.insert(&bounds);
                assert!(taken.overlaps(&bounds));
            }
        }
    }

    #[test]
    fn two_halves_of_a_square_cover_each_sample_once() {
        let halves = [[[8.0, 8.0], [8.0, 40.0], [40.0, 8.0]], [[40.0, 8.0], [8.0, 40.0], [40.0, 40.0]]];
        let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
        for path in [CoveragePath::Opaque, CoveragePath::Discarding] {
            let samples = SamplePattern::standard(4).unwrap();
            let counts = count(&mut renderer, &halves, [64, 48], samples, path).unwrap();
            for (i, word) in counts.iter().enumerate() {
                let (x, y) = (i / 4 % 64, i / 4 / 64);
                let is_inside = (8..40).contains(&x) && (8..40).contains(&y);
                let total: u32 = word.to_le_bytes().iter().map(|byte| u32::from(*byte)).sum();
                assert_eq!(total, u32::from(is_inside), "{x} {y} {path:?}");
            }
        }
    }

    #[test]
    fn lines_that_are_no_triangles_are_named() {
        assert_eq!(parse_csv("# six\n1,2,3,4,5,6\n\n").unwrap(), [[[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]]);
        assert_eq!(parse_csv("1,2,3,4,5,6\n1,2,x,4,5,6").unwrap_err().line, 2);
    }
}
