//! feTurbulence: Perlin noise of several octaves, out of nothing but a seed and a position.
//!
//! The reference algorithm of Filter Effects 1, "feTurbulence" (Perlin, 1985, with its own random numbers), in double
//! precision; only `+ - * /` and square roots, so the noise is the same on every machine.

use super::raster::{Raster, multiply};
use trigon::schedule::Deadline;

/// The noise asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turbulence {
    /// Lattice cells per unit of user space along x and y, at least 0.
    pub base_frequency: (f64, f64),
    /// Number of octaves, each of twice the frequency and half the weight.
    pub octaves: u32,
    /// Seed of the random lattice.
    pub seed: i32,
    /// The rectangle (x, y, width, height) of user space whose opposite sides are to fit together, if any.
    pub stitch: Option<[f64; 4]>,
    /// Whether the octaves are summed with their sign (fractal noise) or without (turbulence).
    pub fractal: bool,
}

/// How pixels lie in user space: `user = origin + pixel * step`, along x and y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// User space position of pixel (0, 0).
    pub origin: (f64, f64),
    /// User space length of a pixel.
    pub step: (f64, f64),
}

/// An octave from the 13th on changes no 8-bit value: it weighs below 2^-12.
const MAX_OCTAVES: u32 = 12;
/// Number of lattice entries.
const LATTICE: usize = 256;
/// Added to positions so that they are positive.
const PERLIN_N: f64 = 4096.0;

/// Premultiplied noise of `width * height` pixels; rows after the deadline are left transparent.
#[must_use]
pub fn turbulence(width: usize, height: usize, grid: Grid, noise: &Turbulence, deadline: Deadline) -> Raster {
    let lattice = Lattice::new(noise.seed);
    let (frequency, wrap) = stitched(noise);
    let mut raster = Raster::new(width, height);
    let mut y = 0.0;
    for row in raster.pixels_mut().chunks_exact_mut(width.max(1)) {
        if deadline.is_over() {
            break;
        }
        let mut x = 0.0;
        for pixel in row {
            let position = (grid.origin.0 + x * grid.step.0, grid.origin.1 + y * grid.step.1);
            let at = (position.0 * frequency.0, position.1 * frequency.1);
            let values = lattice.sum(at, noise, wrap);
            *pixel = multiply(values.map(|value| code(if noise.fractal { (value + 1.0) / 2.0 } else { value })));
            x += 1.0;
        }
        y += 1.0;
    }
    raster
}

#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
fn code(value: f64) -> u8 {
    (value * 255.0 + 0.5) as u8
}

/// Where lattice columns and rows start over, and by how many they do.
#[derive(Debug, Clone, Copy)]
struct Wrap {
    size: (i64, i64),
    at: (i64, i64),
}

/// Frequencies adjusted so that the stitched rectangle holds whole cells, and its wrap.
fn stitched(noise: &Turbulence) -> ((f64, f64), Option<Wrap>) {
    let Some([x, y, width, height]) = noise.stitch else { return (noise.base_frequency, None) };
    let frequency = (whole_cells(noise.base_frequency.0, width), whole_cells(noise.base_frequency.1, height));
    let size = (whole(width * frequency.0 + 0.5), whole(height * frequency.1 + 0.5));
    let at = |start: f64, size: i64| whole(start + PERLIN_N).saturating_add(size);
    (frequency, Some(Wrap { size, at: (at(x * frequency.0, size.0), at(y * frequency.1, size.1)) }))
}

/// The frequency nearest to `frequency`, as a ratio, that has whole cells in `length`.
fn whole_cells(frequency: f64, length: f64) -> f64 {
    if frequency == 0.0 || length == 0.0 {
        return frequency;
    }
    let low = (length * frequency).floor() / length;
    let high = (length * frequency).ceil() / length;
    if low > 0.0 && frequency / low < high / frequency { low } else { high }
}

/// Toward zero, saturating.
#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
fn whole(x: f64) -> i64 {
    x as i64
}

/// The random permutation, and a unit gradient for each of four channels at each entry.
struct Lattice {
    permutation: [u8; LATTICE],
    gradients: Vec<[[f64; 2]; 4]>,
}

impl Lattice {
    fn new(seed: i32) -> Self {
        let mut random = Random::new(seed);
        let mut gradients = vec![[[0.0; 2]; 4]; LATTICE];
        for channel in 0..4 {
            for gradient in &mut gradients {
                let direction = [random.unit(), random.unit()];
                let length = (direction[0] * direction[0] + direction[1] * direction[1]).sqrt();
                gradient[channel] =
                    if length > 0.0 { direction.map(|component| component / length) } else { direction };
            }
        }
        let mut permutation = std::array::from_fn(|i| i.to_le_bytes()[0]);
        for i in (1..LATTICE).rev() {
            permutation.swap(i, random.index());
        }
        Self { permutation, gradients }
    }

