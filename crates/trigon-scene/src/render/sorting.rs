//! Back to front: the order in which blended primitives are drawn.
//!
//! In: primitives and the view. Out: their indices, the farthest first. What is compared is the distance of centroids
//! along the view: exact where surfaces do not interpenetrate and are cut finely enough, which is all that a sort of
//! whole primitives can promise. Objects are sorted by the mean of their primitives, primitives within an object.

use super::frame::FrameUniforms;
use crate::math::{Mat4, vec3};

/// Indices of an object's primitives, sorted, and the mean distance.
pub(super) struct SortedPrimitives {
    pub(super) indices: Vec<u32>,
    pub(super) distance: f64,
}

/// Sorts primitives of `N` vertices each. Those of one distance keep their order.
pub(super) fn back_to_front<const N: usize>(
    positions: &[[f32; 3]],
    primitives: &[[u32; N]],
    world_from_model: &Mat4,
    frame: &FrameUniforms,
) -> SortedPrimitives {
    let mut keys: Vec<(f64, &[u32; N])> = primitives
        .iter()
        .map(|primitive| (distance(centroid(positions, primitive), world_from_model, frame), primitive))
        .collect();
    // NaN sorts as the farthest; such primitives are dropped later.
    keys.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let finite = || keys.iter().map(|(key, _)| *key).filter(|key| key.is_finite());
    let count = finite().count().max(1);
    #[expect(clippy::cast_precision_loss, reason = "a mean need not be exact")]
    let distance = finite().sum::<f64>() / count as f64;
    SortedPrimitives { indices: keys.into_iter().flat_map(|(_, primitive)| *primitive).collect(), distance }
}

fn centroid<const N: usize>(positions: &[[f32; 3]], primitive: &[u32; N]) -> vec3::Vec3 {
    let mut sum = [0.0; 3];
    for &vertex in primitive {
        let position = usize::try_from(vertex).ok().and_then(|i| positions.get(i)).copied().unwrap_or_default();
        sum = vec3::add(sum, vec3::widen(position));
    }
    #[expect(clippy::cast_precision_loss, reason = "one, two or three vertices")]
    vec3::scale(sum, 1.0 / N as f64)
}

/// The distance from the eye, or along the view where the eye is infinitely far.
fn distance(model: vec3::Vec3, world_from_model: &Mat4, frame: &FrameUniforms) -> f64 {
    let [x, y, z, _] = world_from_model.transform_point(model);
    let [ex, ey, ez, w] = frame.eye;
    let eye = vec3::widen([ex, ey, ez]);
    if w == 0.0 { -vec3::dot([x, y, z], eye) } else { vec3::length(vec3::sub([x, y, z], eye)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::RenderSettings;
    use crate::scene::{Camera, Projection, Scene};

    #[test]
    fn farthest_first_in_both_projections() {
        let positions = [[0.0, 0.0, 1.0], [0.0, 0.0, -5.0], [0.0, 0.0, 3.0]];
        let points = [[0], [1], [2]];
        for projection in [Projection::default(), Projection::Orthographic { height: 2.0 }] {
            let camera = Camera {
                eye: [0.0, 0.0, 10.0],
                target: [0.0; 3],
                up: [0.0, 1.0, 0.0],
                projection,
                near: 1.0,
                far: 20.0,
            };
            let frame = FrameUniforms::new(&Scene::default(), &camera, &RenderSettings::new(8, 8));
            let sorted = back_to_front(&positions, &points, &Mat4::IDENTITY, &frame);
            assert_eq!(sorted.indices, [1, 0, 2]);
        }
    }
}
