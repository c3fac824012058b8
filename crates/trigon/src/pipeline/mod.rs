//! The pipeline: draws in, a picture out. The only module that sees every stage.
//!
//! Geometry runs over chunks of primitives, then tiles are drawn one by one, each by one thread from the first
//! triangle to the stored pixel. Two queues, one barrier between them.

mod draw;
mod output;
mod renderer;
mod shading;
mod tile;
mod visible;

pub use draw::{Draw, Frame, FrameError, FrameStatistics, Outputs};
pub use output::Picture;
pub use renderer::{Renderer, RendererOptions};
