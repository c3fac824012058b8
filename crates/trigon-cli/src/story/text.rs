//! The story of a pixel as text, top to bottom in the order of the pipeline.

use super::number::{columns, number};
use super::triangle::{
    blend, compare, linear_weights, listed, names, number_in_mesh, outcome, samples_of, samples_shaded, samples_with,
};
use std::fmt::Write;
use trigon::explain::{FragmentFacts, Note, TextureRead};
use trigon::pipeline::{FragmentStory, Outcome, PixelStory, TriangleStory};
use trigon::shade::Interpolation;
use trigon::target::{ColorSpace, ShadingRate};
use trigon_scene::render::SceneStory;

/// The whole story; `size` is that of the picture.
pub(crate) fn to_text(story: &SceneStory, size: (u32, u32)) -> String {
    let mut out = String::new();
    head(&mut out, story, size);
    triangle_list(&mut out, story);
    for (i, triangle) in story.pixel.triangles.iter().enumerate() {
        if triangle.tests.iter().any(|test| test.is_covered) {
            one_triangle(&mut out, story, i, triangle);
        }
    }
    for (i, fragment) in story.pixel.fragments.iter().enumerate() {
        one_fragment(&mut out, &story.pixel, i, fragment);
    }
    resolve(&mut out, story);
    out
}

/// A line of the text; a string takes everything.
macro_rules! line {
    ($out:expr) => { $out.push('\n') };
    ($out:expr, $($arg:tt)+) => {{
        let _ = writeln!($out, $($arg)+);
    }};
}

fn head(out: &mut String, story: &SceneStory, (width, height): (u32, u32)) {
    let pixel = &story.pixel;
    let [x, y] = pixel.pixel;
    let [r, g, b, a] = story.color;
    let count = pixel.samples.len();
    let samples = if count == 1 { "1 sample".to_owned() } else { format!("{count} samples") };
    let rate = match pixel.shading {
        ShadingRate::Pixel => "shaded once per pixel and triangle",
        ShadingRate::Sample => "shaded once per sample",
    };
    line!(out, "Pixel {x},{y} of {width}x{height}: {samples}, {rate}");
    line!(out, "Colour #{r:02x}{g:02x}{b:02x}{a:02x}: red {r}, green {g}, blue {b}, alpha {a} of 255");
}

fn triangle_list(out: &mut String, story: &SceneStory) {
    let triangles = &story.pixel.triangles;
    line!(out);
    if triangles.is_empty() {
        line!(out, "No triangle's box touches the pixel.");
        return;
    }
    line!(out, "Triangles whose box touches the pixel, as they are drawn: {}", triangles.len());
    let columns = ["covers samples", "passes at", "shaded at"].map(|column| format!("{column:<15}")).concat();
    line!(out, "  {:>3} {:>5} {:>9}  {columns} of", "", "draw", "number");
    for (i, triangle) in triangles.iter().enumerate() {
        let covered: Vec<usize> =
            triangle.tests.iter().enumerate().filter(|(_, test)| test.is_covered).map(|(s, _)| s).collect();
        let drawn = samples_with(triangle, Outcome::Drawn);
        let number = number_in_mesh(story, triangle);
        let columns = [covered, drawn, samples_shaded(story, i)].map(|samples| format!("{:<15}", listed(&samples)));
        let row = format!("  {i:>3} {:>5} {number:>9}  {} {}", triangle.draw, columns.concat(), names(story, triangle));
        line!(out, "{}", row.trim_end());
    }
}

fn one_triangle(out: &mut String, story: &SceneStory, i: usize, triangle: &TriangleStory) {
    line!(out);
    let side = if triangle.is_front { "front" } else { "back" };
    line!(out, "Triangle {i}: number {}, its {side} side{}", number_in_mesh(story, triangle), of(story, triangle));
    if triangle.is_clipped {
        line!(out, "  a piece of it: the triangle crosses the near plane or leaves the guard band, and was clipped");
    }
    if triangle.is_micro {
        line!(out, "  at most 4 x 4 pixels: its coverage was found together with that of fifteen others");
    }
    if triangle.is_whole_block {
        line!(out, "  covers the 8 x 8 pixels around and is the nearest everywhere there: one decision for all");
    }
    line!(out, "  {:<14}{:>13}{:>13}{:>13}{:>13}", "clip space", "x", "y", "z", "w");
    for (vertex, clip) in triangle.vertices.iter().zip(&triangle.clip) {
        line!(out, "    vertex {vertex:<5}{}", columns(clip));
    }
    line!(out, "  {:<14}{:>13}{:>13}{:>13}", "framebuffer", "x px", "y px", "1/w");
    for k in 0..3 {
        let [x, y] = triangle.corners[k].map(pixels);
        let from = if triangle.is_clipped { String::new() } else { vertex_name(triangle, k) };
        line!(out, "    corner {k:<5}{}{from}", columns(&[x, y, triangle.inverse_w[k]]));
    }
    let [depth, dx, dy] = triangle.depth.map(number);
    line!(out, "  depth {depth} at corner 0, {dx} more per pixel to the right, {dy} down; 1 is near, 0 far");
    let writes = if triangle.depth_test.write { "written" } else { "not written" };
    line!(out, "  a sample passes if it is {}; depth is {writes}", compare(triangle.depth_test));
    tests(out, &story.pixel, triangle, &samples_shaded(story, i));
}

