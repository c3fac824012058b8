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

/// Divides encoded color by alpha, as the writers of premultiplied files of integers multiplied it; nearest code.
pub(crate) fn unpremultiply_u8([r, g, b, a]: [u8; 4]) -> [u8; 4] {
    let straight = |code: u8| match a {
        0 => 0,
        _ => u8::try_from((u32::from(code) * 255 + u32::from(a) / 2) / u32::from(a)).unwrap_or(u8::MAX),
    };
    [straight(r), straight(g), straight(b), a]
}

/// Divides encoded color by alpha, as the writers of premultiplied files of integers multiplied it; nearest code.
pub(crate) fn unpremultiply_u16([r, g, b, a]: [u16; 4]) -> [u16; 4] {
    let straight = |code: u16| match a {
        0 => 0,
        _ => u16::try_from((u64::from(code) * 65535 + u64::from(a) / 2) / u64::from(a)).unwrap_or(u16::MAX),
    };
    [straight(r), straight(g), straight(b), a]
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
    fn premultiplied_codes_are_divided() {
        assert_eq!(unpremultiply_u8([64, 128, 200, 128]), [128, 255, 255, 128]);
        assert_eq!(unpremultiply_u8([9, 9, 9, 0]), [0; 4]);
        assert_eq!(unpremultiply_u16([16384, 32768, 65535, 32768]), [32768, 65535, 65535, 32768]);
        for code in 0..=u8::MAX {
            assert_eq!(unpremultiply_u8([code, 0, 0, 255])[0], code);
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
