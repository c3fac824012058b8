//! 3D scenes for trigon: OBJ/MTL, STL and PLY readers, materials, lights, cameras, and the renderer of them.
//!
//! The bytes of a model go in, a [`Scene`](scene::Scene) with warnings comes out; a scene, a camera and settings go in, a
//! picture comes out:
//!
//! ```
//! use trigon::pipeline::{Picture, Renderer, RendererOptions};
//! use trigon_scene::load::{LoadOptions, load_bytes};
//! use trigon_scene::render::{RenderSettings, SceneRenderer, ShaderKind};
//! use trigon_scene::scene::Framing;
//!
//! // A square whose corners have colours: orange, as files write it.
//! let obj = b"v 0 0 0 1 .5 0\nv 1 0 0 1 .5 0\nv 1 1 0 1 .5 0\nv 0 1 0 1 .5 0\nf 1 2 3 4\n";
//! let loaded = load_bytes("square.obj", obj, &LoadOptions::default())?;
//! assert!(loaded.warnings.is_empty());
//!
//! // From the front, with a margin of a quarter on each side.
//! let framing = Framing { azimuth: 0.0, elevation: 0.0, margin: 0.25, ..Framing::default() };
//! let mut settings = RenderSettings::new(32, 32);
//! settings.shader = ShaderKind::Unlit;
//! settings.background = [0.0; 4];
//!
//! let mut picture = Picture::default();
//! let mut renderer = Renderer::new(RendererOptions::from_env()?)?;
//! let camera = framing.camera(&loaded.scene);
//! SceneRenderer::new().render(&mut renderer, &loaded.scene, &camera, &settings, &mut picture)?;
//!
//! let color = picture.color.unwrap(); // 8-bit sRGB, straight alpha, row 0 at the top
//! let [red, green, blue, alpha] = color.get(16, 16).unwrap();
//! assert!(red > 180 && (80..140).contains(&green) && blue == 0 && alpha == 255);
//! assert_eq!(color.get(2, 2), Some([0; 4]));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! - [`load`]: files to scenes; what is read, limits, errors and warnings.
//! - [`scene`]: the data: meshes, instances, materials, textures, lights, cameras; its conventions.
//! - [`render`]: scenes to pictures, and the ways to look inside one.
//! - [`math`]: matrices and boxes in double precision.
//!
//! A scene and a picture are the same on every machine, with any number of threads. The feature `render`, on by default,
//! adds drawing; without it the crate reads models and knows no rasterizer.
//!
//! # Non-goals
//!
//! - Light that bounces: no reflections or refraction. Physically based values of materials are kept, not drawn.
//! - A scene graph or animation: a scene is flat lists that a program may change from frame to frame.
//! - Writing models, or editing meshes beyond what drawing needs.
//! - Windows and picture files: see `trigon-image` for the latter.

mod color;
mod geometry;
pub mod load;
pub mod math;
mod mtl;
mod obj;
mod ply;
#[cfg(feature = "render")]
pub mod render;
pub mod scene;
mod stl;
mod text;

/// Compiles the example of the README.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
pub struct Readme;
