//! The blend modes, on premultiplied bytes: one sample over another.
//!
//! The formulas are those of "Compositing and Blending Level 1" (W3C), sections 5.1, 9 and 10, in single precision with
//! only exact operations; each channel is rounded once, halves up. Normal is not here: it is exact in integers
//! ([`over`](super::over)).

use super::over::over;
use crate::canvas::BlendMode;

/// Red, green, blue in 0..=1.
type Rgb = [f32; 3];

/// `source` over `below` by a blend mode.
pub(crate) fn blend(mode: BlendMode, source: u32, below: u32) -> u32 {
    if mode == BlendMode::Normal || source >> 24 == 0 || below >> 24 == 0 {
        return over(source, below);
    }
    if mode == BlendMode::PlusLighter {
        return sum(source, below);
    }
    let (s, source_alpha) = unpacked(source);
    let (b, below_alpha) = unpacked(below);
    let mixed = mix(mode, straight(b, below_alpha), straight(s, source_alpha));
    // co = cs (1 - ab) + cb (1 - as) + as ab B(Cb, Cs), all premultiplied.
    let both = source_alpha * below_alpha;
    let channel = |i: usize| (s[i] * (1.0 - below_alpha) + b[i] * (1.0 - source_alpha)) + both * mixed[i];
    let alpha = (source_alpha + below_alpha) - both;
    pack(channel(0), channel(1), channel(2), alpha)
}

/// Premultiplied colours added, each channel up to 255.
fn sum(source: u32, below: u32) -> u32 {
    let (s, b) = (source.to_le_bytes(), below.to_le_bytes());
    u32::from_le_bytes(core::array::from_fn(|i| s[i].saturating_add(b[i])))
}

/// The function B of the specification: straight colours in, a straight colour out.
fn mix(mode: BlendMode, below: Rgb, source: Rgb) -> Rgb {
    match mode {
        BlendMode::Hue => set_luminosity(set_saturation(source, saturation(below)), luminosity(below)),
        BlendMode::Saturation => set_luminosity(set_saturation(below, saturation(source)), luminosity(below)),
        BlendMode::Color => set_luminosity(source, luminosity(below)),
        BlendMode::Luminosity => set_luminosity(below, luminosity(source)),
        _ => core::array::from_fn(|i| mix_channel(mode, below[i], source[i])),
    }
}

/// B for the modes that treat each channel alone.
fn mix_channel(mode: BlendMode, below: f32, source: f32) -> f32 {
    match mode {
        BlendMode::Multiply => below * source,
        BlendMode::Screen => screen(below, source),
        BlendMode::Overlay => hard_light(source, below),
        BlendMode::HardLight => hard_light(below, source),
        BlendMode::Darken => smaller(below, source),
        BlendMode::Lighten => larger(below, source),
        BlendMode::ColorDodge if below <= 0.0 => 0.0,
        BlendMode::ColorDodge if source >= 1.0 => 1.0,
        BlendMode::ColorDodge => smaller(1.0, below / (1.0 - source)),
        BlendMode::ColorBurn if below >= 1.0 => 1.0,
        BlendMode::ColorBurn if source <= 0.0 => 0.0,
        BlendMode::ColorBurn => 1.0 - smaller(1.0, (1.0 - below) / source),
        BlendMode::SoftLight => soft_light(below, source),
        BlendMode::Difference => (below - source).abs(),
        BlendMode::Exclusion => (below + source) - 2.0 * (below * source),
        _ => source,
    }
}

fn screen(below: f32, source: f32) -> f32 {
    (below + source) - below * source
}

fn hard_light(below: f32, source: f32) -> f32 {
    if source <= 0.5 { below * (2.0 * source) } else { screen(below, 2.0 * source - 1.0) }
}

fn soft_light(below: f32, source: f32) -> f32 {
    if source <= 0.5 {
        return below - ((1.0 - 2.0 * source) * below) * (1.0 - below);
    }
    let lit = if below <= 0.25 { ((16.0 * below - 12.0) * below + 4.0) * below } else { below.sqrt() };
    below + (2.0 * source - 1.0) * (lit - below)
}

