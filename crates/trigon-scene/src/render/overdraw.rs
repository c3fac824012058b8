//! From counts of surfaces to colours: the last step of the overdraw picture.
//!
//! In: linear colours whose alpha is the mean number of surfaces over a pixel's samples. Out: a ramp over the
//! background, from dark blue (one surface) over green, yellow and red to white (sixteen and more).

use trigon::pipeline::Picture;
use trigon_image::color::{linear_to_srgb, srgb_to_linear};

/// Display colours at 0, 1, 2, 4, 6, 10 and 16 surfaces; the first is where there is none.
const RAMP: [(f32, [u8; 3]); 7] = [
    (0.0, [12, 14, 22]),
    (1.0, [38, 60, 150]),
    (2.0, [30, 140, 170]),
    (4.0, [60, 170, 70]),
    (6.0, [240, 200, 50]),
    (10.0, [220, 60, 40]),
    (16.0, [255, 255, 255]),
];

/// Replaces counts by colours, in every colour image of `picture`.
pub(super) fn color_counts(picture: &mut Picture) {
    let Some(counts) = &mut picture.color_f32 else { return };
    for pixel in counts.values_mut() {
        let [r, g, b] = ramp(pixel[3]);
        *pixel = [r, g, b, 1.0];
    }
    if let Some(color) = &mut picture.color {
        for (out, [r, g, b, _]) in color.values_mut().iter_mut().zip(counts.values()) {
            *out = [linear_to_srgb(*r), linear_to_srgb(*g), linear_to_srgb(*b), u8::MAX];
        }
    }
}

/// The linear colour of a count.
fn ramp(count: f32) -> [f32; 3] {
    let linear = |code: [u8; 3]| code.map(srgb_to_linear);
    for pair in RAMP.windows(2) {
        let ((low, from), (high, to)) = (pair[0], pair[1]);
        if count < high {
            let t = ((count - low) / (high - low)).max(0.0);
            let (from, to) = (linear(from), linear(to));
            return std::array::from_fn(|c| from[c] + t * (to[c] - from[c]));
        }
    }
    [1.0; 3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_step_has_its_colour_and_brightness_ends_at_white() {
        for (count, code) in RAMP {
            assert_eq!(ramp(count).map(linear_to_srgb), code, "{count}");
        }
        assert_eq!(ramp(1e9), [1.0; 3]);
    }
}
