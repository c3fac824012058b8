//! The teapot's glaze: cobalt blue and gold on white, in bands that go around it.
//!
//! One picture holds the bands of all parts, one above the other in v: the wall (0 to 0.61), the lid (0.62 to 0.83)
//! and handle and spout (0.87 to 0.985). It repeats in u, eight times around the wall. The same drawing gives the
//! colour, the specular colour (gold shines in its own) and the exponent (gold has broader highlights).

use super::canvas::{Grid, Linear, srgb};
use crate::assets::vector::smoothstep;

const GRID: Grid = Grid::new(256, 512, 4);

/// What a spot is painted with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Paint {
    White,
    Sky,
    Cobalt,
    Gold,
}

pub(crate) fn glaze_colour() -> Vec<u8> {
    let [white, sky, cobalt, gold] = [srgb(0xf3_ef_e4), srgb(0x86_a9_d6), srgb(0x1b_36_86), srgb(0xb0_7d_2c)];
    GRID.colour(|u, v| match paint(u, v) {
        Paint::White => white,
        Paint::Sky => sky,
        Paint::Cobalt => cobalt,
        Paint::Gold => gold,
    })
}

pub(crate) fn glaze_specular() -> Vec<u8> {
    let (glass, gold) = (Linear([0.42; 3]), Linear([1.0, 0.72, 0.30]));
    GRID.colour(|u, v| if paint(u, v) == Paint::Gold { gold } else { glass })
}

pub(crate) fn glaze_exponent() -> Vec<u8> {
    GRID.grey(|u, v| if paint(u, v) == Paint::Gold { 0.25 } else { 1.0 })
}

/// Edges of plain rings, from the foot up, and what they are painted with.
const RINGS: [(f64, f64, Paint); 14] = [
    (0.0, 0.072, Paint::Cobalt),
    (0.072, 0.086, Paint::Gold),
    (0.212, 0.219, Paint::Cobalt),
    (0.227, 0.231, Paint::Cobalt),
    (0.459, 0.463, Paint::Cobalt),
    (0.471, 0.478, Paint::Cobalt),
    (0.484, 0.494, Paint::Gold),
    (0.572, 0.577, Paint::Cobalt),
    (0.584, 0.632, Paint::Gold),
    (0.642, 0.648, Paint::Cobalt),
    (0.752, 0.768, Paint::Cobalt),
    (0.768, 0.780, Paint::Gold),
    (0.780, 0.815, Paint::Cobalt),
    (0.815, 0.845, Paint::Gold),
];

fn paint(u: f64, v: f64) -> Paint {
    if let Some((_, _, paint)) = RINGS.iter().find(|(low, high, _)| (*low..*high).contains(&v)) {
        return *paint;
    }
    match v {
        0.095..0.205 => petals(u, (v - 0.095) / 0.11),
        0.235..0.455 => lozenges(u, (v - 0.345) / 0.21),
        0.502..0.565 => meander(u, (v - 0.502) / 0.063),
        0.655..0.748 => petals(u, (v - 0.655) / 0.093),
        0.86.. => vine(u, (v - 0.87) / 0.115),
        _ => Paint::White,
    }
}

/// Two pointed petals in a repeat, standing on y = 0 and meeting the ring above at y = 1.
fn petals(u: f64, y: f64) -> Paint {
    let x = (fract(2.0 * u) - 0.5).abs();
    let half_width = 0.49 * (1.0 - y * y * (0.35 + 0.65 * y));
    let inside = half_width - x;
    match inside {
        ..0.0 => Paint::Cobalt,
        0.0..0.06 => Paint::White,
        0.06..0.11 => Paint::Cobalt,
        // A vein in the middle of each petal.
        _ if x < 0.035 && y > 0.12 && y < 0.62 => Paint::White,
        _ if y < 0.75 => Paint::Sky,
        _ => Paint::White,
    }
}

