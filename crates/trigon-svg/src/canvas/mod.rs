//! Drawing in 2D: record shapes into a [`Drawing`], then turn it into pixels with a [`Renderer`].
//!
//! Space: x right, y down, in pixels after the [`Transform`] of each call; pixel (0, 0) covers 0..1 on both axes.
//! Colours are sRGB-encoded, and blended so.

mod blend;
mod clip;
mod drawing;
mod image;
mod layer;
mod paint;
mod path;
mod renderer;
mod stroke;
mod transform;

pub use blend::BlendMode;
pub use clip::{ClipPath, ClipShape};
pub use drawing::Drawing;
pub use image::{Image, ImageFilter};
pub use layer::{Filter, Layer, LayerImage, Mask, MaskKind, PixelRect};
pub use paint::{GradientStop, LinearGradient, Paint, Pattern, RadialGradient, Spread};
pub use path::{FillRule, Path, PathElement};
pub use renderer::{DrawError, Picture, Renderer};
pub use stroke::{Cap, Join, Stroke};
pub use transform::Transform;

pub(crate) use drawing::{Item, Outline, Shape};
