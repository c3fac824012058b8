//! Straight and premultiplied alpha, and numbers in 0..=1 as codes.

/// Straight to premultiplied alpha: colour times alpha. Both in linear light.
#[must_use]
#[inline]
pub fn premultiply([r, g, b, a]: [f32; 4]) -> [f32; 4] {
    [r * a, g * a, b * a, a]
}

/// Premultiplied to straight alpha: colour over alpha; black where alpha is not above 0. Both in linear light.
#[must_use]
#[inline]
pub fn unpremultiply([r, g, b, a]: [f32; 4]) -> [f32; 4] {
    if a > 0.0 { [r / a, g / a, b / a, a] } else { [0.0, 0.0, 0.0, 0.0] }
}

/// The nearest of 256 codes to `x`, halves up, with no transfer function; NaN gives 0, and 0..=1 is clamped to.
#[must_use]
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "a cast from float saturates, and NaN gives 0")]
#[expect(clippy::cast_sign_loss, reason = "a cast from float saturates")]
pub fn unit_to_u8(x: f32) -> u8 {
    // Exact in f64: 24 bits times 8 bits, plus a half.
    (f64::from(x) * 255.0 + 0.5) as u8
}

/// The nearest of 65536 codes to `x`, halves up, with no transfer function; NaN gives 0, and 0..=1 is clamped to.
#[must_use]
#[inline]
#[expect(clippy::cast_possible_truncation, reason = "a cast from float saturates, and NaN gives 0")]
#[expect(clippy::cast_sign_loss, reason = "a cast from float saturates")]
pub fn unit_to_u16(x: f32) -> u16 {
    (f64::from(x) * 65535.0 + 0.5) as u16
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_round_trip_and_clamp() {
        for code in 0..=u8::MAX {
            assert_eq!(unit_to_u8(f32::from(code) / 255.0), code);
        }
        for code in 0..=u16::MAX {
            assert_eq!(unit_to_u16(f32::from(code) / 65535.0), code);
        }
        for (x, code) in [(f32::NAN, 0), (-1.0, 0), (-0.0, 0), (7.0, 255), (f32::INFINITY, 255), (0.5, 128)] {
            assert_eq!(unit_to_u8(x), code);
        }
    }

    #[test]
    fn premultiplying_is_undone() {
        let color = [0.25, 0.5, 2.0, 0.5];
        assert_eq!(unpremultiply(premultiply(color)), color);
        assert_eq!(unpremultiply([0.5, 0.5, 0.5, 0.0]), [0.0; 4]);
        assert_eq!(unpremultiply([0.5, 0.5, 0.5, f32::NAN]), [0.0; 4]);
    }
}
