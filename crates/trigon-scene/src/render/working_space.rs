//! The space that a frame computes colours in: linear light or display values in, numbers for its shaders out.
//!
//! Scenes and settings hold linear light, materials display values. In [`ColorSpace::Linear`] the latter are decoded
//! from sRGB; in [`ColorSpace::Encoded`] the former are encoded. Above 1 a value stays what it is in both.

use trigon::target::ColorSpace;
use trigon_image::color::{premultiply, srgb_decode, srgb_encode, unpremultiply};

/// Display values as numbers of `space`.
pub(super) fn from_display(space: ColorSpace, color: [f32; 3]) -> [f32; 3] {
    match space {
        ColorSpace::Linear => color.map(decode),
        ColorSpace::Encoded => color.map(|c| c.max(0.0)),
    }
}

/// Numbers of `space` as display values.
pub(super) fn to_display(space: ColorSpace, color: [f32; 3]) -> [f32; 3] {
    match space {
        ColorSpace::Linear => color.map(encode),
        ColorSpace::Encoded => color,
    }
}

/// Linear light as numbers of `space`.
pub(super) fn from_linear(space: ColorSpace, color: [f32; 3]) -> [f32; 3] {
    match space {
        ColorSpace::Linear => color,
        ColorSpace::Encoded => color.map(encode),
    }
}

/// The same for colours that are premultiplied by alpha.
pub(super) fn from_linear_premultiplied(space: ColorSpace, color: [f32; 4]) -> [f32; 4] {
    match space {
        ColorSpace::Linear => color,
        ColorSpace::Encoded => through(color, encode),
    }
}

/// Premultiplied display values as linear light.
pub(super) fn pixels_to_linear(pixels: &mut [[f32; 4]]) {
    for pixel in pixels {
        *pixel = through(*pixel, decode);
    }
}

fn through(color: [f32; 4], curve: fn(f32) -> f32) -> [f32; 4] {
    let [r, g, b, alpha] = unpremultiply(color);
    premultiply([curve(r), curve(g), curve(b), alpha])
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
fn decode(c: f32) -> f32 {
    if c > 0.0 && c < 1.0 { srgb_decode(f64::from(c)) as f32 } else { c.max(0.0) }
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
fn encode(c: f32) -> f32 {
    if c > 0.0 && c < 1.0 { srgb_encode(f64::from(c)) as f32 } else { c.max(0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_agree_on_what_is_stored() {
        let display = [0.2, 0.5, 1.5];
        let linear = from_display(ColorSpace::Linear, display);
        for (got, want) in from_linear(ColorSpace::Encoded, linear).into_iter().zip(display) {
            assert!((got - want).abs() < 1e-6, "{got} is not {want}");
        }
        let mut pixels = [[0.1, 0.25, 0.5, 0.5], [0.0; 4]];
        pixels_to_linear(&mut pixels);
        let back = pixels.map(|pixel| from_linear_premultiplied(ColorSpace::Encoded, pixel));
        for (got, want) in back.as_flattened().iter().zip([0.1, 0.25, 0.5, 0.5, 0.0, 0.0, 0.0, 0.0]) {
            assert!((got - want).abs() < 1e-6, "{got} is not {want}");
        }
    }
}
