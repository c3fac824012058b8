//! An orange leaf: its colour, and where it is (1) and is not (0). The stalk is at v = 0.

use super::canvas::{Grid, srgb};
use crate::assets::vector::smoothstep;

const GRID: Grid = Grid::new(128, 256, 3);

/// Half the leaf's width at height v, as a share of the texture's; nothing beyond the tip.
fn half_width(v: f64) -> f64 {
    let t = ((v - 0.12) / 0.85).clamp(0.0, 1.0);
    // Widest at two fifths, drawn out into the tip.
    let blade = 0.47 * libm::pow(4.0 * t * (1.0 - t), 0.75) * (1.22 - 0.55 * t);
    let scallop = 1.0 + 0.025 * libm::sin(t * 75.0);
    (blade * scallop).min(0.48)
}

fn inside(u: f64, v: f64) -> f64 {
    let x = (u - 0.5).abs();
    let stalk = if (0.0..0.2).contains(&v) { 0.028 - x } else { -1.0 };
    (half_width(v) - x).max(stalk)
}

pub(crate) fn leaf_alpha() -> Vec<u8> {
    GRID.grey(|u, v| if inside(u, v) > 0.0 { 1.0 } else { 0.0 })
}

pub(crate) fn leaf_colour() -> Vec<u8> {
    let (dark, light, vein) = (srgb(0x1f_51_1d), srgb(0x5d_93_35), srgb(0xb4_c5_72));
    GRID.colour(|u, v| {
        let x = u - 0.5;
        // Side veins leave the midrib upwards and bend towards the tip.
        let along = (v - 0.75 * x.abs() + 0.5 * x * x) * 9.0;
        let side = (along - along.round()).abs();
        let veins = (1.0 - smoothstep(0.012, 0.030, x.abs())).max(0.55 * (1.0 - smoothstep(0.05, 0.13, side)));
        let between = smoothstep(0.0, 0.5, side);
        dark.mixed(light, 0.25 + 0.35 * between).mixed(vein, veins)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_leaf_keeps_inside_its_picture() {
        for step in 0..=100 {
            let x = f64::from(step) / 100.0;
            assert!(inside(0.0, x) < 0.0 && inside(1.0, x) < 0.0 && inside(x, 1.0) <= 0.0);
        }
        assert!(inside(0.5, 0.5) > 0.3 && inside(0.5, 0.05) > 0.0);
    }
}
