//! `big`: triangle throughput. A bumpy sphere of a million triangles, most of them smaller than a pixel or two.

use super::grid::{Mesh, PatchPoint};
use core::f32::consts::PI;
use trigon::math::host::{cos, sin};

/// 1024 x 512 quads around the globe; the radius waves in longitude and colatitude.
pub(super) fn build() -> Mesh {
    let mut mesh = Mesh::default();
    mesh.push_patch(1024, 512, |a, b| {
        let (longitude, colatitude) = (2.0 * PI * a, PI * b);
        let radius = 0.85 + 0.1 * sin(7.0 * longitude) * sin(5.0 * colatitude);
        let from_axis = radius * sin(colatitude);
        let position = [from_axis * sin(longitude), radius * cos(colatitude), from_axis * cos(longitude)];
        PatchPoint { position, uv: [a, b] }
    });
    mesh
}
