//! From display list to pixels.
//!
//! ```text
//! Drawing -compile-> Program (steps) + Tables (edges by band, shaders, clips)
//! for each band:  edges -coverage-> RunRows -paint-> Surface -resolve-> pixels
//! ```
//!
//! A band is [`coverage::BAND_ROWS`] pixel rows of the whole width. Everything that is done to it stays in the memory of
//! one thread.
#![expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::cast_possible_wrap,
    reason = "coordinates, counts and masks are cast within proven ranges throughout the kernels"
)]

mod band;
mod blend;
mod color;
mod compile;
mod coverage;
mod draw;
mod edge;
mod flatten;
mod geometry;
mod layer;
mod over;
mod paint;
mod program;
mod runs;
mod samples;
mod shader;
mod stroke;
mod surface;

pub(crate) use blend::blend;
pub(crate) use color::{premultiplied_pixel, straight};
pub(crate) use draw::{draw, draw_over};
