//! feMorphology: each channel the smallest (erode) or largest (dilate) value in a rectangle round the pixel.
//!
//! One axis after the other, and along an axis with running extremes of blocks, so that the time does not depend on the
//! radius (van Herk, "A fast algorithm for local minimum and maximum filters", 1992). The rectangle is cut at the edges.

use super::raster::{Pixel, Raster};

/// Which extreme is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Morphology {
    /// The smallest value: shapes shrink.
    Erode,
    /// The largest value: shapes grow.
    Dilate,
}

/// The picture with every channel replaced by its extreme within `radius_x`, `radius_y` whole pixels.
#[must_use]
pub fn morphology(source: Raster, operator: Morphology, radius_x: usize, radius_y: usize) -> Raster {
    let rows = along_rows(source, operator, radius_x);
    if radius_y == 0 { rows } else { along_rows(rows.transposed(), operator, radius_y).transposed() }
}

fn along_rows(mut raster: Raster, operator: Morphology, radius: usize) -> Raster {
    let width = raster.width();
    let radius = radius.min(width.saturating_sub(1));
    if radius == 0 {
        return raster;
    }
    let neutral = match operator {
        Morphology::Erode => [255; 4],
        Morphology::Dilate => [0; 4],
    };
    // The row with `radius` neutral pixels at both ends, cut into blocks of a window each.
    let window = 2 * radius + 1;
    let length = (width + 2 * radius).next_multiple_of(window);
    let mut forward = vec![neutral; length];
    let mut backward = vec![neutral; length];
    for row in raster.pixels_mut().chunks_exact_mut(width) {
        forward[radius..radius + width].copy_from_slice(row);
        forward[radius + width..].fill(neutral);
        forward[..radius].fill(neutral);
        backward.copy_from_slice(&forward);
        for block in forward.chunks_exact_mut(window) {
            for i in 1..window {
                block[i] = extreme(operator, block[i - 1], block[i]);
            }
        }
        for block in backward.chunks_exact_mut(window) {
            for i in (1..window).rev() {
                block[i - 1] = extreme(operator, block[i - 1], block[i]);
            }
        }
        for (x, pixel) in row.iter_mut().enumerate() {
            *pixel = extreme(operator, backward[x], forward[x + window - 1]);
        }
    }
    raster
}

fn extreme(operator: Morphology, a: Pixel, b: Pixel) -> Pixel {
    match operator {
        Morphology::Erode => std::array::from_fn(|i| a[i].min(b[i])),
        Morphology::Dilate => std::array::from_fn(|i| a[i].max(b[i])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn running_extremes_equal_those_by_definition() {
        let mut state = 1u32;
        let pixels: Vec<Pixel> = (0..23 * 11)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                state.to_be_bytes()
            })
            .collect();
        let source = Raster::from_pixels(23, 11, pixels).unwrap();
        for (rx, ry) in [(1, 1), (3, 0), (0, 2), (7, 4), (50, 50)] {
            for operator in [Morphology::Erode, Morphology::Dilate] {
                let fast = morphology(source.clone(), operator, rx, ry);
                assert_eq!(fast, by_definition(&source, operator, rx, ry), "{operator:?} {rx} {ry}");
            }
        }
    }

    fn by_definition(source: &Raster, operator: Morphology, rx: usize, ry: usize) -> Raster {
        let mut result = Raster::new(source.width(), source.height());
        for y in 0..source.height() {
            for x in 0..source.width() {
                let mut found = None;
                for v in y.saturating_sub(ry)..=(y + ry).min(source.height() - 1) {
                    for u in x.saturating_sub(rx)..=(x + rx).min(source.width() - 1) {
                        let pixel = source.pixels()[v * source.width() + u];
                        found = Some(found.map_or(pixel, |other| extreme(operator, other, pixel)));
                    }
                }
                result.pixels_mut()[y * source.width() + x] = found.unwrap();
            }
        }
        result
    }
}
