//! Vertex colours: sRGB-encoded values of files in, linear light out.
//!
//! OBJ and PLY state no colour space; the programs that write vertex colours (scanners, sculpting tools, MeshLab,
//! Blender) write display values, so they are decoded as sRGB (IEC 61966-2-1). Alpha is linear already.

use trigon_image::color::{srgb_decode, srgb_to_linear};

/// Red, green, blue and alpha as written, times `scale`, to linear light. What is not finite becomes white.
pub(crate) fn linear_from_srgb([r, g, b, a]: [f32; 4], scale: f32) -> [f32; 4] {
    let decode = |c: f32| if c.is_finite() { decode_srgb(c * scale) } else { 1.0 };
    [decode(r), decode(g), decode(b), if a.is_finite() { (a * scale).clamp(0.0, 1.0) } else { 1.0 }]
}

fn decode_srgb(encoded: f32) -> f32 {
    let encoded = encoded.clamp(0.0, 1.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within 0 to 255 by the clamp")]
    let code = (encoded * 255.0 + 0.5) as u8;
    // Nearly all files hold 8-bit values, for which there is a table.
    if (encoded * 255.0 - f32::from(code)).abs() < 1e-4 {
        return srgb_to_linear(code);
    }
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    {
        srgb_decode(f64::from(encoded)) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_middle_of_the_curve() {
        assert_eq!(linear_from_srgb([0.0, 1.0, f32::NAN, 0.5], 1.0), [0.0, 1.0, 1.0, 0.5]);
        let middle = linear_from_srgb([128.0, 10.0, 255.0, 255.0], 1.0 / 255.0);
        assert!((middle[0] - 0.215_860_5).abs() < 1e-6 && (middle[1] - 0.003_035_27).abs() < 1e-7, "{middle:?}");
        assert_eq!(middle[3], 1.0);
    }
}
