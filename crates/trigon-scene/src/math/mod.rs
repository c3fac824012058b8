//! Host-side geometry: matrices, points and boxes for cameras, transforms and loaders.
//!
//! Kernels of the rasterizer have their own lane vectors; what is here runs once per object or vertex on the host.
//! Everything is computed in `f64` with + - * / and `sqrt`, trigonometry comes from the `libm` crate, and results are
//! rounded to `f32` once: so every machine gets the same bits.

mod aabb;
mod mat4;
pub mod vec3;

pub use aabb::Aabb;
pub use mat4::Mat4;
