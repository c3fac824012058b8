//! One band of the picture: the steps that meet it, in order, then its pixels.
//!
//! In: a [`Program`] and a band. Out: the band's rows, resolved. A band depends on nothing but the program, so bands are
//! drawn in any order, by any thread.

use super::coverage::{BAND_ROWS, Bounds, Scanner};
use super::draw::Below;
use super::layer::{blend_layer, to_coefficients};
use super::over::scale;
use super::paint::Brush;
use super::program::{Clip, Program, Step, Tables};
use super::runs::RunRows;
use super::samples::SampleRows;
use super::shader::Shader;
use super::surface::{Pixel, Surface, mean};
use crate::canvas::{FillRule, Renderer};
use trigon::lanes::{Kernel, Lanes};
use trigon::schedule::Deadline;

/// The memory of one thread, and what it reads.
pub(crate) struct Worker<'a> {
    tables: &'a Tables,
    deadline: Deadline,
    scanners: Scanners<'a>,
    full_mask: u16,
    sample_count: u32,
    runs: RunRows,
    clipped: RunRows,
    colors: Vec<u32>,
    /// Clip paths that are open, each cut by those below it.
    clips: Vec<RunRows>,
    /// Memory of surfaces that are done.
    spare: Vec<Surface>,
}

/// One band, to be drawn with the CPU features of a level.
struct BandTask<'w, 'a> {
    worker: &'w mut Worker<'a>,
    program: &'w Program,
    band: u32,
    below: Below,
    out: &'w mut [[u8; 4]],
}

impl Kernel for BandTask<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let rows = [self.band * BAND_ROWS, self.band * BAND_ROWS + (self.out.len() / self.worker.width()) as u32];
        let bounds = Bounds { columns: [0, self.worker.width() as u32], rows };
        let mut surface = self.worker.spare.pop().unwrap_or_default();
        match self.below {
            Below::Color(color) => surface.restart(bounds, color),
            Below::Pixels => surface.restart_with(bounds, self.out),
        }
        let surface = self.worker.run(l, self.program, self.band, surface);
        resolve(l, &surface, self.worker.sample_count, self.out);
        self.worker.spare.push(surface);
    }
}

impl<'a> Worker<'a> {
    /// A worker for pictures up to `width` pixels.
    pub(crate) fn new(samples: &'a SampleRows, tables: &'a Tables, width: u32, deadline: Deadline) -> Self {
        Self {
            tables,
            deadline,
            scanners: Scanners::new(samples, width),
            full_mask: samples.full_mask(),
            sample_count: samples.count() as u32,
            runs: RunRows::default(),
            clipped: RunRows::default(),
            colors: Vec::new(),
            clips: Vec::new(),
            spare: Vec::new(),
        }
    }

    fn width(&self) -> usize {
        self.scanners.of_samples.width()
    }

    /// Draws the rows of one band into `out`.
    pub(crate) fn draw_band(
        &mut self,
        renderer: &Renderer,
        program: &Program,
        band: u32,
        below: Below,
        out: &mut [[u8; 4]],
    ) {
        if program.steps_in(band).is_empty() || self.deadline.is_over() {
            below.fill(out);
            return;
        }
        renderer.simd.run(BandTask { worker: self, program, band, below, out });
    }

    /// The steps of a program that meet a band, on a surface.
    #[inline(never)]
    fn run<L: Lanes>(&mut self, l: L, program: &Program, band: u32, surface: Surface) -> Surface {
        l.vectorize(
            #[inline(always)]
            || self.run_steps(l, program, band, surface),
        )
    }

