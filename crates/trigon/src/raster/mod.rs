//! Rasterization: [`ScreenTriangle`](crate::geometry::ScreenTriangle)s in, the visible triangle of every sample of a
//! tile out.
//!
//! A tile is 64 x 64 pixels and stays in the cache until it is finished. Large triangles descend from the tile to its
//! 8 x 8 blocks by corner tests; blocks wholly inside one triangle are remembered as such and never expanded; a block
//! knows its nearest and farthest depth, so that most hidden work is dropped without touching a sample.

mod block;
mod edges;
mod micro;
mod tile;
mod triangle;

pub use block::{PassMasks, commit, fill_masks};
pub use edges::BlockMasks;
pub(crate) use edges::MAX_SAMPLES;
pub use micro::draw_micro;
pub(crate) use tile::GROUPS;
pub use tile::{BLOCK_PIXELS, BLOCK_SIZE, BLOCKS, BLOCKS_PER_SIDE, BlockState, NO_TRIANGLE, Tile, TriangleLookup};
pub use triangle::{DepthCompare, DepthTest, TileTriangle, draw_opaque};
