//! The mip chain: rows of level 0 in, texels of every smaller level out.
//!
//! Each texel of a level is the mean of exactly the area that it covers of the level above (a box filter), computed from
//! the unrounded linear values of that level and rounded only when stored. Along a side of `2n` texels that is the mean
//! of two; along one of `2n + 1`, target `i` covers a part of three: `(n - i, n, i + 1) / (2n + 1)` of texels
//! `2i, 2i + 1, 2i + 2` (Guthe and Heckbert, "Non-Power-of-Two Mipmap Creation", NVIDIA 2005). In an image with even
//! sides a texel is `((a + b) + (c + d)) / 4`, to the bit.
//!
//! The levels run as a cascade: a row that is finished goes to the level below at once, so that no level is ever held in
//! floats.

use super::layout::Level;

type Rgba = [f32; 4];

/// The levels from one on, waiting for rows of the level above.
pub(super) struct MipCascade {
    steps: Vec<HalvingStep>,
}

/// Makes the rows of one level from the rows of the level above.
struct HalvingStep {
    /// Index of the level that is made.
    level: usize,
    source_height: u32,
    source_row: u32,
    /// Columns already halved, rows not yet.
    halved: Vec<Rgba>,
    /// The row being summed up.
    sum: Vec<Rgba>,
}

impl MipCascade {
    pub(super) fn new(levels: &[Level]) -> Self {
        let steps = levels.windows(2).enumerate().map(|(above, pair)| {
            let zero = vec![[0.0; 4]; pair[1].width as usize];
            HalvingStep {
                level: above + 1,
                source_height: pair[0].height,
                source_row: 0,
                halved: zero.clone(),
                sum: zero,
            }
        });
        Self { steps: steps.collect() }
    }

    /// Takes the next row of level 0; calls `store(level, y, row)` for each row that becomes finished by it.
    pub(super) fn push_row(&mut self, row: &[Rgba], store: &mut impl FnMut(usize, u32, &[Rgba])) {
        push_row(&mut self.steps, row, store);
    }
}

fn push_row(steps: &mut [HalvingStep], row: &[Rgba], store: &mut impl FnMut(usize, u32, &[Rgba])) {
    let Some((step, below)) = steps.split_first_mut() else { return };
    halve_columns(row, &mut step.halved);
    let y = step.source_row;
    step.source_row += 1;
    for (target, weight) in shares(y, step.source_height).into_iter().flatten() {
        if y == 2 * target {
            step.sum.fill([0.0; 4]);
        }
        accumulate(&mut step.sum, &step.halved, weight);
        if y == last_source(target, step.source_height) {
            store(step.level, target, &step.sum);
            push_row(below, &step.sum, store);
        }
    }
}

/// The targets that source `i` of `n` goes into, the first one first, and the fraction of each that it makes up.
#[expect(clippy::cast_precision_loss, reason = "sizes are below 2^24")]
fn shares(i: u32, n: u32) -> [Option<(u32, f32)>; 2] {
    let (target, targets) = (i / 2, n / 2);
    match (n % 2, i % 2) {
        _ if n == 1 => [Some((0, 1.0)), None],
        (0, _) => [Some((target, 0.5)), None],
        (_, 1) => [Some((target, targets as f32 / n as f32)), None],
        // An even source of an odd number lies on a border between two targets.
        _ => [
            (target > 0).then(|| (target - 1, target as f32 / n as f32)),
            (target < targets).then(|| (target, (targets - target) as f32 / n as f32)),
        ],
    }
}

/// The last source that goes into a target.
fn last_source(target: u32, n: u32) -> u32 {
    match n {
        1 => 0,
        _ if n.is_multiple_of(2) => 2 * target + 1,
        _ => 2 * target + 2,
    }
}

/// One row with half the columns.
fn halve_columns(row: &[Rgba], halved: &mut [Rgba]) {
    if let [single] = row {
        halved[0] = *single;
    } else if row.len().is_multiple_of(2) {
        for (half, pair) in halved.iter_mut().zip(row.chunks_exact(2)) {
            for c in 0..4 {
                half[c] = (pair[0][c] + pair[1][c]) * 0.5;
            }
        }
    } else {
        let (n, width) = (halved.len() as f32, row.len() as f32);
        for (i, half) in halved.iter_mut().enumerate() {
            let weights = [(n - i as f32) / width, n / width, (i as f32 + 1.0) / width];
            for c in 0..4 {
                half[c] =
                    (row[2 * i][c] * weights[0] + row[2 * i + 1][c] * weights[1]) + row[2 * i + 2][c] * weights[2];
            }
        }
    }
}

