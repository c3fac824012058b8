//! What is said of a triangle: its names, and what came of it.

use trigon::pipeline::{Outcome, TriangleStory};
use trigon::raster::{DepthCompare, DepthTest};
use trigon::resolve::Blend;
use trigon_scene::render::{DrawLabel, SceneStory};

/// The number of a triangle in the list of its mesh.
pub(super) fn number_in_mesh(story: &SceneStory, triangle: &TriangleStory) -> u32 {
    triangle.primitive + label(story, triangle).map_or(0, |label| label.first_primitive)
}

/// What its draw is called.
pub(super) fn label<'s>(story: &'s SceneStory, triangle: &TriangleStory) -> Option<&'s DrawLabel> {
    story.draws.get(usize::try_from(triangle.draw).ok()?)
}

/// What of a mesh it is, and the names of object, group and material, as far as they have some.
pub(super) fn names(story: &SceneStory, triangle: &TriangleStory) -> String {
    let Some(label) = label(story, triangle) else { return String::new() };
    let material = label.material.as_deref().unwrap_or("");
    let parts = [("object", label.object.as_str()), ("group", label.group.as_str()), ("material", material)];
    let named = parts.iter().filter(|(_, name)| !name.is_empty()).map(|(what, name)| format!("{what} {name}"));
    let names = named.collect::<Vec<_>>().join(", ");
    // Lines and points are drawn as triangles of their own.
    let kind = match triangle.vertices {
        [a, b, c] if a == b && b == c => "a point",
        [a, _, c] if a == c => "a line",
        _ => return names,
    };
    if names.is_empty() { kind.to_owned() } else { format!("{kind} of {names}") }
}

pub(super) fn outcome(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Outside => "outside",
        Outcome::Hidden => "hidden",
        Outcome::Discarded => "discarded",
        Outcome::Drawn => "drawn",
    }
}

pub(super) fn blend(blend: Blend) -> &'static str {
    match blend {
        Blend::Replace => "replace",
        Blend::Over => "over",
        Blend::Add => "add",
        Blend::Multiply => "multiply",
    }
}

pub(super) fn compare(test: DepthTest) -> &'static str {
    match test.compare {
        DepthCompare::Nearer => "nearer",
        DepthCompare::NearerOrEqual => "nearer or equal",
        DepthCompare::Always => "always",
    }
}

/// The samples with this outcome.
pub(super) fn samples_with(triangle: &TriangleStory, outcome: Outcome) -> Vec<usize> {
    triangle.tests.iter().enumerate().filter(|(_, test)| test.outcome == outcome).map(|(s, _)| s).collect()
}

/// The samples whose colour comes from the triangle with this number, alone or blended: those that it was shaded for.
pub(super) fn samples_shaded(story: &SceneStory, number: usize) -> Vec<usize> {
    let own = story.pixel.fragments.iter().filter(|fragment| fragment.triangle == number && fragment.color.is_some());
    samples_of(own.fold(0, |mask, fragment| mask | fragment.samples))
}

/// Numbers, rising, as `0 to 15`, `3`, `0 2 3`, `0 to 13, 15` or `none`.
pub(super) fn listed(numbers: &[usize]) -> String {
    if numbers.is_empty() {
        return "none".to_owned();
    }
    let runs = || numbers.chunk_by(|a, b| a + 1 == *b);
    let is_long = |run: &[usize]| run.len() > 2;
    let separator = if runs().any(is_long) { ", " } else { " " };
    let written = runs().flat_map(|run| match run {
        [first, .., last] if is_long(run) => vec![format!("{first} to {last}")],
        _ => run.iter().map(ToString::to_string).collect(),
    });
    written.collect::<Vec<_>>().join(separator)
}

/// The samples of a mask, one bit each.
pub(super) fn samples_of(mask: u32) -> Vec<usize> {
    (0..32).filter(|s| mask >> s & 1 == 1).collect()
}

/// The weights of the corners by area in the framebuffer, without perspective, at a point in pixels; by vertex.
///
/// `None` where corners are not vertices.
pub(super) fn linear_weights(triangle: &TriangleStory, point: [f32; 2]) -> Option<[f64; 3]> {
    let [a, b, c] = triangle.corners.map(|corner| corner.map(|value| f64::from(value) / 256.0));
    let p = point.map(f64::from);
    let area =
        |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]| (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    let whole = area(a, b, c);
    let mut by_corner = [area(p, b, c), area(a, p, c), area(a, b, p)].map(|part| part / whole);
    if triangle.is_clipped || triangle.vertices[0] == triangle.vertices[2] {
        return None;
    }
    let weights = by_corner;
    for (k, weight) in weights.into_iter().enumerate() {
        by_corner[triangle.vertex_of_corner[k]] = weight;
    }
    Some(by_corner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_short() {
        assert_eq!(listed(&[]), "none");
        assert_eq!(listed(&[4]), "4");
        assert_eq!(listed(&[0, 1]), "0 1");
        assert_eq!(listed(&[0, 1, 2, 3]), "0 to 3");
        assert_eq!(listed(&[0, 2, 3]), "0 2 3");
        assert_eq!(listed(&[0, 1, 2, 3, 5, 8, 9, 10]), "0 to 3, 5, 8 to 10");
        assert_eq!(samples_of(0b1011), [0, 1, 3]);
    }
}
