//! An exact, fast software rasterizer: triangles to pixels on the CPU, bit for bit the same on every machine.
#![expect(
    clippy::cast_possible_truncation,
    reason = "coordinates, counts and masks are cast within proven ranges throughout the kernels"
)]

#[doc(hidden)]
pub mod geometry;
pub mod lanes;
pub mod math;
pub mod pipeline;
#[doc(hidden)]
pub mod raster;
#[doc(hidden)]
pub mod resolve;
pub mod schedule;
pub mod shade;
pub mod target;
