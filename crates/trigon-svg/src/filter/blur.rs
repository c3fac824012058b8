//! feGaussianBlur: a picture and two standard deviations in pixels in, the blurred picture out; transparent around it.
//!
//! Below [`BOX_FROM`] the Gaussian is summed directly with integer weights; from there on it is the three box blurs that
//! Filter Effects 1, "feGaussianBlur" gives, in running sums, so that the time does not depend on the deviation.
//! Between passes a channel has eight fractional bits. Integers only, of 32 bits so that the four channels of a pixel share
//! one register: the result is the same on every machine.

use super::raster::{Pixel, Raster};

/// The deviation from which three box blurs stand for the Gaussian, as the specification allows.
const BOX_FROM: f32 = 2.0;
/// Below this deviation, in pixels, a blur changes no 8-bit value.
const NO_BLUR: f32 = 0.05;
/// Sum of the weights of a direct kernel: small enough that a weighted sum fits 32 bits.
const WEIGHT_ONE: u32 = 1 << 14;

/// Rows up to this length have eight fractional bits, longer ones none, so that the sum of a row fits 32 bits.
const MAX_LENGTH_WITH_FRACTION: usize = 65_000;

/// A channel with fractional bits, four of them a pixel.
type Wide = [u32; 4];

/// The picture blurred by `deviation_x` and `deviation_y`, in pixels; not along an axis where it is below 1/20.
#[must_use]
pub fn gaussian_blur(source: Raster, deviation_x: f32, deviation_y: f32) -> Raster {
    let blurred = blur_rows(source, deviation_x);
    if deviation_y < NO_BLUR { blurred } else { blur_rows(blurred.transposed(), deviation_y).transposed() }
}

fn blur_rows(mut raster: Raster, deviation: f32) -> Raster {
    if deviation < NO_BLUR || raster.width() == 0 {
        return raster;
    }
    let kernel = Kernel::new(deviation);
    let width = raster.width();
    let fraction_bits = if width <= MAX_LENGTH_WITH_FRACTION { 8 } else { 0 };
    let (mut row, mut scratch) = (vec![[0; 4]; width], vec![[0; 4]; width]);
    for pixels in raster.pixels_mut().chunks_exact_mut(width) {
        if pixels.iter().all(|pixel| pixel[3] == 0) {
            continue;
        }
        for (wide, pixel) in row.iter_mut().zip(&*pixels) {
            *wide = pixel.map(|code| u32::from(code) << fraction_bits);
        }
        kernel.apply(&mut row, &mut scratch);
        for (pixel, wide) in pixels.iter_mut().zip(&row) {
            *pixel = narrow(*wide, fraction_bits);
        }
    }
    raster
}

/// Nearest codes; colors never above alpha, which rounding could break.
fn narrow(wide: Wide, fraction_bits: u32) -> Pixel {
    let half = (1 << fraction_bits) >> 1;
    let [r, g, b, a] = wide.map(|value| u8::try_from((value + half) >> fraction_bits).unwrap_or(u8::MAX));
    [r.min(a), g.min(a), b.min(a), a]
}

enum Kernel {
    /// Weights of the centre and of one side, together with the other side [`WEIGHT_ONE`].
    Weights(Vec<u32>),
    /// Three box blurs: pixels before the centre, and size.
    Boxes([(usize, usize); 3]),
}

impl Kernel {
    fn new(deviation: f32) -> Self {
        if deviation < BOX_FROM { Self::Weights(weights(deviation)) } else { Self::Boxes(boxes(deviation)) }
    }

    fn apply(&self, row: &mut Vec<Wide>, scratch: &mut Vec<Wide>) {
        match self {
            Self::Weights(weights) => {
                convolve(row, scratch, weights);
                std::mem::swap(row, scratch);
            }
            Self::Boxes(boxes) => {
                for &(before, size) in boxes {
                    box_blur(row, scratch, before, size);
                    std::mem::swap(row, scratch);
                }
            }
        }
    }
}

/// The Gaussian at whole distances up to three deviations, scaled so that the whole kernel sums to [`WEIGHT_ONE`].
fn weights(deviation: f32) -> Vec<u32> {
    let deviation = f64::from(deviation);
    let mut values = Vec::new();
    let mut distance = 0.0;
    while distance <= 3.0 * deviation + 1.0 {
        values.push(libm::exp(-distance * distance / (2.0 * deviation * deviation)));
        distance += 1.0;
    }
    let total = 2.0 * values.iter().sum::<f64>() - values[0];
    let mut weights: Vec<u32> = values.iter().map(|value| round(value / total * f64::from(WEIGHT_ONE))).collect();
    // What rounding left over goes to the centre, so that a flat area keeps its value.
    weights[0] = WEIGHT_ONE - 2 * weights[1..].iter().sum::<u32>();
    weights
}

#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
fn round(value: f64) -> u32 {
    (value + 0.5) as u32
}

