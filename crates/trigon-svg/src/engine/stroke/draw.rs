//! The steps of a stroke: lines, dashes, polygons.

use super::dash::Dashes;
use super::hairline::{Hairline, transformed};
use super::outline::Outliner;
use super::polyline::{Polyline, PolylineSink};
use crate::canvas::{Path, Stroke, Transform};
use crate::engine::flatten::{LineSink, TOLERANCE, flatten};

/// Memory that strokes are made in, one after the other.
#[derive(Default)]
pub(crate) struct StrokeMemory {
    lines: PolylineSink,
    /// A dash.
    piece: Polyline,
    /// A piece of a hairline, in pixels.
    in_pixels: Polyline,
    /// The two sides of a strip.
    sides: [Vec<[f64; 2]>; 2],
}

/// Sends the polygons that make up the stroke of `path`, or of its wider double if it is a hairline.
pub(crate) fn stroke(
    path: &Path,
    style: &Stroke,
    hairline: Option<&Hairline>,
    transform: &Transform,
    memory: &mut StrokeMemory,
    sink: &mut impl LineSink,
) {
    let scale = transform.max_scale();
    let has_area = style.width > 0.0 && style.width.is_finite() && scale > 0.0 && scale.is_finite();
    if !has_area {
        return;
    }
    let tolerance = TOLERANCE / scale;
    let StrokeMemory { lines, piece, in_pixels, sides } = memory;
    lines.restart();
    flatten(path, &Transform::IDENTITY, tolerance, lines);
    let lines = lines.finish();
    let Some(hairline) = hairline else {
        let mut outliner = Outliner::new(style, tolerance, transform, sides, sink);
        cut_into_dashes(lines, style, piece, &mut |piece| outliner.draw(piece));
        return;
    };
    let mut outliner = Outliner::new(&hairline.style(style), TOLERANCE, &Transform::IDENTITY, sides, sink);
    outliner.shorten_caps(hairline.reach());
    cut_into_dashes(lines, style, piece, &mut |piece| {
        transformed(piece, transform, in_pixels);
        outliner.draw(in_pixels);
    });
}

/// Calls `draw` with each dash, or with each whole line if the style has no dashes.
fn cut_into_dashes(lines: &[Polyline], style: &Stroke, piece: &mut Polyline, draw: &mut impl FnMut(&Polyline)) {
    match Dashes::along(lines, style) {
        None => lines.iter().for_each(draw),
        Some(dashes) => lines.iter().for_each(|line| dashes.cut(line, piece, draw)),
    }
}
