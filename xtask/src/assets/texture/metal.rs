//! Hammered metal: shallow round dents side by side, a ridge where two meet; repeats both ways.

use super::canvas::Grid;
use super::noise::Lattice;

pub(crate) fn metal_normal() -> Vec<u8> {
    Grid::new(256, 256, 1).normals(height)
}

fn height(u: f64, v: f64) -> f64 {
    const DENTS: Lattice = Lattice::new(7, 7, 3);
    let (distance, _) = DENTS.nearest_point(u, v);
    0.048 * distance * distance
}
