//! The table's wood: four oiled planks, grain along u; repeats both ways.

use super::canvas::{Grid, Linear, srgb};
use super::noise::{Lattice, chance};
use crate::assets::vector::smoothstep;

const PLANKS: i32 = 4;

pub(crate) fn wood_colour() -> Vec<u8> {
    Grid::new(512, 512, 2).toned(40, palette, tone)
}

/// From the dark of a joint over brown to honey.
fn palette(tone: f64) -> Linear {
    let stops = [(0.0, srgb(0x2a_16_0c)), (0.25, srgb(0x6b_3f_20)), (0.6, srgb(0x9c_66_38)), (1.0, srgb(0xc9_98_62))];
    let next = stops.iter().position(|(at, _)| tone <= *at).unwrap_or(stops.len() - 1).max(1);
    let ((low, dark), (high, light)) = (stops[next - 1], stops[next]);
    dark.mixed(light, ((tone - low) / (high - low)).clamp(0.0, 1.0))
}

fn tone(u: f64, v: f64) -> f64 {
    let across = v * f64::from(PLANKS);
    let plank = whole(across);
    let y = across - across.floor();
    let shade = 0.12 * (chance(plank, 0, 11) - 0.5);
    // Each plank shows another part of the tree: its own centre of the rings, its own waves.
    let shift = chance(plank, 1, 11);
    let bend = Lattice::new(3, 8, 21).fractal(2, u + shift, v);
    let rings = (y - 0.2 - 0.6 * chance(plank, 2, 11)).abs() * 5.0 + bend * 4.5;
    let ring = rings - rings.floor();
    // Early wood darkens slowly into late wood, which ends at once.
    let late = smoothstep(0.25, 0.92, ring) * (1.0 - smoothstep(0.94, 1.0, ring));
    let fibre = Lattice::new(6, 160, 31).fractal(2, u + shift * 3.0, v) - 0.5;
    let pores = smoothstep(0.66, 0.86, Lattice::new(14, 230, 41).noise(u + shift, v));
    let wood = 0.74 + shade - 0.24 * late + 0.26 * fibre - 0.18 * pores;
    wood * (1.0 - joint(u, y, plank))
}

/// How much of the spot is the dark of a joint: between planks, and once across each.
fn joint(u: f64, y: f64, plank: i32) -> f64 {
    let side = y.min(1.0 - y) / f64::from(PLANKS);
    let end = u - [0.13, 0.63, 0.37, 0.88][plank.rem_euclid(PLANKS).cast_unsigned() as usize];
    let end = (end - end.round()).abs();
    0.85 * (1.0 - smoothstep(0.0012, 0.0042, side.min(end)))
}

#[expect(clippy::cast_possible_truncation, reason = "the number of a plank")]
fn whole(x: f64) -> i32 {
    (x.floor() as i32).rem_euclid(PLANKS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_repeats() {
        for step in 0..500 {
            let x = chance(step, 9, 9);
            assert!((tone(x, 1e-9) - tone(x + 1.0, 1.0 + 1e-9)).abs() < 1e-5);
            assert!((tone(-1e-9, x) - tone(1.0 - 1e-9, x)).abs() < 1e-5);
        }
    }
}
