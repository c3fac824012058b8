//! Clip paths: the union of shapes, cut by further clip paths.

use super::{FillRule, Path, Transform};
use std::sync::Arc;

/// What may be drawn on: the samples inside any of `shapes` that are also inside `intersect`.
///
/// Each sample is in or out, by the same rule as a fill: a clip has no soft edge of its own, its pixels' samples do.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ClipPath {
    /// The shapes; none means nothing is drawn.
    pub shapes: Vec<ClipShape>,
    /// A further clip path on all of it (the `clip-path` of a `clipPath`).
    pub intersect: Option<Arc<ClipPath>>,
}

/// One shape of a clip path.
#[derive(Clone, PartialEq, Debug)]
pub struct ClipShape {
    /// The outline.
    pub path: Arc<Path>,
    /// What of it is inside.
    pub rule: FillRule,
    /// Pixels from path space.
    pub transform: Transform,
    /// A clip path on this shape alone.
    pub clip: Option<Arc<ClipPath>>,
}

impl ClipPath {
    /// A clip path of one shape.
    #[must_use]
    pub fn new(path: impl Into<Arc<Path>>, rule: FillRule, transform: Transform) -> Self {
        Self { shapes: vec![ClipShape { path: path.into(), rule, transform, clip: None }], intersect: None }
    }
}