    #[inline(always)]
    fn run_steps<L: Lanes>(&mut self, l: L, program: &Program, band: u32, surface: Surface) -> Surface {
        // Clip paths of a layer do not reach into its mask.
        let outer_clips = core::mem::take(&mut self.clips);
        let bounds = surface.bounds();
        let mut surfaces = vec![surface];
        for number in program.steps_in(band) {
            if self.deadline.is_over() {
                break;
            }
            let step_bounds = program.bounds[*number as usize].intersect(&bounds);
            let Some(surface) = surfaces.last_mut() else { break };
            match program.steps[*number as usize] {
                Step::Fill { shape, rule, shader, blend } => {
                    if self.cover(l, shape, rule, band) {
                        let brush = Brush { shader: &self.tables.shaders[shader], blend, full_mask: self.full_mask };
                        brush.paint(l, &self.runs, &step_bounds, surface, &mut self.colors);
                    }
                }
                Step::Pixels { image, at, opacity, blend } => {
                    self.copy_pixels(l, image, at, opacity, blend, &step_bounds, surface);
                }
                Step::PushClip { clip } => self.push_clip(l, clip, band),
                Step::PopClip => {
                    self.clips.pop();
                }
                Step::PushLayer => surfaces.push(self.new_surface(step_bounds)),
                Step::PopLayer { opacity, blend, mask } => {
                    if let [.., below, layer] = &mut surfaces[..] {
                        let masks = self.masks(l, mask, band, step_bounds);
                        blend_layer(l, layer, &masks, opacity, blend, self.full_mask, below, &mut self.colors);
                        self.spare.extend(masks);
                        self.spare.extend(surfaces.pop());
                    }
                }
            }
        }
        self.clips = outer_clips;
        surfaces.swap_remove(0)
    }

    /// Transparent black.
    fn new_surface(&mut self, bounds: Bounds) -> Surface {
        let mut surface = self.spare.pop().unwrap_or_default();
        surface.restart(bounds, 0);
        surface
    }

    /// The coverage of a shape inside the open clip paths, into `self.runs`; false if there is none.
    fn cover<L: Lanes>(&mut self, l: L, shape: usize, rule: FillRule, band: u32) -> bool {
        if self.clips.last().is_some_and(RunRows::is_empty) {
            return false;
        }
        self.scanners.scan(l, self.tables, shape, rule, band, &mut self.runs);
        if let Some(clip) = self.clips.last() {
            self.runs.intersect(clip, &mut self.clipped);
            core::mem::swap(&mut self.runs, &mut self.clipped);
        }
        !self.runs.is_empty()
    }

    /// Opens a clip path.
    fn push_clip<L: Lanes>(&mut self, l: L, clip: usize, band: u32) {
        let mut inside = RunRows::default();
        cover_clip(l, &mut self.scanners, self.tables, &self.tables.clips[clip], band, &mut inside);
        if let Some(below) = self.clips.last() {
            let mut both = RunRows::default();
            inside.intersect(below, &mut both);
            inside = both;
        }
        self.clips.push(inside);
    }

    /// Paints pixels as they are.
    #[expect(clippy::too_many_arguments, reason = "the parts of one step")]
    #[inline(always)]
    fn copy_pixels<L: Lanes>(
        &mut self,
        l: L,
        image: usize,
        at: [i64; 2],
        opacity: u32,
        blend: crate::canvas::BlendMode,
        bounds: &Bounds,
        surface: &mut Surface,
    ) {
        let image = &self.tables.images[image];
        let full = self.full_mask;
        let brush = Brush { shader: &Shader::Solid(0), blend, full_mask: full };
        let bounds = bounds.intersect(&surface.bounds());
        if bounds.is_empty() {
            return;
        }
        let everything = [super::runs::Run {
            x: bounds.columns[0] as u16,
            len: (bounds.columns[1] - bounds.columns[0]) as u16,
            mask: full,
        }];
        for y in bounds.rows[0]..bounds.rows[1] {
            let source_row = (i64::from(y) - at[1]) as usize * image.rect.width as usize;
            let runs = self.clips.last().map_or(&everything[..], |clip| clip.row(y)); // tidy: allow(lane-closure): no lanes in it
            let mut row = surface.row_mut(y);
            for run in runs {
                let start = u32::from(run.x).max(bounds.columns[0]);
                let end = u32::from(run.end()).min(bounds.columns[1]);
                if start >= end {
                    continue;
                }
                let first = source_row + (i64::from(start) - at[0]) as usize;
                let sources = &image.pixels[first..first + (end - start) as usize];
                self.colors.clear();
                for pixel in sources {
                    self.colors.push(scale(u32::from_le_bytes(*pixel), opacity));
                }
                let start = (start - row.left) as usize;
                brush.colored_span_at(l, start, run.mask, &self.colors, &mut row);
            }
        }
    }

