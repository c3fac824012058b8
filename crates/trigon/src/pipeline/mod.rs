//! The pipeline: draws in, a picture out. The only module that sees every stage.
//!
//! Geometry runs over chunks of primitives, then tiles are drawn one by one, each by one thread from the first
//! triangle to the stored pixel. Two queues, one barrier between them.

mod draw;
mod explain;
mod output;
mod renderer;
mod shading;
mod story;
mod tile;
mod visible;
mod witness;

pub use draw::{Draw, Frame, FrameError, FrameStatistics, Outputs};
pub use output::Picture;
pub use renderer::{Renderer, RendererOptions};
pub use story::{FragmentStory, Outcome, PixelStory, ResolveStory, SampleTest, TriangleStory};
