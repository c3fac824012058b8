//! The renderer: memory and threads that live from frame to frame.
//!
//! In: a frame and its draws. Out: a picture and counts. First every chunk of primitives goes through the geometry
//! stage, on any thread; then every tile is drawn, on any thread; each tile reads the chunks in submission order.

use super::draw::{Draw, Frame, FrameError, FrameStatistics};
use super::output::{Picture, TileOfPicture};
use super::tile::{TileInput, TileWorker};
use crate::clock::Stopwatch;
use crate::geometry::{CHUNK_PRIMITIVES, Chunk, ChunkInput, ChunkScratch, Segment, Viewport, process_chunk};
use crate::lanes::{SimdError, SimdLevel, dispatch};
use crate::schedule::{Deadline, TileOrder, share, tile_sequence};
use crate::target::TILE_SIZE;
use fearless_simd::Level;

/// How a renderer works; none of it changes a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct RendererOptions {
    /// Threads to use, the caller's included; at least one.
    pub threads: usize,
    /// Instruction set to use.
    pub simd: SimdLevel,
    /// Which tiles first.
    pub tile_order: TileOrder,
}

impl RendererOptions {
    /// One thread per available core, and the level that `TRIGON_SIMD` names or else the best.
    ///
    /// # Errors
    /// `TRIGON_SIMD` names no level, or one that this CPU lacks.
    pub fn from_env() -> Result<Self, SimdError> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        Ok(Self { threads, simd: SimdLevel::from_env()?, tile_order: TileOrder::default() })
    }
}

/// Draws frames. Keeps its memory between them.
pub struct Renderer {
    options: RendererOptions,
    deadline: Deadline,
    level: Level,
    pub(super) chunks: Vec<Chunk>,
    scratch: Vec<ChunkScratch>,
    tiles: Vec<TileWorker>,
}

/// Fewer primitives and pixels than this are drawn by the caller alone: starting threads would cost more.
const SMALL_FRAME: (usize, usize) = (2_000, 40_000);

impl Renderer {
    /// A renderer with these options.
    ///
    /// # Errors
    /// The CPU lacks the SIMD level.
    pub fn new(options: RendererOptions) -> Result<Self, SimdError> {
        let level = options.simd.to_level().ok_or(SimdError::Unavailable(options.simd))?;
        Ok(Self {
            options,
            deadline: Deadline::NEVER,
            level,
            chunks: Vec::new(),
            scratch: Vec::new(),
            tiles: Vec::new(),
        })
    }

    /// How it works: for code beside it that shares the work among threads, at the same SIMD level.
    #[must_use]
    pub fn options(&self) -> RendererOptions {
        self.options
    }

    /// Gives frames up that are not done at this moment: from then on until another one is set, drawing fails. A frame
    /// stops within the time that a chunk of primitives or a tile takes.
    pub fn set_deadline(&mut self, deadline: Deadline) {
        self.deadline = deadline;
    }

    /// The moment after which frames are given up; [`Deadline::NEVER`] unless one was set.
    #[must_use]
    pub fn deadline(&self) -> Deadline {
        self.deadline
    }

