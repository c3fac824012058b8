//! 4x4 matrices for transforms and projections, column-major, column vectors: `p' = m * p`.
//!
//! Names say target-from-source, so that spaces meet: `clip_from_model = clip_from_view * view_from_world *
//! world_from_model`. Products and inverses are computed in `f64` and rounded once.

use super::vec3::{self, Vec3};
use std::ops::Mul;

/// A 4x4 matrix; `columns[c][r]` is the element in row `r`, column `c`.
///
/// Transforms column vectors. Angles are in radians; rotations follow the right-hand rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat4 {
    /// The four columns; the last one holds the translation of an affine matrix.
    pub columns: [[f32; 4]; 4],
}

impl Default for Mat4 {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Mat4 {
    /// The identity.
    pub const IDENTITY: Self =
        Self { columns: [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]] };

    /// From rows as they are written on paper.
    #[must_use]
    pub fn from_rows(rows: [[f64; 4]; 4]) -> Self {
        Self::round(std::array::from_fn(|c| std::array::from_fn(|r| rows[r][c])))
    }

    /// Moves by `offset`.
    #[must_use]
    pub fn translation(offset: Vec3) -> Self {
        Self::from_rows([
            [1.0, 0.0, 0.0, offset[0]],
            [0.0, 1.0, 0.0, offset[1]],
            [0.0, 0.0, 1.0, offset[2]],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// Scales each axis about the origin.
    #[must_use]
    pub fn scaling(factors: Vec3) -> Self {
        Self::from_rows([
            [factors[0], 0.0, 0.0, 0.0],
            [0.0, factors[1], 0.0, 0.0],
            [0.0, 0.0, factors[2], 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ])
    }

    /// Turns about the x axis: y towards z.
    #[must_use]
    pub fn rotation_x(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self::from_rows([[1.0, 0.0, 0.0, 0.0], [0.0, c, -s, 0.0], [0.0, s, c, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// Turns about the y axis: z towards x.
    #[must_use]
    pub fn rotation_y(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self::from_rows([[c, 0.0, s, 0.0], [0.0, 1.0, 0.0, 0.0], [-s, 0.0, c, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// Turns about the z axis: x towards y.
    #[must_use]
    pub fn rotation_z(angle: f64) -> Self {
        let (s, c) = sin_cos(angle);
        Self::from_rows([[c, -s, 0.0, 0.0], [s, c, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
    }

    /// The point `p` transformed, without the divide: homogeneous (x, y, z, w).
    #[must_use]
    pub fn transform_point(&self, p: Vec3) -> [f64; 4] {
        let m = self.widen();
        std::array::from_fn(|r| ((m[0][r] * p[0] + m[1][r] * p[1]) + m[2][r] * p[2]) + m[3][r])
    }

    /// The direction `v` transformed: translation does not apply.
    #[must_use]
    pub fn transform_vector(&self, v: Vec3) -> Vec3 {
        let m = self.widen();
        std::array::from_fn(|r| (m[0][r] * v[0] + m[1][r] * v[1]) + m[2][r] * v[2])
    }

    /// The rows of the upper left 3x3 block, transposed and inverted up to a positive factor: what normals are
    /// transformed with. `columns[c][r]` as in the matrix; normalize the result of using it.
    ///
    /// It is the cofactor matrix times the sign of the determinant, so it exists for singular matrices too.
    #[must_use]
    pub fn normal_from_model(&self) -> [[f32; 3]; 3] {
        let m = self.widen();
        let column = |c: usize| [m[c][0], m[c][1], m[c][2]];
        let cofactors =
            [vec3::cross(column(1), column(2)), vec3::cross(column(2), column(0)), vec3::cross(column(0), column(1))];
        let sign = if vec3::dot(column(0), cofactors[0]) < 0.0 { -1.0 } else { 1.0 };
        cofactors.map(|c| vec3::narrow(vec3::scale(c, sign)))
    }

    /// The determinant of the upper left 3x3 block; negative if the transform mirrors, which flips the winding.
    #[must_use]
    pub fn linear_determinant(&self) -> f64 {
        let m = self.widen();
        let column = |c: usize| [m[c][0], m[c][1], m[c][2]];
        vec3::dot(column(0), vec3::cross(column(1), column(2)))
    }

    /// The inverse, or `None` for a singular matrix. Gauss-Jordan elimination with partial pivoting.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let mut left = self.widen();
        let mut right = Self::IDENTITY.widen();
        // Elimination on the transpose: columns play the rows, and the inverse of the transpose is transposed back.
        for step in 0..4 {
            let pivot = (step..4).max_by(|&a, &b| left[a][step].abs().total_cmp(&left[b][step].abs()))?;
            if !(left[pivot][step].abs() > 0.0 && left[pivot][step].is_finite()) {
                return None;
            }
            left.swap(step, pivot);
            right.swap(step, pivot);
            let divisor = left[step][step];
            for k in 0..4 {
                left[step][k] /= divisor;
                right[step][k] /= divisor;
            }
            for row in (0..4).filter(|&row| row != step) {
                let factor = left[row][step];
                for k in 0..4 {
                    left[row][k] -= factor * left[step][k];
                    right[row][k] -= factor * right[step][k];
                }
            }
        }
        Some(Self::round(right))
    }

    fn widen(&self) -> [[f64; 4]; 4] {
        self.columns.map(|column| column.map(f64::from))
    }

    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    fn round(columns: [[f64; 4]; 4]) -> Self {
        Self { columns: columns.map(|column| column.map(|element| element as f32)) }
    }
}

impl Mul for Mat4 {
    type Output = Self;

    /// `self * other`: first `other`, then `self`.
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self.widen(), other.widen());
        Self::round(std::array::from_fn(|c| {
            std::array::from_fn(|r| ((a[0][r] * b[c][0] + a[1][r] * b[c][1]) + a[2][r] * b[c][2]) + a[3][r] * b[c][3])
        }))
    }
}

/// Sine and cosine, exact at the multiples of a right angle that turntables and axis swaps use.
fn sin_cos(angle: f64) -> (f64, f64) {
    let quarter_turns = angle / std::f64::consts::FRAC_PI_2;
    if quarter_turns == libm::rint(quarter_turns) && quarter_turns.abs() < 1e9 {
        return match libm::fmod(libm::fmod(quarter_turns, 4.0) + 4.0, 4.0) {
            0.0 => (0.0, 1.0),
            1.0 => (1.0, 0.0),
            2.0 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    (libm::sin(angle), libm::cos(angle))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_follow_the_right_hand_rule() {
        let quarter = std::f64::consts::FRAC_PI_2;
        assert_eq!(Mat4::rotation_x(quarter).transform_vector([0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
        assert_eq!(Mat4::rotation_y(quarter).transform_vector([0.0, 0.0, 1.0]), [1.0, 0.0, 0.0]);
        assert_eq!(Mat4::rotation_z(quarter).transform_vector([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        assert_eq!(Mat4::rotation_y(-4.0 * quarter), Mat4::IDENTITY);
    }

    #[test]
    fn product_applies_the_right_factor_first() {
        let m = Mat4::translation([1.0, 2.0, 3.0]) * Mat4::scaling([2.0, 2.0, 2.0]);
        assert_eq!(m.transform_point([1.0, 1.0, 1.0]), [3.0, 4.0, 5.0, 1.0]);
        assert_eq!(m.transform_vector([1.0, 1.0, 1.0]), [2.0, 2.0, 2.0]);
    }

    #[test]
    fn inverse_undoes_a_transform() {
        let m = Mat4::translation([1.0, -2.0, 3.0]) * Mat4::rotation_x(0.7) * Mat4::scaling([2.0, 0.5, 4.0]);
        let identity = m.inverse().unwrap() * m;
        for (got, want) in identity.columns.iter().flatten().zip(Mat4::IDENTITY.columns.iter().flatten()) {
            assert!((got - want).abs() < 1e-6, "{identity:?}");
        }
        assert_eq!(Mat4::scaling([1.0, 0.0, 1.0]).inverse(), None);
    }

    #[test]
    fn normals_stay_perpendicular_under_uneven_scale_and_mirrors() {
        let m = Mat4::scaling([1.0, 5.0, -2.0]) * Mat4::rotation_z(0.3);
        let n = m.normal_from_model();
        let normal = [1.0, 1.0, 0.5];
        let tangent = [1.0, -1.0, 0.0];
        let normal_in_world: Vec3 =
            std::array::from_fn(|r| (0..3).map(|c| f64::from(n[c][r]) * normal[c]).sum::<f64>());
        let moved = m.transform_vector(tangent);
        assert!(vec3::dot(normal_in_world, moved).abs() < 1e-5);
        // A normal keeps its side: moving along it is still moving away from the surface.
        assert!(vec3::dot(normal_in_world, m.transform_vector(normal)) > 0.0);
    }
}
