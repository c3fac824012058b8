//! Outlines: the visible surfaces of a picture in, lines over the picture out.
//!
//! A Sobel filter looks for abrupt changes of the object, of the normal, and of depth; depth is measured from the plane
//! of the surface in the middle, so that a floor seen at a grazing angle is no edge however fast it recedes. What it finds
//! is widened to the width of the lines, and laid over the picture.
//!
//! A filter knows edges to the pixel only. So that lines are as smooth as the picture, the surfaces are drawn anew,
//! larger by a whole factor, and a pixel gets as much of the line as its part of the larger picture has.

use super::effects::Outline;
use super::settings::RenderSettings;
use super::shapes::{Shapes, each_band};
use trigon::lanes::{F32, I32, Kernel, LANES, Lanes};
use trigon::pipeline::{Picture, RendererOptions};
use trigon::target::MAX_SIZE;
use trigon_image::color::{linear_to_srgb, premultiply, srgb_to_linear, unit_to_u8, unpremultiply};

/// Most pixels of the larger picture: beyond, it is made smaller, and lines are less smooth.
const MOST_PIXELS: u64 = 1 << 25;

/// How much larger the surfaces of lines are drawn: about as the picture's own samples lie.
pub(super) fn scale(settings: &RenderSettings) -> u32 {
    let wanted = match settings.samples.count() {
        1 => 1,
        2..=4 => 2,
        _ => 4,
    };
    let fits = |scale: &u32| {
        let (width, height) = (settings.width.saturating_mul(*scale), settings.height.saturating_mul(*scale));
        width.max(height) <= MAX_SIZE && u64::from(width) * u64::from(height) <= MOST_PIXELS
    };
    [4, 2].into_iter().filter(|scale| *scale <= wanted).find(fits).unwrap_or(1)
}

/// Draws the outlines of `shapes`, which are `scale` times as large as the picture.
pub(super) fn draw(picture: &mut Picture, shapes: &Shapes, scale: u32, outline: &Outline, options: RendererOptions) {
    let mut edges = vec![0_u8; shapes.objects.len()];
    each_band(options, shapes.width, &mut edges, |y, rows| {
        options.simd.run(Edges { shapes, scale, threshold: outline.threshold, y, rows });
    });
    let lines = Lines::new(edges, shapes, scale, outline);
    let (width, height) = (shapes.width / scale, shapes.height / scale);
    let mut coverage = vec![0.0; width as usize * height as usize];
    each_band(options, width, &mut coverage, |y, rows| lines.cover(y, rows));
    lay(picture, &coverage, outline.color);
}

/// Lays `color` (linear light, premultiplied) over the part of each pixel that `coverage` says.
pub(super) fn lay(picture: &mut Picture, coverage: &[f32], line: [f32; 4]) {
    if let Some(color) = &mut picture.color {
        for (pixel, part) in color.values_mut().iter_mut().zip(coverage).filter(|(_, part)| **part > 0.0) {
            *pixel = encode(over(decode(*pixel), line, *part));
        }
    }
    if let Some(color) = &mut picture.color_f32 {
        for (pixel, part) in color.values_mut().iter_mut().zip(coverage).filter(|(_, part)| **part > 0.0) {
            *pixel = over(*pixel, line, *part);
        }
    }
}

/// The filter, for a band of rows: 1 where there is an edge.
struct Edges<'a> {
    shapes: &'a Shapes,
    scale: u32,
    threshold: f32,
    /// The first row.
    y: usize,
    rows: &'a mut [u8],
}

/// The neighbours of a pixel, and their weights in the derivatives along x and y.
const SOBEL: [([f32; 2], [f32; 2]); 8] = [
    ([-1.0, -1.0], [-1.0, -1.0]),
    ([0.0, -1.0], [0.0, -2.0]),
    ([1.0, -1.0], [1.0, -1.0]),
    ([-1.0, 0.0], [-2.0, 0.0]),
    ([1.0, 0.0], [2.0, 0.0]),
    ([-1.0, 1.0], [-1.0, 1.0]),
    ([0.0, 1.0], [0.0, 2.0]),
    ([1.0, 1.0], [1.0, 1.0]),
];
/// What the filter makes of a step from 0 to 1.
const SOBEL_OF_STEP: f32 = 4.0;

