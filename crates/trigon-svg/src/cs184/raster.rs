//! A band of rows of the picture: primitives in, averaged pixels out.
//!
//! Every pixel has n x n samples on a grid, each with its own color, painted over in order. Points and lines fill all
//! samples of a pixel; a triangle those that lie in it, edges included on every side.

use super::Options;
use super::cast::{to_f32, to_f64, to_usize};
use super::primitive::{Color, Position, Primitive, TrianglePaint};
use super::texture::Texture;

/// Rows `top..top + rows` of a picture.
pub(super) struct Band<'a> {
    options: &'a Options,
    width: usize,
    top: usize,
    rows: usize,
    /// Samples a pixel along each axis.
    n: usize,
    /// Pixels along a side of a point.
    point_size: usize,
    /// The samples of a pixel lie together; pixels in row order.
    samples: Vec<[f32; 3]>,
}

/// Longest way a line is stepped along; a longer one starts at the edge of what can be seen.
const MAX_LINE_STEPS: f32 = 1e6;

impl<'a> Band<'a> {
    /// White rows.
    pub(super) fn new(options: &'a Options, top: usize, rows: usize) -> Self {
        let (width, n) = (options.width as usize, options.samples_per_axis.clamp(1, 4) as usize);
        let point_size = options.enlargement.max(1) as usize;
        Self { options, width, top, rows, n, point_size, samples: vec![[1.0; 3]; width * rows * n * n] }
    }

    /// Paints one primitive over what is there.
    pub(super) fn draw(&mut self, primitive: &Primitive) {
        let (first, last) = primitive.rows();
        let beyond = to_f64(self.point_size - 1);
        if last + beyond < to_f64(self.top) || first - beyond >= to_f64(self.top + self.rows) {
            return;
        }
        let in_points = |at: &Position| at.map(|coordinate| coordinate / to_f64(self.point_size));
        match primitive {
            Primitive::Point { at, color } => {
                let [x, y] = in_points(at);
                self.point(x.floor(), y.floor(), *color);
            }
            Primitive::Line { from, to, color } => self.line(in_points(from), in_points(to), *color),
            Primitive::Triangle { corners, paint } => self.triangle(*corners, paint),
            Primitive::Picture { from, to, texture } => self.picture(in_points(from), in_points(to), texture),
        }
    }

    /// The mean of each pixel's samples, opaque, in row order.
    pub(super) fn resolve(&self) -> Vec<[u8; 4]> {
        let count = self.n * self.n;
        let mean = |samples: &[[f32; 3]]| {
            let [r, g, b] = [0, 1, 2].map(|channel| {
                let sum: f32 = samples.iter().map(|sample| sample[channel]).sum();
                #[expect(clippy::cast_precision_loss, reason = "at most 16")]
                let mean = sum / count as f32;
                trigon_image::color::unit_to_u8(mean)
            });
            [r, g, b, 255]
        };
        self.samples.chunks_exact(count).map(mean).collect()
    }

    /// Paints all samples of the point in column `x`, row `y`, as far as it is here. A point is a pixel, or as many along
    /// a side as the picture is enlarged.
    fn point(&mut self, x: f64, y: f64, color: Color) {
        let size = to_f64(self.point_size);
        let columns = range(x * size, (x + 1.0) * size, 0, self.width);
        // The place of a line without length is not a number.
        let is_place = x >= 0.0 && y >= 0.0;
        if !is_place || columns.is_empty() {
            return;
        }
        let count = self.n * self.n;
        for y in range(y * size, (y + 1.0) * size, self.top, self.top + self.rows) {
            let row = (y - self.top) * self.width;
            for sample in &mut self.samples[(row + columns.start) * count..(row + columns.end) * count] {
                paint(sample, color);
            }
        }
    }

    /// Steps along the axis on which the line is longer, in single precision, as the course's program does.
    fn line(&mut self, from: Position, to: Position, color: Color) {
        let (mut x0, mut y0, mut x1, mut y1) = (to_f32(from[0]), to_f32(from[1]), to_f32(to[0]), to_f32(to[1]));
        if x0 > x1 {
            ((x0, y0), (x1, y1)) = ((x1, y1), (x0, y0));
        }
        let slope = (y1 - y0) / (x1 - x0);
        let (step_x, step_y) = if x0 == x1 {
            (0.0, if y1 < y0 { -1.0 } else { 1.0 })
        } else if slope.abs() <= 1.0 {
            (1.0, slope)
        } else {
            (1.0 / slope.abs(), if slope < 0.0 { -1.0 } else { 1.0 })
        };
        let ([x0, y0], length) = self.visible_start([x0, y0], [x1, y1], [step_x, step_y]);
        let (mut x, mut y) = (x0, y0);
        let mut steps = 0.0;
        while x.floor() <= x1.floor() && (y - y0).abs() <= length && steps <= MAX_LINE_STEPS {
            self.point(f64::from(x.floor()), f64::from(y.floor()), color);
            x += step_x;
            y += step_y;
            steps += 1.0;
        }
    }

