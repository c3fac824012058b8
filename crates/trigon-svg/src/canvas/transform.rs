//! Affine maps of the plane, in double precision.

use core::ops::Mul;

/// The affine map (x, y) -> (a x + c y + e, b x + d y + f): SVG's `matrix(a b c d e f)`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Transform {
    /// x by x.
    pub a: f64,
    /// y by x.
    pub b: f64,
    /// x by y.
    pub c: f64,
    /// y by y.
    pub d: f64,
    /// Translation along x.
    pub e: f64,
    /// Translation along y.
    pub f: f64,
}

impl Transform {
    /// Every point stays where it is.
    pub const IDENTITY: Self = Self::new(1.0, 0.0, 0.0, 1.0, 0.0, 0.0);

    /// The map with these six numbers, in the order of SVG's `matrix()`.
    #[must_use]
    pub const fn new(a: f64, b: f64, c: f64, d: f64, e: f64, f: f64) -> Self {
        Self { a, b, c, d, e, f }
    }

    /// Moves by (x, y).
    #[must_use]
    pub const fn translate(x: f64, y: f64) -> Self {
        Self::new(1.0, 0.0, 0.0, 1.0, x, y)
    }

    /// Multiplies x and y.
    #[must_use]
    pub const fn scale(x: f64, y: f64) -> Self {
        Self::new(x, 0.0, 0.0, y, 0.0, 0.0)
    }

    /// Turns by an angle in radians about the origin: from x towards y, clockwise on the screen.
    #[must_use]
    pub fn rotate(angle_rad: f64) -> Self {
        let (sin, cos) = (trigon::math::host::sin_f64(angle_rad), trigon::math::host::cos_f64(angle_rad));
        Self::new(cos, sin, -sin, cos, 0.0, 0.0)
    }

    /// Where a point goes.
    #[must_use]
    pub fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [(self.a * x + self.c * y) + self.e, (self.b * x + self.d * y) + self.f]
    }

    /// Where a direction goes: no translation.
    #[must_use]
    pub fn apply_vector(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.a * x + self.c * y, self.b * x + self.d * y]
    }

    /// The area of the image of a unit square, negative if mirrored.
    #[must_use]
    pub fn determinant(&self) -> f64 {
        self.a * self.d - self.b * self.c
    }

    /// The map back; `None` if there is none, or a number is not finite.
    #[must_use]
    pub fn inverse(&self) -> Option<Self> {
        let Self { a, b, c, d, e, f } = *self;
        let determinant = self.determinant();
        let back = Self::new(
            d / determinant,
            -b / determinant,
            -c / determinant,
            a / determinant,
            (c * f - d * e) / determinant,
            (b * e - a * f) / determinant,
        );
        back.is_finite().then_some(back)
    }

    /// True if all six numbers are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        [self.a, self.b, self.c, self.d, self.e, self.f].iter().all(|value| value.is_finite())
    }

    /// The lengths of the images of the unit vectors along x and y.
    #[must_use]
    pub fn axis_scales(&self) -> [f64; 2] {
        [(self.a * self.a + self.b * self.b).sqrt(), (self.c * self.c + self.d * self.d).sqrt()]
    }

    /// The largest factor by which any length grows: the larger singular value.
    #[must_use]
    pub fn max_scale(&self) -> f64 {
        let (p, q) = (self.a + self.d, self.b - self.c);
        let (r, s) = (self.a - self.d, self.b + self.c);
        ((p * p + q * q).sqrt() + (r * r + s * s).sqrt()) * 0.5
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// `outer * inner`: first `inner`, then `outer`.
impl Mul for Transform {
    type Output = Self;
    fn mul(self, inner: Self) -> Self {
        let [a, b] = self.apply_vector([inner.a, inner.b]);
        let [c, d] = self.apply_vector([inner.c, inner.d]);
        let [e, f] = self.apply([inner.e, inner.f]);
        Self { a, b, c, d, e, f }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_apply_the_right_one_first() {
        let both = Transform::translate(10.0, 0.0) * Transform::scale(2.0, 3.0);
        assert_eq!(both.apply([1.0, 1.0]), [12.0, 3.0]);
        assert_eq!(both.apply_vector([1.0, 1.0]), [2.0, 3.0]);
    }

    #[test]
    fn inverse_undoes() {
        let map = Transform::new(2.0, 1.0, -1.0, 3.0, 5.0, -7.0);
        let [x, y] = map.inverse().unwrap().apply(map.apply([3.0, 4.0]));
        assert!((x - 3.0).abs() < 1e-12 && (y - 4.0).abs() < 1e-12);
        assert_eq!(Transform::scale(0.0, 1.0).inverse(), None);
        assert_eq!(Transform::scale(f64::NAN, 1.0).inverse(), None);
    }

    #[test]
    fn largest_scale_of_a_turned_stretch() {
        let map = Transform::rotate(0.3) * Transform::scale(2.0, 5.0) * Transform::rotate(1.1);
        assert!((map.max_scale() - 5.0).abs() < 1e-12);
    }
}
