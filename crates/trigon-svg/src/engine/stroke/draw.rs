//! The steps of a stroke: lines, dashes, polygons.

use super::dash::Dashes;
use super::hairline::{Hairline, transformed};
use super::outline::Outliner;
use super::polyline::{Polyline, PolylineSink};
use crate::canvas::{Path, Stroke, Transform};
use crate::engine::flatten::{LineSink, TOLERANCE, flatten};

/// Sends the polygons that make up the stroke of `path`, or of its wider double if it is a hairline.
pub(crate) fn stroke(
    path: &Path,
    style: &Stroke,
    hairline: Option<&Hairline>,
    transform: &Transform,
    sink: &mut impl LineSink,
) {
    let scale = transform.max_scale();
    let has_area = style.width > 0.0 && style.width.is_finite() && scale > 0.0 && scale.is_finite();
    if !has_area {
        return;
    }
    let tolerance = TOLERANCE / scale;
    let mut polylines = PolylineSink::default();
    flatten(path, &Transform::IDENTITY, tolerance, &mut polylines);
    let polylines = polylines.finish();
    let Some(hairline) = hairline else {
        let mut outliner = Outliner::new(style, tolerance, transform, sink);
        cut_into_dashes(&polylines, style, &mut |piece| outliner.draw(piece));
        return;
    };
    let mut outliner = Outliner::new(&hairline.style(style), TOLERANCE, &Transform::IDENTITY, sink);
    outliner.shorten_caps(hairline.reach());
    let mut in_pixels = Polyline::default();
    cut_into_dashes(&polylines, style, &mut |piece| {
        transformed(piece, transform, &mut in_pixels);
        outliner.draw(&in_pixels);
    });
}

/// Calls `draw` with each dash, or with each whole line if the style has no dashes.
fn cut_into_dashes(polylines: &[Polyline], style: &Stroke, draw: &mut impl FnMut(&Polyline)) {
    match Dashes::along(polylines, style) {
        None => polylines.iter().for_each(draw),
        Some(dashes) => {
            let mut piece = Polyline::default();
            for line in polylines {
                dashes.cut(line, &mut piece, draw);
            }
        }
    }
}
