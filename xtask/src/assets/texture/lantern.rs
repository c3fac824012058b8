//! The lantern: its lattice of hemp-leaf stars, cut out by an alpha map, and the light on the paper behind it.

use super::canvas::{Grid, Linear};
use super::relief::segment;
use crate::assets::vector::smoothstep;

/// 1 where there is wood, 0 in the openings; repeats both ways. The hemp-leaf pattern (asanoha) of Japanese
/// joinery: triangles, each cut in three from its centre.
pub(crate) fn lantern_lattice() -> Vec<u8> {
    Grid::new(192, 192, 4).grey(|u, v| if to_bar(u, v) < 0.034 { 1.0 } else { 0.0 })
}

/// The distance to the middle of the nearest bar, in sides of a triangle.
fn to_bar(u: f64, v: f64) -> f64 {
    // Two rows of triangles to a repeat, twice across, squeezed a little (2 / sqrt 3) to fit a square.
    let height = 3.0_f64.sqrt() / 2.0;
    let (x, y) = (u * 2.0, v * 4.0 * height * 0.5);
    // Fold into the rhombus of one upright and one hanging triangle, then into the upright one.
    let row = y / height;
    let skewed = x - row * 0.5;
    let (s, t) = (skewed - skewed.floor(), row - row.floor());
    let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
    let (x, y) = (s + t * 0.5, t * height);
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, height]];
    let centre = [0.5, height / 3.0];
    let mut nearest = f64::MAX;
    for (index, corner) in corners.iter().enumerate() {
        nearest = nearest.min(segment(x, y, *corner, corners[(index + 1) % 3]));
        nearest = nearest.min(segment(x, y, *corner, centre));
    }
    nearest
}

/// The glow of a candle behind paper: brightest a little below the middle, redder where it is weak.
pub(crate) fn lantern_glow() -> Vec<u8> {
    Grid::new(64, 128, 2).colour(|_, v| {
        let height = (v - 0.40) / 0.60;
        let light = (1.0 - smoothstep(0.0, 1.05, height.abs())) * 0.92 + 0.08;
        Linear([light, 0.62 * light * (0.55 + 0.45 * light), 0.26 * light * light])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lattice_repeats() {
        for step in 0..100 {
            let x = f64::from(step) / 100.0;
            assert!((to_bar(x, 0.3) - to_bar(x + 1.0, 0.3)).abs() < 1e-9);
            assert!((to_bar(0.3, x) - to_bar(0.3, x + 1.0)).abs() < 1e-9);
        }
    }
}
