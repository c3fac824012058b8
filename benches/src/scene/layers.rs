//! `fill_ftb` and `fill_btf`: fill rate. Parallel tilted quads that overfill the view, front to back or back to front.

use super::grid::Mesh;
use super::orbit::half_view_at_origin;
use trigon::math::host::{cos, sin};

/// How many quads.
const LAYERS: u8 = 16;

/// Which quad is drawn first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum LayerOrder {
    FrontToBack,
    BackToFront,
}

/// Sixteen quads, tilted by 10 degrees about y, for a picture of `size` pixels.
pub(super) fn build(size: [u32; 2], order: LayerOrder) -> Mesh {
    let [half_width, half_height] = half_view_at_origin(size);
    let tilt = 10.0f32.to_radians();
    let (s, c) = (sin(tilt), cos(tilt));
    let mut mesh = Mesh::default();
    for drawn in 0..LAYERS {
        let depth = match order {
            LayerOrder::FrontToBack => f32::from(drawn),
            LayerOrder::BackToFront => f32::from(LAYERS - 1 - drawn),
        };
        let z = 0.5 - depth / f32::from(LAYERS);
        let base = 4 * u32::from(drawn);
        for [side, up] in [[-1.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]] {
            let (x, y) = (side * 2.0 * half_width, up * 2.0 * half_height);
            mesh.positions.push([x * c, y, z - x * s]);
            mesh.normals.push([s, 0.0, c]);
            mesh.uvs.push([0.82 * x + 0.37 * depth, 0.82 * y]);
        }
        mesh.triangles.extend([[base, base + 2, base + 1], [base + 1, base + 2, base + 3]]);
    }
    mesh
}