/// Offsets and sizes of the three boxes; Filter Effects 1, "feGaussianBlur".
fn boxes(deviation: f32) -> [(usize, usize); 3] {
    // 3 * sqrt(2 pi) / 4.
    const SIZE_OF_DEVIATION: f64 = 1.879_971_205_598_325;
    let size = usize::try_from(round(f64::from(deviation) * SIZE_OF_DEVIATION)).unwrap_or(usize::MAX).max(1);
    let half = size / 2;
    if size % 2 == 1 { [(half, size); 3] } else { [(half, size), (half - 1, size), (half, size + 1)] }
}

fn convolve(from: &[Wide], to: &mut [Wide], weights: &[u32]) {
    for (x, out) in to.iter_mut().enumerate() {
        let mut sum = from[x].map(|value| value * weights[0]);
        for (distance, weight) in weights.iter().enumerate().skip(1) {
            let left = x.checked_sub(distance).map_or([0; 4], |x| from[x]);
            let right = from.get(x + distance).copied().unwrap_or([0; 4]);
            for channel in 0..4 {
                sum[channel] += (left[channel] + right[channel]) * weight;
            }
        }
        *out = sum.map(|value| (value + WEIGHT_ONE / 2) / WEIGHT_ONE);
    }
}

/// The mean of `size` pixels of which `before` lie before the pixel written; transparent outside the row.
fn box_blur(from: &[Wide], to: &mut [Wide], before: usize, size: usize) {
    // Division by `size` as multiplication: off by less than 2^-32 of the sum, which has 32 bits. A size of 1 fits too.
    let reciprocal = u32::try_from((1u64 << 32).div_ceil(size as u64)).unwrap_or(u32::MAX);
    let after = size - 1 - before;
    let mut sum = [0u32; 4];
    for pixel in &from[..after.min(from.len())] {
        sum = added(sum, *pixel);
    }
    for (x, out) in to.iter_mut().enumerate() {
        if let Some(entering) = x.checked_add(after).and_then(|x| from.get(x)) {
            sum = added(sum, *entering);
        }
        *out = sum.map(|value| scaled(value, reciprocal));
        if let Some(leaving) = x.checked_sub(before) {
            for (total, value) in sum.iter_mut().zip(from[leaving]) {
                *total -= value;
            }
        }
    }
}

fn added(sum: [u32; 4], pixel: Wide) -> [u32; 4] {
    std::array::from_fn(|i| sum[i] + pixel[i])
}

/// `value * reciprocal / 2^32`, nearest.
fn scaled(value: u32, reciprocal: u32) -> u32 {
    let product = u64::from(value) * u64::from(reciprocal) + (1 << 31);
    u32::try_from(product >> 32).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(size: usize) -> Raster {
        let mut raster = Raster::new(size, size);
        raster.pixels_mut()[size / 2 * size + size / 2] = [255; 4];
        raster
    }

    #[test]
    fn flat_areas_keep_their_value() {
        for deviation in [0.3, 1.0, 1.9, 2.0, 2.5, 3.0, 7.3] {
            let flat = gaussian_blur(Raster::filled(65, 65, [10, 77, 200, 201]), deviation, deviation);
            assert_eq!(flat.pixel(32, 32), [10, 77, 200, 201], "{deviation}");
        }
    }

    #[test]
    fn the_blur_is_symmetric_and_of_the_asked_width() {
        for deviation in [1.0f32, 1.5, 2.0, 3.0, 6.0] {
            let mut raster = Raster::new(101, 1);
            raster.pixels_mut()[50] = [255; 4];
            let blurred = gaussian_blur(raster, deviation, 0.0);
            let row: Vec<f64> = blurred.pixels().iter().map(|pixel| f64::from(pixel[3])).collect();
            let square = |x: usize| (x.abs_diff(50) * x.abs_diff(50)) as f64;
            let variance =
                row.iter().enumerate().map(|(x, value)| value * square(x)).sum::<f64>() / row.iter().sum::<f64>();
            assert!(
                (variance.sqrt() - f64::from(deviation)).abs() < 0.12 * f64::from(deviation),
                "{deviation}: {}",
                variance.sqrt()
            );
            for x in 0..50 {
                assert_eq!(row[x], row[100 - x], "{deviation}");
            }
        }
    }

    #[test]
    fn axes_are_alike() {
        let wide = gaussian_blur(dot(33), 1.3, 4.0);
        let high = gaussian_blur(dot(33), 4.0, 1.3).transposed();
        for (a, b) in wide.pixels().iter().zip(high.pixels()) {
            assert!(a[3].abs_diff(b[3]) <= 1, "{a:?} {b:?}");
        }
    }

    #[test]
    fn a_deviation_far_larger_than_the_picture_is_no_trouble() {
        let blurred = gaussian_blur(Raster::filled(9, 9, [255; 4]), 1e9, 1e9);
        assert!(blurred.pixels().iter().all(|pixel| *pixel == [0; 4]));
    }
}
