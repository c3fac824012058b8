//! An exact, fast software rasterizer: triangles to pixels on the CPU, bit for bit the same on every machine.
//!
//! A shader, primitives and a [`Frame`](pipeline::Frame) go in, a [`Picture`](pipeline::Picture) comes out:
//!
//! ```
//! use trigon::lanes::{Lanes, Rgba, U32, Vec3};
//! use trigon::pipeline::{Draw, Frame, Picture, Renderer, RendererOptions};
//! use trigon::shade::{Fragment, Shader, Vertex};
//! use trigon::{Indices, Primitives};
//!
//! /// One triangle whose corners are red, green and blue. Written once, compiled for every SIMD level.
//! struct Tricolor;
//!
//! impl Shader for Tricolor {
//!     type Varying<L: Lanes> = Vec3<L>; // linear red, green, blue
//!
//!     #[inline(always)]
//!     fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Vec3<L>> {
//!         let position = index.gather_vec4(&[[-1.0, -1.0, 0.5, 1.0], [1.0, -1.0, 0.5, 1.0], [0.0, 1.0, 0.5, 1.0]]);
//!         Vertex { position, varying: index.gather_vec3(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]) }
//!     }
//!
//!     #[inline(always)]
//!     fn fragment<L: Lanes>(&self, l: L, fragment: &Fragment<L, Vec3<L>>) -> Rgba<L> {
//!         fragment.varying.rgba(1.0)
//!     }
//! }
//!
//! let mut picture = Picture::default();
//! let mut renderer = Renderer::new(RendererOptions::from_env()?)?;
//! let draw = Draw::new(&Tricolor, Primitives::Triangles(Indices::Sequence(3)));
//! renderer.render(&Frame::new(16, 16), &[draw], &mut picture)?;
//!
//! let color = picture.color.unwrap(); // 8-bit sRGB, row 0 at the top
//! assert_eq!(color.get(0, 0), Some([0, 0, 0, 255])); // outside: the frame's clear colour
//! let [red, green, blue, alpha] = color.get(8, 15).unwrap(); // near the middle of the bottom edge
//! assert!(red > 170 && green > 170 && blue < 60 && alpha == 255);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`shade`]: shaders, varyings and textures, what a user of the crate writes and fills.
//! - [`pipeline`]: draws, frames, the renderer and its pictures.
//! - [`target`]: sample patterns and shading rates. [`schedule`]: the order of tiles.
//! - [`explain`]: what is told of a pixel: every step from its triangles to its bytes.
//! - [`lanes`] and [`math`]: the numbers that shaders compute with, and the SIMD level.
//!
//! Space: clip space is that of WebGPU (x right, y up) with reversed depth, 1 near and 0 far; the framebuffer has its
//! origin at the top left and pixel centres at +0.5. Colour is linear and premultiplied until it is stored.
//!
//! The same draws give the same bits at every SIMD level, with any number of threads and in any order of tiles. A shader
//! keeps that promise as long as it uses the lanes and [`math`], and no platform functions such as `f32::sin`.
//!
//! # Non-goals
//!
//! - No scene, material, camera or model file (see `trigon-scene`), no picture file (see `trigon-image`), no window.
//! - No emulation of a graphics API: no shading language, no command buffers, no stencil.
//! - No ray tracing, and no neighbour pixels: derivatives come from the triangle's planes, so there are no helper lanes.
//! - No approximate mode: there is no switch that trades bits for speed.
#![expect(
    clippy::cast_possible_truncation,
    reason = "coordinates, counts and masks are cast within proven ranges throughout the kernels"
)]

mod clock;
pub mod explain;
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

#[doc(inline)]
pub use geometry::{Cull, Indices, Primitives};
#[doc(inline)]
pub use raster::{DepthCompare, DepthTest};
#[doc(inline)]
pub use resolve::Blend;
