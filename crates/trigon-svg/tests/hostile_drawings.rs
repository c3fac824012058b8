//! Drawings that mean harm: they end soon, in a picture or an error, without a panic.

use std::sync::Arc;
use trigon_image::Color;
use trigon_svg::canvas::{
    BlendMode, Cap, ClipPath, DrawError, Drawing, FillRule, Filter, GradientStop, Join, Layer, LayerImage,
    LinearGradient, Mask, MaskKind, Path, Pattern, PixelRect, RadialGradient, Renderer, Spread, Stroke, Transform,
};

const STILL: Transform = Transform::IDENTITY;

fn draw(drawing: &Drawing) -> Vec<[u8; 4]> {
    Renderer { threads: 2, ..Renderer::new() }.draw(drawing, 70, 50, Color::WHITE).unwrap().into_pixels()
}

fn fill(drawing: &mut Drawing, path: Path, transform: Transform) {
    drawing.fill(path, FillRule::NonZero, transform, Color::BLACK, 1.0, BlendMode::Normal);
}

#[test]
fn numbers_that_are_huge_or_none_at_all() {
    for value in [f32::NAN, f32::INFINITY, -f32::INFINITY, f32::MAX, -1e30, 1e9, 1e-40] {
        let mut drawing = Drawing::new();
        let mut curve = Path::new();
        curve.move_to(1.0, 1.0).cubic_to(value, 3.0, 5.0, value, 40.0, 30.0).quad_to(value, value, 3.0, 9.0);
        let pen = Stroke::new(3.0)
            .with_cap(Cap::Square)
            .with_join(Join::MiterClip { limit: value })
            .with_dashes(&[1.0, 2.0], value);
        drawing.stroke(curve.clone(), &pen, STILL, Color::BLACK, value, BlendMode::Hue);
        drawing.stroke(curve.clone(), &Stroke::new(value), STILL, Color::BLACK, 1.0, BlendMode::Normal);
        fill(&mut drawing, curve.clone(), Transform::scale(f64::from(value), 1.0));
        fill(&mut drawing, Path::rect(value, -3.0, 20.0, value), STILL);
        let stops =
            [0.0, value, 1.0].map(|offset| GradientStop { offset, color: Color::BLACK, opacity: value }).to_vec();
        let linear = LinearGradient {
            start: [value, 0.0],
            end: [9.0, value],
            stops: stops.clone(),
            spread: Spread::Repeat,
            transform: STILL,
        };
        drawing.fill(curve.clone(), FillRule::EvenOdd, STILL, linear, 1.0, BlendMode::SoftLight);
        let radial = RadialGradient {
            center: [value, 9.0],
            radius: 9.0,
            focus: [3.0, value],
            focal_radius: value,
            stops,
            spread: Spread::Reflect,
            transform: Transform::scale(1.0, f64::from(value)),
        };
        drawing.fill(Path::rect(0.0, 0.0, 70.0, 50.0), FillRule::EvenOdd, STILL, radial, 1.0, BlendMode::Normal);
        let pattern = Pattern {
            drawing: Drawing::new(),
            tile: [0.0, value, value, 5.0],
            transform: STILL,
            pixels: None,
            opacity: 1.0,
        };
        drawing.fill(curve, FillRule::EvenOdd, STILL, pattern, 1.0, BlendMode::Normal);
        assert_eq!(draw(&drawing).len(), 70 * 50);
    }
}

#[test]
fn a_huge_shape_covers_the_picture_and_a_far_one_does_not() {
    let mut drawing = Drawing::new();
    fill(&mut drawing, Path::rect(-1e12, -1e12, 2e12, 2e12), STILL);
    assert!(draw(&drawing).iter().all(|pixel| *pixel == [0, 0, 0, 255]));
    let mut drawing = Drawing::new();
    fill(&mut drawing, Path::rect(1e9, 1e9, 1e9, 1e9), STILL);
    fill(&mut drawing, Path::rect(-5.0, -1e9, 4.0, 2e9), STILL);
    assert!(draw(&drawing).iter().all(|pixel| *pixel == [255; 4]));
}

#[test]
fn nesting_without_end_is_cut() {
    let mut drawing = Drawing::new();
    for _ in 0..10_000 {
        drawing.push_layer(Layer { opacity: 0.5, ..Layer::default() });
    }
    fill(&mut drawing, Path::rect(0.0, 0.0, 70.0, 50.0), STILL);
    for _ in 0..20_000 {
        drawing.pop_layer();
    }
    assert!(draw(&drawing).iter().all(|pixel| *pixel == [255; 4]));

    let (mut clip, mut mask, mut pattern) = (ClipPath::default(), None, Drawing::new());
    for _ in 0..500 {
        clip = ClipPath {
            intersect: Some(Arc::new(clip)),
            ..ClipPath::new(Path::circle(9.0, 9.0, 9.0), FillRule::NonZero, STILL)
        };
        mask = Some(Arc::new(Mask { drawing: Drawing::new(), kind: MaskKind::Alpha, mask }));
        let inner =
            Pattern { drawing: pattern, tile: [0.0, 0.0, 9.0, 9.0], transform: STILL, pixels: None, opacity: 1.0 };
        pattern = Drawing::new();
        pattern.fill(Path::rect(0.0, 0.0, 9.0, 9.0), FillRule::NonZero, STILL, inner, 1.0, BlendMode::Normal);
    }
    let mut drawing = pattern;
    drawing.push_layer(Layer { clip: Some(Arc::new(clip)), mask, ..Layer::default() });
    fill(&mut drawing, Path::rect(0.0, 0.0, 70.0, 50.0), STILL);
    assert_eq!(draw(&drawing).len(), 70 * 50);
}

#[test]
fn pictures_over_the_limits_are_refused_and_filters_cut() {
    let renderer = Renderer { max_pixels: 10_000, ..Renderer::new() };
    let drawing = Drawing::new();
    for [width, height] in [[101, 100], [16_385, 1], [u32::MAX, u32::MAX]] {
        let error = renderer.draw(&drawing, width, height, Color::WHITE).unwrap_err();
        assert_eq!(error, DrawError::TooLarge { width, height });
    }
    assert!(renderer.draw(&drawing, 0, 9, Color::WHITE).unwrap().pixels().is_empty());
    let mut drawing = Drawing::new();
    let region = PixelRect { x: i32::MIN, y: i32::MAX, width: u32::MAX, height: u32::MAX };
    let wrong_size =
        Filter { region, apply: Arc::new(|layer: LayerImage, _| LayerImage { pixels: vec![[9; 4]], ..layer }) };
    drawing.push_layer(Layer { filter: Some(wrong_size), ..Layer::default() });
    fill(&mut drawing, Path::rect(0.0, 0.0, 70.0, 50.0), STILL);
    assert!(renderer.draw(&drawing, 70, 50, Color::WHITE).unwrap().pixels().iter().all(|pixel| *pixel == [255; 4]));
}

#[test]
fn ten_thousand_tall_edges_are_bounded() {
    let mut path = Path::new();
    for i in 0..10_000u16 {
        let x = f32::from(i) * 0.007;
        path.move_to(x, -5.0).line_to(x + 0.001, 60.0).line_to(x + 0.003, 60.0).close();
    }
    let mut drawing = Drawing::new();
    fill(&mut drawing, path, STILL);
    assert_eq!(draw(&drawing).len(), 70 * 50);
}