    /// Where stepping begins, and how far in y it goes: the line's start unless that is far away.
    fn visible_start(&self, start: [f32; 2], end: [f32; 2], step: [f32; 2]) -> ([f32; 2], f32) {
        let length = (end[1] - start[1]).abs();
        let reach = MAX_LINE_STEPS / 4.0;
        let is_near = |value: f32| value.abs() <= reach;
        if (is_near(start[0]) && is_near(start[1])) || !(length.is_finite() && (end[0] - start[0]).is_finite()) {
            return (start, length);
        }
        let skipped_x = if step[0] > 0.0 { ((-reach - start[0]) / step[0]).max(0.0) } else { 0.0 };
        let skipped_y = ((-reach * step[1].signum() - start[1]) / step[1]).max(0.0);
        let is_steep = step[1].abs() >= 1.0;
        let skipped = if is_steep { skipped_y } else { skipped_x }.floor();
        let moved = [start[0] + skipped * step[0], start[1] + skipped * step[1]];
        (moved, (end[1] - moved[1]).abs())
    }

    fn triangle(&mut self, corners: [Position; 3], paint_with: &TrianglePaint) {
        if corners.iter().flatten().any(|coordinate| !coordinate.is_finite()) {
            return;
        }
        let triangle = Triangle::new(corners);
        let level = match paint_with {
            TrianglePaint::Textured { uv, texture } => triangle.level(*uv, texture),
            _ => 0.0,
        };
        let (columns, rows) = (triangle.span(0, 0, self.width), triangle.span(1, self.top, self.top + self.rows));
        let offset = |i: usize| (to_f64(i) + 0.5) / to_f64(self.n);
        for y in rows {
            for x in columns.clone() {
                let first = ((y - self.top) * self.width + x) * self.n * self.n;
                for j in 0..self.n {
                    for i in 0..self.n {
                        let at = [to_f64(x) + offset(i), to_f64(y) + offset(j)];
                        if let Some(edges) = triangle.covering(at) {
                            let color = self.color(&triangle, edges, paint_with, level);
                            paint(&mut self.samples[first + j * self.n + i], color);
                        }
                    }
                }
            }
        }
    }

    fn color(&self, triangle: &Triangle, edges: [f64; 3], paint_with: &TrianglePaint, level: f64) -> Color {
        match paint_with {
            TrianglePaint::Flat(color) => *color,
            TrianglePaint::Mixed(colors) => {
                let weights = triangle.weights(edges).map(to_f32);
                let [r, g, b] = [0, 1, 2].map(|channel| {
                    let [a, b, c] = colors.map(|color| color[channel]);
                    (a * weights[0] + b * weights[1] + c * weights[2]).clamp(0.0, 1.0)
                });
                [r, g, b, 1.0]
            }
            TrianglePaint::Textured { uv, texture } => {
                let [r, g, b] = texture.sample(mixed(triangle.weights(edges), *uv), level, self.options);
                [r, g, b, 1.0]
            }
        }
    }

    /// A picture between two corners, point by point.
    fn picture(&mut self, from: Position, to: Position, texture: &Texture) {
        let size = self.point_size;
        let columns = range(from[0].floor(), to[0].floor() + 1.0, 0, self.width.div_ceil(size));
        let last_row = (self.top + self.rows).div_ceil(size);
        let rows = range(from[1].floor(), to[1].floor() + 1.0, self.top / size, last_row);
        let place = |at: usize, axis: usize| (to_f64(at) + 0.5 - from[axis]) / (to[axis] - from[axis] + 1.0);
        for y in rows {
            for x in columns.clone() {
                let [r, g, b] = texture.bilinear([place(x, 0), place(y, 1)]);
                self.point(to_f64(x), to_f64(y), [r, g, b, 1.0]);
            }
        }
    }
}

/// A triangle by its corners and edge functions.
struct Triangle {
    corners: [Position; 3],
    doubled_area: f64,
}

impl Triangle {
    fn new(corners: [Position; 3]) -> Self {
        let doubled_area = edge(corners[0], corners[1], corners[2]);
        Self { corners, doubled_area }
    }

