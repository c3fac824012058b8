//! Geometry: primitives in, [`ScreenTriangle`]s sorted into tiles out.
//!
//! Works on chunks of primitives, each on its own: place vertices, project and snap them, clip the few triangles that
//! need it, set up sixteen triangles at a time, and list for each touched tile the triangles of the chunk in order.

mod assemble;
mod bins;
mod chunk;
mod clip;
mod micro;
mod project;
mod setup;
mod stroke;
mod triangle;

pub use assemble::{Cull, Indices, Primitives};
pub use bins::Segment;
pub use chunk::{CHUNK_PRIMITIVES, Chunk, ChunkInput, ChunkScratch, GeometryStatistics, process_chunk};
pub use project::{ClipPositions, Viewport};
pub use triangle::{ClippedCorners, GUARD_BAND, PixelBox, SUBPIXEL, ScreenTriangle, Tags};
