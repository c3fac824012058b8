//! Hairlines: strokes too thin for the samples to hit evenly are drawn wider, and fainter by as much.
//!
//! In: a stroke's style and its map to pixels. Out: the width to draw it with and the factor for its opacity, if it needs
//! any. Samples lie `1 / sqrt(n)` px apart; a line thinner than that is hit here and missed there, and falls into
//! speckles. So no line is drawn thinner than [`least_width`], two sample columns: half a pixel with 16 samples. A line of
//! width w then has the opacity w / least width, which leaves the light that it takes from each pixel what it was, on
//! average. Analytic rasterizers do the same below one pixel (Skia, `SkDrawTreatAsHairline`). Measured against exact
//! areas with 16 samples, the error of half a pixel is half of theirs, and not above that of wider lines.

use super::polyline::Polyline;
use crate::canvas::{Join, Stroke, Transform};

/// The miter limit of hairlines: right angles stay pointed, sharper corners do not reach further than wide ones would.
const MITER_LIMIT: f32 = 1.5;

/// How a thin stroke is drawn instead.
pub(crate) struct Hairline {
    /// In pixels.
    width: f64,
    /// The opacity of what is drawn: the part of `width` that the stroke really has.
    pub(crate) opacity: f64,
}

/// The thinnest line that is drawn as it is, in pixels, with this many samples per pixel.
fn least_width(samples: usize) -> f64 {
    (2.0 / (samples as f64).sqrt()).min(1.0)
}

impl Hairline {
    /// `None` for a stroke that is wide enough in some direction, or none at all.
    pub(crate) fn of(style: &Stroke, transform: &Transform, samples: usize) -> Option<Self> {
        let (width, stroke_width) = (least_width(samples), f64::from(style.width));
        let widest = stroke_width * transform.max_scale();
        let is_thin = stroke_width > 0.0 && widest < width;
        // Where the map stretches the pen, the mean of its two widths.
        let mean_width = stroke_width * transform.determinant().abs().sqrt();
        is_thin.then_some(Self { width, opacity: mean_width / width })
    }

    /// The style of the wider stroke, in pixels. Dashes are cut before, in the units of the path.
    pub(super) fn style(&self, style: &Stroke) -> Stroke {
        let join = match style.join {
            Join::Miter { .. } | Join::MiterClip { .. } => Join::Miter { limit: MITER_LIMIT },
            join => join,
        };
        Stroke { width: self.width as f32, join, ..Stroke::new(0.0) }.with_cap(style.cap)
    }

    /// How far caps reach beyond the ends, in pixels. The line is wider than it should be and its caps are not: then
    /// they too have the light that they should have.
    pub(super) fn reach(&self) -> f64 {
        0.5 * self.width * self.opacity
    }
}

/// Moves the points of a polyline to pixels.
pub(super) fn transformed(line: &Polyline, transform: &Transform, out: &mut Polyline) {
    out.clear();
    out.is_closed = line.is_closed;
    for vertex in &line.vertices {
        let mut vertex = *vertex;
        vertex.point = transform.apply(vertex.point);
        out.push(vertex);
    }
    // Points that have become one.
    let ends_meet =
        out.vertices.len() > 1 && out.vertices.first().map(|v| v.point) == out.vertices.last().map(|v| v.point);
    if out.is_closed && ends_meet {
        out.vertices.pop();
    }
}