impl Kernel for Edges<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        for (row, values) in self.rows.chunks_mut(self.shapes.width as usize).enumerate() {
            let y = l.f32((self.y + row) as f32);
            for (group, out) in values.chunks_mut(LANES).enumerate() {
                let x = l.lane_numbers() + (group * LANES) as f32;
                let found = change(l, self.shapes, self.scale, x, y).gt(self.threshold).bits();
                for (lane, out) in out.iter_mut().enumerate() {
                    *out = u8::from(found >> lane & 1 == 1);
                }
            }
        }
    }
}

/// How abruptly things change at sixteen pixels: the largest of the changes of object, normal and depth.
#[inline(always)]
fn change<L: Lanes>(l: L, shapes: &Shapes, scale: u32, x: F32<L>, y: F32<L>) -> F32<L> {
    /// A step in depth that counts as much as a change of normals by 1, in pixels of the picture.
    const STEP_PX: f32 = 8.0;
    /// Larger changes count as these, background included.
    const MOST: f32 = 4.0;
    let here = shapes.index(l, x, y);
    let (position, normal) = (here.gather_vec3(&shapes.positions), here.gather_vec3(&shapes.normals));
    let object: I32<L> = here.gather_u32(&shapes.objects).as_i32();
    let [ax, ay, az, offset] = shapes.view_axis;
    let distance = position.dot(l.vec3([ax, ay, az])) + offset;
    let pixel = distance * shapes.pixel[1] + shapes.pixel[0];
    let per_step = 1.0 / (pixel * (scale as f32 * STEP_PX));
    let zero = l.f32(0.0);
    let (mut bend_x, mut bend_y) = (l.vec3([0.0; 3]), l.vec3([0.0; 3]));
    let (mut rise_x, mut rise_y, mut other) = (zero, zero, zero);
    for ([dx, dy], [wx, wy]) in SOBEL {
        let there = shapes.index(l, x + dx, y + dy);
        let its_normal = there.gather_vec3(&shapes.normals);
        let height = normal.dot(there.gather_vec3(&shapes.positions) - position);
        let height = (height * per_step).clamp(-MOST, MOST);
        (bend_x, bend_y) = (bend_x + its_normal * wx, bend_y + its_normal * wy);
        (rise_x, rise_y) = (rise_x + height * wx, rise_y + height * wy);
        other = there.gather_u32(&shapes.objects).as_i32().eq(object).select(other, l.f32(MOST));
    }
    let bend = (bend_x.dot(bend_x) + bend_y.dot(bend_y)).sqrt() * (1.0 / SOBEL_OF_STEP);
    let rise = (rise_x * rise_x + rise_y * rise_y).sqrt() * (1.0 / SOBEL_OF_STEP);
    bend.max(rise).max(other)
}

/// Edges, ready to be widened.
struct Lines {
    width: usize,
    height: usize,
    scale: usize,
    /// For each pixel, how far the nearest edge in its row is; 255 and more are 255.
    across: Vec<u8>,
    /// How far a line reaches from the middle of an edge pixel, squared.
    reach_squared: usize,
    reach: usize,
}

impl Lines {
    fn new(edges: Vec<u8>, shapes: &Shapes, scale: u32, outline: &Outline) -> Self {
        let (width, height) = (shapes.width as usize, shapes.height as usize);
        // The filter finds the pixels on both sides of an edge: what it finds is two pixels wide.
        let wanted = outline.width_px.clamp(0.0, Outline::MAX_WIDTH) * scale as f32;
        let reach = ((wanted - 2.0) * 0.5).max(0.0);
        let mut across = edges;
        for row in across.chunks_mut(width) {
            let mut distance = u8::MAX;
            for value in row.iter_mut() {
                distance = if *value == 1 { 0 } else { distance.saturating_add(1) };
                *value = distance;
            }
            distance = u8::MAX;
            for value in row.iter_mut().rev() {
                distance = if *value == 0 { 0 } else { distance.saturating_add(1) };
                *value = (*value).min(distance);
            }
        }
        let (whole, squared) = whole_reach(reach);
        Self { width, height, scale: scale as usize, across, reach_squared: squared, reach: whole }
    }