    /// All octaves of all channels at a position in lattice cells.
    fn sum(&self, mut at: (f64, f64), noise: &Turbulence, mut wrap: Option<Wrap>) -> [f64; 4] {
        let mut sum = [0.0; 4];
        let mut ratio = 1.0;
        for _ in 0..noise.octaves.min(MAX_OCTAVES) {
            for (total, value) in sum.iter_mut().zip(self.noise(at, wrap)) {
                *total += if noise.fractal { value } else { value.abs() } / ratio;
            }
            at = (at.0 * 2.0, at.1 * 2.0);
            ratio *= 2.0;
            if let Some(wrap) = &mut wrap {
                let offset = whole(PERLIN_N);
                wrap.size = (wrap.size.0.saturating_mul(2), wrap.size.1.saturating_mul(2));
                let next = |at: i64| at.saturating_mul(2).saturating_sub(offset);
                wrap.at = (next(wrap.at.0), next(wrap.at.1));
            }
        }
        sum
    }

    /// One octave.
    fn noise(&self, at: (f64, f64), wrap: Option<Wrap>) -> [f64; 4] {
        let (x0, x1, left) = cell(at.0, wrap.map(|wrap| (wrap.at.0, wrap.size.0)));
        let (y0, y1, top) = cell(at.1, wrap.map(|wrap| (wrap.at.1, wrap.size.1)));
        let (i, j) = (self.permutation[x0], self.permutation[x1]);
        let corner = |column: u8, row: usize| {
            let index = (usize::from(column) + row) % LATTICE;
            &self.gradients[usize::from(self.permutation[index])]
        };
        let (g00, g10, g01, g11) = (corner(i, y0), corner(j, y0), corner(i, y1), corner(j, y1));
        let (right, bottom) = (left - 1.0, top - 1.0);
        let (sx, sy) = (smooth(left), smooth(top));
        std::array::from_fn(|channel| {
            let dot = |g: &[[f64; 2]; 4], x: f64, y: f64| x * g[channel][0] + y * g[channel][1];
            let above = mix(sx, dot(g00, left, top), dot(g10, right, top));
            let below = mix(sx, dot(g01, left, bottom), dot(g11, right, bottom));
            mix(sy, above, below)
        })
    }
}

/// The two lattice indices round a position, and how far behind the first it lies.
fn cell(at: f64, wrap: Option<(i64, i64)>) -> (usize, usize, f64) {
    let shifted = at + PERLIN_N;
    let first = whole(shifted);
    let wrapped = |index: i64| match wrap {
        Some((from, size)) if index >= from => index.saturating_sub(size),
        _ => index,
    };
    let index = |index: i64| usize::from(wrapped(index).to_le_bytes()[0]);
    #[expect(clippy::cast_precision_loss, reason = "exact: the number came from a double")]
    let fraction = shifted - first as f64;
    (index(first), index(first.saturating_add(1)), fraction)
}

fn smooth(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

fn mix(t: f64, a: f64, b: f64) -> f64 {
    a + t * (b - a)
}

/// The random numbers of the specification: Park and Miller's minimal standard.
struct Random(i32);

impl Random {
    const M: i32 = i32::MAX;
    const A: i32 = 16_807;
    const Q: i32 = 127_773;
    const R: i32 = 2_836;

    fn new(seed: i32) -> Self {
        let seed = if seed <= 0 { -(seed % (Self::M - 1)) + 1 } else { seed };
        Self(seed.min(Self::M - 1))
    }

    fn next(&mut self) -> i32 {
        let next = Self::A * (self.0 % Self::Q) - Self::R * (self.0 / Self::Q);
        self.0 = if next <= 0 { next + Self::M } else { next };
        self.0
    }

    /// In -1..1, in 256 steps each way.
    fn unit(&mut self) -> f64 {
        f64::from(self.next() % 512 - 256) / 256.0
    }

    fn index(&mut self) -> usize {
        usize::from(self.next().to_le_bytes()[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOISE: Turbulence =
        Turbulence { base_frequency: (0.05, 0.05), octaves: 2, seed: 0, stitch: None, fractal: true };
    const GRID: Grid = Grid { origin: (0.0, 0.0), step: (1.0, 1.0) };

    #[test]
    fn the_random_numbers_are_those_of_the_specification() {
        // "Test results: after 10 000 calls starting at 1 the seed is 1 043 618 065."
        let mut random = Random::new(1);
        for _ in 0..10_000 {
            random.next();
        }
        assert_eq!(random.0, 1_043_618_065);
    }

    #[test]
    fn stitched_noise_repeats_over_its_rectangle() {
        let noise = Turbulence { stitch: Some([0.0, 0.0, 48.0, 32.0]), ..NOISE };
        let raster = turbulence(49, 33, GRID, &noise, Deadline::NEVER);
        for y in 0..33 {
            assert_eq!(raster.pixel(0, y), raster.pixel(48, y), "row {y}");
        }
        for x in 0..49 {
            assert_eq!(raster.pixel(x, 0), raster.pixel(x, 32), "column {x}");
        }
    }

    #[test]
    fn hostile_numbers_end() {
        let noise = Turbulence { base_frequency: (1e300, f64::INFINITY), octaves: u32::MAX, seed: i32::MIN, ..NOISE };
        assert_eq!(turbulence(3, 2, GRID, &noise, Deadline::NEVER).pixels().len(), 6);
    }
}
