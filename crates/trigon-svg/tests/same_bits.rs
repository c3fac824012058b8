//! One drawing that uses everything has the same bytes at every SIMD level, with any number of threads, and in any frame
//! of mind of the machine.

use std::sync::Arc;
use trigon::lanes::SimdLevel;
use trigon::target::SamplePattern;
use trigon_image::{Color, Rgba8Image};
use trigon_svg::canvas::{
    BlendMode, Cap, ClipPath, Drawing, FillRule, Filter, GradientStop, Image, ImageFilter, Join, Layer, LinearGradient,
    Mask, MaskKind, Path, Pattern, PixelRect, RadialGradient, Renderer, Spread, Stroke, Transform,
};

const STILL: Transform = Transform::IDENTITY;

fn stops() -> Vec<GradientStop> {
    let stop = |offset, name, opacity| GradientStop { offset, color: Color::parse(name).unwrap(), opacity };
    vec![stop(0.0, "#f30", 1.0), stop(0.3, "#fe8", 0.4), stop(0.3, "#08c", 1.0), stop(1.0, "#014", 0.9)]
}

fn star(points: u16, radius: f32) -> Path {
    let mut path = Path::new();
    for i in 0..points {
        let angle = f32::from(i) * 2.0 * std::f32::consts::PI * 2.0 / f32::from(points);
        let (x, y) = (radius * trigon::math::host::sin(angle), -radius * trigon::math::host::cos(angle));
        if i == 0 {
            path.move_to(x, y)
        } else {
            path.line_to(x, y)
        };
    }
    path.close();
    path
}

/// Every kind of paint, layer and stroke.
fn everything() -> Drawing {
    let mut drawing = Drawing::new();
    let normal = BlendMode::Normal;
    let linear = LinearGradient {
        start: [10.0, 0.0],
        end: [80.0, 40.0],
        stops: stops(),
        spread: Spread::Reflect,
        transform: STILL,
    };
    drawing.fill(Path::rect(3.3, 2.7, 150.0, 90.0), FillRule::NonZero, STILL, linear.clone(), 1.0, normal);
    let radial = RadialGradient {
        center: [60.0, 60.0],
        radius: 40.0,
        focus: [50.0, 45.0],
        focal_radius: 4.0,
        stops: stops(),
        spread: Spread::Repeat,
        transform: Transform::new(1.0, 0.1, 0.2, 0.8, 0.0, 0.0),
    };
    for (i, blend) in (0u8..).zip(BlendMode::ALL) {
        let place = Transform::translate(f64::from(i % 8) * 20.0 + 9.0, f64::from(i / 8) * 30.0 + 15.0);
        drawing.fill(star(5, 14.0), FillRule::EvenOdd, place * Transform::rotate(0.3), radial.clone(), 0.8, blend);
    }
    let clip = ClipPath {
        intersect: Some(Arc::new(ClipPath::new(star(7, 60.0), FillRule::NonZero, Transform::translate(80.0, 100.0)))),
        ..ClipPath::new(Path::circle(80.0, 100.0, 45.0), FillRule::NonZero, STILL)
    };
    let mut light = Drawing::new();
    light.fill(Path::rect(0.0, 60.0, 160.0, 90.0), FillRule::NonZero, STILL, linear, 1.0, normal);
    let mask = Mask { drawing: light, kind: MaskKind::LinearLuminance, mask: None };
    drawing.push_layer(Layer {
        opacity: 0.7,
        blend: BlendMode::Multiply,
        clip: Some(Arc::new(clip)),
        mask: Some(Arc::new(mask)),
        ..Layer::default()
    });
    let pen = Stroke::new(5.0).with_cap(Cap::Round).with_join(Join::Round).with_dashes(&[11.0, 7.0], 3.0);
    drawing.stroke(star(9, 40.0), &pen, Transform::translate(80.0, 100.0), radial.clone(), 0.9, normal);
    let thin = Stroke::new(0.11).with_cap(Cap::Round).with_dashes(&[5.0, 1.5], 0.0);
    drawing.stroke(star(9, 55.0), &thin, Transform::translate(80.0, 100.0), Color::BLACK, 1.0, normal);
    drawing.set_crisp_edges(true);
    drawing.fill(star(5, 20.0), FillRule::EvenOdd, Transform::translate(60.0, 90.0), radial.clone(), 0.6, normal);
    drawing.set_crisp_edges(false);
    let mut dots = Drawing::new();
    dots.fill(Path::circle(4.0, 4.0, 3.0), FillRule::NonZero, STILL, Color::WHITE, 0.8, normal);
    let pattern = Pattern {
        drawing: dots,
        tile: [0.0, 0.0, 8.5, 8.0],
        transform: Transform::rotate(0.2),
        pixels: None,
        opacity: 0.9,
    };
    drawing.fill(Path::circle(90.0, 95.0, 38.0), FillRule::NonZero, STILL, pattern, 1.0, normal);
    drawing.pop_layer();
    let invert = Filter {
        region: PixelRect { x: 100, y: 90, width: 50, height: 40 },
        apply: Arc::new(|mut layer, _| {
            for pixel in &mut layer.pixels {
                pixel.swap(0, 2);
            }
            layer
        }),
    };
    drawing.push_layer(Layer { filter: Some(invert), opacity: 0.8, ..Layer::default() });
    let pixels = (0..64u8).flat_map(|i| [i * 4, 255 - i * 3, i, 128 + i]).collect::<Vec<u8>>();
    let image = Image::new(&Rgba8Image::from_bytes(8, 8, &pixels).unwrap()).unwrap();
    let place = Transform::translate(104.0, 92.0) * Transform::rotate(0.2) * Transform::scale(4.0, 3.5);
    drawing.image(&image, ImageFilter::SMOOTH, place, 1.0, normal);
    drawing.pop_layer();
    drawing
}

fn draw(pattern: SamplePattern, threads: usize, simd: SimdLevel) -> Vec<[u8; 4]> {
    let renderer = Renderer { pattern, threads, simd, ..Renderer::new() };
    renderer.draw(&everything(), 160, 150, Color::rgb(250, 250, 240)).unwrap().into_pixels()
}

#[test]
fn levels_and_threads_change_no_bit() {
    for pattern in
        [SamplePattern::grid(16).unwrap(), SamplePattern::grid(9).unwrap(), SamplePattern::standard(8).unwrap()]
    {
        let expected = draw(pattern, 1, SimdLevel::Scalar);
        assert!(expected.iter().collect::<std::collections::HashSet<_>>().len() > 1000, "a drawing of many colours");
        for simd in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            for threads in [1, 2, 3, 7] {
                assert!(draw(pattern, threads, simd) == expected, "{pattern}, {simd}, {threads} threads");
            }
        }
    }
}

#[test]
fn a_part_of_the_picture_is_the_same_as_in_the_whole() {
    // A narrower and lower picture has other bands, bounds and words, but the same pixels.
    let renderer = Renderer::new();
    let whole = renderer.draw(&everything(), 160, 150, Color::BLACK).unwrap();
    let part = renderer.draw(&everything(), 90, 101, Color::BLACK).unwrap();
    for y in 0..101 {
        let row = |width: usize, pixels: &[[u8; 4]]| pixels[y * width..y * width + 90].to_vec();
        assert_eq!(row(90, part.pixels()), row(160, whole.pixels()), "row {y}");
    }
}
