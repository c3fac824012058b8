//! Layers: a group drawn apart, then treated and blended as one.

use super::{BlendMode, ClipPath, Drawing};
use core::fmt;
use std::sync::Arc;
use trigon::schedule::Deadline;

/// How a group is treated. In SVG's order: the filter first, then clip, mask and opacity, then it is blended.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Multiplied into the group, 0 to 1.
    pub opacity: f32,
    /// How the group as a whole is blended with what is below.
    pub blend: BlendMode,
    /// Draw the group apart, on transparent black, even if nothing else asks for it: so that blend modes inside do not
    /// see what is below.
    pub isolate: bool,
    /// Where the group is seen.
    pub clip: Option<Arc<ClipPath>>,
    /// How much of it is seen.
    pub mask: Option<Arc<Mask>>,
    /// What its picture goes through before.
    pub filter: Option<Filter>,
}

impl Default for Layer {
    fn default() -> Self {
        Self { opacity: 1.0, blend: BlendMode::Normal, isolate: false, clip: None, mask: None, filter: None }
    }
}

/// A drawing that says, sample by sample, how much of a layer is seen.
#[derive(Clone, Debug)]
pub struct Mask {
    /// The drawing, in pixels as the layer; not drawn on is 0.
    pub drawing: Drawing,
    /// What of it counts.
    pub kind: MaskKind,
    /// Applied to this mask: the `mask` of a `mask`.
    pub mask: Option<Arc<Mask>>,
}

/// What of a mask's drawing counts.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum MaskKind {
    /// Luminance of the sRGB-encoded colour, times alpha.
    #[default]
    Luminance,
    /// Luminance of the colour in linear light, times alpha (`color-interpolation: linearRGB`).
    LinearLuminance,
    /// Alpha.
    Alpha,
}

/// A function from the picture of a layer to the picture that takes its place.
#[derive(Clone)]
pub struct Filter {
    /// The pixels that the layer is drawn for; may lie outside of the picture. Limited by
    /// [`Renderer::max_pixels`](super::Renderer::max_pixels).
    pub region: PixelRect,
    /// The function. It gets the layer, resolved to one colour per pixel, and the deadline of the renderer, after which
    /// nobody sees what it returns. That may be of another region.
    pub apply: Arc<dyn Fn(LayerImage, Deadline) -> LayerImage + Send + Sync>,
}

impl fmt::Debug for Filter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Filter").field("region", &self.region).finish_non_exhaustive()
    }
}

/// A rectangle of whole pixels.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct PixelRect {
    /// The leftmost column.
    pub x: i32,
    /// The topmost row.
    pub y: i32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// Pixels at a place: sRGB-encoded, premultiplied, row 0 at the top.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct LayerImage {
    /// Where they lie.
    pub rect: PixelRect,
    /// `rect.width * rect.height` of them, red, green, blue, alpha. If there are not so many, nothing is drawn.
    pub pixels: Vec<[u8; 4]>,
}

impl LayerImage {
    /// Transparent black.
    #[must_use]
    pub fn new(rect: PixelRect) -> Self {
        Self { rect, pixels: vec![[0; 4]; rect.width as usize * rect.height as usize] }
    }
}
