//! Three-component vectors as plain `[f64; 3]` arrays: the few operations that loaders and cameras need.
//!
//! Arrays rather than a type of our own: positions are `[f32; 3]` in the attribute arrays, and [`widen`] is exact.

/// A vector or point in `f64`.
pub type Vec3 = [f64; 3];

/// The same vector in `f64`; exact.
#[inline]
#[must_use]
pub fn widen(v: [f32; 3]) -> Vec3 {
    v.map(f64::from)
}

/// The nearest `f32` vector; components beyond the range of `f32` become infinite.
#[inline]
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
pub fn narrow(v: Vec3) -> [f32; 3] {
    v.map(|c| c as f32)
}

/// `a + b`.
#[inline]
#[must_use]
pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a - b`.
#[inline]
#[must_use]
pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `v * s`.
#[inline]
#[must_use]
pub fn scale(v: Vec3, s: f64) -> Vec3 {
    [v[0] * s, v[1] * s, v[2] * s]
}

/// The dot product, summed in the order x, y, z.
#[inline]
#[must_use]
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

/// The right-handed cross product `a x b`.
#[inline]
#[must_use]
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The Euclidean length.
#[inline]
#[must_use]
pub fn length(v: Vec3) -> f64 {
    dot(v, v).sqrt()
}

/// The unit vector along `v`, or `None` where `v` is zero or not finite.
#[inline]
#[must_use]
pub fn normalized(v: Vec3) -> Option<Vec3> {
    let largest = v.iter().fold(0.0_f64, |m, c| if c.abs() > m { c.abs() } else { m });
    if !(v.iter().all(|c| c.is_finite()) && largest > 0.0) {
        return None;
    }
    // Scale first, so that squares neither overflow nor vanish.
    let v = [v[0] / largest, v[1] / largest, v[2] / largest];
    let length = length(v);
    Some([v[0] / length, v[1] / length, v[2] / length])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_survive_extreme_lengths() {
        for s in [1e-300, 1e-3, 1.0, 1e300] {
            let unit = normalized([3.0 * s, 0.0, -4.0 * s]).unwrap();
            assert!((length(unit) - 1.0).abs() < 1e-15, "{unit:?}");
        }
        assert_eq!(normalized([0.0; 3]), None);
        assert_eq!(normalized([f64::NAN, 1.0, 0.0]), None);
        assert_eq!(normalized([f64::INFINITY, 1.0, 0.0]), None);
    }

    #[test]
    fn cross_product_is_right_handed() {
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    }
}
