//! Benchmark scenes, their shaders, and what is measured about a frame: shared by the `trigon-bench` command and the
//! criterion benches.

pub mod clock;
pub mod coverage;
pub mod measure;
pub mod scene;
pub mod shading;
pub mod shot;
