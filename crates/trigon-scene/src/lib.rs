//! 3D scenes for trigon: OBJ/MTL, STL and PLY readers, materials, lights, cameras.

pub mod math;
pub mod scene;
