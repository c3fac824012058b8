//! A sample pattern as scan lines: each pixel row has a few sample rows, each with one to four samples of the same y.
//!
//! Coordinates are 24.8 fixed point, in 1/256 px. Sample rows are numbered through the picture, `rows()` to a pixel row,
//! top down. A sample's number within its pixel is `row * columns() + column`.

use std::sync::OnceLock;
use trigon::target::SamplePattern;

/// Most sample rows in a pixel row.
pub(crate) const MAX_SAMPLE_ROWS: usize = 16;

/// The tables that turn coordinates into sample rows and columns.
#[derive(Clone)]
pub(crate) struct SampleRows {
    rows: usize,
    columns: usize,
    /// Offset of each row from the top of the pixel.
    offset_y: [i32; MAX_SAMPLE_ROWS],
    /// Added to an x so that the pixel it falls in is the one whose samples it comes before.
    shift_x: [i32; MAX_SAMPLE_ROWS],
    /// By the fraction of a shifted x: the columns at or right of it, one byte each, 1 if so. The last byte always is.
    columns_from: Box<[u32; 256]>,
    /// By the fraction of a y: the number of rows above it.
    rows_before: Box<[u8; 256]>,
}

impl SampleRows {
    /// The rows of a pattern, in order of y.
    pub(crate) fn new(pattern: SamplePattern) -> Self {
        let mut positions: Vec<[i32; 2]> = pattern.positions().iter().map(|p| p.map(i32::from)).collect();
        positions.sort_unstable_by_key(|&[x, y]| [y, x]);
        let mut ys: Vec<i32> = positions.iter().map(|p| p[1]).collect();
        ys.dedup();
        let (rows, columns) = (ys.len(), positions.len() / ys.len());
        let (mut offset_y, mut shift_x) = ([0; MAX_SAMPLE_ROWS], [0; MAX_SAMPLE_ROWS]);
        for (row, line) in positions.chunks(columns).enumerate() {
            offset_y[row] = line[0][1];
            shift_x[row] = 255 - line[columns - 1][0];
        }
        // All rows of a grid have the same columns; those of other patterns have one.
        let shifted: Vec<i32> = positions[..columns].iter().map(|p| p[0] + shift_x[0]).collect();
        let mut columns_from = Box::new([0; 256]);
        let mut rows_before = Box::new([0; 256]);
        for (fraction, (from, before)) in (0..).zip(columns_from.iter_mut().zip(rows_before.iter_mut())) {
            let first = shifted.iter().filter(|x| **x < fraction).count();
            *from = 0x0101_0101 << (8 * first);
            *before = ys.iter().map(|y| u8::from(*y < fraction)).sum();
        }
        Self { rows, columns, offset_y, shift_x, columns_from, rows_before }
    }

    /// One sample, at the centre: where shapes with crisp edges are tested.
    pub(crate) fn centers() -> &'static Self {
        static CENTERS: OnceLock<SampleRows> = OnceLock::new();
        CENTERS.get_or_init(|| Self::new(SamplePattern::CENTER))
    }

    /// Sample rows in a pixel row.
    pub(crate) fn rows(&self) -> usize {
        self.rows
    }

    /// Samples in a sample row of a pixel.
    pub(crate) fn columns(&self) -> usize {
        self.columns
    }

    /// Samples in a pixel.
    pub(crate) fn count(&self) -> usize {
        self.rows * self.columns
    }

    /// One bit per sample.
    pub(crate) fn full_mask(&self) -> u16 {
        u16::MAX >> (16 - self.count())
    }

    /// The first sample row at or below `y`.
    #[inline(always)]
    pub(crate) fn first_row(&self, y: i32) -> i32 {
        (y >> 8) * self.rows as i32 + i32::from(self.rows_before[(y & 255) as usize])
    }

    /// The y of each of the `R` rows, from the top of the pixel.
    #[inline(always)]
    pub(crate) fn offsets_y<const R: usize>(&self) -> [i32; R] {
        core::array::from_fn(|row| self.offset_y[row])
    }

    /// What to add to an x in each of the `R` rows before it is split into pixel and fraction.
    #[inline(always)]
    pub(crate) fn shifts_x<const R: usize>(&self) -> [i32; R] {
        core::array::from_fn(|row| self.shift_x[row])
    }

    /// By the fraction of a shifted x: its columns at or right of it, one byte each.
    #[inline(always)]
    pub(crate) fn columns_from(&self) -> &[u32; 256] {
        &self.columns_from
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pattern_fits() {
        for (pattern, rows, columns) in [
            (SamplePattern::CENTER, 1, 1),
            (SamplePattern::grid(4).unwrap(), 2, 2),
            (SamplePattern::grid(9).unwrap(), 3, 3),
            (SamplePattern::grid(16).unwrap(), 4, 4),
            (SamplePattern::standard(2).unwrap(), 2, 1),
            (SamplePattern::standard(4).unwrap(), 4, 1),
            (SamplePattern::standard(8).unwrap(), 8, 1),
            (SamplePattern::standard(16).unwrap(), 16, 1),
        ] {
            let samples = SampleRows::new(pattern);
            assert_eq!((samples.rows(), samples.columns()), (rows, columns), "{pattern}");
            assert_eq!(samples.full_mask().count_ones() as usize, pattern.count());
            assert!(samples.columns_from().iter().all(|from| from >> 24 == 1), "{pattern}");
        }
    }

    #[test]
    fn rows_are_counted_from_the_top() {
        let samples = SampleRows::new(SamplePattern::grid(16).unwrap());
        let first: Vec<i32> = [-225, -224, 0, 32, 33, 224, 225, 256].map(|y| samples.first_row(y)).to_vec();
        assert_eq!(first, [-4, -4, 0, 0, 1, 3, 4, 4]);
    }
}