fn luminosity([r, g, b]: Rgb) -> f32 {
    (0.3 * r + 0.59 * g) + 0.11 * b
}

fn saturation([r, g, b]: Rgb) -> f32 {
    larger(larger(r, g), b) - smaller(smaller(r, g), b)
}

/// `color` with another luminosity, moved towards grey as far as it left 0..=1 (`SetLum` and `ClipColor`).
fn set_luminosity(color: Rgb, wanted: f32) -> Rgb {
    let shift = wanted - luminosity(color);
    let color = color.map(|channel| channel + shift);
    let gray = luminosity(color);
    let least = smaller(smaller(color[0], color[1]), color[2]);
    let most = larger(larger(color[0], color[1]), color[2]);
    let mut out = color;
    if least < 0.0 {
        out = out.map(|channel| gray + ((channel - gray) * gray) / (gray - least));
    }
    if most > 1.0 {
        out = out.map(|channel| gray + ((channel - gray) * (1.0 - gray)) / (most - gray));
    }
    out
}

/// `color` stretched to another saturation, its least channel 0 (`SetSat`).
fn set_saturation(color: Rgb, wanted: f32) -> Rgb {
    let least = smaller(smaller(color[0], color[1]), color[2]);
    let range = saturation(color);
    if range > 0.0 { color.map(|channel| ((channel - least) * wanted) / range) } else { [0.0; 3] }
}

fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Premultiplied colour and alpha in 0..=1.
fn unpacked(pixel: u32) -> (Rgb, f32) {
    let [r, g, b, a] = pixel.to_le_bytes().map(|byte| f32::from(byte) / 255.0);
    ([r, g, b], a)
}

fn straight(color: Rgb, alpha: f32) -> Rgb {
    color.map(|channel| smaller(1.0, channel / alpha))
}

/// To bytes, halves up; no colour above its alpha.
fn pack(r: f32, g: f32, b: f32, a: f32) -> u32 {
    let byte = |value: f32| (larger(0.0, smaller(1.0, value)) * 255.0 + 0.5) as u32;
    let alpha = byte(a);
    let channel = |value: f32| byte(value).min(alpha);
    channel(r) | channel(g) << 8 | channel(b) << 16 | alpha << 24
}

#[cfg(test)]
mod tests {
    use super::*;

    /// B(Cb, Cs) of the specification for one channel, in double precision, written from its text.
    fn reference_channel(mode: BlendMode, b: f64, s: f64) -> f64 {
        let multiply = |b: f64, s: f64| b * s;
        let screen = |b: f64, s: f64| b + s - b * s;
        let hard_light = |b: f64, s: f64| if s <= 0.5 { multiply(b, 2.0 * s) } else { screen(b, 2.0 * s - 1.0) };
        match mode {
            BlendMode::Normal => s,
            BlendMode::Multiply => multiply(b, s),
            BlendMode::Screen => screen(b, s),
            BlendMode::Overlay => hard_light(s, b),
            BlendMode::Darken => b.min(s),
            BlendMode::Lighten => b.max(s),
            BlendMode::ColorDodge => match (b, s) {
                (0.0, _) => 0.0,
                (_, 1.0) => 1.0,
                _ => (b / (1.0 - s)).min(1.0),
            },
            BlendMode::ColorBurn => match (b, s) {
                (1.0, _) => 1.0,
                (_, 0.0) => 0.0,
                _ => 1.0 - ((1.0 - b) / s).min(1.0),
            },
            BlendMode::HardLight => hard_light(b, s),
            BlendMode::SoftLight if s <= 0.5 => b - (1.0 - 2.0 * s) * b * (1.0 - b),
            BlendMode::SoftLight => {
                let d = if b <= 0.25 { ((16.0 * b - 12.0) * b + 4.0) * b } else { b.sqrt() };
                b + (2.0 * s - 1.0) * (d - b)
            }
            BlendMode::Difference => (b - s).abs(),
            BlendMode::Exclusion => b + s - 2.0 * b * s,
            _ => unreachable!("not a mode of single channels"),
        }
    }