fn of(story: &SceneStory, triangle: &TriangleStory) -> String {
    let names = names(story, triangle);
    if names.is_empty() { format!(", draw {}", triangle.draw) } else { format!(", draw {}: {names}", triangle.draw) }
}

fn vertex_name(triangle: &TriangleStory, corner: usize) -> String {
    let is_triangle = triangle.vertices[0] != triangle.vertices[2];
    let vertex = triangle.vertices[triangle.vertex_of_corner[corner]];
    if is_triangle { format!("    vertex {vertex}") } else { String::new() }
}

/// From 1/256 px.
fn pixels(value: i32) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "at most 23 bits")]
    let value = value as f32;
    value / 256.0
}

fn tests(out: &mut String, pixel: &PixelStory, triangle: &TriangleStory, shaded: &[usize]) {
    line!(
        out,
        "  {:<22}{:>13}{:>13}{:>13}{:>13}{:>13}",
        "sample at x y, 1/256",
        "edge 0-1",
        "edge 1-2",
        "edge 2-0",
        "depth",
        "depth there"
    );
    for (s, (test, [x, y])) in triangle.tests.iter().zip(&pixel.samples).enumerate() {
        let [a, b, c] = test.edges;
        let place = format!("{s:>2} at {x:>3} {y:>3}");
        let row = format!("    {place:<20}{a:>13}{b:>13}{c:>13}");
        let depths = if test.is_covered { columns(&[test.depth, test.stored]) } else { " ".repeat(26) };
        let is_covered_later = test.outcome == Outcome::Drawn && !shaded.contains(&s);
        let later = if is_covered_later { ", later hidden" } else { "" };
        line!(out, "{row}{depths}  {}{later}", outcome(test.outcome));
    }
}

fn one_fragment(out: &mut String, pixel: &PixelStory, i: usize, fragment: &FragmentStory) {
    let facts = &fragment.facts;
    let samples = samples_of(fragment.samples);
    let plural = if samples.len() == 1 { "" } else { "s" };
    let samples = listed(&samples);
    let [x, y] = facts.point.map(number);
    let kind = if fragment.color.is_some() { "Fragment" } else { "Alpha test" };
    line!(out);
    line!(out, "{kind} {i}: triangle {} at sample{plural} {samples}, at {x} {y} in the framebuffer", fragment.triangle);
    let triangle = pixel.triangles.get(fragment.triangle);
    weights(out, pixel.interpolation, facts, triangle);
    if !facts.varyings.is_empty() {
        line!(out, "  {:<22}{:>13}{:>13}{:>13}", "interpolated", "value", "per px right", "per px down");
    }
    for varying in &facts.varyings {
        line!(out, "    {:<20}{}", varying.name, columns(&[varying.value, varying.dx, varying.dy]));
    }
    for note in &fragment.notes {
        one_note(out, note);
    }
    let Some(color) = fragment.color else { return };
    line!(
        out,
        "  {:<22}{:>13}{:>13}{:>13}{:>13}",
        format!("colour, {}", space(pixel)),
        "red",
        "green",
        "blue",
        "alpha"
    );
    line!(out, "    {:<20}{}", "of the fragment", columns(&color));
    let Some(triangle) = triangle.filter(|triangle| blend(triangle.blend) != "replace") else { return };
    line!(out, "  blend: {}", blend(triangle.blend));
    for s in samples_of(fragment.samples) {
        if let (Some(before), Some(after)) = (fragment.before.get(s), fragment.after.get(s)) {
            line!(out, "    {:<20}{}", format!("sample {s} before"), columns(before));
            line!(out, "    {:<20}{}", "after", columns(after));
        }
    }
}

