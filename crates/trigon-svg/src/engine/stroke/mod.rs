//! Strokes: a path and a pen in, polygons out whose union is the stroke.
//!
//! The path becomes polylines ([`polyline`]), dashes cut them ([`dash`]), and each is drawn as quads along its segments
//! with a wedge at each corner and a cap at each end ([`outline`]). All polygons turn the same way round, so by the
//! non-zero rule nothing is ever cancelled, however tight the turns. All of it happens before the transform, which may
//! stretch the pen.

mod dash;
mod outline;
mod polyline;

use super::flatten::{LineSink, TOLERANCE, flatten};
use crate::canvas::{Path, Stroke, Transform};
use outline::Outliner;
use polyline::{Polyline, PolylineSink};

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
    match dash::Dashes::new(style) {
        None => polylines.iter().for_each(|line| outliner.draw(line)),
        Some(dashes) => {
            let mut piece = Polyline::default();
            for line in &polylines {
                dashes.cut(line, &mut piece, &mut |piece| outliner.draw(piece));
            }
        }
    }
}
