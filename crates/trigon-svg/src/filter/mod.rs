//! Filter primitives as pure functions over pictures, and the graph that runs them.
//!
//! Independent of SVG text: pictures, numbers in pixels and colors in, a picture out. Filter Effects Module Level 1 (W3C).

mod blend;
mod blur;
mod color;
mod composite;
mod convolve;
mod displace;
mod graph;
mod lighting;
mod morphology;
mod raster;
mod turbulence;

pub use blend::blend;
pub use blur::gaussian_blur;
pub use color::{ColorMatrix, LUMINANCE_TO_ALPHA, Transfer, color_matrix, component_transfer, hue_rotate, saturate};
pub use composite::{Operator, composite, draw_over, flood_in, offset, tile};
pub use convolve::{Convolution, Edge, convolve};
pub use displace::displace;
pub use graph::{DrawPicture, Graph, Input, Primitive, Step};
pub use lighting::{Lamp, Surface, cos_degrees, distant, lighting};
pub use morphology::{Morphology, morphology};
pub use raster::{ColorSpace, Pixel, Raster, Region, convert_color, divide, multiply, product};
pub use turbulence::{Grid, Turbulence, turbulence};
