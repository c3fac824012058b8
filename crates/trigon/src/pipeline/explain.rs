//! One pixel explained: a frame and a pixel in, its story out.
//!
//! The frame's geometry is processed and the pixel's tile is drawn as for a picture, by the same code, at the plain
//! level with a witness beside it. All levels give the same bits, so it is the story of every picture of the frame.

use super::draw::{Draw, Frame, FrameError, Outputs};
use super::renderer::{Renderer, TileBins, chunk_tasks};
use super::story::PixelStory;
use super::tile::{TileInput, TileWorker};
use crate::target::TILE_SIZE;
use fearless_simd::Level;

impl Renderer {
    /// Tells how the pixel in column `x` and row `y` of a frame comes about.
    ///
    /// The outputs that the frame asks for do not matter.
    ///
    /// # Errors
    /// Those of [`render`](Self::render), or a pixel outside of the frame.
    pub fn explain(&mut self, frame: &Frame, draws: &[Draw<'_>], [x, y]: [u32; 2]) -> Result<PixelStory, FrameError> {
        frame.check()?;
        if x >= frame.width || y >= frame.height {
            return Err(FrameError::NoPixel { x, y, width: frame.width, height: frame.height });
        }
        let frame = &Frame { outputs: Outputs { color_f32: true, ..Outputs::COLOR }, ..*frame };
        let tasks = chunk_tasks(draws)?;
        let threads = self.threads(frame, &tasks);
        self.run_geometry(frame, draws, &tasks, threads)?;
        let chunks = &self.chunks[..tasks.len()];
        let bins = TileBins::new(frame, chunks);
        let input = TileInput { level: Level::fallback(), frame, draws, chunks };
        let size = TILE_SIZE as u32;
        let (column, row) = (x / size, y / size);
        let segments = bins.segments(row * frame.width.div_ceil(size) + column);
        let place = [(x % size) as usize, (y % size) as usize];
        let (triangles, fragments, resolve) = TileWorker::default().explain(&input, segments, [column, row], place);
        Ok(PixelStory {
            pixel: [x, y],
            samples: frame.samples.positions().to_vec(),
            shading: frame.shading,
            interpolation: frame.interpolation,
            color_space: frame.color_space,
            clear: frame.clear,
            triangles,
            fragments,
            resolve,
        })
    }
}
