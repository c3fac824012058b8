//! feBlend: a picture blended with another by one of the blend modes, pixel by pixel.
//!
//! "Compositing and Blending Level 1", section 10: `cs(1 - ab) + cb(1 - as) + as ab B(cb, cs)`, where `as`, `ab` are the
//! alphas, `cs`, `cb` premultiplied in the first two terms and straight in the third.

use trigon_image::color::unit_to_u8;

use super::raster::{Pixel, Raster};
use crate::canvas::BlendMode;

type Rgb = [f32; 3];

/// `source` blended with `backdrop`, of the same size.
#[must_use]
pub fn blend(source: &Raster, mut backdrop: Raster, mode: BlendMode) -> Raster {
    for (below, above) in backdrop.pixels_mut().iter_mut().zip(source.pixels()) {
        if above[3] != 0 {
            *below = blended(*above, *below, mode);
        }
    }
    backdrop
}

fn blended(source: Pixel, backdrop: Pixel, mode: BlendMode) -> Pixel {
    let (cs, a_s) = straight(source);
    let (cb, ab) = straight(backdrop);
    let both = mixed(mode, cb, cs);
    let channel = |i: usize| cs[i] * a_s * (1.0 - ab) + cb[i] * ab * (1.0 - a_s) + a_s * ab * both[i];
    let alpha = unit_to_u8(a_s + ab - a_s * ab);
    let [r, g, b] = [0, 1, 2].map(|i| unit_to_u8(channel(i)).min(alpha));
    [r, g, b, alpha]
}

fn straight([r, g, b, a]: Pixel) -> (Rgb, f32) {
    let alpha = f32::from(a) / 255.0;
    let divisor = if a == 0 { 1.0 } else { f32::from(a) };
    ([r, g, b].map(|code| f32::from(code) / divisor), alpha)
}

/// The function B of the specification.
fn mixed(mode: BlendMode, cb: Rgb, cs: Rgb) -> Rgb {
    match mode {
        BlendMode::Hue => set_luminance(set_saturation(cs, saturation(cb)), luminance(cb)),
        BlendMode::Saturation => set_luminance(set_saturation(cb, saturation(cs)), luminance(cb)),
        BlendMode::Color => set_luminance(cs, luminance(cb)),
        BlendMode::Luminosity => set_luminance(cb, luminance(cs)),
        _ => std::array::from_fn(|i| separable(mode, cb[i], cs[i])),
    }
}

fn separable(mode: BlendMode, cb: f32, cs: f32) -> f32 {
    match mode {
        BlendMode::Multiply => cb * cs,
        BlendMode::Screen => cb + cs - cb * cs,
        BlendMode::Overlay => hard_light(cs, cb),
        BlendMode::Darken => cb.min(cs),
        BlendMode::Lighten => cb.max(cs),
        BlendMode::ColorDodge if cb <= 0.0 => 0.0,
        BlendMode::ColorDodge if cs >= 1.0 => 1.0,
        BlendMode::ColorDodge => (cb / (1.0 - cs)).min(1.0),
        BlendMode::ColorBurn if cb >= 1.0 => 1.0,
        BlendMode::ColorBurn if cs <= 0.0 => 0.0,
        BlendMode::ColorBurn => 1.0 - ((1.0 - cb) / cs).min(1.0),
        BlendMode::HardLight => hard_light(cb, cs),
        BlendMode::SoftLight => soft_light(cb, cs),
        BlendMode::Difference => (cb - cs).abs(),
        BlendMode::Exclusion => cb + cs - 2.0 * cb * cs,
        _ => cs,
    }
}

fn hard_light(cb: f32, cs: f32) -> f32 {
    if cs <= 0.5 {
        cb * (2.0 * cs)
    } else {
        let cs = 2.0 * cs - 1.0;
        cb + cs - cb * cs
    }
}

fn soft_light(cb: f32, cs: f32) -> f32 {
    if cs <= 0.5 {
        return cb - (1.0 - 2.0 * cs) * cb * (1.0 - cb);
    }
    let d = if cb <= 0.25 { ((16.0 * cb - 12.0) * cb + 4.0) * cb } else { cb.sqrt() };
    cb + (2.0 * cs - 1.0) * (d - cb)
}

fn luminance([r, g, b]: Rgb) -> f32 {
    0.3 * r + 0.59 * g + 0.11 * b
}

fn saturation([r, g, b]: Rgb) -> f32 {
    r.max(g).max(b) - r.min(g).min(b)
}

fn set_saturation(color: Rgb, wanted: f32) -> Rgb {
    let [r, g, b] = color;
    let least = r.min(g).min(b);
    let range = saturation(color);
    if range > 0.0 { color.map(|channel| (channel - least) * wanted / range) } else { [0.0; 3] }
}

fn set_luminance(color: Rgb, wanted: f32) -> Rgb {
    let shift = wanted - luminance(color);
    let shifted = color.map(|channel| channel + shift);
    let (least, most) = (shifted[0].min(shifted[1]).min(shifted[2]), shifted[0].max(shifted[1]).max(shifted[2]));
    let l = luminance(shifted);
    let mut clipped = shifted;
    if least < 0.0 {
        clipped = clipped.map(|channel| l + (channel - l) * l / (l - least));
    }
    if most > 1.0 {
        clipped = clipped.map(|channel| l + (channel - l) * (1.0 - l) / (most - l));
    }
    clipped
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLORS: [Pixel; 5] = [[255, 0, 0, 255], [10, 200, 90, 255], [64, 0, 128, 128], [0; 4], [255; 4]];

    #[test]
    fn transparent_sources_and_backdrops_change_nothing() {
        for mode in BlendMode::ALL {
            for color in COLORS {
                assert_eq!(blended(color, [0; 4], mode), color, "{mode:?}");
                assert_eq!(blended([0; 4], color, mode), color, "{mode:?}");
            }
        }
    }

    #[test]
    fn colors_never_exceed_alpha() {
        for mode in BlendMode::ALL {
            for source in COLORS {
                for backdrop in COLORS {
                    let [r, g, b, a] = blended(source, backdrop, mode);
                    assert!(r <= a && g <= a && b <= a, "{mode:?} {source:?} {backdrop:?}");
                }
            }
        }
    }

    #[test]
    fn known_values() {
        let of = |mode, source, backdrop| blended(source, backdrop, mode);
        assert_eq!(of(BlendMode::Multiply, [128, 128, 128, 255], [255, 128, 0, 255]), [128, 64, 0, 255]);
        assert_eq!(of(BlendMode::Difference, [255; 4], [255, 0, 10, 255]), [0, 255, 245, 255]);
        assert_eq!(of(BlendMode::Luminosity, [255; 4], [255, 0, 0, 255]), [255; 4]);
        assert_eq!(of(BlendMode::Normal, [0, 64, 0, 64], [200, 0, 0, 255]), [150, 64, 0, 255]);
    }
}
