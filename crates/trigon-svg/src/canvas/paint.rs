//! What shapes are filled with: a colour, a gradient, a pattern, an image.

use super::{Drawing, Image, ImageFilter, Transform};
use std::sync::Arc;
use trigon_image::Color;

/// What shapes are filled with. A paint is laid out in the space of its path: the transform of the draw call moves
/// both; each paint has a transform of its own before that.
#[derive(Clone, Debug)]
pub enum Paint {
    /// The same colour everywhere.
    Color(Color),
    /// Colours along a line.
    Linear(Arc<LinearGradient>),
    /// Colours between two circles.
    Radial(Arc<RadialGradient>),
    /// A drawing, repeated.
    Pattern(Arc<Pattern>),
    /// An image, its pixel (0, 0) at the origin; transparent outside.
    Image {
        /// The pixels.
        image: Image,
        /// How it is sampled.
        filter: ImageFilter,
        /// Path space from pixels of the image.
        transform: Transform,
    },
}

/// A colour at a place along a gradient.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct GradientStop {
    /// Place, 0 to 1. Places that fall back are moved up to the one before.
    pub offset: f32,
    /// Colour there, straight alpha. Between stops straight colours are mixed, then multiplied by alpha.
    pub color: Color,
    /// Multiplied into the colour's alpha.
    pub opacity: f32,
}

/// What lies outside 0..1 along a gradient.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Spread {
    /// The colours of the ends.
    #[default]
    Pad,
    /// The gradient mirrored every other time.
    Reflect,
    /// The gradient again.
    Repeat,
}

/// Colours along the line from `start` to `end`, the same along each normal of it.
///
/// Of no length: the last colour. Without stops: nothing is drawn.
#[derive(Clone, PartialEq, Debug)]
pub struct LinearGradient {
    /// Where offset 0 is.
    pub start: [f32; 2],
    /// Where offset 1 is.
    pub end: [f32; 2],
    /// Colours, by offset.
    pub stops: Vec<GradientStop>,
    /// Outside 0..1.
    pub spread: Spread,
    /// Path space from gradient space.
    pub transform: Transform,
}

/// Colours between a focal circle (offset 0) and an outer circle (offset 1); SVG 2, `radialGradient`.
///
/// Where the circles' cone does not reach, nothing is drawn.
#[derive(Clone, PartialEq, Debug)]
pub struct RadialGradient {
    /// Centre of the outer circle.
    pub center: [f32; 2],
    /// Radius of the outer circle. Zero or negative: the last colour everywhere.
    pub radius: f32,
    /// Centre of the focal circle.
    pub focus: [f32; 2],
    /// Radius of the focal circle.
    pub focal_radius: f32,
    /// Colours, by offset.
    pub stops: Vec<GradientStop>,
    /// Outside 0..1.
    pub spread: Spread,
    /// Path space from gradient space.
    pub transform: Transform,
}

/// A drawing whose part inside `tile` is repeated in both directions.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// What is repeated.
    pub drawing: Drawing,
    /// The repeated part: x, y, width, height, in pattern space. Without area: nothing is drawn.
    pub tile: [f32; 4],
    /// Path space from pattern space, which is that of the drawing.
    pub transform: Transform,
    /// Columns and rows of pixels that the tile is drawn with; `None`: as many as it takes up on the screen, rounded.
    ///
    /// Filters inside the drawing count pixels of the drawing; they are right only where these are the tile's width and
    /// height.
    pub pixels: Option<[u32; 2]>,
    /// Multiplied into the drawing.
    pub opacity: f32,
}

impl From<Color> for Paint {
    fn from(color: Color) -> Self {
        Self::Color(color)
    }
}

impl From<LinearGradient> for Paint {
    fn from(gradient: LinearGradient) -> Self {
        Self::Linear(Arc::new(gradient))
    }
}

impl From<RadialGradient> for Paint {
    fn from(gradient: RadialGradient) -> Self {
        Self::Radial(Arc::new(gradient))
    }
}

impl From<Pattern> for Paint {
    fn from(pattern: Pattern) -> Self {
        Self::Pattern(Arc::new(pattern))
    }
}
