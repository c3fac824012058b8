//! feConvolveMatrix: each pixel the weighted sum of its neighbors.
//!
//! Filter Effects 1, "feConvolveMatrix": the matrix is applied rotated by 180 degrees; `preserveAlpha` works on colors
//! without alpha and leaves alpha as it is.

use trigon::schedule::Deadline;
use trigon_image::color::unit_to_u8;

use super::raster::{Pixel, Raster, divide};

/// The matrix and how it is applied.
#[derive(Debug, Clone, PartialEq)]
pub struct Convolution {
    /// Columns of the matrix.
    pub columns: usize,
    /// Rows of the matrix.
    pub rows: usize,
    /// `columns * rows` weights in row order.
    pub weights: Vec<f32>,
    /// Column of the matrix that lies on the pixel written.
    pub target_x: usize,
    /// Row of the matrix that lies on the pixel written.
    pub target_y: usize,
    /// What the sum is divided by; not 0.
    pub divisor: f32,
    /// Added after the division, times alpha.
    pub bias: f32,
    /// What lies outside the picture.
    pub edge: Edge,
    /// Whether alpha is copied and colors are taken without it.
    pub preserve_alpha: bool,
}

/// The pixels outside the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// Transparent.
    Transparent,
    /// The nearest pixel inside.
    Duplicate,
    /// The picture again.
    Wrap,
}

/// The picture convolved; rows after the deadline are left transparent.
#[must_use]
pub fn convolve(mut source: Raster, convolution: &Convolution, deadline: Deadline) -> Raster {
    let alphas: Option<Vec<u8>> = convolution.preserve_alpha.then(|| {
        source.pixels_mut().iter_mut().for_each(|pixel| *pixel = divide(*pixel));
        source.pixels().iter().map(|pixel| pixel[3]).collect()
    });
    let mut result = Raster::new(source.width(), source.height());
    let width = source.width();
    for y in 0..source.height() {
        if deadline.is_over() {
            break;
        }
        for x in 0..width {
            let index = y * width + x;
            let sum = weighted_sum(&source, convolution, x, y);
            result.pixels_mut()[index] = match &alphas {
                Some(alphas) => with_alpha(sum, alphas[index], convolution),
                None => premultiplied(sum, convolution),
            };
        }
    }
    result
}

/// Sum over the matrix, channels in 0..=1 times weights.
fn weighted_sum(source: &Raster, convolution: &Convolution, x: usize, y: usize) -> [f32; 4] {
    let mut sum = [0.0; 4];
    for row in 0..convolution.rows {
        let Some(from_y) = position(y, row, convolution.target_y, source.height(), convolution.edge) else { continue };
        for column in 0..convolution.columns {
            let Some(from_x) = position(x, column, convolution.target_x, source.width(), convolution.edge) else {
                continue;
            };
            let (rotated_row, rotated_column) = (convolution.rows - 1 - row, convolution.columns - 1 - column);
            let weight = convolution.weights[rotated_row * convolution.columns + rotated_column];
            let pixel = source.pixels()[from_y * source.width() + from_x];
            for (total, code) in sum.iter_mut().zip(pixel) {
                *total += f32::from(code) / 255.0 * weight;
            }
        }
    }
    sum
}

/// Where the matrix cell `cell` reads, for the pixel at `at`; `None` for nothing.
fn position(at: usize, cell: usize, target: usize, length: usize, edge: Edge) -> Option<usize> {
    let wanted = i64::try_from(at).ok()? + i64::try_from(cell).ok()? - i64::try_from(target).ok()?;
    let length = i64::try_from(length).ok()?;
    let found = match edge {
        Edge::Transparent => (0..length).contains(&wanted).then_some(wanted)?,
        Edge::Duplicate => wanted.clamp(0, length - 1),
        Edge::Wrap => wanted.rem_euclid(length),
    };
    usize::try_from(found).ok()
}

fn premultiplied(sum: [f32; 4], convolution: &Convolution) -> Pixel {
    let alpha = sum[3] / convolution.divisor + convolution.bias;
    let channel = |i: usize| sum[i] / convolution.divisor + convolution.bias * alpha;
    let code = unit_to_u8(alpha);
    [0, 1, 2].map(|i| unit_to_u8(channel(i)).min(code)).into_pixel(code)
}

fn with_alpha(sum: [f32; 4], alpha: u8, convolution: &Convolution) -> Pixel {
    let a = f32::from(alpha) / 255.0;
    let channel = |i: usize| (sum[i] / convolution.divisor + convolution.bias * a).clamp(0.0, 1.0) * a;
    [0, 1, 2].map(|i| unit_to_u8(channel(i))).into_pixel(alpha)
}

trait IntoPixel {
    fn into_pixel(self, alpha: u8) -> Pixel;
}

impl IntoPixel for [u8; 3] {
    fn into_pixel(self, alpha: u8) -> Pixel {
        [self[0], self[1], self[2], alpha]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shift(edge: Edge, preserve_alpha: bool) -> Convolution {
        // The weight left of the target reads, rotated, the pixel to the right.
        let weights = vec![1.0, 0.0, 0.0];
        let (columns, rows, target_x, target_y) = (3, 1, 1, 0);
        Convolution { columns, rows, weights, target_x, target_y, divisor: 1.0, bias: 0.0, edge, preserve_alpha }
    }

    fn ramp() -> Raster {
        Raster::from_pixels(3, 1, vec![[10, 0, 0, 255], [20, 0, 0, 255], [30, 0, 0, 255]]).unwrap()
    }

    #[test]
    fn the_matrix_is_rotated_and_edges_are_as_asked() {
        for (edge, last) in [(Edge::Transparent, 0), (Edge::Duplicate, 30), (Edge::Wrap, 10)] {
            let convolved = convolve(ramp(), &shift(edge, true), Deadline::NEVER);
            let reds: Vec<u8> = convolved.pixels().iter().map(|pixel| pixel[0]).collect();
            assert_eq!(reds, [20, 30, last], "{edge:?}");
        }
    }

    #[test]
    fn alpha_is_convolved_unless_preserved() {
        let last = |preserve| convolve(ramp(), &shift(Edge::Transparent, preserve), Deadline::NEVER).pixel(2, 0);
        assert_eq!(last(false), [0; 4]);
        assert_eq!(last(true), [0, 0, 0, 255]);
    }
}
