//! 3D scenes for trigon: OBJ/MTL, STL and PLY readers, materials, lights, cameras.

mod color;
mod geometry;
pub mod load;
pub mod math;
mod mtl;
mod obj;
mod ply;
pub mod render;
pub mod scene;
mod stl;
mod text;