fn accumulate(sum: &mut [Rgba], row: &[Rgba], weight: f32) {
    for (sum, value) in sum.iter_mut().zip(row) {
        for (sum, value) in sum.iter_mut().zip(value) {
            *sum += value * weight;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{TexelFormat, Texture, TextureDesc};

    fn values([width, height]: [u32; 2]) -> Vec<f32> {
        (0..width * height).map(|i| (i.wrapping_mul(2_654_435_761) >> 8) as f32 / 16_777_216.0).collect()
    }

    fn texture(size: [u32; 2]) -> Texture {
        Texture::from_floats(&TextureDesc::new(size, TexelFormat::R32Float), &values(size)).unwrap()
    }

    fn sizes() -> Vec<[u32; 2]> {
        let mut sizes: Vec<[u32; 2]> = (1..=17).flat_map(|w| (1..=17).map(move |h| [w, h])).collect();
        sizes.extend([[255, 129], [1, 300], [301, 1], [64, 3], [6, 127]]);
        sizes
    }

    /// How much of target `i` of `targets` source `k` of `sources` covers, by the overlap of their intervals.
    fn overlap(i: u32, targets: u32, k: u32, sources: u32) -> f64 {
        let ratio = f64::from(sources) / f64::from(targets);
        let (from, to) = (f64::from(i) * ratio, f64::from(i + 1) * ratio);
        ((f64::from(k) + 1.0).min(to) - f64::from(k).max(from)).max(0.0) / ratio
    }

    #[test]
    fn each_texel_is_the_mean_of_its_area() {
        for size in sizes() {
            let texture = texture(size);
            let mut above: Vec<f64> = values(size).into_iter().map(f64::from).collect();
            let [mut width, mut height] = size;
            for level in 1..texture.levels() {
                let [w, h] = texture.level_size(level).unwrap();
                assert_eq!([w, h], [(width / 2).max(1), (height / 2).max(1)]);
                let mut means = Vec::new();
                for (y, x) in (0..h).flat_map(|y| (0..w).map(move |x| (y, x))) {
                    let mut mean = 0.0;
                    // No target reaches further than three sources.
                    for (j, i) in
                        (2 * y..height.min(2 * y + 3)).flat_map(|j| (2 * x..width.min(2 * x + 3)).map(move |i| (j, i)))
                    {
                        mean += above[(j * width + i) as usize] * overlap(x, w, i, width) * overlap(y, h, j, height);
                    }
                    let made = texture.texel(level, x, y).unwrap()[0];
                    assert!((f64::from(made) - mean).abs() < 1e-6, "{size:?} level {level} ({x}, {y}): {made} {mean}");
                    means.push(mean);
                }
                (above, width, height) = (means, w, h);
            }
            assert_eq!([width, height], [1, 1]);
        }
    }

    #[test]
    fn every_level_has_the_mean_of_the_image() {
        for size in sizes() {
            let texture = texture(size);
            let mean = |level: usize| {
                let [w, h] = texture.level_size(level).unwrap();
                let texels = (0..h).flat_map(|y| (0..w).map(move |x| (x, y)));
                let sum: f64 = texels.map(|(x, y)| f64::from(texture.texel(level, x, y).unwrap()[0])).sum();
                sum / f64::from(w * h)
            };
            for level in 1..texture.levels() {
                assert!((mean(level) - mean(0)).abs() < 1e-6, "{size:?} level {level}");
            }
        }
    }

    #[test]
    fn even_sides_give_the_plain_mean_to_the_bit() {
        let texture = texture([32, 8]);
        for level in 1..4 {
            let [w, h] = texture.level_size(level).unwrap();
            for (y, x) in (0..h).flat_map(|y| (0..w).map(move |x| (y, x))) {
                let above = |dx, dy| texture.texel(level - 1, 2 * x + dx, 2 * y + dy).unwrap()[0];
                let mean = ((above(0, 0) + above(1, 0)) + (above(0, 1) + above(1, 1))) * 0.25;
                assert_eq!(texture.texel(level, x, y).unwrap()[0].to_bits(), mean.to_bits());
            }
        }
    }
}