/// What the numbers of colours are.
fn space(pixel: &PixelStory) -> &'static str {
    match pixel.color_space {
        ColorSpace::Linear => "linear light",
        ColorSpace::Encoded => "as stored",
    }
}

fn weights(out: &mut String, way: Interpolation, facts: &FragmentFacts, triangle: Option<&TriangleStory>) {
    let way = match way {
        Interpolation::Perspective => "perspective",
        Interpolation::Affine => "affine",
    };
    line!(out, "  {:<22}{:>13}{:>13}{:>13}", "weights of vertices", "first", "second", "third");
    line!(out, "    {:<20}{}", way, columns(&facts.barycentric));
    #[expect(clippy::cast_possible_truncation, reason = "six digits are shown")]
    if let Some(linear) = triangle.and_then(|triangle| linear_weights(triangle, facts.point)) {
        line!(out, "    {:<20}{}", "by area", columns(&linear.map(|weight| weight as f32)));
    }
    let (w, depth) = (number(1.0 / facts.inverse_w), number(facts.depth));
    line!(out, "  1/w {}, so w {w}; depth {depth}", number(facts.inverse_w));
}

fn one_note(out: &mut String, note: &Note) {
    match note {
        Note::Topic { name, number: Some(number) } => line!(out, "  {name} {number}"),
        Note::Topic { name, number: None } => line!(out, "  {name}"),
        Note::Value { name, values } => line!(out, "    {name:<30}{}", columns(values)),
        Note::Texture(read) => texture(out, read),
        _ => {}
    }
}

fn texture(out: &mut String, read: &TextureRead) {
    let [width, height] = read.size;
    line!(out, "    texture of {width}x{height} texels, {} levels, at uv {}", read.levels, pair(read.uv));
    if let Some([dx, dy]) = read.footprint {
        line!(out, "    footprint: uv changes by {} per pixel right, {} down", pair(dx), pair(dy));
        line!(out, "    which are {} and {} texels", number(length(dx, read.size)), number(length(dy, read.size)));
    }
    let taps = if read.taps.len() == 1 { "one point".to_owned() } else { format!("{} points", read.taps.len()) };
    line!(out, "    level of detail {}, read at {taps}", number(read.lod));
    for tap in &read.taps {
        if read.taps.len() > 1 {
            line!(out, "    at uv {}", pair(tap.uv));
        }
        for level in &tap.levels {
            let [width, height] = level.size;
            line!(out, "      level {}, {width}x{height} texels, weight {}", level.level, number(level.weight));
            for texel in &level.texels {
                let place = format!("texel {} {}", texel.column, texel.row);
                let place = if texel.is_border { "border colour".to_owned() } else { place };
                line!(out, "        {place:<16}weight{}  {}", columns(&[texel.weight]), columns(&texel.color));
            }
        }
    }
    line!(out, "    {:<30}{}", "value read", columns(&read.color));
}

fn pair([x, y]: [f32; 2]) -> String {
    format!("{} {}", number(x), number(y))
}

/// The length in texels of level 0 of a change of uv.
fn length([x, y]: [f32; 2], [width, height]: [u32; 2]) -> f32 {
    #[expect(clippy::cast_precision_loss, reason = "sizes are below 2^24")]
    let (x, y) = (x * width as f32, y * height as f32);
    (x * x + y * y).sqrt()
}

fn resolve(out: &mut String, story: &SceneStory) {
    let end = &story.pixel.resolve;
    line!(out);
    line!(out, "Resolve");
    line!(out, "  {:<22}{:>13}{:>13}{:>13}{:>13}", space(&story.pixel), "red", "green", "blue", "alpha");
    for (s, color) in end.samples.iter().enumerate() {
        line!(out, "    {:<20}{}", format!("sample {s}"), columns(color));
    }
    line!(out, "    {:<20}{}", "mean", columns(&end.mean));
    let [r, g, b, a] = end.bytes;
    let encoding = match story.pixel.color_space {
        ColorSpace::Linear => "as sRGB of 8 bits",
        ColorSpace::Encoded => "as 8 bits",
    };
    line!(out, "  {encoding}, straight alpha: {r} {g} {b} {a}");
    if story.color != end.bytes {
        let [r, g, b, a] = story.color;
        line!(
            out,
            "  after last steps over the whole picture (counts as colours, outlines, --backdrop, --overlay): {r} {g} {b} {a}"
        );
    }
}