    /// The part of each pixel of some rows that lines cover.
    fn cover(&self, first_row: usize, rows: &mut [f32]) {
        let width = self.width / self.scale;
        for (row, values) in rows.chunks_mut(width).enumerate() {
            for (column, value) in values.iter_mut().enumerate() {
                let (x, y) = (column * self.scale, (first_row + row) * self.scale);
                let parts = (0..self.scale * self.scale)
                    .filter(|part| self.is_on_line(x + part % self.scale, y + part / self.scale))
                    .count();
                *value = parts as f32 / (self.scale * self.scale) as f32;
            }
        }
    }

    fn is_on_line(&self, x: usize, y: usize) -> bool {
        let rows = y.saturating_sub(self.reach)..(y + self.reach + 1).min(self.height);
        rows.into_iter().any(|row| {
            let (across, down) = (usize::from(self.across[row * self.width + x]), row.abs_diff(y));
            across * across + down * down <= self.reach_squared
        })
    }
}

/// A length rounded down, and its square rounded down.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 64, and not negative")]
fn whole_reach(reach: f32) -> (usize, usize) {
    (reach as usize, (reach * reach) as usize)
}

/// `part` of a line over a colour, both premultiplied.
fn over(below: [f32; 4], line: [f32; 4], part: f32) -> [f32; 4] {
    let kept = 1.0 - line[3] * part;
    std::array::from_fn(|c| below[c] * kept + line[c] * part)
}

/// A stored colour as linear and premultiplied.
fn decode([r, g, b, a]: [u8; 4]) -> [f32; 4] {
    premultiply([srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b), f32::from(a) / 255.0])
}

/// The inverse of [`decode`].
fn encode(color: [f32; 4]) -> [u8; 4] {
    let [r, g, b, a] = unpremultiply(color);
    [linear_to_srgb(r), linear_to_srgb(g), linear_to_srgb(b), unit_to_u8(a)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines about the middle pixel of a picture of `size` x `size`.
    fn lines(size: u32, scale: u32, width_px: f32) -> Lines {
        let n = size as usize;
        let mut edges = vec![0; n * n];
        edges[n / 2 * n + n / 2] = 1;
        let shapes = Shapes {
            width: size,
            height: size,
            positions: Vec::new(),
            normals: Vec::new(),
            objects: Vec::new(),
            view_axis: [0.0; 4],
            pixel: [0.0; 2],
        };
        Lines::new(edges, &shapes, scale, &Outline { width_px, ..Outline::default() })
    }

    #[test]
    fn lines_are_widened_to_disks() {
        let wide = lines(21, 1, 12.0);
        let mut coverage = vec![0.0; 21 * 21];
        wide.cover(0, &mut coverage);
        for (i, part) in coverage.iter().enumerate() {
            let (x, y) = ((i % 21).abs_diff(10), (i / 21).abs_diff(10));
            assert_eq!(*part, if x * x + y * y <= 25 { 1.0 } else { 0.0 }, "{x}, {y}");
        }
    }

    #[test]
    fn pixels_get_their_part_of_the_larger_picture() {
        let mut coverage = vec![0.0; 25];
        lines(10, 2, 1.0).cover(0, &mut coverage);
        let covered: Vec<usize> = (0..25).filter(|i| coverage[*i] > 0.0).collect();
        assert_eq!((covered, coverage[12]), (vec![12], 0.25));
    }

    #[test]
    fn stored_colours_survive_and_lines_cover_them() {
        for pixel in [[0, 0, 0, 255], [12, 200, 255, 255], [90, 30, 7, 128]] {
            assert_eq!(encode(decode(pixel)), pixel);
            assert_eq!(encode(over(decode(pixel), [1.0; 4], 1.0)), [255; 4]);
        }
        assert_eq!(over([0.0; 4], [0.2, 0.2, 0.2, 0.4], 0.5), [0.1, 0.1, 0.1, 0.2]);
    }
}
