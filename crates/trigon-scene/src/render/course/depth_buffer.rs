//! The depth buffer of tinyrenderer, and its lessons that read one: occlusion and outlines.
//!
//! In: the visible surfaces of a picture. Out: the depth of each pixel, how open it is, whether a line is drawn there.
//!
//! The program divides by `w = 1 - z/f`, with z towards the viewer from the point that is looked at, and f the distance of
//! the eye from there. Its depths z/w are 0 at that point, grow towards the eye, and are -1000 where nothing is; x and y
//! are in the same unit. Dmitry Sokolov, "tinyrenderer" (2025), <https://github.com/ssloy/tinyrenderer>, branches `ssao`
//! and `sobel`.

use crate::math::vec3;
use crate::render::effects::AmbientOcclusion;
use crate::render::shapes::{EachPixel, PerPixel, Shapes, each_band, narrow};
use crate::scene::{Camera, Projection};
use trigon::lanes::{F32, Lanes, U32, Vec3};
use trigon::pipeline::RendererOptions;

/// Depths as functions of the position in the world.
#[derive(Clone, Copy, Debug)]
pub(in crate::render) struct DepthScale {
    /// `dot(axis, position) + offset` is z.
    axis: [f32; 4],
    /// 1/f; 0 for a camera without perspective.
    inverse_distance: f32,
    /// f.
    distance: f32,
}

/// The depth where nothing is drawn.
const EMPTY: f32 = -1000.0;

/// Half the side of the cube in which neighbours are looked for.
const RADIUS: f32 = 0.1;

/// The course's numbers.
pub(in crate::render) const OCCLUSION: AmbientOcclusion =
    AmbientOcclusion { radius: Some(RADIUS), strength: 1.0, samples: 128 };

/// What nine depths make of a line, as the course has it: the length of the gradient of Sobel's filter.
const LINE_THRESHOLD: f32 = 0.15;

impl DepthScale {
    pub(in crate::render) fn new(camera: &Camera) -> Self {
        let forward = camera.forward();
        let [x, y, z] = vec3::narrow(vec3::scale(forward, -1.0));
        let distance = vec3::length(vec3::sub(camera.target, camera.eye)).max(f64::from(f32::MIN_POSITIVE));
        let inverse_distance = match camera.projection {
            Projection::Perspective { .. } => narrow(1.0 / distance),
            Projection::Orthographic { .. } => 0.0,
        };
        Self {
            axis: [x, y, z, narrow(vec3::dot(forward, camera.target))],
            inverse_distance,
            distance: narrow(distance),
        }
    }

    /// The depths of sixteen points.
    #[inline(always)]
    pub(in crate::render) fn at<L: Lanes>(&self, l: L, position: Vec3<L>) -> F32<L> {
        let [x, y, z, offset] = self.axis;
        let height = position.dot(l.vec3([x, y, z])) + offset;
        height / (1.0 - height * self.inverse_distance)
    }

    /// The depths of a picture, row by row.
    fn of(&self, shapes: &Shapes) -> Vec<f32> {
        let mut depths = shapes.along(self.axis, EMPTY);
        for depth in depths.iter_mut().filter(|height| **height != EMPTY) {
            *depth /= 1.0 - *depth * self.inverse_distance;
        }
        depths
    }

    /// How open each pixel is, as the course estimates it: of random points in a cube around the pixel, as large on the
    /// picture as it is deep, four tenths of those that lie behind what is drawn there count as hidden.
    ///
    /// Its random numbers differ from run to run; these are made of the numbers of pixel and point.
    pub(in crate::render) fn openness(
        &self,
        shapes: &Shapes,
        settings: &AmbientOcclusion,
        options: RendererOptions,
    ) -> Vec<f32> {
        let depths = self.of(shapes);
        let radius = settings.radius.unwrap_or(RADIUS).max(f32::MIN_POSITIVE);
        let samples = settings.samples.clamp(1, AmbientOcclusion::MAX_SAMPLES);
        let strength = settings.strength.max(0.0);
        let pixel = shapes.pixel[0] + shapes.pixel[1] * self.distance;
        let votes = Votes { shapes, depths: &depths, radius, radius_px: radius / pixel, samples, strength };
        let mut openness = vec![1.0; depths.len()];
        each_band(options, shapes.width, &mut openness, |y, rows| {
            options.simd.run(EachPixel { of: &votes, width: shapes.width, y, rows });
        });
        openness
    }

