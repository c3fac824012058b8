//! Colours as the engine holds them: premultiplied, sRGB-encoded, packed into one `u32`, red in the lowest byte.

use trigon_image::Color;

/// `round(value / 255)` for `value` up to 255 * 255: exact, halves cannot occur.
#[inline(always)]
pub(crate) const fn div_255(value: u32) -> u32 {
    let biased = value + 128;
    (biased + (biased >> 8)) >> 8
}

/// Packs bytes.
#[inline(always)]
pub(crate) const fn pack(pixel: [u8; 4]) -> u32 {
    u32::from_le_bytes(pixel)
}

/// The premultiplied colour, with `opacity` multiplied into its alpha: products are formed in double precision and
/// rounded once each, halves up.
pub(crate) fn premultiplied(color: Color, opacity: f32) -> u32 {
    let alpha = f64::from(color.a) * f64::from(unit(opacity)) / 255.0;
    let channel = |value: u8| to_byte(f64::from(value) * alpha);
    pack([channel(color.r), channel(color.g), channel(color.b), to_byte(255.0 * alpha)])
}

/// Premultiplied alpha from straight: products over 255, rounded to nearest.
pub(crate) fn premultiplied_pixel([r, g, b, a]: [u8; 4]) -> [u8; 4] {
    let product = |value: u8| div_255(u32::from(value) * u32::from(a)) as u8;
    [product(r), product(g), product(b), a]
}

/// Into 0..=1; NaN is 0.
#[inline(always)]
pub(crate) fn unit(value: f32) -> f32 {
    if value > 0.0 { if value < 1.0 { value } else { 1.0 } } else { 0.0 }
}

/// 0..=255 to the nearest byte, halves up.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the values are 0 to 255")]
fn to_byte(value: f64) -> u8 {
    (value + 0.5) as u8
}

/// Straight alpha from premultiplied: each colour times 255 / alpha, rounded to nearest, at most 255.
pub(crate) fn straight([r, g, b, a]: [u8; 4]) -> [u8; 4] {
    match a {
        0 => [0; 4],
        255 => [r, g, b, 255],
        _ => {
            let divide = |value: u8| {
                let quotient = (u32::from(value) * 510 + u32::from(a)) / (2 * u32::from(a));
                u8::try_from(quotient).unwrap_or(u8::MAX)
            };
            [divide(r), divide(g), divide(b), a]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn division_by_255_rounds_to_nearest() {
        for value in 0..=255 * 255 {
            assert_eq!(div_255(value), (value * 2 + 255) / 510, "{value}");
        }
    }

    #[test]
    fn straight_undoes_premultiplied_for_opaque_and_transparent() {
        let teal = Color { r: 0, g: 128, b: 128, a: 255 };
        assert_eq!(straight(premultiplied(teal, 1.0).to_le_bytes()), [0, 128, 128, 255]);
        assert_eq!(straight(premultiplied(teal, 0.0).to_le_bytes()), [0; 4]);
        assert_eq!(premultiplied(teal, 0.5).to_le_bytes(), [0, 64, 64, 128]);
        assert_eq!(premultiplied(teal, f32::NAN), 0);
    }
}
