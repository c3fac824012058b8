//! The seven scenes that every 3D renderer is compared on: generators and one loaded model in, meshes, textures and
//! draws out.

mod bumpy_sphere;
mod grid;
mod hall;
mod height_field;
mod kind;
mod layers;
mod model;
mod orbit;
mod pattern;

pub use grid::Mesh;
pub use kind::{BenchScene, MaterialRun, ModelFiles, SceneError, SceneKind, Surface};
pub use orbit::{FRAMES, Orbit, View};