    /// Draws a frame: `draws` in order, into `picture`.
    ///
    /// # Errors
    /// A picture size outside 1..=16 384, a draw with more than 2^32 primitives, or a [`Deadline`] that comes before the
    /// end; `picture` then has no images.
    pub fn render(
        &mut self,
        frame: &Frame,
        draws: &[Draw<'_>],
        picture: &mut Picture,
    ) -> Result<FrameStatistics, FrameError> {
        frame.check()?;
        let tasks = chunk_tasks(draws)?;
        picture.prepare(frame);
        let threads = self.threads(frame, &tasks);

        let started = Stopwatch::start();
        self.run_geometry(frame, draws, &tasks, threads).inspect_err(|_| *picture = Picture::default())?;
        let geometry_time = started.elapsed();
        let started = Stopwatch::start();
        let chunks = &self.chunks[..tasks.len()];
        let bins = TileBins::new(frame, chunks);
        self.tiles.resize_with(threads, TileWorker::default);
        let mut parts: Vec<_> = TileOfPicture::of_picture(picture, frame).map(Some).collect();
        let input = TileInput { level: self.level, frame, draws, chunks };
        let columns = frame.width.div_ceil(TILE_SIZE as u32);
        let deadline = self.deadline;
        let order = tile_sequence(self.options.tile_order, &bins.cost);
        let work = order.into_iter().filter_map(|tile| Some((tile, parts[tile as usize].take()?)));
        share(&mut self.tiles, work, |worker, (tile, part)| {
            if !deadline.is_over() {
                worker.draw(&input, bins.segments(tile), [tile % columns, tile / columns], part);
            }
        });
        if deadline.is_over() {
            *picture = Picture::default();
            return Err(FrameError::TimeOver);
        }
        let mut statistics = FrameStatistics {
            tiles: bins.cost.len() as u64,
            tile_triangles: bins.cost.iter().map(|c| u64::from(*c)).sum(),
            geometry_time,
            tile_time: started.elapsed(),
            ..FrameStatistics::default()
        };
        for chunk in chunks {
            statistics.geometry += chunk.statistics;
        }
        Ok(statistics)
    }

    /// How many threads the frame is worth.
    pub(super) fn threads(&self, frame: &Frame, tasks: &[ChunkTask]) -> usize {
        let pixels = frame.width as usize * frame.height as usize;
        let primitives: usize = tasks.iter().map(|task| task.count).sum();
        let is_small = primitives < SMALL_FRAME.0 && pixels < SMALL_FRAME.1;
        if is_small { 1 } else { self.options.threads.max(1) }
    }

    /// Fills the first chunks, one for each task. After an error they hold old and new ones and are not to be read.
    pub(super) fn run_geometry(
        &mut self,
        frame: &Frame,
        draws: &[Draw<'_>],
        tasks: &[ChunkTask],
        threads: usize,
    ) -> Result<(), FrameError> {
        if self.chunks.len() < tasks.len() {
            self.chunks.resize_with(tasks.len(), Chunk::default);
        }
        self.scratch.resize_with(threads, ChunkScratch::default);
        let viewport = Viewport { width: frame.width, height: frame.height };
        let (level, deadline) = (self.level, self.deadline);
        let work = tasks.iter().zip(&mut self.chunks);
        share(&mut self.scratch, work, |scratch, (task, chunk)| {
            if deadline.is_over() {
                return;
            }
            let draw = &draws[task.draw as usize];
            let input = ChunkInput {
                primitives: draw.primitives,
                first: task.first,
                count: task.count,
                cull: draw.cull,
                viewport,
                samples: frame.samples,
            };
            chunk.draw = task.draw;
            let (vertices, positions) = scratch.assemble(&input);
            draw.shader.positions(level, vertices, positions);
            dispatch!(level, l => process_chunk(l, &input, scratch, chunk));
        });
        // Time does not run backwards: where a chunk was left out, it is over now.
        if deadline.is_over() { Err(FrameError::TimeOver) } else { Ok(()) }
    }
}

/// A range of a draw's primitives.
pub(super) struct ChunkTask {
    draw: u32,
    first: usize,
    count: usize,
}

pub(super) fn chunk_tasks(draws: &[Draw<'_>]) -> Result<Vec<ChunkTask>, FrameError> {
    let mut tasks = Vec::new();
    for (d, draw) in draws.iter().enumerate() {
        let total = draw.primitives.count();
        if u32::try_from(total).is_err() {
            return Err(FrameError::TooManyPrimitives(total));
        }
        for first in (0..total).step_by(CHUNK_PRIMITIVES) {
            tasks.push(ChunkTask { draw: d as u32, first, count: CHUNK_PRIMITIVES.min(total - first) });
        }
    }
    Ok(tasks)
}

/// Every tile's segments, chunk by chunk in submission order.
pub(super) struct TileBins {
    /// `(chunk, segment)`, grouped by tile.
    segments: Vec<(u32, Segment)>,
    /// First segment of each tile, and the end.
    starts: Vec<u32>,
    /// Triangles of each tile.
    cost: Vec<u32>,
}

impl TileBins {
    pub(super) fn new(frame: &Frame, chunks: &[Chunk]) -> Self {
        let size = TILE_SIZE as u32;
        let tiles = frame.width.div_ceil(size) as usize * frame.height.div_ceil(size) as usize;
        let mut starts = vec![0u32; tiles + 1];
        let mut cost = vec![0u32; tiles];
        for segment in chunks.iter().flat_map(|chunk| &chunk.segments) {
            starts[segment.tile as usize + 1] += 1;
            cost[segment.tile as usize] += segment.len;
        }
        for tile in 0..tiles {
            starts[tile + 1] += starts[tile];
        }
        let mut next = starts.clone();
        let empty = (0, Segment { tile: 0, start: 0, len: 0 });
        let mut segments = vec![empty; starts[tiles] as usize];
        for (c, chunk) in chunks.iter().enumerate() {
            for segment in &chunk.segments {
                let at = &mut next[segment.tile as usize];
                segments[*at as usize] = (c as u32, *segment);
                *at += 1;
            }
        }
        Self { segments, starts, cost }
    }

    pub(super) fn segments(&self, tile: u32) -> &[(u32, Segment)] {
        let tile = tile as usize;
        &self.segments[self.starts[tile] as usize..self.starts[tile + 1] as usize]
    }
}
