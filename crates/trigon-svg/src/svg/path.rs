//! `usvg`'s geometry in the canvas's types.

use usvg::tiny_skia_path::{self, PathSegment};

use crate::canvas::{Path, PathElement, Transform};

/// The same outline.
pub(super) fn path(source: &tiny_skia_path::Path) -> Path {
    let point = |p: tiny_skia_path::Point| [p.x, p.y];
    source
        .segments()
        .map(|segment| match segment {
            PathSegment::MoveTo(p) => PathElement::MoveTo(point(p)),
            PathSegment::LineTo(p) => PathElement::LineTo(point(p)),
            PathSegment::QuadTo(p1, p) => PathElement::QuadTo(point(p1), point(p)),
            PathSegment::CubicTo(p1, p2, p) => PathElement::CubicTo(point(p1), point(p2), point(p)),
            PathSegment::Close => PathElement::Close,
        })
        .collect()
}

/// The same map.
pub(super) fn transform(source: usvg::Transform) -> Transform {
    let [a, b, c, d, e, f] = [source.sx, source.ky, source.kx, source.sy, source.tx, source.ty].map(f64::from);
    Transform::new(a, b, c, d, e, f)
}

/// The rectangle as a path.
pub(super) fn rect_path(rect: usvg::NonZeroRect) -> Path {
    Path::rect(rect.x(), rect.y(), rect.width(), rect.height())
}