    /// 1 for each pixel, row by row, where the course draws its outlines, else 0.
    pub(in crate::render) fn lines(&self, shapes: &Shapes, options: RendererOptions) -> Vec<f32> {
        let depths = self.of(shapes);
        let mut lines = vec![0.0; depths.len()];
        let edges = Edges { shapes, depths: &depths };
        each_band(options, shapes.width, &mut lines, |y, rows| {
            options.simd.run(EachPixel { of: &edges, width: shapes.width, y, rows });
        });
        lines
    }
}

/// The vote of random points on how open a pixel is.
struct Votes<'a> {
    shapes: &'a Shapes,
    depths: &'a [f32],
    radius: f32,
    radius_px: f32,
    samples: u32,
    strength: f32,
}

impl PerPixel for &Votes<'_> {
    #[inline(always)]
    fn at<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> F32<L> {
        /// The share of all votes that makes a pixel black.
        const WEIGHT: f32 = 0.4;
        /// What is so many radii nearer has nothing to do with the pixel.
        const RANGE: f32 = 5.0;
        let pixel = self.shapes.index(l, x, y);
        let depth = pixel.gather_f32(self.depths);
        let zero = l.f32(0.0);
        let (mut voters, mut hidden) = (zero, zero);
        for sample in 0..self.samples {
            let [dx, dy, dz] = random(l, pixel * l.u32(self.samples) + l.u32(sample));
            // Rows of the program count from the bottom, and places are cut to whole pixels.
            let (column, row) = ((x + dx * self.radius_px).floor(), y - (dy * self.radius_px).floor());
            let there = self.shapes.index(l, column, row).gather_f32(self.depths);
            let is_inside =
                column.ge(0.0) & row.ge(0.0) & column.lt(self.shapes.width as f32) & row.lt(self.shapes.height as f32);
            let counts = is_inside & there.le(depth + RANGE * self.radius);
            let hides = counts & there.gt(depth + dz * self.radius);
            voters += counts.select(l.f32(1.0), zero);
            hidden += hides.select(l.f32(1.0), zero);
        }
        let open = (1.0 - (hidden / voters.max(1.0)) * (WEIGHT * self.strength)).saturate();
        (open * open) * (3.0 - 2.0 * open)
    }
}

/// Three numbers of -1 to 1 made of one, by a hash that leaves no pattern (Chris Wellons, "Prospecting for Hash
/// Functions", 2018).
#[inline(always)]
fn random<L: Lanes>(l: L, number: U32<L>) -> [F32<L>; 3] {
    let mut bits = number;
    bits = (bits ^ (bits >> 16)) * l.u32(0x7feb_352d);
    bits = (bits ^ (bits >> 15)) * l.u32(0x846c_a68b);
    bits = bits ^ (bits >> 16);
    let mut parts = [l.f32(0.0); 3];
    for (part, shift) in parts.iter_mut().zip([0, 10, 20]) {
        *part = ((bits >> shift) & l.u32(1023)).as_i32().to_f32() * (2.0 / 1023.0) - 1.0;
    }
    parts
}

/// Where the neighbours of a pixel are.
const NEIGHBOURS: [(f32, f32); 8] =
    [(-1.0, -1.0), (0.0, -1.0), (1.0, -1.0), (-1.0, 0.0), (1.0, 0.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0)];

/// Where depths change abruptly.
struct Edges<'a> {
    shapes: &'a Shapes,
    depths: &'a [f32],
}

impl PerPixel for &Edges<'_> {
    #[inline(always)]
    fn at<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> F32<L> {
        let zero = l.f32(0.0);
        let (mut across, mut down) = (zero, zero);
        for (dx, dy) in NEIGHBOURS {
            let depth = self.shapes.index(l, x + dx, y + dy).gather_f32(self.depths);
            across += depth * (dx * (2.0 - dy.abs()));
            down += depth * (dy * (2.0 - dx.abs()));
        }
        let is_edge = (across * across + down * down).sqrt().gt(LINE_THRESHOLD);
        // The filter needs eight neighbours.
        let is_inner =
            x.ge(1.0) & y.ge(1.0) & x.lt((self.shapes.width - 1) as f32) & y.lt((self.shapes.height - 1) as f32);
        (is_edge & is_inner).select(l.f32(1.0), zero)
    }
}
