//! feDisplacementMap: a picture read at places moved by the colors of another.
//!
//! Filter Effects 1, "feDisplacementMap": `P'(x, y) = P(x + scale * (X(x, y) - 1/2), y + scale * (Y(x, y) - 1/2))`,
//! where X and Y are channels of the map without alpha; nearest pixel.

use super::raster::{Raster, divide};

/// `source` displaced by `map`, of the same size.
///
/// `scale` is in pixels along x and y; `channels` says which of r, g, b, a (0 to 3) moves along x and along y.
///
/// # Panics
/// If a channel is above 3.
#[must_use]
pub fn displace(source: &Raster, map: &Raster, scale: (f32, f32), channels: (usize, usize)) -> Raster {
    let mut displaced = Raster::new(source.width(), source.height());
    let width = source.width().max(1);
    for (index, (pixel, color)) in displaced.pixels_mut().iter_mut().zip(map.pixels()).enumerate() {
        let color = divide(*color);
        let shift = |code: u8, scale: f32| scale * (f32::from(code) / 255.0 - 0.5);
        let x = moved(index % width, shift(color[channels.0], scale.0));
        let y = moved(index / width, shift(color[channels.1], scale.1));
        *pixel = source.pixel(x, y);
    }
    displaced
}

#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_precision_loss, reason = "pictures have fewer than 2^24 pixels a side")]
fn moved(at: usize, by: f32) -> i64 {
    (at as f32 + by + 0.5).floor() as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_red_reads_half_the_scale_to_the_right() {
        let source = Raster::from_pixels(4, 1, (0..4).map(|i| [i, 0, 0, 255]).collect()).unwrap();
        let map = Raster::filled(4, 1, [255, 0, 0, 255]);
        let displaced = displace(&source, &map, (4.0, 0.0), (0, 1));
        assert_eq!(displaced.pixels(), [[2, 0, 0, 255], [3, 0, 0, 255], [0; 4], [0; 4]]);
    }

    #[test]
    fn a_hostile_scale_reads_nothing() {
        let source = Raster::filled(4, 4, [255; 4]);
        let map = Raster::filled(4, 4, [255, 0, 0, 255]);
        assert_eq!(displace(&source, &map, (1e30, f32::INFINITY), (0, 1)), Raster::new(4, 4));
    }
}
