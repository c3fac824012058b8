//! Components to red, green and blue: values per pixel in, opaque pixels out.
//!
//! YCbCr is that of JFIF (ITU-R BT.601, full range) in 16-bit fixed point with the roundings of `jdcolor.c`. Which of the
//! colours a file has is said by its markers, or else guessed from the names of its components, as libjpeg does.

use crate::color::without_inks;

/// What the components of a pixel are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Color {
    Grey,
    YCbCr,
    Rgb,
    /// Amounts of ink. Adobe's programs store them inverted.
    Cmyk {
        is_inverted: bool,
    },
    /// Cyan, magenta and yellow as inverted YCbCr; and black.
    Ycck {
        is_inverted: bool,
    },
}

impl Color {
    /// From the names of the components, of which there are one, three or four, whether there is a JFIF marker, and the
    /// transform in an Adobe marker.
    pub(super) fn new(ids: &[u8], has_jfif: bool, adobe: Option<u8>) -> Self {
        let is_inverted = adobe.is_some();
        match (ids, adobe) {
            ([_], _) => Self::Grey,
            ([_, _, _], _) if has_jfif => Self::YCbCr,
            ([_, _, _], Some(0)) => Self::Rgb,
            ([b'R', b'G', b'B'], None) => Self::Rgb,
            ([_, _, _], _) => Self::YCbCr,
            (_, None | Some(0)) => Self::Cmyk { is_inverted },
            (_, Some(_)) => Self::Ycck { is_inverted },
        }
    }

    /// Appends the pixels of one row to `pixels`; `rows` has a row of values for each component.
    pub(super) fn append(self, rows: &[Vec<u8>], width: usize, pixels: &mut Vec<[u8; 4]>) {
        match (self, rows) {
            (Self::Grey, [grey]) => pixels.extend(grey[..width].iter().map(|&grey| [grey, grey, grey, u8::MAX])),
            (Self::Rgb | Self::YCbCr, [a, b, c]) => {
                let values = a[..width].iter().zip(&b[..width]).zip(&c[..width]).map(|((&a, &b), &c)| [a, b, c]);
                if self == Self::Rgb {
                    pixels.extend(values.map(opaque));
                } else {
                    pixels.extend(values.map(rgb_of_ycbcr).map(opaque));
                }
            }
            (Self::Cmyk { is_inverted } | Self::Ycck { is_inverted }, [a, b, c, k]) => {
                let is_ycck = matches!(self, Self::Ycck { .. });
                pixels.extend((0..width).map(|x| {
                    let color = [a[x], b[x], c[x]];
                    let inks = if is_ycck { rgb_of_ycbcr(color).map(|value| !value) } else { color };
                    let amount = |value: u8| if is_inverted { !value } else { value };
                    opaque(inks.map(|ink| without_inks(amount(ink), amount(k[x]))))
                }));
            }
            _ => {}
        }
    }
}

fn opaque([r, g, b]: [u8; 3]) -> [u8; 4] {
    [r, g, b, u8::MAX]
}

#[inline(always)]
fn rgb_of_ycbcr([y, cb, cr]: [u8; 3]) -> [u8; 3] {
    const HALF: i32 = 1 << 15;
    let [y, cb, cr] = [i32::from(y), i32::from(cb) - 128, i32::from(cr) - 128];
    [
        y + ((91_881 * cr + HALF) >> 16),                // 1.40200
        y + ((-22_554 * cb - 46_802 * cr + HALF) >> 16), // 0.34414 and 0.71414
        y + ((116_130 * cb + HALF) >> 16),               // 1.77200
    ]
    .map(|value| u8::try_from(value.clamp(0, 255)).unwrap_or(u8::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markers_come_before_names() {
        let color = |ids: &[u8], has_jfif, adobe| Color::new(ids, has_jfif, adobe);
        assert_eq!(color(&[1, 2, 3], false, None), Color::YCbCr);
        assert_eq!(color(b"RGB", false, None), Color::Rgb);
        assert_eq!(color(b"RGB", true, None), Color::YCbCr);
        assert_eq!(color(&[1, 2, 3], false, Some(0)), Color::Rgb);
        assert_eq!(color(b"RGB", false, Some(1)), Color::YCbCr);
        assert_eq!(color(&[1, 2, 3, 4], true, Some(2)), Color::Ycck { is_inverted: true });
        assert_eq!(color(&[1, 2, 3, 4], true, Some(0)), Color::Cmyk { is_inverted: true });
        assert_eq!(color(&[1, 2, 3, 4], true, Some(1)), Color::Ycck { is_inverted: true });
        assert_eq!(color(&[1, 2, 3, 4], false, None), Color::Cmyk { is_inverted: false });
    }

    #[test]
    fn primaries_of_ycbcr_are_within_one_of_the_definition() {
        for y in (0..=255_u8).step_by(5) {
            assert_eq!(rgb_of_ycbcr([y, 128, 128]), [y; 3]);
            for (cb, cr) in [(0, 0), (255, 3), (100, 200), (17, 128), (128, 250)] {
                let [l, b, r] = [f64::from(y), f64::from(cb) - 128.0, f64::from(cr) - 128.0];
                let want = [l + 1.402 * r, l - 0.344_136 * b - 0.714_136 * r, l + 1.772 * b];
                for (got, want) in rgb_of_ycbcr([y, cb, cr]).into_iter().zip(want) {
                    assert!((f64::from(got) - want.clamp(0.0, 255.0)).abs() < 0.51, "{got} is not {want}");
                }
            }
        }
    }

    #[test]
    fn inks_take_light_away() {
        let pixel = |is_inverted, values: [u8; 4]| {
            let mut pixels = Vec::new();
            Color::Cmyk { is_inverted }.append(&values.map(|value| vec![value]), 1, &mut pixels);
            pixels[0]
        };
        assert_eq!(pixel(false, [0, 255, 0, 0]), [255, 0, 255, 255]);
        assert_eq!(pixel(true, [255, 0, 255, 128]), [128, 0, 128, 255]);
    }
}
