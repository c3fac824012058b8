//! The skin of an orange as heights: pores of several sizes; repeats both ways.

use super::canvas::Grid;
use super::noise::Lattice;
use crate::assets::vector::smoothstep;

pub(crate) fn peel_height() -> Vec<u8> {
    Grid::new(128, 128, 2).grey(height)
}

/// 1 on the skin, lower in a pore.
fn height(u: f64, v: f64) -> f64 {
    const PORES: Lattice = Lattice::new(13, 13, 5);
    let (distance, size) = PORES.nearest_point(u, v);
    1.0 - (0.45 + 0.4 * size) * (1.0 - smoothstep(0.05, 0.30 + 0.25 * size, distance))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_use_the_range_of_a_texel() {
        let heights: Vec<f64> =
            (0..10_000).map(|i| height(f64::from(i % 100) / 100.0, f64::from(i / 100) / 100.0)).collect();
        assert!(heights.iter().all(|height| (0.0..=1.0).contains(height)));
        assert!(heights.iter().any(|height| *height > 0.99) && heights.iter().any(|height| *height < 0.4));
    }
}
