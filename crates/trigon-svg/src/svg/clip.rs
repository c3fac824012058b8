//! `clip-path`: the shapes of a `clipPath` in pixels.

use std::sync::Arc;

use super::paint::fill_rule;
use super::path::{path, transform};
use crate::canvas::{ClipPath, ClipShape, Transform};

/// The clip path, for an element drawn by `pixels_from_user`.
pub(super) fn clip_path(source: &usvg::ClipPath, pixels_from_user: Transform) -> ClipPath {
    let mut shapes = Vec::new();
    gather(source.root(), pixels_from_user * transform(source.transform()), None, &mut shapes);
    let intersect = source.clip_path().map(|outer| Arc::new(clip_path(outer, pixels_from_user)));
    ClipPath { shapes, intersect }
}

/// Adds what a group of a `clipPath` holds; `clip` is that of the groups around it.
fn gather(group: &usvg::Group, pixels_from_group: Transform, clip: Option<&Arc<ClipPath>>, out: &mut Vec<ClipShape>) {
    for child in group.children() {
        match child {
            usvg::Node::Path(shape) => {
                if let (true, Some(fill)) = (shape.is_visible(), shape.fill()) {
                    out.push(ClipShape {
                        path: Arc::new(path(shape.data())),
                        rule: fill_rule(fill.rule()),
                        transform: pixels_from_group,
                        clip: clip.cloned(),
                    });
                }
            }
            usvg::Node::Text(text) => gather(text.flattened(), pixels_from_group, clip, out),
            usvg::Node::Group(inner) => {
                let pixels_from_inner = pixels_from_group * transform(inner.transform());
                let own = inner.clip_path().map(|own| {
                    let own = clip_path(own, pixels_from_inner);
                    Arc::new(clip.map_or_else(|| own.clone(), |around| both(&own, around)))
                });
                gather(inner, pixels_from_inner, own.as_ref().or(clip), out);
            }
            usvg::Node::Image(_) => {}
        }
    }
}

/// The clip path of what is inside both.
fn both(inner: &ClipPath, outer: &Arc<ClipPath>) -> ClipPath {
    let intersect = match &inner.intersect {
        Some(further) => Arc::new(both(further, outer)),
        None => Arc::clone(outer),
    };
    ClipPath { shapes: inner.shapes.clone(), intersect: Some(intersect) }
}
