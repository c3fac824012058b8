//! The end of a layer: its pixels, times masks and opacity, blended with what is below, sample by sample.

use super::blend::blend;
use super::color::div_255;
use super::over::{over_lanes, scale, scale_lanes};
use super::paint::Brush;
use super::shader::Shader;
use super::surface::{Pixel, Surface};
use crate::canvas::{BlendMode, MaskKind};
use trigon::lanes::{Lanes, U32};

/// Blends `layer` with `below`. `masks` hold a coefficient of 0..=255 for each sample of the layer; `colors` is memory to
/// work in.
#[expect(clippy::too_many_arguments, reason = "the parts of one step")]
#[inline(always)]
pub(crate) fn blend_layer<L: Lanes>(
    l: L,
    layer: &Surface,
    masks: &[Surface],
    opacity: u32,
    mode: BlendMode,
    full_mask: u16,
    below: &mut Surface,
    colors: &mut Vec<u32>,
) {
    let brush = Brush { shader: &Shader::Solid(0), blend: mode, full_mask };
    let bounds = layer.bounds();
    if bounds.is_empty() {
        return;
    }
    for y in bounds.rows[0]..bounds.rows[1] {
        let drawn = layer.drawn(y);
        let mut row = below.row_mut(y);
        let shift = (bounds.columns[0] - row.left) as usize;
        let mut x = drawn.start;
        while x < drawn.end {
            // Pixels of one colour, side by side.
            colors.clear();
            let start = x;
            while x < drawn.end {
                let Some(color) = whole_color(layer, masks, x, y, opacity) else { break };
                colors.push(color);
                x += 1;
            }
            if !colors.is_empty() {
                brush.colored_span_at(l, start + shift, full_mask, colors, &mut row);
            }
            // A pixel whose samples differ.
            if x < drawn.end {
                let source = samples(l, layer, masks, x, y, opacity);
                row.mark_drawn(x + shift, x + shift + 1);
                let line = row.expand(l, x + shift);
                if mode == BlendMode::Normal {
                    line.0 = over_lanes(l, source, l.u32_array(&line.0)).to_array();
                } else {
                    for (below, source) in line.0.iter_mut().zip(source.to_array()) {
                        *below = blend(mode, source, *below);
                    }
                }
                x += 1;
            }
        }
    }
}

/// The colour of a pixel whose samples are all alike, in the layer and in all masks.
#[inline(always)]
fn whole_color(layer: &Surface, masks: &[Surface], x: usize, y: u32, opacity: u32) -> Option<u32> {
    let Pixel::Whole(mut color) = layer.pixel(x, y) else { return None };
    for mask in masks {
        let Pixel::Whole(coefficient) = mask.pixel(x, y) else { return None };
        color = scale(color, coefficient);
    }
    Some(if opacity == 255 { color } else { scale(color, opacity) })
}

/// The colours of the samples of a pixel.
#[inline(always)]
fn samples<L: Lanes>(l: L, layer: &Surface, masks: &[Surface], x: usize, y: u32, opacity: u32) -> U32<L> {
    let mut color = lanes_of(l, layer.pixel(x, y));
    for mask in masks {
        color = scale_lanes(l, color, lanes_of(l, mask.pixel(x, y)));
    }
    scale_lanes(l, color, l.u32(opacity))
}

#[inline(always)]
fn lanes_of<L: Lanes>(l: L, pixel: Pixel<'_>) -> U32<L> {
    match pixel {
        Pixel::Whole(word) => l.u32(word),
        Pixel::Samples(line) => l.u32_array(&line.0),
    }
}

/// Turns the colours of a mask's drawing into coefficients of 0..=255.
pub(crate) fn to_coefficients(kind: MaskKind, surface: &mut Surface) {
    match kind {
        MaskKind::Alpha => surface.map(|color| color >> 24),
        MaskKind::Luminance => surface.map(luminance),
        MaskKind::LinearLuminance => surface.map(linear_luminance),
    }
}

/// 0.2125 r + 0.7154 g + 0.0721 b in 1/65,536, halves up (SVG 2, "Masking", through CSS Masking, section 7.10.1).
fn luminance(color: u32) -> u32 {
    let [r, g, b, _] = color.to_le_bytes().map(u32::from);
    (r * 13_927 + g * 46_884 + b * 4_725 + 32_768) >> 16
}

/// The same of the straight colour in linear light, times alpha.
fn linear_luminance(color: u32) -> u32 {
    let [r, g, b, a] = super::color::straight(color.to_le_bytes());
    let linear = |value: u8| trigon_image::color::srgb_to_linear(value);
    let luminance = (0.2125 * linear(r) + 0.7154 * linear(g)) + 0.0721 * linear(b);
    div_255((luminance * 255.0 + 0.5) as u32 * u32::from(a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn luminance_of_white_is_full_and_of_black_none() {
        assert_eq!((luminance(u32::MAX), luminance(0xFF00_0000)), (255, 0));
        assert_eq!((linear_luminance(u32::MAX), linear_luminance(0xFF00_0000)), (255, 0));
        assert_eq!(luminance(0x8080_8080), 128);
        assert!(linear_luminance(0xFF80_8080) < 60);
    }
}
