//! The story of a pixel as a picture: its neighbourhood and itself enlarged, triangles, samples and colours.
//!
//! Left the pixels around, as the picture has them, with the edges of all triangles whose box touches the pixel; right
//! the pixel alone, with its samples in the colours that they ended with. Below what each colour of a line stands for.

use super::triangle::{listed, names, number_in_mesh, samples_shaded};
use crate::failure::Failure;
use crate::figure::{Anchor, Sketch, enlarged, lay_over, line_height};
use trigon::pipeline::{Outcome, TriangleStory};
use trigon::target::ColorSpace;
use trigon_image::Rgba8Image;
use trigon_image::color::{linear_to_srgb, unit_to_u8};
use trigon_scene::render::SceneStory;

/// Pixels along a side of the neighbourhood, and how large each is drawn.
const AROUND: u32 = 9;
const SCALE: u32 = 48;
/// Side of both squares.
const SIDE: u32 = AROUND * SCALE;
const MARGIN: u32 = 24;
const CAPITAL: f64 = 10.0;
const INK: &str = "#1d2126";
const PALE_INK: &str = "#59616b";
const GRID: &str = "#8a919b";
const PAPER: [u8; 4] = [255; 4];

/// Colours of the triangles that are shown first, told apart by most eyes (after Okabe and Ito).
const LINES: [&str; 8] = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a5195", "#3b3b3b"];

/// The colour of all others.
const OTHER: &str = "#a4abb4";

/// More triangles than this are left out of the legend.
const LISTED: usize = 12;

/// Draws the story; `picture` is the whole picture that the pixel belongs to.
pub(crate) fn to_picture(story: &SceneStory, picture: &Rgba8Image) -> Result<Rgba8Image, Failure> {
    let shown = shown_triangles(story);
    let lines = shown.len().min(LISTED) + 3 + usize::from(shown.len() > LISTED);
    let text = line_height(CAPITAL) * count(lines);
    let width = 2 * SIDE + 3 * MARGIN;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few lines of text")]
    let height = SIDE + 3 * MARGIN + text.ceil() as u32;
    let mut out = Rgba8Image::filled(width, height, PAPER);
    let [x, y] = story.pixel.pixel;
    let first = [x, y].map(|c| i64::from(c) - i64::from(AROUND / 2));
    lay_over(&mut out, &enlarged(picture, first, [AROUND; 2], SCALE), [MARGIN, MARGIN]);
    let around = View { left: f64::from(MARGIN), origin: first.map(to_f64), scale: f64::from(SCALE) };
    let inside = View { left: f64::from(2 * MARGIN + SIDE), origin: [x, y].map(f64::from), scale: f64::from(SIDE) };
    let pixel = Rgba8Image::filled(SIDE, SIDE, story.color);
    lay_over(&mut out, &pixel, [2 * MARGIN + SIDE, MARGIN]);

    let mut sketch = Sketch::new(width, height);
    around.grid(&mut sketch);
    // What is seen comes last, over the lines of what is not.
    for view in [&around, &inside] {
        for (place, (number, triangle)) in shown.iter().enumerate().rev() {
            view.triangle(&mut sketch, line_color(place), triangle, !samples_shaded(story, *number).is_empty());
        }
    }
    around.mark(&mut sketch, [x, y].map(f64::from));
    inside.samples(&mut sketch, story, &shown);
    sketch.frame([inside.left, f64::from(MARGIN), f64::from(SIDE), f64::from(SIDE)], 2.0, INK);
    legend(&mut sketch, story, &shown);
    lay_over(&mut out, &sketch.draw()?, [0, 0]);
    Ok(out)
}

/// Those that are seen at some sample first, so that the legend has them, then the others; with their numbers.
fn shown_triangles(story: &SceneStory) -> Vec<(usize, &TriangleStory)> {
    let mut shown: Vec<(usize, &TriangleStory)> = story.pixel.triangles.iter().enumerate().collect();
    let rank = |(number, triangle): &(usize, &TriangleStory)| {
        let is_seen = !samples_shaded(story, *number).is_empty();
        if is_seen { 0 } else { 2 - u8::from(triangle.tests.iter().any(|test| test.is_covered)) }
    };
    shown.sort_by_key(rank);
    shown
}

/// The colour of the triangle that is shown at this place.
fn line_color(place: usize) -> &'static str {
    LINES.get(place).copied().unwrap_or(OTHER)
}

/// A square of the sheet that shows part of the framebuffer.
struct View {
    left: f64,
    /// Framebuffer position of the top left corner, in pixels.
    origin: [f64; 2],
    /// Size of a pixel.
    scale: f64,
}

