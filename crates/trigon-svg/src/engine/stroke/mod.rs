//! Strokes: a path and a pen in, polygons out whose union is the stroke.
//!
//! The path becomes polylines ([`polyline`]), dashes cut them ([`dash`]), and each is drawn as quads along its segments
//! with a wedge at each corner and a cap at each end ([`outline`]). All polygons turn the same way round, so by the
//! non-zero rule nothing is ever cancelled, however tight the turns. All of it happens before the transform, which may
//! stretch the pen; but [`hairline`]s, which no map makes wide, are drawn after it.

mod dash;
mod draw;
mod hairline;
mod outline;
mod polyline;

pub(crate) use draw::{StrokeMemory, stroke};
pub(crate) use hairline::Hairline;
