//! Shading: visible fragments in, linear colours out.
//!
//! Shaders are Rust types, generic over the lanes. What is visible is packed densely: lanes are filled across
//! triangles, so that tiny triangles cost no idle lanes.

mod coefficients;
mod erased;
mod fragments;
mod shader;
pub mod texture;
mod varying;

pub use coefficients::{FragmentRows, Interpolation, Rows, TriangleGroup};
pub use erased::{ErasedShader, FragmentBatch};
pub use fragments::{ColorGroup, FragmentRange, SurfaceGroup};
pub use shader::{Fragment, Shader, SurfaceLanes, Vertex};
pub use varying::{CornerSink, FragmentSource, Varying};

pub(crate) use coefficients::store_rows;
pub(crate) use fragments::{Candidates, Destination, FragmentList, Placement, ShadingPoints};
