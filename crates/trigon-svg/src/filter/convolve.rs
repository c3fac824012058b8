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
    let (width, height) = (source.width(), source.height());
    let mut result = Raster::new(width, height);
    let mut sums = vec![[0.0; 4]; width];
    let mut line = vec![[0.0; 4]; width + convolution.columns];
    for (y, out) in result.pixels_mut().chunks_exact_mut(width.max(1)).enumerate() {
        sums.fill([0.0; 4]);
        for row in 0..convolution.rows {
            // A row of the matrix is much work where there are many.
            if deadline.is_over() {
                return result;
            }
            let from_y = position(y, row, convolution.target_y, height, convolution.edge);
            if let Some(from_y) = from_y {
                read_line(&source.pixels()[from_y * width..(from_y + 1) * width], convolution, &mut line);
                add_line(&line, convolution, row, &mut sums);
            }
        }
        for (x, (pixel, sum)) in out.iter_mut().zip(&sums).enumerate() {
            *pixel = match &alphas {
                Some(alphas) => with_alpha(*sum, alphas[y * width + x], convolution),
                None => premultiplied(*sum, convolution),
            };
        }
    }
    result
}

/// Pixels of a row, channels in 0..=1, from the one that the first column of the matrix reads for pixel 0.
fn read_line(row: &[Pixel], convolution: &Convolution, line: &mut [[f32; 4]]) {
    for (at, out) in line.iter_mut().enumerate() {
        let from = position(0, at, convolution.target_x, row.len(), convolution.edge);
        *out = from.map_or([0.0; 4], |from| row[from].map(|code| f32::from(code) / 255.0));
    }
}

/// Adds a row of the matrix to the sums of all pixels: each gets its terms in the order of the columns.
fn add_line(line: &[[f32; 4]], convolution: &Convolution, row: usize, sums: &mut [[f32; 4]]) {
    let width = sums.len();
    for column in 0..convolution.columns {
        let (rotated_row, rotated_column) = (convolution.rows - 1 - row, convolution.columns - 1 - column);
        let weight = convolution.weights[rotated_row * convolution.columns + rotated_column];
        // Nothing is added for what lies outside, not even zero times a weight that may be infinite.
        let inside = match convolution.edge {
            Edge::Transparent => {
                let start = convolution.target_x.saturating_sub(column).min(width);
                start..(width + convolution.target_x).saturating_sub(column).clamp(start, width)
            }
            Edge::Duplicate | Edge::Wrap => 0..width,
        };
        // One list of channels: four side by side in each pixel would be shuffled back and forth.
        let channels = line[inside.start + column..].as_flattened();
        for (total, channel) in sums[inside].as_flattened_mut().iter_mut().zip(channels) {
            *total += channel * weight;
        }
    }
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
    fn sums_are_those_of_the_definition() {
        let mut state = 1u32;
        let mut random = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 16
        };
        for (columns, rows) in [(1, 1), (3, 3), (5, 2), (2, 7), (19, 4)] {
            for edge in [Edge::Transparent, Edge::Duplicate, Edge::Wrap] {
                let pixels = (0..11 * 6).map(|_| [(); 4].map(|()| random().to_le_bytes()[0])).collect();
                let source = Raster::from_pixels(11, 6, pixels).unwrap();
                let weights = (0..columns * rows).map(|_| f32::from(random().to_le_bytes()[0]) / 256.0 - 0.4).collect();
                let (target_x, target_y) = (random() as usize % columns, random() as usize % rows);
                let (divisor, bias, preserve_alpha) = (0.7 * columns as f32, 0.1, false);
                let convolution =
                    Convolution { columns, rows, weights, target_x, target_y, divisor, bias, edge, preserve_alpha };
                let convolved = convolve(source.clone(), &convolution, Deadline::NEVER);
                for (x, y) in (0..6).flat_map(|y| (0..11).map(move |x| (x, y))) {
                    let expected = premultiplied(by_definition(&source, &convolution, x, y), &convolution);
                    assert_eq!(convolved.pixels()[y * 11 + x], expected, "{columns}x{rows} {edge:?} at {x} {y}");
                }
            }
        }
    }

    fn by_definition(source: &Raster, convolution: &Convolution, x: usize, y: usize) -> [f32; 4] {
        let mut sum = [0.0; 4];
        for (row, column) in (0..convolution.rows).flat_map(|row| (0..convolution.columns).map(move |c| (row, c))) {
            let from_x = position(x, column, convolution.target_x, source.width(), convolution.edge);
            let from_y = position(y, row, convolution.target_y, source.height(), convolution.edge);
            let (Some(from_x), Some(from_y)) = (from_x, from_y) else { continue };
            let weight = convolution.weights[convolution.weights.len() - 1 - (row * convolution.columns + column)];
            for (total, code) in sum.iter_mut().zip(source.pixels()[from_y * source.width() + from_x]) {
                *total += f32::from(code) / 255.0 * weight;
            }
        }
        sum
    }

    #[test]
    fn alpha_is_convolved_unless_preserved() {
        let last = |preserve| convolve(ramp(), &shift(Edge::Transparent, preserve), Deadline::NEVER).pixel(2, 0);
        assert_eq!(last(false), [0; 4]);
        assert_eq!(last(true), [0, 0, 0, 255]);
    }
}
