//! feDiffuseLighting and feSpecularLighting: a picture's alpha taken as a height, lit by one lamp.
//!
//! Filter Effects 1, "feDiffuseLighting": normals by the Sobel operator, whose two kernels are cut at the edges of the
//! picture and reweighted; Phong's model with the eye at infinity. Pixel (x, y) of the picture is the point (x, y).

use trigon::math::host;
use trigon::schedule::Deadline;
use trigon_image::color::unit_to_u8;

use super::raster::{Pixel, Raster};

type Vec3 = [f32; 3];

/// A lamp; positions in pixels of the picture, z towards the eye.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lamp {
    /// Infinitely far: the unit vector towards it.
    Distant(Vec3),
    /// At a point, shining everywhere.
    Point(Vec3),
    /// At a point, shining along an axis.
    Spot {
        /// Where it is.
        position: Vec3,
        /// Where it points.
        target: Vec3,
        /// How the light falls off from the axis: the cosine to this power.
        exponent: f32,
        /// The cosine of the angle from the axis beyond which it is dark.
        cone_cos: Option<f32>,
    },
}

/// What light does at a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Surface {
    /// Scattered evenly; the result is opaque.
    Diffuse {
        /// Factor kd.
        constant: f32,
    },
    /// Reflected; the result is as opaque as its brightest channel.
    Specular {
        /// Factor ks.
        constant: f32,
        /// Shininess.
        exponent: f32,
    },
}

/// Light of `color` on the heights `surface_scale * alpha`; rows after the deadline are left transparent.
#[must_use]
pub fn lighting(
    source: &Raster,
    surface: Surface,
    surface_scale: f32,
    color: [u8; 3],
    lamp: &Lamp,
    deadline: Deadline,
) -> Raster {
    let (width, height) = (source.width(), source.height());
    let color = color.map(|code| f32::from(code) / 255.0);
    let mut lit = Raster::new(width, height);
    for y in 0..height {
        if deadline.is_over() {
            break;
        }
        for x in 0..width {
            let point = [to_f32(x), to_f32(y), surface_scale * alpha(source, x, y)];
            let light = towards(lamp, point);
            let brightness = intensity(lamp, light) * reflected(surface, normal(source, surface_scale, x, y), light);
            lit.pixels_mut()[y * width + x] = shaded(surface, color.map(|channel| channel * brightness));
        }
    }
    lit
}

/// The unit vector towards a lamp at `azimuth` and `elevation`, in degrees.
#[must_use]
pub fn distant(azimuth: f32, elevation: f32) -> Lamp {
    let radians = |degrees: f32| f64::from(degrees) * std::f64::consts::PI / 180.0;
    let (a, e) = (radians(azimuth), radians(elevation));
    let flat = host::cos_f64(e);
    Lamp::Distant([host::cos_f64(a) * flat, host::sin_f64(a) * flat, host::sin_f64(e)].map(narrow))
}

