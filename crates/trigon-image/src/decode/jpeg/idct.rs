//! The inverse cosine transform: dequantized coefficients in, 8 x 8 samples out.
//!
//! The algorithm of Loeffler, Ligtenberg and Moschytz (1989) with 12 multiplications per dimension in 13-bit fixed
//! point; constants and roundings are those of `jidctint.c`. Broken files may overflow, so the sums wrap.

use std::num::Wrapping;

/// Coefficients or samples of a block, row by row.
pub(super) type Block = [i16; 64];

/// Fraction bits of the constants.
const CONSTANT_BITS: usize = 13;
/// Fraction bits that the columns' results keep for the rows.
const COLUMN_BITS: usize = 2;

/// Writes the samples of `coefficients` times `quantization` to the first 8 bytes of 8 rows, `stride` bytes apart.
pub(super) fn inverse_transform(coefficients: &Block, quantization: &[u16; 64], samples: &mut [u8], stride: usize) {
    let level = |index: usize| Wrapping(i32::from(coefficients[index])) * Wrapping(i32::from(quantization[index]));
    if coefficients[1..].iter().all(|&coefficient| coefficient == 0) {
        let sample = sample_of((level(0) + Wrapping(4)) >> 3);
        samples.chunks_mut(stride).take(8).for_each(|row| row[..8].fill(sample));
        return;
    }
    let levels = std::array::from_fn(level);
    let columns = transposed(&pass(&levels, CONSTANT_BITS - COLUMN_BITS));
    // The mean of 8 times 8 values is an eighth of the transform's.
    let rows = transposed(&pass(&columns, CONSTANT_BITS + COLUMN_BITS + 3));
    for (to, from) in samples.chunks_mut(stride).zip(rows.as_chunks::<8>().0) {
        to[..8].copy_from_slice(&from.map(sample_of));
    }
}

/// Values around zero are samples around 128.
fn sample_of(value: Wrapping<i32>) -> u8 {
    u8::try_from((value.0.clamp(-128, 127)) + 128).unwrap_or(0)
}

type Values = [Wrapping<i32>; 64];

fn transposed(values: &Values) -> Values {
    std::array::from_fn(|index| values[index % 8 * 8 + index / 8])
}

/// The transform in one dimension of each column, without `shift` of its fraction bits, rounded.
#[inline(always)]
fn pass(values: &Values, shift: usize) -> Values {
    let mut result = [Wrapping(0); 64];
    let half = Wrapping(1 << (shift - 1));
    for column in 0..8 {
        let transformed = transform(std::array::from_fn(|row| values[row * 8 + column]));
        for row in 0..8 {
            result[row * 8 + column] = (transformed[row] + half) >> shift;
        }
    }
    result
}

/// Eight coefficients to eight values, times 2^13.
#[inline(always)]
fn transform(x: [Wrapping<i32>; 8]) -> [Wrapping<i32>; 8] {
    let [even, odd] = [even_part(x[0], x[2], x[4], x[6]), odd_part(x[1], x[3], x[5], x[7])];
    std::array::from_fn(|index| if index < 4 { even[index] + odd[index] } else { even[7 - index] - odd[7 - index] })
}

#[inline(always)]
fn even_part(x0: Wrapping<i32>, x2: Wrapping<i32>, x4: Wrapping<i32>, x6: Wrapping<i32>) -> [Wrapping<i32>; 4] {
    let rotated = (x2 + x6) * Wrapping(4433); // 0.541196100
    let outer = rotated + x2 * Wrapping(6270); // 0.765366865
    let inner = rotated - x6 * Wrapping(15137); // 1.847759065
    let sum = (x0 + x4) << CONSTANT_BITS;
    let difference = (x0 - x4) << CONSTANT_BITS;
    [sum + outer, difference + inner, difference - inner, sum - outer]
}

#[inline(always)]
fn odd_part(x1: Wrapping<i32>, x3: Wrapping<i32>, x5: Wrapping<i32>, x7: Wrapping<i32>) -> [Wrapping<i32>; 4] {
    let all = (x1 + x3 + x5 + x7) * Wrapping(9633); // 1.175875602
    let outer = (x7 + x1) * Wrapping(-7373); // -0.899976223
    let inner = (x5 + x3) * Wrapping(-20995); // -2.562915447
    let high = (x7 + x3) * Wrapping(-16069) + all; // -1.961570560
    let low = (x5 + x1) * Wrapping(-3196) + all; // -0.390180644
    [
        x1 * Wrapping(12299) + outer + low,  // 1.501321110
        x3 * Wrapping(25172) + inner + high, // 3.072711026
        x5 * Wrapping(16819) + inner + low,  // 2.053119869
        x7 * Wrapping(2446) + outer + high,  // 0.298631336
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(coefficients: &Block) -> [u8; 64] {
        let mut samples = [0; 64];
        inverse_transform(coefficients, &[1; 64], &mut samples, 8);
        samples
    }

    /// T.81, A.3.3, in double precision.
    fn exact(coefficients: &Block) -> [f64; 64] {
        let scale = |k: usize| if k == 0 { 0.5_f64.sqrt() } else { 1.0 };
        let wave = |k: usize, x: usize| libm::cos((2 * x + 1) as f64 * k as f64 * std::f64::consts::PI / 16.0);
        std::array::from_fn(|place| {
            let terms = (0..64).map(|index| {
                let (u, v) = (index % 8, index / 8);
                scale(u) * scale(v) * f64::from(coefficients[index]) * wave(u, place % 8) * wave(v, place / 8)
            });
            (terms.sum::<f64>() / 4.0 + 128.0).clamp(0.0, 255.0)
        })
    }

    #[test]
    fn samples_are_within_one_of_the_definition() {
        let mut seed = 1_u32;
        let mut next = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            i16::try_from(seed >> 24).unwrap() - 128
        };
        for _ in 0..200 {
            let mut block: Block = std::array::from_fn(|index| if index % 3 == 0 { next() } else { 0 });
            block[0] *= 4;
            for (got, want) in samples(&block).into_iter().zip(exact(&block)) {
                assert!((f64::from(got) - want).abs() < 1.0, "{got} is not {want}");
            }
        }
    }

    #[test]
    fn a_mean_alone_is_what_the_whole_transform_makes_of_it() {
        for mean in (-1100..1100).step_by(7) {
            let mut block = [0; 64];
            block[0] = mean;
            let short = samples(&block);
            let levels = std::array::from_fn(|index| Wrapping(i32::from(block[index])));
            let rows = pass(&transposed(&pass(&levels, 11)), 18);
            assert_eq!(short, rows.map(sample_of));
        }
    }

    #[test]
    fn the_largest_numbers_of_a_broken_file_do_not_panic() {
        let mut out = [0; 64];
        inverse_transform(&[i16::MIN; 64], &[u16::MAX; 64], &mut out, 8);
    }
}
