//! Figures: lines, areas and labels in, an 8-bit picture out. Drawn by trigon itself, as an SVG picture.

use super::font;
use crate::failure::Failure;
use std::fmt::Write;
use trigon_image::{Color, Rgba8Image};
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, Options, View};

/// A figure in the making; coordinates are pixels from the top left.
pub(crate) struct Sketch {
    size: (u32, u32),
    elements: String,
}

/// Which point of a text is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Left,
    Middle,
}

impl Sketch {
    /// An empty figure.
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self { size: (width, height), elements: String::new() }
    }

    /// A line of text with its baseline at `y`; `capital_px` is the height of a capital.
    pub(crate) fn text(&mut self, [x, y]: [f64; 2], anchor: Anchor, capital_px: f64, color: &str, text: &str) {
        let width = font::width_px(text, capital_px);
        let left = match anchor {
            Anchor::Left => x,
            Anchor::Middle => x - 0.5 * width,
        };
        let pen = font::pen_px(capital_px);
        let paths = font::paths(text, left, y, capital_px);
        self.element(format_args!(
            "<g fill=\"none\" stroke=\"{color}\" stroke-width=\"{:.4}\" stroke-linecap=\"round\" \
             stroke-linejoin=\"round\">{paths}</g>",
            // Glyphs are scaled, and their pen with them.
            pen / (capital_px / 7.0)
        ));
    }

    /// A filled rectangle.
    pub(crate) fn rectangle(&mut self, [x, y, width, height]: [f64; 4], color: &str) {
        self.element(format_args!("<path fill=\"{color}\" d=\"M{x} {y}h{width}v{height}h{}z\"/>", -width));
    }

    /// The outline of a rectangle; half the line lies outside.
    pub(crate) fn frame(&mut self, [x, y, width, height]: [f64; 4], line_px: f64, color: &str) {
        self.element(format_args!(
            "<path fill=\"none\" stroke=\"{color}\" stroke-width=\"{line_px}\" d=\"M{x} {y}h{width}v{height}h{}z\"/>",
            -width
        ));
    }

    /// A straight line.
    pub(crate) fn line(&mut self, from: [f64; 2], to: [f64; 2], line_px: f64, color: &str) {
        let ([x0, y0], [x1, y1]) = (from, to);
        self.element(format_args!(
            "<path stroke=\"{color}\" stroke-width=\"{line_px}\" stroke-linecap=\"round\" d=\"M{x0} {y0}L{x1} {y1}\"/>"
        ));
    }

    /// A disc with an outline.
    pub(crate) fn disc(&mut self, [x, y]: [f64; 2], radius: f64, fill: &str, line_px: f64, line: &str) {
        self.element(format_args!(
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{line}\" stroke-width=\"{line_px}\"/>"
        ));
    }

    /// The outline of a polygon, cut off outside of the rectangle `clip`.
    pub(crate) fn polygon_outline(&mut self, corners: &[[f64; 2]], color: &str, line_px: f64, clip: [f64; 4]) {
        let points: String = corners.iter().map(|[x, y]| format!("{x},{y} ")).collect();
        let [x, y, width, height] = clip;
        let id = self.elements.len();
        self.element(format_args!(
            "<clipPath id=\"c{id}\"><path d=\"M{x} {y}h{width}v{height}h{}z\"/></clipPath><polygon clip-path=\"url(#c{id})\" \
             points=\"{points}\" fill=\"none\" stroke=\"{color}\" \
             stroke-width=\"{line_px}\" stroke-linejoin=\"round\"/>",
            -width
        ));
    }

    fn element(&mut self, element: std::fmt::Arguments<'_>) {
        // A string takes everything.
        let _ = self.elements.write_fmt(element);
    }

    /// The figure, transparent where nothing is.
    pub(crate) fn draw(&self) -> Result<Rgba8Image, Failure> {
        let (width, height) = self.size;
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\">{}</svg>",
            self.elements
        );
        let failed = |error: trigon_svg::svg::SvgError| Failure::work(format!("cannot draw the labels: {error}"));
        let document = Document::parse(text.as_bytes(), &Options::default()).map_err(failed)?;
        let renderer = Renderer::new();
        let (picture, _) = document.draw(&View::default(), &renderer, Color::TRANSPARENT).map_err(failed)?;
        Ok(picture.to_image())
    }
}

/// Height of a line of text, from baseline to baseline.
pub(crate) fn line_height(capital_px: f64) -> f64 {
    font::line_height(capital_px)
}

/// Width of a text in pixels.
pub(crate) fn text_width(text: &str, capital_px: f64) -> f64 {
    font::width_px(text, capital_px)
}