/// The cosine of an angle in degrees.
#[must_use]
pub fn cos_degrees(degrees: f32) -> f32 {
    narrow(host::cos_f64(f64::from(degrees) * std::f64::consts::PI / 180.0))
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
fn narrow(x: f64) -> f32 {
    x as f32
}

#[expect(clippy::cast_precision_loss, reason = "pictures have fewer than 2^24 pixels a side")]
fn to_f32(index: usize) -> f32 {
    index as f32
}

fn alpha(source: &Raster, x: usize, y: usize) -> f32 {
    f32::from(source.pixels()[y * source.width() + x][3]) / 255.0
}

/// The surface normal, z = 1, not normalized.
fn normal(source: &Raster, surface_scale: f32, x: usize, y: usize) -> Vec3 {
    let (columns, rows) = (Neighbors::of(x, source.width()), Neighbors::of(y, source.height()));
    let height_at = |x: usize, y: usize| f32::from(source.pixels()[y * source.width() + x][3]) / 255.0;
    let mut slope_x = 0.0;
    for (row, weight) in rows.weighted() {
        slope_x += weight * (height_at(columns.after, row) - height_at(columns.before, row));
    }
    let mut slope_y = 0.0;
    for (column, weight) in columns.weighted() {
        slope_y += weight * (height_at(column, rows.after) - height_at(column, rows.before));
    }
    let scaled = |slope: f32, along: &Neighbors, across: &Neighbors| {
        let divisor = along.distance() * across.total();
        if divisor > 0.0 { -surface_scale * slope * 2.0 / divisor } else { 0.0 }
    };
    [scaled(slope_x, &columns, &rows), scaled(slope_y, &rows, &columns), 1.0]
}

/// A pixel's neighbors along one axis, as far as the picture goes.
struct Neighbors {
    before: usize,
    at: usize,
    after: usize,
}

impl Neighbors {
    fn of(at: usize, length: usize) -> Self {
        Self { before: at.saturating_sub(1), at, after: (at + 1).min(length - 1) }
    }

    /// The kernel across the derivative: 1 2 1, without what lies outside.
    fn weighted(&self) -> impl Iterator<Item = (usize, f32)> {
        let weight = |neighbor: usize| if neighbor == self.at { 0.0 } else { 1.0 };
        [(self.before, weight(self.before)), (self.at, 2.0), (self.after, weight(self.after))].into_iter()
    }

    fn total(&self) -> f32 {
        self.weighted().map(|(_, weight)| weight).sum()
    }

    fn distance(&self) -> f32 {
        to_f32(self.after - self.before)
    }
}

fn towards(lamp: &Lamp, point: Vec3) -> Vec3 {
    match *lamp {
        Lamp::Distant(direction) => direction,
        Lamp::Point(position) | Lamp::Spot { position, .. } => normalized(minus(position, point)),
    }
}

/// How much of the lamp's light leaves it towards the point.
fn intensity(lamp: &Lamp, light: Vec3) -> f32 {
    let Lamp::Spot { position, target, exponent, cone_cos } = *lamp else { return 1.0 };
    let along_axis = -dot(light, normalized(minus(target, position)));
    let is_lit = along_axis > 0.0 && cone_cos.is_none_or(|cos| along_axis >= cos);
    if is_lit { host::powf(along_axis, exponent) } else { 0.0 }
}

fn reflected(surface: Surface, normal: Vec3, light: Vec3) -> f32 {
    let normal = normalized(normal);
    match surface {
        Surface::Diffuse { constant } => constant * dot(normal, light),
        Surface::Specular { constant, exponent } => {
            let half = normalized([light[0], light[1], light[2] + 1.0]);
            let facing = dot(normal, half);
            if facing > 0.0 { constant * host::powf(facing, exponent) } else { 0.0 }
        }
    }
}

fn shaded(surface: Surface, color: Vec3) -> Pixel {
    let [r, g, b] = color.map(unit_to_u8);
    match surface {
        Surface::Diffuse { .. } => [r, g, b, 255],
        Surface::Specular { .. } => [r, g, b, r.max(g).max(b)],
    }
}

fn minus(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vec3, b: Vec3) -> f32 {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

fn normalized(v: Vec3) -> Vec3 {
    let length = dot(v, v).sqrt();
    if length > 0.0 { v.map(|component| component / length) } else { v }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DIFFUSE: Surface = Surface::Diffuse { constant: 1.0 };

    #[test]
    fn a_flat_surface_under_the_lamp_has_its_color() {
        let flat = Raster::filled(5, 4, [0, 0, 0, 255]);
        let lit = lighting(&flat, DIFFUSE, 3.0, [200, 100, 50], &distant(0.0, 90.0), Deadline::NEVER);
        assert!(lit.pixels().iter().all(|pixel| *pixel == [200, 100, 50, 255]));
        let shiny = Surface::Specular { constant: 0.5, exponent: 7.0 };
        let lit = lighting(&flat, shiny, 3.0, [200, 100, 50], &distant(0.0, 90.0), Deadline::NEVER);
        assert!(lit.pixels().iter().all(|pixel| *pixel == [100, 50, 25, 100]));
    }

    #[test]
    fn normals_of_a_ramp_are_the_same_inside_and_at_every_edge() {
        // Heights 0, 20/255, 40/255, ..: the slope is 20/255 a pixel, which the specification doubles.
        let pixels = (0..20).map(|i| [0, 0, 0, 20 * (i % 5)]).collect();
        let ramp = Raster::from_pixels(5, 4, pixels).unwrap();
        for y in 0..4 {
            for x in 0..5 {
                let [nx, ny, _] = normal(&ramp, 1.0, x, y);
                assert!((nx + 2.0 * 20.0 / 255.0).abs() < 1e-6 && ny.abs() < 1e-6, "{x} {y}: {nx} {ny}");
            }
        }
    }

    #[test]
    fn a_spot_is_dark_outside_its_cone() {
        let flat = Raster::filled(9, 1, [0, 0, 0, 255]);
        let cone_cos = Some(cos_degrees(20.0));
        let lamp = Lamp::Spot { position: [4.0, 0.0, 6.0], target: [4.0, 0.0, 0.0], exponent: 1.0, cone_cos };
        let lit: Vec<bool> = lighting(&flat, DIFFUSE, 1.0, [255; 3], &lamp, Deadline::NEVER)
            .pixels()
            .iter()
            .map(|pixel| pixel[0] > 0)
            .collect();
        // The height 1 is 5 below the lamp: 20 degrees reach 1.8 pixels.
        assert_eq!(lit, [false, false, false, true, true, true, false, false, false]);
    }

    #[test]
    fn the_smallest_pictures_are_no_trouble() {
        for (width, height) in [(0, 0), (1, 1), (1, 4), (3, 1)] {
            let flat = Raster::filled(width, height, [255; 4]);
            let lit = lighting(&flat, DIFFUSE, 1.0, [255; 3], &distant(45.0, 45.0), Deadline::NEVER);
            assert_eq!(lit.pixels().len(), width * height);
        }
    }
}
