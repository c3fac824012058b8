//! The trigon command: draws 3D models to pictures on machines without a GPU.
fn main() {}
