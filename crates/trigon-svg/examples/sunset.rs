//! Draws a sunset over the sea without SVG: gradients, curves, strokes, a clip and a translucent layer.
//!
//! `cargo run --release --package trigon-svg --example sunset -- sunset.png`

use std::error::Error;
use trigon_image::{Color, EncodeOptions, Format, encode};
use trigon_svg::canvas::{
    BlendMode, Cap, ClipPath, Drawing, FillRule, GradientStop, Layer, LinearGradient, Path, RadialGradient, Renderer,
    Spread, Stroke, Transform,
};

fn stops(colors: &[(f32, &str)]) -> Result<Vec<GradientStop>, Box<dyn Error>> {
    let stop = |&(offset, name): &(f32, &str)| Ok(GradientStop { offset, color: Color::parse(name)?, opacity: 1.0 });
    colors.iter().map(stop).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let (mut drawing, still, rule) = (Drawing::new(), Transform::IDENTITY, FillRule::NonZero);
    let linear = |end, stops| LinearGradient { start: [0.0, 0.0], end, stops, spread: Spread::Pad, transform: still };

    let dusk = stops(&[(0.0, "#1b2150"), (0.45, "#a3456d"), (0.62, "#ffb25c"), (0.63, "#5b3a6b"), (1.0, "#120f2d")])?;
    drawing.fill(Path::rect(0.0, 0.0, 640.0, 400.0), rule, still, linear([0.0, 400.0], dusk), 1.0, BlendMode::Normal);

    // The sun is cut at the horizon.
    let above = ClipPath::new(Path::rect(0.0, 0.0, 640.0, 250.0), rule, still);
    drawing.push_layer(Layer { clip: Some(above.into()), ..Layer::default() });
    let (center, radius) = ([320.0, 235.0], 300.0);
    let glow = stops(&[(0.0, "#fff6c9"), (0.2, "#ffe08a"), (0.21, "#ff9d4d90"), (1.0, "#ff5e5e00")])?;
    let (focus, focal_radius, spread) = (center, 0.0, Spread::Pad);
    let glow = RadialGradient { center, radius, focus, focal_radius, stops: glow, spread, transform: still };
    drawing.fill(Path::circle(320.0, 235.0, 300.0), rule, still, glow, 1.0, BlendMode::Screen);
    drawing.pop_layer();

    // Ripples, longer towards the viewer.
    for i in 0..14u8 {
        let (row, reach) = (f32::from(i), 40.0 + 14.0 * f32::from(i));
        let (x, y) = (320.0 - reach + 21.0 * (row % 3.0), 256.0 + row * row * 0.7);
        let mut wave = Path::new();
        wave.move_to(x, y).cubic_to(x + reach * 0.7, y - 5.0, x + reach * 1.3, y + 5.0, x + reach * 2.0, y);
        let dashes = [reach * 0.6, 9.0, 14.0, 9.0];
        let pen = Stroke::new(1.0 + row * 0.22).with_cap(Cap::Round).with_dashes(&dashes, row * 7.0);
        drawing.stroke(wave, &pen, still, Color::parse("#ffc983")?, 0.75 - row * 0.04, BlendMode::Normal);
    }

    // A boat: its parts overlap, the layer does not show it.
    drawing.push_layer(Layer { opacity: 0.9, ..Layer::default() });
    let (mut hull, mut sail) = (Path::new(), Path::new());
    hull.move_to(-60.0, 0.0).cubic_to(-35.0, 30.0, 35.0, 30.0, 64.0, -4.0).quad_to(0.0, 10.0, -60.0, 0.0).close();
    sail.move_to(4.0, -120.0).cubic_to(40.0, -80.0, 52.0, -40.0, 50.0, -10.0).quad_to(25.0, -2.0, 4.0, -6.0).close();
    sail.move_to(-4.0, -100.0).quad_to(-38.0, -50.0, -44.0, -12.0).quad_to(-22.0, -4.0, -4.0, -8.0).close();
    let boat = Transform::translate(190.0, 292.0) * Transform::rotate(-0.05);
    for (path, color) in [(sail, "#2a1636"), (hull, "#1a0d24"), (Path::rect(-2.0, -124.0, 4.0, 130.0), "#1a0d24")] {
        drawing.fill(path, rule, boat, Color::parse(color)?, 1.0, BlendMode::Normal);
    }
    drawing.pop_layer();

    let picture = Renderer { threads: 2, ..Renderer::new() }.draw(&drawing, 640, 400, Color::TRANSPARENT)?;
    let file = std::env::args().nth(1).unwrap_or_else(|| "sunset.png".to_owned());
    std::fs::write(file, encode(&picture.to_image(), Format::Png, &EncodeOptions::default())?)?;
    Ok(())
}
