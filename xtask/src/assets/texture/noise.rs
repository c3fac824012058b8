//! Noise that repeats: value noise and scattered points on a lattice, from an integer hash.

/// A number in 0..1 that depends on everything given and looks like chance (the finalizer of MurmurHash3, chained).
pub(crate) fn chance(x: i32, y: i32, seed: u32) -> f64 {
    let mut hash = seed;
    for part in [x, y] {
        hash = hash.wrapping_mul(0x9e37_79b9) ^ part.cast_unsigned();
        hash = (hash ^ (hash >> 16)).wrapping_mul(0x85eb_ca6b);
        hash = (hash ^ (hash >> 13)).wrapping_mul(0xc2b2_ae35);
        hash ^= hash >> 16;
    }
    f64::from(hash) / 4_294_967_296.0
}

/// A lattice of `columns` x `rows` cells over the unit square, which repeats beyond it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lattice {
    pub(crate) columns: i32,
    pub(crate) rows: i32,
    pub(crate) seed: u32,
}

impl Lattice {
    pub(crate) const fn new(columns: i32, rows: i32, seed: u32) -> Self {
        Self { columns, rows, seed }
    }

    fn at(self, column: i32, row: i32) -> f64 {
        chance(column.rem_euclid(self.columns), row.rem_euclid(self.rows), self.seed)
    }

    /// Smooth noise in 0..=1 with one random value per lattice point.
    pub(crate) fn noise(self, u: f64, v: f64) -> f64 {
        let (column, s) = cell(u * f64::from(self.columns));
        let (row, t) = cell(v * f64::from(self.rows));
        let (s, t) = (fade(s), fade(t));
        let low = self.at(column, row) * (1.0 - s) + self.at(column + 1, row) * s;
        let high = self.at(column, row + 1) * (1.0 - s) + self.at(column + 1, row + 1) * s;
        low * (1.0 - t) + high * t
    }

    /// Noise of `octaves` lattices, each twice as fine and half as strong as the one before; in 0..=1.
    pub(crate) fn fractal(self, octaves: u32, u: f64, v: f64) -> f64 {
        let (mut sum, mut total, mut strength, mut lattice) = (0.0, 0.0, 1.0, self);
        for octave in 0..octaves {
            sum += lattice.noise(u, v) * strength;
            total += strength;
            strength /= 2.0;
            lattice = Self::new(lattice.columns * 2, lattice.rows * 2, self.seed + octave + 1);
        }
        sum / total
    }

    /// The distance to the nearest of the points scattered one to a cell, in cells, and that point's own number.
    pub(crate) fn nearest_point(self, u: f64, v: f64) -> (f64, f64) {
        let (column, s) = cell(u * f64::from(self.columns));
        let (row, t) = cell(v * f64::from(self.rows));
        let scatter = Self { seed: self.seed ^ 0x5bd1_e995, ..self };
        let mut nearest = (f64::MAX, 0.0);
        for j in -2..=2 {
            for i in -2..=2 {
                let x = f64::from(i) + 0.5 + 0.8 * (self.at(column + i, row + j) - 0.5) - s;
                let y = f64::from(j) + 0.5 + 0.8 * (scatter.at(column + i, row + j) - 0.5) - t;
                let distance = (x * x + y * y).sqrt();
                if distance < nearest.0 {
                    nearest = (distance, chance(column + i, row + j, self.seed + 77));
                }
            }
        }
        nearest
    }
}

/// The whole part and the rest.
#[expect(clippy::cast_possible_truncation, reason = "lattices have a few hundred cells")]
fn cell(x: f64) -> (i32, f64) {
    (x.floor() as i32, x - x.floor())
}

fn fade(t: f64) -> f64 {
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_repeats_and_stays_in_range() {
        let lattice = Lattice::new(5, 3, 7);
        for step in 0..200 {
            let (u, v) = (chance(step, 0, 1), chance(step, 1, 1));
            let value = lattice.fractal(3, u, v);
            assert!((0.0..=1.0).contains(&value));
            assert!((value - lattice.fractal(3, u + 1.0, v - 1.0)).abs() < 1e-9);
            let (distance, _) = lattice.nearest_point(u, v);
            assert!((0.0..1.3).contains(&distance));
            assert!((distance - lattice.nearest_point(u - 1.0, v + 1.0).0).abs() < 1e-9);
        }
    }

    #[test]
    fn chance_is_even() {
        let mean = (0..10_000).map(|i| chance(i, 3, 5)).sum::<f64>() / 10_000.0;
        assert!((mean - 0.5).abs() < 0.02, "{mean}");
    }
}
