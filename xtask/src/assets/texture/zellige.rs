//! The tile under the teapot: an eight-pointed star in relief, each field in its own glaze.

use super::canvas::{Grid, Linear, srgb};
use super::relief::{raised, star};

const BEVEL: f64 = 0.014;

/// A field of the tile at (u, v): how far inside its outline, and its glaze.
fn field(u: f64, v: f64) -> (f64, Linear) {
    let (x, y) = (u - 0.5, v - 0.5);
    let gap = 0.010;
    let border = x.abs().max(y.abs());
    let frame = (0.5 - border).min(border - 0.445);
    let centre = star(x, y, 0.11);
    let middle = star(x, y, 0.225).min(-star(x, y, 0.125));
    // Quarter stars in the corners, and what lies between them.
    let corner = star(0.445 - x.abs(), 0.445 - y.abs(), 0.115).min(0.43 - border);
    let ground = (-star(x, y, 0.24)).min(-star(0.445 - x.abs(), 0.445 - y.abs(), 0.13)).min(0.43 - border);
    let fields = [
        (frame, srgb(0x1f_4d_54)),
        (centre, srgb(0xd9_9a_35)),
        (middle, srgb(0x1f_7a_78)),
        (corner, srgb(0xb6_4b_2d)),
        (ground, srgb(0xe4_d9_bd)),
    ];
    let nearest = fields.into_iter().fold((f64::MIN, srgb(0)), |best, next| if next.0 > best.0 { next } else { best });
    (nearest.0 - gap * 0.3, nearest.1)
}

pub(crate) fn zellige_colour() -> Vec<u8> {
    let mortar = srgb(0x4a_3a_2c);
    Grid::new(256, 256, 3).colour(|u, v| {
        let (inside, glaze) = field(u, v);
        // The glaze runs off the edges and shows the clay.
        mortar.mixed(glaze.scaled(0.78 + 0.22 * raised(inside, 0.05)), raised(inside, 0.006))
    })
}

pub(crate) fn zellige_normal() -> Vec<u8> {
    Grid::new(256, 256, 1).normals(|u, v| {
        let (inside, _) = field(u.rem_euclid(1.0), v.rem_euclid(1.0));
        0.7 * BEVEL * raised(inside, BEVEL)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tile_has_four_mirrors() {
        for (u, v) in [(0.1, 0.2), (0.43, 0.31), (0.02, 0.47)] {
            let here = field(u, v).0;
            for other in [field(1.0 - u, v), field(u, 1.0 - v), field(v, u)] {
                assert!((other.0 - here).abs() < 1e-12);
            }
        }
    }
}
