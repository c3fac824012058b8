//! 3D scenes for trigon: OBJ/MTL, STL and PLY readers, materials, lights, cameras.

mod color;
mod geometry;
pub mod load;
pub mod math;
mod mtl;
mod obj;
pub mod scene;
mod text;
