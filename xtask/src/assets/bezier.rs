//! Cubic Bezier curves and bicubic Bezier patches: points and derivatives from control points.

use super::vector::{V2, V3, add, cross, length, normalize, scale};

/// The Bernstein polynomials of degree three at `t`.
fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

/// Their derivatives.
fn bernstein_derivative(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * s - 6.0 * s * t, 6.0 * s * t - 3.0 * t * t, 3.0 * t * t]
}

/// A plane cubic curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Curve(pub(crate) [V2; 4]);

impl Curve {
    /// The straight line from `a` to `b`.
    pub(crate) fn line(a: V2, b: V2) -> Self {
        let between = |t: f64| [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
        Self([a, between(1.0 / 3.0), between(2.0 / 3.0), b])
    }

    pub(crate) fn point(&self, t: f64) -> V2 {
        self.weighted(bernstein(t))
    }

    pub(crate) fn derivative(&self, t: f64) -> V2 {
        self.weighted(bernstein_derivative(t))
    }

    fn weighted(&self, weights: [f64; 4]) -> V2 {
        let mut sum = [0.0; 2];
        for (point, weight) in self.0.iter().zip(weights) {
            sum = [sum[0] + point[0] * weight, sum[1] + point[1] * weight];
        }
        sum
    }

    /// The length, by the chords of 64 steps.
    pub(crate) fn length(&self) -> f64 {
        let mut length = 0.0;
        let mut last = self.point(0.0);
        for step in 1..=64 {
            let next = self.point(f64::from(step) / 64.0);
            let (dx, dy) = (next[0] - last[0], next[1] - last[1]);
            length += (dx * dx + dy * dy).sqrt();
            last = next;
        }
        length
    }
}

/// A bicubic patch: four rows of four control points; `s` runs along a row, `t` from row to row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch(pub(crate) [[V3; 4]; 4]);

impl Patch {
    pub(crate) fn point(&self, s: f64, t: f64) -> V3 {
        self.weighted(bernstein(s), bernstein(t))
    }

    /// The unit normal, on the side of ds x dt. Where a row has shrunk to a point (the pole of the lid), the limit
    /// from inside the patch.
    pub(crate) fn normal(&self, s: f64, t: f64) -> V3 {
        let normal = self.tangent_product(s, t);
        if length(normal) > 1e-9 {
            return normalize(normal);
        }
        let inside = |x: f64| x.clamp(1e-5, 1.0 - 1e-5);
        normalize(self.tangent_product(inside(s), inside(t)))
    }

    fn tangent_product(&self, s: f64, t: f64) -> V3 {
        let ds = self.weighted(bernstein_derivative(s), bernstein(t));
        let dt = self.weighted(bernstein(s), bernstein_derivative(t));
        cross(ds, dt)
    }

    fn weighted(&self, along: [f64; 4], across: [f64; 4]) -> V3 {
        let mut sum = [0.0; 3];
        for (row, row_weight) in self.0.iter().zip(across) {
            for (point, weight) in row.iter().zip(along) {
                sum = add(sum, scale(*point, weight * row_weight));
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::vector::{dot, sub};

    const CURVE: Curve = Curve([[0.0, 0.0], [1.0, 2.0], [3.0, -1.0], [4.0, 1.0]]);

    #[test]
    fn a_curve_passes_through_its_ends_along_its_legs() {
        assert_eq!(CURVE.point(0.0), [0.0, 0.0]);
        assert_eq!(CURVE.point(1.0), [4.0, 1.0]);
        assert_eq!(CURVE.derivative(0.0), [3.0, 6.0]);
        assert!((Curve::line([0.0, 0.0], [3.0, 4.0]).length() - 5.0).abs() < 1e-12);
    }

    #[test]
    fn derivatives_agree_with_differences() {
        for step in 1..10 {
            let (t, h) = (f64::from(step) / 10.0, 1e-6);
            let (a, b, d) = (CURVE.point(t - h), CURVE.point(t + h), CURVE.derivative(t));
            assert!(((b[0] - a[0]) / (2.0 * h) - d[0]).abs() < 1e-6);
            assert!(((b[1] - a[1]) / (2.0 * h) - d[1]).abs() < 1e-6);
        }
    }

    #[test]
    fn the_normal_is_square_to_the_surface() {
        let bent = |row: u8, column: u8| [f64::from(column), f64::from(row) * f64::from(column) * 0.2, f64::from(row)];
        let patch = Patch([0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| bent(row, column))));
        let (normal, h) = (patch.normal(0.3, 0.6), 1e-6);
        assert!((length(normal) - 1.0).abs() < 1e-12);
        for other in [patch.point(0.3 + h, 0.6), patch.point(0.3, 0.6 + h)] {
            assert!((dot(sub(other, patch.point(0.3, 0.6)), normal) / h).abs() < 1e-5);
        }
    }
}