    /// The three edge functions, opposite to each corner, where the point is inside or on an edge.
    fn covering(&self, at: Position) -> Option<[f64; 3]> {
        let [a, b, c] = self.corners;
        let edges = [edge(b, c, at), edge(c, a, at), edge(a, b, at)];
        let is_covered = edges.iter().all(|edge| *edge >= 0.0) || edges.iter().all(|edge| *edge <= 0.0);
        is_covered.then_some(edges)
    }

    /// Barycentric weights; a triangle of no area takes its first corner.
    fn weights(&self, edges: [f64; 3]) -> [f64; 3] {
        if self.doubled_area == 0.0 { [1.0, 0.0, 0.0] } else { edges.map(|edge| edge / self.doubled_area) }
    }

    /// The mip level: log2 of the longer step in level 0 texels, for a step of one pixel along x and along y.
    fn level(&self, uv: [[f64; 2]; 3], texture: &Texture) -> f64 {
        let [a, b, c] = self.corners;
        let uv_at = |at: Position| mixed(self.weights([edge(b, c, at), edge(c, a, at), edge(a, b, at)]), uv);
        let size = texture.size();
        let here = uv_at(a);
        let step = |to: [f64; 2]| {
            let (du, dv) = ((to[0] - here[0]) * size[0], (to[1] - here[1]) * size[1]);
            (du * du + dv * dv).sqrt()
        };
        let longer = step(uv_at([a[0] + 1.0, a[1]])).max(step(uv_at([a[0], a[1] + 1.0])));
        if longer > 1.0 { libm::log2(longer) } else { 0.0 }
    }

    /// The pixels along an axis that its box touches, within `from..to`.
    fn span(&self, axis: usize, from: usize, to: usize) -> std::ops::Range<usize> {
        let [a, b, c] = self.corners.map(|corner| corner[axis]);
        range(a.min(b).min(c).floor(), a.max(b).max(c).floor() + 1.0, from, to)
    }
}

/// `first..last` as whole numbers within `from..to`.
fn range(first: f64, last: f64, from: usize, to: usize) -> std::ops::Range<usize> {
    to_usize(first.max(to_f64(from)))..to_usize(last.min(to_f64(to)))
}

/// Twice the area of the triangle a, b, p.
fn edge(a: Position, b: Position, p: Position) -> f64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

fn mixed(weights: [f64; 3], uv: [[f64; 2]; 3]) -> [f64; 2] {
    [0, 1].map(|axis| (weights[0] * uv[0][axis] + weights[1] * uv[1][axis]) + weights[2] * uv[2][axis])
}

fn paint(sample: &mut [f32; 3], [r, g, b, a]: Color) {
    if a >= 1.0 {
        *sample = [r, g, b];
    } else {
        for (below, above) in sample.iter_mut().zip([r, g, b]) {
            *below = *below * (1.0 - a) + above * a;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Color = [1.0, 0.0, 0.0, 1.0];

    fn drawn(n: u32, primitive: &Primitive) -> Vec<[u8; 4]> {
        let options = Options { samples_per_axis: n, ..Options::new(8, 8) };
        let mut band = Band::new(&options, 0, 8);
        band.draw(primitive);
        band.resolve()
    }

    #[test]
    fn edges_are_averaged_over_the_samples() {
        let paint = TrianglePaint::Flat(RED);
        let half = Primitive::Triangle { corners: [[0.0, 0.0], [4.5, 0.0], [0.0, 99.0]], paint };
        assert_eq!(drawn(1, &half)[3], [255, 0, 0, 255]);
        assert_eq!(drawn(2, &half)[4], [255, 128, 128, 255]);
    }

    #[test]
    fn lines_are_one_pixel_wide_in_every_direction() {
        for (to, count) in [([6.5, 1.5], 6), ([1.5, 6.5], 6), ([6.5, 4.0], 6), ([1.5, 1.5], 0)] {
            let line = Primitive::Line { from: [1.5, 1.5], to, color: RED };
            let red = drawn(2, &line).iter().filter(|pixel| **pixel == [255, 0, 0, 255]).count();
            assert!(red == count || (count == 0 && red <= 1), "{to:?}: {red}");
        }
    }

    #[test]
    fn endless_lines_end() {
        for to in [[1e30, 1.0], [1.0, -1e30], [f64::INFINITY, f64::NAN], [-1e30, 1e30]] {
            drawn(1, &Primitive::Line { from: [1.0, 1.0], to, color: RED });
        }
        let far = Primitive::Line { from: [-1e7, 3.5], to: [1e7, 3.5], color: RED };
        assert_eq!(drawn(1, &far).iter().filter(|pixel| **pixel == [255, 0, 0, 255]).count(), 8);
    }
}
