//! feComposite, feMerge, feFlood, feOffset, feTile and feDropShadow: pictures placed and combined, pixel by pixel.
//!
//! Colors are premultiplied, so that a Porter-Duff operator is one formula for all four channels: source times Fa plus
//! backdrop times Fb ("Compositing Digital Images", 1984).

use super::raster::{Pixel, Raster, Region, multiply, product};

/// How feComposite combines a source (`in`) with a backdrop (`in2`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operator {
    /// The source over the backdrop.
    Over,
    /// The source where the backdrop is.
    In,
    /// The source where the backdrop is not.
    Out,
    /// The source over the backdrop where the backdrop is.
    Atop,
    /// Each where the other is not.
    Xor,
    /// The sum.
    Lighter,
    /// `k[0] * source * backdrop + k[1] * source + k[2] * backdrop + k[3]`.
    Arithmetic([f32; 4]),
}

/// `source` combined with `backdrop`, of the same size.
#[must_use]
pub fn composite(source: &Raster, mut backdrop: Raster, operator: Operator) -> Raster {
    for (below, above) in backdrop.pixels_mut().iter_mut().zip(source.pixels()) {
        *below = combined(*above, *below, operator);
    }
    backdrop
}

fn combined(source: Pixel, backdrop: Pixel, operator: Operator) -> Pixel {
    let (of_source, of_backdrop) = (source[3], backdrop[3]);
    let (source_share, backdrop_share) = match operator {
        Operator::Over => (255, 255 - of_source),
        Operator::In => (of_backdrop, 0),
        Operator::Out => (255 - of_backdrop, 0),
        Operator::Atop => (of_backdrop, 255 - of_source),
        Operator::Xor => (255 - of_backdrop, 255 - of_source),
        Operator::Lighter => (255, 255),
        Operator::Arithmetic(k) => return arithmetic(source, backdrop, k),
    };
    std::array::from_fn(|i| product(source[i], source_share).saturating_add(product(backdrop[i], backdrop_share)))
}

fn arithmetic(source: Pixel, backdrop: Pixel, [k1, k2, k3, k4]: [f32; 4]) -> Pixel {
    let value = |i: usize| {
        let (a, b) = (f32::from(source[i]) / 255.0, f32::from(backdrop[i]) / 255.0);
        trigon_image::color::unit_to_u8(((k1 * a) * b + k2 * a) + (k3 * b + k4))
    };
    let alpha = value(3);
    [value(0).min(alpha), value(1).min(alpha), value(2).min(alpha), alpha]
}

/// Lays `source` over `backdrop`, of the same size.
pub fn draw_over(backdrop: &mut Raster, source: &Raster) {
    for (below, above) in backdrop.pixels_mut().iter_mut().zip(source.pixels()) {
        if above[3] == 255 {
            *below = *above;
        } else if above[3] != 0 {
            *below = combined(*above, *below, Operator::Over);
        }
    }
}

/// `source` moved by whole pixels inside its own bounds.
#[must_use]
pub fn offset(source: &Raster, dx: i32, dy: i32) -> Raster {
    Raster::placed(source, dx, dy, source.width(), source.height())
}

/// The part of `source` in `tile`, repeated over a picture of the same size.
#[must_use]
pub fn tile(source: &Raster, tile: Region) -> Raster {
    let Some(tile) = tile.intersect(source.bounds()) else { return Raster::new(source.width(), source.height()) };
    let cell = source.cropped(tile);
    let phase = |start: i32, side: usize| {
        let start = usize::try_from(start).unwrap_or(0);
        (side - start % side) % side
    };
    let (phase_x, phase_y) = (phase(tile.left, cell.width()), phase(tile.top, cell.height()));
    let mut tiled = Raster::new(source.width(), source.height());
    for (y, row) in tiled.pixels_mut().chunks_exact_mut(source.width()).enumerate() {
        let start = (y + phase_y) % cell.height() * cell.width();
        let from = &cell.pixels()[start..start + cell.width()];
        for (pixel, repeated) in row.iter_mut().zip(from.iter().cycle().skip(phase_x)) {
            *pixel = *repeated;
        }
    }
    tiled
}

/// `color` (straight alpha) in the shape of `coverage`'s alpha.
#[must_use]
pub fn flood_in(mut coverage: Raster, [r, g, b, a]: Pixel) -> Raster {
    for pixel in coverage.pixels_mut() {
        *pixel = multiply([r, g, b, product(a, pixel[3])]);
    }
    coverage
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Pixel = [255, 0, 0, 255];
    const HALF_GREEN: Pixel = [0, 128, 0, 128];

    #[test]
    fn operators_meet_their_definitions() {
        let of = |operator| combined(HALF_GREEN, RED, operator);
        assert_eq!(of(Operator::Over), [127, 128, 0, 255]);
        assert_eq!(of(Operator::In), HALF_GREEN);
        assert_eq!(of(Operator::Out), [0; 4]);
        assert_eq!(of(Operator::Atop), [127, 128, 0, 255]);
        assert_eq!(of(Operator::Xor), [127, 0, 0, 127]);
        assert_eq!(of(Operator::Lighter), [255, 128, 0, 255]);
        assert_eq!(of(Operator::Arithmetic([0.0, 1.0, 0.0, 0.0])), HALF_GREEN);
        assert_eq!(of(Operator::Arithmetic([0.0, 0.0, 0.0, 0.5])), [128; 4]);
        assert_eq!(of(Operator::Arithmetic([0.0, -1.0, 0.0, 0.0])), [0; 4]);
    }

    #[test]
    fn tiles_continue_both_ways() {
        let pixels = (0..35u8).map(|i| [i, 0, 0, 255]).collect();
        let source = Raster::from_pixels(7, 5, pixels).unwrap();
        let tiled = tile(&source, Region { left: 2, top: 1, right: 5, bottom: 3 });
        for y in 0..5 {
            for x in 0..7 {
                let expected = source.pixel(2 + (x + 1) % 3, 1 + (y + 1) % 2);
                assert_eq!(tiled.pixel(x, y), expected, "{x} {y}");
            }
        }
    }

    #[test]
    fn an_offset_leaves_transparent_pixels_behind() {
        let moved = offset(&Raster::filled(3, 3, RED), 1, -1);
        assert_eq!(moved.pixels().iter().filter(|pixel| **pixel == RED).count(), 4);
        assert_eq!((moved.pixel(0, 0), moved.pixel(1, 0), moved.pixel(2, 2)), ([0; 4], RED, [0; 4]));
    }
}
