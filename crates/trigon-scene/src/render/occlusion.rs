//! Screen-space ambient occlusion: how much of its surroundings each visible point can see.
//!
//! In: the visible surfaces of a picture. Out: an [`OcclusionMap`]: one number per pixel, 1 where nothing is near, 0 in a deep crack,
//! by which shaders dim the light from all around. It is estimated from what is in the picture alone (Mittring, "Finding
//! Next Gen: CryEngine 2", 2007): the visible points around a pixel stand for all that could be in the way.
//!
//! The estimator is that of McGuire, Mara and Luebke, "Scalable Ambient Obscurance", 2012. A neighbour v away from a
//! point with normal n hides more of its sky the steeper it rises over the point's plane (v.n) and the nearer it is, and
//! nothing beyond the radius. A flat surface never hides itself, however coarse the picture, because on it v.n is zero.
//! Neighbours lie on a spiral, turned differently for each of 8 x 8 pixels; the pattern that this leaves is blurred away,
//! along surfaces only.

use super::effects::AmbientOcclusion;
use super::shapes::{EachPixel, NOWHERE, PerPixel, Shapes, each_band, narrow};
use trigon::lanes::{F32, Lanes, U32, Vec2};
use trigon::pipeline::RendererOptions;

/// How open the surfaces of a picture are.
pub(super) struct OcclusionMap {
    pub(super) width: u32,
    pub(super) height: u32,
    /// 0 to 1, row by row.
    pub(super) openness: Vec<f32>,
    /// Distance of each pixel's surface along the view; far beyond the scene where there is none.
    pub(super) distances: Vec<f32>,
    /// `dot(axis, position) + offset` is that distance.
    pub(super) view_axis: [f32; 4],
    /// A fragment farther than this from its pixel's surface is not the one that was measured.
    pub(super) reach: f32,
}

/// The surfaces of a picture, and how to measure on them.
struct Field<'a> {
    shapes: &'a Shapes,
    distances: &'a [f32],
    radius: f32,
}

/// Neighbours are looked for in this part of the picture's height at most, so that a near surface does not scatter them.
const WIDEST: f32 = 0.25;

impl OcclusionMap {
    /// The map of openness that is known for each pixel.
    pub(super) fn of(openness: Vec<f32>, shapes: &Shapes, reach: f32) -> Self {
        let Shapes { width, height, view_axis, .. } = *shapes;
        Self { width, height, openness, distances: shapes.distances(), view_axis, reach }
    }

    /// Measures the surfaces of a picture of a scene of that radius.
    pub(super) fn new(
        shapes: &Shapes,
        settings: &AmbientOcclusion,
        scene_radius: f64,
        options: RendererOptions,
    ) -> Self {
        let fitted = AmbientOcclusion::FITTED_RADIUS * narrow(scene_radius);
        let radius = settings.radius.unwrap_or(fitted).max(f32::MIN_POSITIVE);
        let distances = shapes.distances();
        let openness = Field { shapes, distances: &distances, radius }.openness(options, settings);
        let Shapes { width, height, view_axis, .. } = *shapes;
        Self { width, height, openness, distances, view_axis, reach: radius }
    }
}

impl Field<'_> {
    fn openness(&self, options: RendererOptions, settings: &AmbientOcclusion) -> Vec<f32> {
        let spiral = spiral(settings.samples.clamp(1, AmbientOcclusion::MAX_SAMPLES));
        let turns: [[f32; 2]; 64] = std::array::from_fn(|i| direction(i as f64 / 64.0));
        let strength = if settings.strength > 0.0 { settings.strength } else { 0.0 };
        let mut noisy = vec![1.0; self.distances.len()];
        each_band(options, self.shapes.width, &mut noisy, |y, rows| {
            let of = Estimate { field: self, spiral: &spiral, turns: &turns, strength };
            options.simd.run(EachPixel { of, width: self.shapes.width, y, rows });
        });
        let mut halfway = vec![1.0; noisy.len()];
        each_band(options, self.shapes.width, &mut halfway, |y, rows| {
            let of = Blur { field: self, values: &noisy, step: [1, 0] };
            options.simd.run(EachPixel { of, width: self.shapes.width, y, rows });
        });
        each_band(options, self.shapes.width, &mut noisy, |y, rows| {
            let of = Blur { field: self, values: &halfway, step: [0, 1] };
            options.simd.run(EachPixel { of, width: self.shapes.width, y, rows });
        });
        noisy
    }
}

/// The estimate: how open the surfaces at sixteen pixels are.
struct Estimate<'a> {
    field: &'a Field<'a>,
    /// Within the unit circle.
    spiral: &'a [[f32; 2]],
    /// Unit vectors in all directions.
    turns: &'a [[f32; 2]],
    strength: f32,
}

