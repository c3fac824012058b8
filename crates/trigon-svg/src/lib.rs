//! 2D drawing and SVG for trigon: paths, paints and layers in, a picture out.
//!
//! Every sample of every pixel is inside or outside a shape by its winding number, computed with exact integers, and
//! samples are averaged once, when the whole picture is done. So shapes that share an edge meet without a seam, and the
//! picture is the same, bit for bit, at every SIMD level and with any number of threads.
//!
//! [`canvas`] is the drawing interface for Rust programs, [`svg`] reads SVG files into it, [`filter`] has the filter
//! primitives, and [`cs184`] draws as a rasterizer of a course does.

pub mod canvas;
pub mod cs184;
mod engine;
pub mod filter;
mod linked;
pub mod svg;
