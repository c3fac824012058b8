//! Drawing over a picture that is there: its pixels count as a background of one colour does.

use trigon_image::{Color, Rgba8Image};
use trigon_svg::canvas::{BlendMode, Drawing, FillRule, Layer, Path, Picture, Renderer, Stroke, Transform};

const STILL: Transform = Transform::IDENTITY;

/// Translucent shapes, blend modes and a layer, in part of the picture: some bands stay untouched.
fn marks() -> Drawing {
    let mut drawing = Drawing::new();
    let color = |name| Color::parse(name).unwrap();
    drawing.fill(Path::circle(30.3, 22.7, 12.0), FillRule::NonZero, STILL, color("#36c8"), 1.0, BlendMode::Normal);
    drawing.fill(Path::circle(38.0, 25.0, 9.0), FillRule::NonZero, STILL, color("#fc0"), 0.7, BlendMode::Multiply);
    drawing.push_layer(Layer { opacity: 0.5, ..Layer::default() });
    let mut line = Path::new();
    line.move_to(2.0, 3.0).line_to(60.0, 44.0);
    drawing.stroke(line, &Stroke::new(3.0), STILL, color("#111"), 1.0, BlendMode::Difference);
    drawing.pop_layer();
    drawing
}

#[test]
fn a_picture_of_one_colour_is_a_background() {
    for background in ["#ffffff", "#402010", "#00000000", "#80c04080"] {
        let color = Color::parse(background).unwrap();
        let expected = Renderer::new().draw(&marks(), 64, 80, color).unwrap();
        let image = Rgba8Image::filled(64, 80, [color.r, color.g, color.b, color.a]);
        for threads in [1, 3] {
            let mut picture = Picture::from_image(&image);
            Renderer { threads, ..Renderer::new() }.draw_over(&marks(), &mut picture).unwrap();
            assert!(picture == expected, "{background}");
        }
    }
}

#[test]
fn what_nothing_is_drawn_on_stays() {
    let pixels = (0..64 * 80u32).map(|i| {
        let [a, b, c, _] = i.wrapping_mul(2_654_435_761).to_le_bytes();
        [a, b, c, 255]
    });
    let before = Picture::from_image(&Rgba8Image::from_pixels(64, 80, pixels.collect()).unwrap());
    let mut after = before.clone();
    Renderer::new().draw_over(&marks(), &mut after).unwrap();
    let same = |y: usize, x: usize| before.pixels()[y * 64 + x] == after.pixels()[y * 64 + x];
    assert!((0..64).all(|x| same(60, x) && same(0, x)) && (0..46).all(|y| same(y, 0)));
    assert!(!same(22, 30));
}
