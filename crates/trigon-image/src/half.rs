//! IEEE 754 binary16 numbers, as EXR files hold them, from and to `f32`: in integers, so equal on every machine.

/// The exact value of a half-precision number.
pub(crate) fn f16_to_f32(half: u16) -> f32 {
    let sign = u32::from(half & 0x8000) << 16;
    let exponent = u32::from(half >> 10 & 0x1f);
    let mantissa = u32::from(half & 0x3ff);
    let magnitude = match (exponent, mantissa) {
        (0x1f, _) => 0x7f80_0000 | mantissa << 13,
        (0, 0) => 0,
        // Subnormal: units of 2^-24, normalized by moving the leading one to bit 10.
        (0, _) => {
            let shift = mantissa.leading_zeros() - 21;
            (113 - shift) << 23 | (mantissa << shift & 0x3ff) << 13
        }
        _ => (exponent + 112) << 23 | mantissa << 13,
    };
    f32::from_bits(sign | magnitude)
}

/// The nearest half-precision number, ties to even; overflow gives infinity, NaN stays NaN.
#[expect(clippy::cast_possible_truncation, reason = "each branch keeps 16 bits")]
pub(crate) fn f32_to_f16(x: f32) -> u16 {
    let bits = x.to_bits();
    let sign = (bits >> 16 & 0x8000) as u16;
    let magnitude = bits & 0x7fff_ffff;
    let half = if magnitude > 0x7f80_0000 {
        0x7e00
    } else if magnitude >= 0x4780_0000 {
        // From 2^16 on, also infinity. Smaller numbers that round up to 2^16 get there by the carry below.
        0x7c00
    } else if magnitude >= 0x3880_0000 {
        // Normal: a smaller bias and 13 bits less.
        round_to_even(magnitude - (112 << 23), 13) as u16
    } else if magnitude >= 0x3300_0000 {
        // Subnormal: the mantissa with its leading one, in units of 2^-24.
        let shift = 126 - (magnitude >> 23);
        round_to_even(magnitude & 0x007f_ffff | 0x0080_0000, shift) as u16
    } else {
        0
    };
    sign | half
}

/// `bits / 2^shift` to the nearest integer, ties to even.
fn round_to_even(bits: u32, shift: u32) -> u32 {
    let half = 1 << (shift - 1);
    let odd = bits >> shift & 1;
    (bits + half - 1 + odd) >> shift
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All finite numbers of 16 bits in ascending order from 0.
    fn positive_halves() -> impl Iterator<Item = u16> {
        0..0x7c00
    }

    #[test]
    fn every_half_round_trips() {
        for half in 0..=u16::MAX {
            let x = f16_to_f32(half);
            if x.is_nan() {
                assert_eq!(f32_to_f16(x) & 0x7fff, 0x7e00);
            } else {
                assert_eq!(f32_to_f16(x), half, "{x}");
            }
        }
    }

    #[test]
    fn values_follow_the_definition() {
        for half in positive_halves() {
            let (exponent, mantissa) = (i32::from(half >> 10), f64::from(half & 0x3ff));
            let truth = match exponent {
                0 => libm::ldexp(mantissa, -24),
                _ => libm::ldexp(1024.0 + mantissa, exponent - 25),
            };
            assert_eq!(f64::from(f16_to_f32(half)), truth);
            assert_eq!(f64::from(f16_to_f32(half | 0x8000)), -truth);
        }
        assert_eq!(f16_to_f32(0x7c00), f32::INFINITY);
    }

    #[test]
    #[expect(clippy::cast_possible_truncation, reason = "the middle of two halves has few bits")]
    fn rounding_is_to_nearest_even() {
        for half in positive_halves() {
            let next = half + 1;
            let below = f64::from(f16_to_f32(half));
            // Above the largest comes 2^16 as far as rounding goes.
            let above = if next == 0x7c00 { 65536.0 } else { f64::from(f16_to_f32(next)) };
            let middle = f64::midpoint(below, above) as f32;
            assert_eq!(f32_to_f16(middle), half + (half & 1), "tie above {below}");
            assert_eq!(f32_to_f16(middle.next_down()), half);
            assert_eq!(f32_to_f16(middle.next_up()), next);
        }
        assert_eq!(f32_to_f16(f32::MAX), 0x7c00);
        assert_eq!(f32_to_f16(-f32::INFINITY), 0xfc00);
        assert_eq!(f32_to_f16(-0.0), 0x8000);
    }
}
