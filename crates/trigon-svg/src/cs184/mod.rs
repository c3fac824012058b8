//! Pictures as the rasterizer of Berkeley's CS184, project 1, draws them: its elements, its view rule, its sampling.
//!
//! Not SVG: lines are one pixel wide and aliased, a rectangle of no size is a point, `viewBox` and CSS are ignored, and
//! there are elements of its own (`texture`, `textri`, `colortri`). Follows StoicLD/CS184 (2019) with the opacity of
//! cmu462/DrawSVG; where both leave something undefined the nearest defined thing is done.

mod cast;
mod ears;
mod element;
mod number;
mod options;
mod picture;
mod primitive;
mod raster;
mod reader;
mod texture;
mod transform;

pub(crate) use number::list as number_list;
pub use options::{LevelSampling, NearestRule, Options, PixelSampling};
pub use picture::draw;