impl PerPixel for Estimate<'_> {
    #[inline(always)]
    fn at<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> F32<L> {
        let Self { field, spiral, turns, strength } = *self;
        /// Rises below this part of the radius are noise of the surface itself; distances get this much added.
        const SMALLEST_RISE: f32 = 0.02;
        const SOFTENING: f32 = 0.02;
        let shapes = field.shapes;
        let here = shapes.index(l, x, y);
        let (position, normal) = (here.gather_vec3(&shapes.positions), here.gather_vec3(&shapes.normals));
        let pixel = here.gather_f32(field.distances) * shapes.pixel[1] + shapes.pixel[0];
        let radius = (field.radius / pixel).min(shapes.height as f32 * WIDEST);
        let turn = scattered(l, x, y).gather_vec2(turns);
        let mut sum = l.f32(0.0);
        for [u, v] in spiral {
            let at = Vec2 {
                x: (x + 0.5) + (turn.x * *u - turn.y * *v) * radius,
                y: (y + 0.5) + (turn.y * *u + turn.x * *v) * radius,
            };
            let away = (shapes.index(l, at.x, at.y).gather_vec3(&shapes.positions) - position) * (1.0 / field.radius);
            let (squared, rise) = (away.dot(away), away.dot(normal));
            let near = 1.0 - squared;
            let hidden = (near * near * near) * ((rise - SMALLEST_RISE).max(0.0) / (squared + SOFTENING));
            let counts = squared.lt(1.0)
                & at.x.ge(0.0)
                & at.y.ge(0.0)
                & at.x.lt(shapes.width as f32)
                & at.y.lt(shapes.height as f32);
            sum += counts.select(hidden, l.f32(0.0));
        }
        let open = 1.0 - sum * (5.0 * strength / spiral.len() as f32);
        position.x.eq(NOWHERE).select(l.f32(1.0), open.saturate())
    }
}

/// 0 to 63, each once in any square of 8 x 8 pixels and far from its neighbours' numbers (Bayer, "An Optimum Method for
/// Two-Level Rendition of Continuous-Tone Pictures", 1973): the bits of x ^ y and y in turn, the lowest on top. Random
/// numbers would leave blotches that no small blur removes.
#[inline(always)]
fn scattered<L: Lanes>(l: L, x: F32<L>, y: F32<L>) -> U32<L> {
    let (x, y) = (x.to_i32_within(0.0, 65_535.0).as_u32(), y.to_i32_within(0.0, 65_535.0).as_u32());
    let (odd, one) = (x ^ y, l.u32(1));
    let mut number = l.u32(0);
    for bit in 0..3 {
        number = (number << 2) | ((((odd >> bit) & one) << 1) | ((y >> bit) & one));
    }
    number
}

/// One direction of the blur: the mean of sixteen pixels' neighbours along `step`, as far as they lie on the same surface.
struct Blur<'a> {
    field: &'a Field<'a>,
    values: &'a [f32],
    /// To the next pixel.
    step: [u8; 2],
}

impl PerPixel for Blur<'_> {
    #[inline(always)]
    fn at<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> F32<L> {
        let Self { field, values, step } = *self;
        /// A normal distribution over -4 to 4 pixels.
        const WEIGHTS: [f32; 9] = [0.1353, 0.3247, 0.6065, 0.8825, 1.0, 0.8825, 0.6065, 0.3247, 0.1353];
        /// Points this part of the radius off the plane are on another surface.
        const OFF_PLANE: f32 = 0.1;
        let shapes = field.shapes;
        let here = shapes.index(l, x, y);
        let (position, normal) = (here.gather_vec3(&shapes.positions), here.gather_vec3(&shapes.normals));
        let (mut sum, mut total) = (l.f32(0.0), l.f32(0.0));
        for (tap, weight) in WEIGHTS.iter().enumerate() {
            let offset = tap as f32 - 4.0;
            let there = shapes.index(l, x + offset * f32::from(step[0]), y + offset * f32::from(step[1]));
            let off_plane = normal.dot(there.gather_vec3(&shapes.positions) - position).abs();
            let alike = normal.dot(there.gather_vec3(&shapes.normals)).max(0.0);
            let weight = (1.0 - off_plane * (1.0 / (OFF_PLANE * field.radius))).max(0.0) * (alike * *weight);
            sum += weight * there.gather_f32(values);
            total += weight;
        }
        // Without a surface there is no normal, and no weight.
        total.gt(0.0).select(sum / total, l.f32(1.0))
    }
}

/// Points of a spiral of seven turns, the inner ones closer together: near surfaces hide most.
fn spiral(samples: u32) -> Vec<[f32; 2]> {
    const TURNS: f64 = 7.0;
    (0..samples)
        .map(|i| {
            let part = (f64::from(i) + 0.5) / f64::from(samples);
            direction(part * TURNS).map(|c| c * narrow(part))
        })
        .collect()
}

/// The unit vector at `turn` whole turns.
fn direction(turn: f64) -> [f32; 2] {
    let angle = turn * std::f64::consts::TAU;
    [narrow(libm::cos(angle)), narrow(libm::sin(angle))]
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon::lanes::{Kernel, SimdLevel};

    /// The numbers of sixteen pixels of each of eight rows.
    struct Numbers;

    impl Kernel for Numbers {
        type Output = Vec<u32>;

        #[inline(always)]
        fn run<L: Lanes>(self, l: L) -> Vec<u32> {
            let mut numbers = Vec::new();
            for row in 0..8 {
                numbers.extend(scattered(l, l.lane_numbers(), l.f32(row as f32)).to_array());
            }
            numbers
        }
    }

    #[test]
    fn each_square_of_8_by_8_pixels_has_all_64_turns() {
        let numbers = SimdLevel::Scalar.run(Numbers);
        for left in 0..8 {
            let mut square: Vec<u32> = numbers.chunks(16).flat_map(|row| row[left..left + 8].to_vec()).collect();
            square.sort_unstable();
            assert_eq!(square, (0..64).collect::<Vec<u32>>());
        }
        // Neighbours look to opposite sides.
        assert!(numbers.chunks(16).all(|row| row.windows(2).all(|pair| pair[0].abs_diff(pair[1]) >= 16)));
    }

    #[test]
    fn spirals_fill_the_unit_circle() {
        let spiral = spiral(64);
        let radius = |[x, y]: &[f32; 2]| (x * x + y * y).sqrt();
        assert!(spiral.iter().all(|p| radius(p) < 1.0) && spiral.windows(2).all(|p| radius(&p[0]) < radius(&p[1])));
    }
}
