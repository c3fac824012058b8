//! An exact, fast software rasterizer: triangles to pixels on the CPU, bit for bit the same on every machine.

pub mod lanes;
pub mod math;
pub mod shade;