    fn lum(c: [f64; 3]) -> f64 {
        0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2]
    }

    fn sat(c: [f64; 3]) -> f64 {
        c[0].max(c[1]).max(c[2]) - c[0].min(c[1]).min(c[2])
    }

    fn set_lum(c: [f64; 3], l: f64) -> [f64; 3] {
        let d = l - lum(c);
        let mut c = c.map(|v| v + d);
        let (l, n, x) = (lum(c), c[0].min(c[1]).min(c[2]), c[0].max(c[1]).max(c[2]));
        if n < 0.0 {
            c = c.map(|v| l + (v - l) * l / (l - n));
        }
        if x > 1.0 {
            c = c.map(|v| l + (v - l) * (1.0 - l) / (x - l));
        }
        c
    }

    /// `SetSat` as the specification has it: by the order of the channels.
    fn set_sat(c: [f64; 3], s: f64) -> [f64; 3] {
        let mut order = [0, 1, 2];
        order.sort_by(|i, j| c[*i].total_cmp(&c[*j]));
        let [min, mid, max] = order;
        let mut out = [0.0; 3];
        if c[max] > c[min] {
            out[mid] = (c[mid] - c[min]) * s / (c[max] - c[min]);
            out[max] = s;
        }
        out
    }

    fn reference(mode: BlendMode, source: u32, below: u32) -> [f64; 4] {
        let [s, b] = [source, below].map(|pixel| pixel.to_le_bytes().map(|byte| f64::from(byte) / 255.0));
        if mode == BlendMode::PlusLighter {
            return core::array::from_fn(|i| (s[i] + b[i]).min(1.0));
        }
        let straight = |c: [f64; 4]| [c[0] / c[3], c[1] / c[3], c[2] / c[3]];
        let (cs, cb) = (straight(s), straight(b));
        let mixed = match mode {
            BlendMode::Hue => set_lum(set_sat(cs, sat(cb)), lum(cb)),
            BlendMode::Saturation => set_lum(set_sat(cb, sat(cs)), lum(cb)),
            BlendMode::Color => set_lum(cs, lum(cb)),
            BlendMode::Luminosity => set_lum(cb, lum(cs)),
            _ => core::array::from_fn(|i| reference_channel(mode, cb[i], cs[i])),
        };
        let (sa, ba) = (s[3], b[3]);
        let channel = |i: usize| sa * (1.0 - ba) * cs[i] + sa * ba * mixed[i] + (1.0 - sa) * ba * cb[i];
        [channel(0), channel(1), channel(2), sa + ba - sa * ba]
    }

    fn random_pixel(random: &mut u64) -> u32 {
        let mut byte = |end: u64| {
            *random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            ((*random >> 33) % end) as u32
        };
        let alpha = [255, 1 + byte(255), 1 + byte(255)][byte(3) as usize];
        let mut channel = || [0, alpha, byte(u64::from(alpha) + 1)][byte(3) as usize];
        channel() | channel() << 8 | channel() << 16 | alpha << 24
    }

    #[test]
    fn every_mode_is_within_half_a_step_of_the_formula() {
        let mut random = 3;
        for _ in 0..20_000 {
            let (source, below) = (random_pixel(&mut random), random_pixel(&mut random));
            for mode in BlendMode::ALL {
                let actual = blend(mode, source, below).to_le_bytes().map(f64::from);
                let expected = reference(mode, source, below).map(|value| value * 255.0);
                for c in 0..4 {
                    let error = (actual[c] - expected[c]).abs();
                    assert!(error <= 0.501, "{mode:?} {source:08x} over {below:08x}: {actual:?} for {expected:?}");
                }
            }
        }
    }

    #[test]
    fn nothing_over_something_and_something_over_nothing_stay_as_they_are() {
        for mode in BlendMode::ALL {
            assert_eq!(blend(mode, 0, 0x8010_2040), 0x8010_2040);
            assert_eq!(blend(mode, 0x8010_2040, 0), 0x8010_2040);
        }
    }
}
