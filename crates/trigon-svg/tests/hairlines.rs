//! Strokes thinner than the distance of samples: lines without gaps, as light as their width says.

use trigon::target::SamplePattern;
use trigon_image::Color;
use trigon_svg::canvas::{BlendMode, Cap, Drawing, Paint, Path, Renderer, Stroke, Transform};

/// Side of the pictures in pixels.
const SIZE: u16 = 96;

/// Alpha of each pixel, 0 to 1, of a white stroke.
fn coverage(samples: u32, path: &Path, stroke: &Stroke, transform: Transform) -> Vec<f64> {
    let mut drawing = Drawing::new();
    drawing.stroke(path.clone(), stroke, transform, Paint::from(Color::WHITE), 1.0, BlendMode::Normal);
    let renderer = Renderer { pattern: SamplePattern::grid(samples).unwrap(), ..Renderer::new() };
    let picture = renderer.draw(&drawing, SIZE.into(), SIZE.into(), Color::TRANSPARENT).unwrap();
    picture.pixels().iter().map(|pixel| f64::from(pixel[3]) / 255.0).collect()
}

/// The sums of the columns from 8 to 88.
fn column_sums(coverage: &[f64]) -> Vec<f64> {
    let size = usize::from(SIZE);
    (8..size - 8).map(|x| coverage[x..].iter().step_by(size).sum()).collect()
}

#[test]
fn lines_at_any_angle_are_even_and_of_the_right_lightness() {
    for (samples, tolerance) in [(1, 1.0), (4, 0.4), (9, 0.3), (16, 0.3)] {
        for width in [0.04, 0.1, 0.2, 0.3, 0.45] {
            for step in 0..24u8 {
                let mut path = Path::new();
                let (slope, top) = (f32::from(step) / 24.0, 1.5 + 0.21 * f32::from(step));
                path.move_to(0.0, top).line_to(SIZE.into(), top + slope * f32::from(SIZE));
                let coverage = coverage(samples, &path, &Stroke::new(width), Transform::IDENTITY);
                // A column crosses a slanted line along a longer way.
                let expected = f64::from(width * (1.0 + slope * slope).sqrt());
                let sums = column_sums(&coverage);
                let mean = sums.iter().sum::<f64>() / sums.len() as f64;
                let rounding = 3.0 / 255.0;
                assert!(
                    (mean - expected).abs() <= tolerance / 3.0 * expected + rounding,
                    "{samples} {width} {slope}: {mean}"
                );
                for sum in sums {
                    let error = (sum - expected).abs();
                    assert!(error <= tolerance * expected + rounding, "{samples} {width} {slope}: {sum} of {expected}");
                    assert!(sum > 0.4 * expected - rounding && sum > 0.0, "a gap: {samples} {width} {slope}");
                }
            }
        }
    }
}

#[test]
fn the_width_counts_after_the_transform() {
    let mut path = Path::new();
    path.move_to(0.0, 3.3).line_to(960.0, 3.3);
    let (narrow, stroke) = (Transform::scale(0.1, 10.0), Stroke::new(0.2));
    // 2 px high, though only 0.02 px wide along x: no hairline.
    let coverage = coverage(16, &path, &stroke, narrow);
    for sum in column_sums(&coverage) {
        assert!((sum - 2.0).abs() < 1e-9, "{sum}");
    }
}

#[test]
fn dots_and_dashes_keep_their_light() {
    let mut path = Path::new();
    path.move_to(8.0, 20.2).line_to(88.0, 20.2);
    let width = 0.4f32;
    let light = |stroke: &Stroke| coverage(16, &path, stroke, Transform::IDENTITY).iter().sum::<f64>();
    // Dash lengths are multiples of the distance of samples, so that only the width is at stake.
    let (wide, area) = (f64::from(width), |length: f64| length * f64::from(width));
    let check = |light: f64, expected: f64| assert!((light - expected).abs() < 0.06 * expected, "{light}, {expected}");
    check(light(&Stroke::new(width).with_dashes(&[3.0, 2.0], 0.0)), area(16.0 * 3.0));
    check(light(&Stroke::new(width).with_dashes(&[3.1, 1.9], 0.0).with_cap(Cap::Square)), area(16.0 * (3.1 + wide)));
    // Discs of the stroke's width: 40 of them, and halves at both ends stay whole.
    let disc = core::f64::consts::FRAC_PI_4 * wide * wide;
    let dots = light(&Stroke::new(width).with_dashes(&[0.0, 2.03], 0.0).with_cap(Cap::Round));
    assert!((dots - 40.0 * disc).abs() < 0.25 * 40.0 * disc, "{dots}, {}", 40.0 * disc);
}

#[test]
fn there_is_no_jump_where_lines_begin_to_be_hairlines() {
    let mut path = Path::new();
    path.move_to(0.0, 5.3).line_to(96.0, 40.9);
    let [thin, wide] = [0.499_999, 0.500_001]
        .map(|width| column_sums(&coverage(16, &path, &Stroke::new(width), Transform::IDENTITY)).iter().sum::<f64>());
    assert!((thin - wide).abs() < 0.02 * wide, "{thin} {wide}");
}