    /// The coefficients of a mask and of the masks on it, for the pixels of a layer.
    fn masks<L: Lanes>(&mut self, l: L, mask: Option<usize>, band: u32, bounds: Bounds) -> Vec<Surface> {
        let mut surfaces = Vec::new();
        let mut next = mask;
        while let Some(number) = next {
            let mask = &self.tables.masks[number];
            let surface = self.new_surface(bounds);
            let mut surface = self.run(l, &mask.program, band, surface);
            to_coefficients(mask.kind, &mut surface);
            surfaces.push(surface);
            next = mask.mask;
        }
        surfaces
    }
}

/// What turns edges into runs: for shapes of samples, and for those with crisp edges.
struct Scanners<'a> {
    of_samples: Scanner<'a>,
    of_centers: Scanner<'a>,
    full_mask: u16,
}

impl<'a> Scanners<'a> {
    fn new(samples: &'a SampleRows, width: u32) -> Self {
        let of_centers = Scanner::new(SampleRows::centers(), width);
        Self { of_samples: Scanner::new(samples, width), of_centers, full_mask: samples.full_mask() }
    }

    /// The coverage of a shape in a band.
    fn scan<L: Lanes>(&mut self, l: L, tables: &Tables, shape: usize, rule: FillRule, band: u32, out: &mut RunRows) {
        let shape = tables.geometry.shape(shape);
        let rows = [band * BAND_ROWS, (band + 1) * BAND_ROWS];
        let bounds = shape.bounds();
        let bounds = bounds.intersect(&Bounds { columns: bounds.columns, rows });
        if shape.is_crisp() {
            self.of_centers.scan(l, shape.edges_in(band), rule, &bounds, out);
            out.cover_whole(self.full_mask);
        } else {
            self.of_samples.scan(l, shape.edges_in(band), rule, &bounds, out);
        }
    }
}

/// The coverage of a clip path in a band.
fn cover_clip<L: Lanes>(l: L, scanners: &mut Scanners<'_>, tables: &Tables, clip: &Clip, band: u32, out: &mut RunRows) {
    out.restart(band * BAND_ROWS);
    let (mut one, mut other) = (RunRows::default(), RunRows::default());
    for (shape, rule, own) in &clip.shapes {
        scanners.scan(l, tables, *shape, *rule, band, &mut one);
        if let Some(own) = own {
            let mut inside = RunRows::default();
            cover_clip(l, scanners, tables, &tables.clips[*own], band, &mut inside);
            one.intersect(&inside, &mut other);
            core::mem::swap(&mut one, &mut other);
        }
        out.unite(&one, &mut other);
        core::mem::swap(out, &mut other);
    }
    if let Some(further) = clip.intersect {
        cover_clip(l, scanners, tables, &tables.clips[further], band, &mut one);
        out.intersect(&one, &mut other);
        core::mem::swap(out, &mut other);
    }
}

/// The mean of each pixel's samples.
#[inline(always)]
fn resolve<L: Lanes>(_: L, surface: &Surface, count: u32, out: &mut [[u8; 4]]) {
    let bounds = surface.bounds();
    let width = (bounds.columns[1] - bounds.columns[0]) as usize;
    for (y, out) in (bounds.rows[0]..bounds.rows[1]).zip(out.chunks_exact_mut(width)) {
        let mut x = 0;
        while x < width {
            let (end, words) = surface.whole_pixels(x, y);
            for (out, word) in out[x..end].iter_mut().zip(words) {
                *out = word.to_le_bytes();
            }
            x = end;
            while x < width {
                let Pixel::Samples(line) = surface.pixel(x, y) else { break };
                out[x] = mean(line, count).to_le_bytes();
                x += 1;
            }
        }
    }
}