impl View {
    /// From the framebuffer to the sheet.
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.left + (x - self.origin[0]) * self.scale, f64::from(MARGIN) + (y - self.origin[1]) * self.scale]
    }

    fn square(&self) -> [f64; 4] {
        [self.left, f64::from(MARGIN), f64::from(SIDE), f64::from(SIDE)]
    }

    /// Lines between pixels.
    fn grid(&self, sketch: &mut Sketch) {
        let [left, top, side, _] = self.square();
        for line in 0..=AROUND {
            let at = f64::from(line * SCALE);
            sketch.line([left + at, top], [left + at, top + side], 0.5, GRID);
            sketch.line([left, top + at], [left + side, top + at], 0.5, GRID);
        }
    }

    /// The pixel that is explained.
    fn mark(&self, sketch: &mut Sketch, pixel: [f64; 2]) {
        let [x, y] = self.place(pixel);
        sketch.frame([x, y, self.scale, self.scale], 4.0, "#ffffff");
        sketch.frame([x, y, self.scale, self.scale], 2.0, INK);
    }

    /// The edges; those of triangles that are seen are thick.
    fn triangle(&self, sketch: &mut Sketch, color: &str, triangle: &TriangleStory, is_seen: bool) {
        let corners = triangle.corners.map(|corner| self.place(corner.map(|value| f64::from(value) / 256.0)));
        let line = if is_seen { 3.0 } else { 1.0 };
        sketch.polygon_outline(&corners, color, line, self.square());
    }

    /// Samples in the colours that they ended with; the ring is that of the triangle that was drawn last.
    fn samples(&self, sketch: &mut Sketch, story: &SceneStory, shown: &[(usize, &TriangleStory)]) {
        let pixel = &story.pixel;
        let radius = match pixel.samples.len() {
            0..=4 => 19.0,
            5..=9 => 15.0,
            _ => 11.0,
        };
        for (s, (position, color)) in pixel.samples.iter().zip(&pixel.resolve.samples).enumerate() {
            let offset = position.map(|value| f64::from(value) / 256.0);
            let [x, y] = self.place([self.origin[0] + offset[0], self.origin[1] + offset[1]]);
            let drawn = |triangle: &TriangleStory| triangle.tests.get(s).is_some_and(|t| t.outcome == Outcome::Drawn);
            let last = pixel.triangles.iter().rposition(drawn);
            let place = last.and_then(|last| shown.iter().position(|(number, _)| *number == last));
            let ring = place.map_or(GRID, line_color);
            let [r, g, b] = encoded(pixel.color_space, color);
            sketch.disc([x, y], radius + 3.5, "#ffffff", 1.0, "#ffffff");
            sketch.disc([x, y], radius, &format!("rgb({r},{g},{b})"), 4.0, ring);
            let ink = if u32::from(r) * 2 + u32::from(g) * 5 + u32::from(b) > 1000 { INK } else { "#ffffff" };
            sketch.text([x, y + 0.4 * radius], Anchor::Middle, 0.8 * radius, ink, &s.to_string());
        }
    }
}

/// The colour without its alpha, for the figure.
fn encoded(space: ColorSpace, [r, g, b, a]: &[f32; 4]) -> [u8; 3] {
    let scale = if unit_to_u8(*a) == 0 { 0.0 } else { 1.0 / a };
    [r, g, b].map(|c| match space {
        ColorSpace::Linear => linear_to_srgb(c * scale),
        ColorSpace::Encoded => unit_to_u8(c * scale),
    })
}

fn legend(sketch: &mut Sketch, story: &SceneStory, shown: &[(usize, &TriangleStory)]) {
    let [x, y] = story.pixel.pixel;
    let [r, g, b, a] = story.color;
    let left = f64::from(MARGIN);
    let mut baseline = f64::from(SIDE + 2 * MARGIN) + CAPITAL;
    let mut next = || {
        let this = baseline;
        baseline += line_height(CAPITAL);
        this
    };
    let right = f64::from(2 * MARGIN + SIDE);
    let head = next();
    sketch.text([left, head], Anchor::Left, CAPITAL, INK, &format!("{AROUND} x {AROUND} pixels around {x},{y}"));
    let samples = match story.pixel.samples.len() {
        1 => "1 sample".to_owned(),
        count => format!("{count} samples"),
    };
    let color = format!("pixel {x},{y}: {samples}, red {r}, green {g}, blue {b}, alpha {a}");
    sketch.text([right, head], Anchor::Left, CAPITAL, INK, &color);
    let _ = next();
    if shown.is_empty() {
        sketch.text([left, next()], Anchor::Left, CAPITAL, PALE_INK, "no triangle's box touches the pixel");
    }
    for (place, (number, triangle)) in shown.iter().enumerate().take(LISTED) {
        let y = next();
        sketch.rectangle([left, y - CAPITAL, CAPITAL, CAPITAL], line_color(place));
        let of = names(story, triangle);
        let comma = if of.is_empty() { "" } else { ", " };
        let in_mesh = number_in_mesh(story, triangle);
        let seen = samples_shaded(story, *number);
        let text = format!("triangle {number} {}; number {in_mesh}{comma}{of}", fate(triangle, &seen));
        let ink = if seen.is_empty() { PALE_INK } else { INK };
        sketch.text([left + 2.0 * CAPITAL, y], Anchor::Left, CAPITAL, ink, &text);
    }
    if shown.len() > LISTED {
        let text = format!("and {} more", shown.len() - LISTED);
        sketch.text([left + 2.0 * CAPITAL, next()], Anchor::Left, CAPITAL, PALE_INK, &text);
    }
}

/// What the samples saw of a triangle.
fn fate(triangle: &TriangleStory, seen: &[usize]) -> String {
    let covered: Vec<usize> =
        triangle.tests.iter().enumerate().filter(|(_, test)| test.is_covered).map(|(s, _)| s).collect();
    let has = |outcome| triangle.tests.iter().any(|test| test.outcome == outcome);
    let plural = if covered.len() == 1 { "" } else { "s" };
    let covers = format!("covers sample{plural} {}", listed(&covered));
    match (covered.as_slice(), seen) {
        ([], _) => "covers no sample".to_owned(),
        (_, []) if has(Outcome::Drawn) => format!("{covers} and is hidden by what is drawn later"),
        (_, []) if has(Outcome::Discarded) => format!("{covers} and is cut out there"),
        (_, []) => format!("{covers} and is hidden there"),
        (_, seen) if covered == seen => format!("{covers} and is seen there"),
        (_, seen) => format!("{covers} and is seen at {}", listed(seen)),
    }
}

#[expect(clippy::cast_precision_loss, reason = "pixels of a picture")]
fn to_f64(value: i64) -> f64 {
    value as f64
}

#[expect(clippy::cast_precision_loss, reason = "a few lines")]
fn count(lines: usize) -> f64 {
    lines as f64
}