/// One lozenge in a repeat with a flower inside, fans in the corners between, and a gold bead where two meet.
fn lozenges(u: f64, y: f64) -> Paint {
    const WIDTH: f64 = 1.43;
    let x = (fract(u) - 0.5) * WIDTH;
    let diamond = 1.0 - x.abs() / (WIDTH / 2.0) - y.abs() / 0.5;
    let (bead_x, fan_y) = (WIDTH / 2.0 - x.abs(), 0.5 - y.abs());
    let bead = radius(bead_x, y);
    let fan = radius(bead_x, fan_y);
    match diamond {
        _ if bead < 0.055 => Paint::Gold,
        _ if bead < 0.085 => Paint::Cobalt,
        0.06..0.13 => Paint::Cobalt,
        0.18..0.205 => Paint::Cobalt,
        0.205.. => flower(x, y),
        _ => match fan {
            ..0.09 => Paint::Gold,
            0.09..0.13 => Paint::Cobalt,
            0.13..0.24 => Paint::Sky,
            0.24..0.28 => Paint::Cobalt,
            // Rays around the fan.
            _ if fan < 0.36 && fract(libm::atan2(fan_y, bead_x) * 10.0 / std::f64::consts::PI + 0.25) < 0.5 => {
                Paint::Cobalt
            }
            _ => Paint::White,
        },
    }
}

/// Eight petals around a gold heart.
fn flower(x: f64, y: f64) -> Paint {
    let (r, angle) = (radius(x, y), libm::atan2(y, x));
    // Long petals along the axes of the lozenge, short ones between.
    let lobe = libm::cos(4.0 * angle).abs();
    let reach = 0.12 + 0.17 * lobe + 0.10 * smoothstep(0.6, 1.0, libm::cos(2.0 * angle)) * lobe;
    match r {
        ..0.050 => Paint::Gold,
        0.050..0.075 => Paint::Cobalt,
        _ if r < reach - 0.05 => Paint::Cobalt,
        _ if r < reach => Paint::Sky,
        _ => Paint::White,
    }
}

/// The Greek key, three in a repeat.
fn meander(u: f64, y: f64) -> Paint {
    const KEY: [&[u8; 8]; 7] =
        [b"########", b"#       ", b"# ##### ", b"# #   # ", b"# ### # ", b"#     # ", b"####### "];
    let row = index((1.0 - y) * 7.0, 7);
    let column = index(fract(3.0 * u) * 8.0, 8);
    if KEY[row][column] == b'#' { Paint::Cobalt } else { Paint::White }
}

/// A stem that winds along handle and spout, with a leaf at each bend; y = 1 is their ridge.
fn vine(u: f64, y: f64) -> Paint {
    let u = fract(u);
    let stem = 0.48 + 0.17 * libm::sin(u * std::f64::consts::TAU);
    // Two leaves in a repeat, at the bends, pointing back across the stem.
    let leaf = |centre_u: f64, centre_y: f64, lean: f64| {
        let (x, y) = ((u - centre_u) / 0.17, (y - centre_y - lean * (u - centre_u)) / 0.16);
        1.0 - x * x - y.abs() * (1.0 + x * x)
    };
    let blade = leaf(0.25, 0.34, 0.5).max(leaf(0.75, 0.64, -0.5));
    match y {
        0.90.. => Paint::Cobalt,
        0.85..0.875 => Paint::Cobalt,
        0.06..0.085 => Paint::Cobalt,
        ..0.03 => Paint::Cobalt,
        _ if (y - stem).abs() < 0.035 => Paint::Cobalt,
        _ if blade > 0.35 => Paint::Sky,
        _ if blade > 0.0 => Paint::Cobalt,
        _ => Paint::White,
    }
}

fn radius(x: f64, y: f64) -> f64 {
    (x * x + y * y).sqrt()
}

fn fract(x: f64) -> f64 {
    x - x.floor()
}

/// The cell of `x` among `count`.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to a small count")]
fn index(x: f64, count: u8) -> usize {
    x.clamp(0.0, f64::from(count - 1)) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_repeat_has_no_seam() {
        for step in 0..1000 {
            let v = f64::from(step) / 1000.0;
            assert_eq!(paint(1e-7, v), paint(1.0 + 1e-7, v));
            // Where a pattern is the same on both sides of its axis, both ends of the repeat meet.
            if !(0.502..0.565).contains(&v) {
                assert_eq!(paint(1e-7, v), paint(1.0 - 1e-7, v), "at v = {v}");
            }
        }
    }
}
