//! The display list: what is drawn, in order, kept until a renderer wants it.

use super::{BlendMode, FillRule, Image, ImageFilter, Layer, LayerImage, Paint, Path, Stroke, Transform};
use std::sync::Arc;

/// A recorded sequence of shapes and layers. It has no size: a [`Renderer`](super::Renderer) draws a part of it.
///
/// Transforms are pixels from path space. `opacity` is multiplied into the paint and taken as 0 to 1.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    items: Vec<Item>,
    has_crisp_edges: bool,
}

/// One step of a drawing.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    /// The inside of a path, or of its stroke.
    Shape(Box<Shape>),
    /// Pixels, unchanged, at whole pixels.
    Pixels { image: Arc<LayerImage>, opacity: f32, blend: BlendMode },
    /// The beginning of a layer.
    Push(Box<Layer>),
    /// The end of the last one that is open.
    Pop,
}

/// A painted shape.
#[derive(Clone, Debug)]
pub(crate) struct Shape {
    pub(crate) path: Arc<Path>,
    pub(crate) outline: Outline,
    pub(crate) transform: Transform,
    pub(crate) paint: Paint,
    pub(crate) opacity: f32,
    pub(crate) blend: BlendMode,
    pub(crate) has_crisp_edges: bool,
}

/// What of a path is painted.
#[derive(Clone, Debug)]
pub(crate) enum Outline {
    Fill(FillRule),
    Stroke(Stroke),
}

impl Drawing {
    /// Nothing drawn yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// True if nothing was recorded.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// From here on, a shape covers all samples of a pixel or none, as it covers the pixel's centre (`crispEdges`); or,
    /// as at the beginning, each sample for itself. Layers and clip paths keep their samples.
    pub fn set_crisp_edges(&mut self, crisp: bool) {
        self.has_crisp_edges = crisp;
    }

    /// Fills the inside of a path.
    pub fn fill(
        &mut self,
        path: impl Into<Arc<Path>>,
        rule: FillRule,
        transform: Transform,
        paint: impl Into<Paint>,
        opacity: f32,
        blend: BlendMode,
    ) {
        let (path, paint) = (path.into(), paint.into());
        self.push(Shape {
            path,
            outline: Outline::Fill(rule),
            transform,
            paint,
            opacity,
            blend,
            has_crisp_edges: self.has_crisp_edges,
        });
    }

    /// Draws the outline of a path; all of it at once, so that a translucent stroke does not double where it overlaps.
    pub fn stroke(
        &mut self,
        path: impl Into<Arc<Path>>,
        stroke: &Stroke,
        transform: Transform,
        paint: impl Into<Paint>,
        opacity: f32,
        blend: BlendMode,
    ) {
        let (path, paint) = (path.into(), paint.into());
        self.push(Shape {
            path,
            outline: Outline::Stroke(stroke.clone()),
            transform,
            paint,
            opacity,
            blend,
            has_crisp_edges: self.has_crisp_edges,
        });
    }

    /// Draws an image with its top left corner at the origin and one unit per pixel, before `transform`.
    pub fn image(&mut self, image: &Image, filter: ImageFilter, transform: Transform, opacity: f32, blend: BlendMode) {
        #[expect(clippy::cast_precision_loss, reason = "sides are at most 32,768")]
        let [width, height] = image.size().map(|side| side as f32);
        let paint = Paint::Image { image: image.clone(), filter, transform: Transform::IDENTITY };
        self.fill(Path::rect(0.0, 0.0, width, height), FillRule::NonZero, transform, paint, opacity, blend);
    }

    /// Draws pixels at whole pixels, without any sampling.
    pub fn pixels(&mut self, image: impl Into<Arc<LayerImage>>, opacity: f32, blend: BlendMode) {
        self.items.push(Item::Pixels { image: image.into(), opacity, blend });
    }

    /// Begins a layer: what follows, up to [`pop_layer`](Self::pop_layer), is one group.
    pub fn push_layer(&mut self, layer: Layer) {
        self.items.push(Item::Push(Box::new(layer)));
    }

    /// Ends the last layer that is open; without one, does nothing. Layers still open end with the drawing.
    pub fn pop_layer(&mut self) {
        self.items.push(Item::Pop);
    }

    pub(crate) fn items(&self) -> &[Item] {
        &self.items
    }

    fn push(&mut self, shape: Shape) {
        self.items.push(Item::Shape(Box::new(shape)));
    }
}
