//! Loading files into scenes: format recognition, side files, limits, errors and warnings.
//!
//! ```
//! use trigon_scene::load::{LoadOptions, load_bytes};
//!
//! let obj = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
//! let loaded = load_bytes("triangle.obj", obj, &LoadOptions::default())?;
//! assert_eq!(loaded.scene.triangle_count(), 1);
//! assert_eq!(loaded.scene.meshes[0].normals[0], [0.0, 0.0, 1.0]);
//! assert_eq!(loaded.warnings[0].to_string(), "triangle.obj:4: material red is not defined; a neutral one used");
//! # Ok::<(), trigon_scene::load::LoadError>(())
//! ```
#![doc = include_str!("../../FORMATS.md")]

mod decoder;
mod entry;
mod error;
mod format;
mod gzip;
mod options;
mod parallel;
mod resolver;
mod side_files;
mod warnings;

pub use decoder::PictureDecoder;
pub use entry::{Loaded, load_bytes, load_path};
pub use error::{LoadError, Location, Place};
pub use format::Format;
pub use options::{Limits, LoadOptions, UpAxis};
pub use resolver::{DirectoryResolver, MemoryResolver, NoSideFiles, Resolver};
pub use warnings::{Warning, WarningKind};

pub(crate) use format::has_binary_stl_length;
pub(crate) use parallel::parallel_map;
pub(crate) use side_files::SideFiles;
pub(crate) use warnings::Findings;
