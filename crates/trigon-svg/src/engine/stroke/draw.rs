//! The steps of a stroke: lines, dashes, polygons.

use super::dash::Dashes;
use super::outline::Outliner;
use super::polyline::{Polyline, PolylineSink};
use crate::canvas::{Path, Stroke, Transform};
use crate::engine::flatten::{LineSink, TOLERANCE, flatten};

/// Sends the polygons that make up the stroke of `path`.
pub(crate) fn stroke(path: &Path, style: &Stroke, transform: &Transform, sink: &mut impl LineSink) {
    let scale = transform.max_scale();
    let has_area = style.width > 0.0 && style.width.is_finite() && scale > 0.0 && scale.is_finite();
    if !has_area {
        return;
    }
    let tolerance = TOLERANCE / scale;
    let mut polylines = PolylineSink::default();
    flatten(path, &Transform::IDENTITY, tolerance, &mut polylines);
    let polylines = polylines.finish();
    let mut outliner = Outliner::new(style, tolerance, transform, sink);
    match Dashes::along(&polylines, style) {
        None => polylines.iter().for_each(|line| outliner.draw(line)),
        Some(dashes) => {
            let mut piece = Polyline::default();
            for line in &polylines {
                dashes.cut(line, &mut piece, &mut |piece| outliner.draw(piece));
            }
        }
    }
}
