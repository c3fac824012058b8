//! feColorMatrix and feComponentTransfer: each pixel's own color recomputed, on colors without alpha.
//!
//! Filter Effects 1, "feColorMatrix" and "feComponentTransfer".

use trigon::math::host;
use trigon_image::color::unit_to_u8;

use super::raster::{Raster, divide, multiply, table_of};

/// A 4x5 matrix in row order: each of r, g, b, a out of (r, g, b, a, 1), all in 0..=1.
pub type ColorMatrix = [f32; 20];

/// One channel's curve in feComponentTransfer; in and out in 0..=1.
#[derive(Debug, Clone, PartialEq)]
pub enum Transfer {
    /// Unchanged.
    Identity,
    /// Piecewise linear through equally spaced values.
    Table(Vec<f32>),
    /// Steps of equal length.
    Discrete(Vec<f32>),
    /// `slope * c + intercept`.
    Linear {
        /// Factor.
        slope: f32,
        /// Summand.
        intercept: f32,
    },
    /// `amplitude * c^exponent + offset`.
    Gamma {
        /// Factor.
        amplitude: f32,
        /// Power.
        exponent: f32,
        /// Summand.
        offset: f32,
    },
}

/// The matrix of `type="saturate"`: 0 gray, 1 unchanged.
#[must_use]
pub fn saturate(s: f32) -> ColorMatrix {
    let row = |r: f32, g: f32, b: f32| [0.213 + r * s, 0.715 + g * s, 0.072 + b * s];
    of_rows([row(0.787, -0.715, -0.072), row(-0.213, 0.285, -0.072), row(-0.213, -0.715, 0.928)])
}

/// The matrix of `type="hueRotate"`; degrees.
#[must_use]
pub fn hue_rotate(degrees: f32) -> ColorMatrix {
    let angle = f64::from(degrees) * std::f64::consts::PI / 180.0;
    let (cos, sin) = (host::cos_f64(angle), host::sin_f64(angle));
    let mix = |base: f64, of_cos: f64, of_sin: f64| to_f32(base + of_cos * cos + of_sin * sin);
    of_rows([
        [mix(0.213, 0.787, -0.213), mix(0.715, -0.715, -0.715), mix(0.072, -0.072, 0.928)],
        [mix(0.213, -0.213, 0.143), mix(0.715, 0.285, 0.140), mix(0.072, -0.072, -0.283)],
        [mix(0.213, -0.213, -0.787), mix(0.715, -0.715, 0.715), mix(0.072, 0.928, 0.072)],
    ])
}

/// The matrix of `type="luminanceToAlpha"`.
pub const LUMINANCE_TO_ALPHA: ColorMatrix = [
    0.0, 0.0, 0.0, 0.0, 0.0, //
    0.0, 0.0, 0.0, 0.0, 0.0, //
    0.0, 0.0, 0.0, 0.0, 0.0, //
    0.2125, 0.7154, 0.0721, 0.0, 0.0,
];

/// Multiplies every color by `matrix`.
pub fn color_matrix(raster: &mut Raster, matrix: &ColorMatrix) {
    let mut last = None;
    for pixel in raster.pixels_mut() {
        // Neighbors are often equal.
        *pixel = match last {
            Some((source, result)) if source == *pixel => result,
            _ => {
                let result = transformed(divide(*pixel).map(|code| f32::from(code) / 255.0), matrix);
                last = Some((*pixel, result));
                result
            }
        };
    }
}

fn transformed([r, g, b, a]: [f32; 4], m: &ColorMatrix) -> [u8; 4] {
    let row = |i: usize| unit_to_u8(((r * m[i] + g * m[i + 1]) + (b * m[i + 2] + a * m[i + 3])) + m[i + 4]);
    multiply([row(0), row(5), row(10), row(15)])
}

/// Sends every channel through its curve: r, g, b, a.
pub fn component_transfer(raster: &mut Raster, curves: &[Transfer; 4]) {
    let tables = curves.each_ref().map(|curve| table_of(|code| unit_to_u8(curve.at(f32::from(code) / 255.0))));
    for pixel in raster.pixels_mut() {
        let mut straight = divide(*pixel);
        for (code, table) in straight.iter_mut().zip(&tables) {
            *code = table[usize::from(*code)];
        }
        *pixel = multiply(straight);
    }
}

impl Transfer {
    /// The curve at `c`, 0..=1; not clamped.
    #[must_use]
    pub fn at(&self, c: f32) -> f32 {
        match self {
            Self::Identity => c,
            Self::Table(values) => match values.as_slice() {
                [] => c,
                [value] => *value,
                values => {
                    let (step, fraction) = step_of(c, values.len() - 1);
                    values[step] + fraction * (values[step + 1] - values[step])
                }
            },
            Self::Discrete(values) => match values.as_slice() {
                [] => c,
                values => values[step_of(c, values.len()).0],
            },
            Self::Linear { slope, intercept } => slope * c + intercept,
            Self::Gamma { amplitude, exponent, offset } => amplitude * host::powf(c, *exponent) + offset,
        }
    }
}

/// Which of `steps` equal parts of 0..=1 holds `c`, and where in it, 0..=1.
#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
#[expect(clippy::cast_precision_loss, reason = "more than 2^24 values do not occur in 256 codes")]
fn step_of(c: f32, steps: usize) -> (usize, f32) {
    let position = c * steps as f32;
    let step = (position as usize).min(steps - 1);
    (step, position - step as f32)
}

fn of_rows(rows: [[f32; 3]; 3]) -> ColorMatrix {
    let mut matrix = [0.0; 20];
    for (i, row) in rows.iter().enumerate() {
        matrix[i * 5..i * 5 + 3].copy_from_slice(row);
    }
    matrix[18] = 1.0;
    matrix
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
fn to_f32(x: f64) -> f32 {
    x as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(pixel: [u8; 4], matrix: &ColorMatrix) -> [u8; 4] {
        let mut raster = Raster::filled(1, 1, pixel);
        color_matrix(&mut raster, matrix);
        raster.pixels()[0]
    }

    #[test]
    fn neutral_matrices_change_nothing() {
        for pixel in [[10, 200, 30, 255], [5, 9, 17, 120], [0, 0, 0, 0]] {
            assert_eq!(of(pixel, &saturate(1.0)), pixel);
            assert_eq!(of(pixel, &hue_rotate(0.0)), pixel);
        }
    }

    #[test]
    fn saturation_zero_is_gray_of_the_same_luminance() {
        assert_eq!(of([255, 0, 0, 255], &saturate(0.0)), [54, 54, 54, 255]);
        assert_eq!(of([255, 255, 255, 255], &LUMINANCE_TO_ALPHA), [0, 0, 0, 255]);
    }

    #[test]
    fn curves_meet_their_values() {
        let table = Transfer::Table(vec![1.0, 0.0, 0.5]);
        assert_eq!([0.0, 0.25, 0.5, 1.0].map(|c| table.at(c)), [1.0, 0.5, 0.0, 0.5]);
        let discrete = Transfer::Discrete(vec![0.1, 0.9]);
        assert_eq!([0.0, 0.49, 0.5, 1.0].map(|c| discrete.at(c)), [0.1, 0.1, 0.9, 0.9]);
        assert_eq!(Transfer::Gamma { amplitude: 2.0, exponent: 2.0, offset: 0.25 }.at(0.5), 0.75);
        assert_eq!(Transfer::Table(Vec::new()).at(0.3), 0.3);
    }
}
