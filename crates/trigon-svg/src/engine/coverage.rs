//! From edges to coverage: which samples have a winding number that is inside.
//!
//! Where an edge crosses a sample row, the winding number changes for all samples at or right of the crossing. The change
//! is added, for the samples of the pixel that is crossed, to a word with one byte per sample of the row; a sweep from
//! left to right sums the words. The last sample of a row has seen every change so far, so its byte is what the next
//! pixel begins with. Only pixels that are crossed are visited.
//!
//! Bytes of a word are summed as one integer: a negative byte borrows from the next one, and a bias of 128 in each byte
//! undoes that, as long as winding numbers lie in -128..=127. Where more than 127 edges meet one sample row, words with
//! 32 bits per sample are used instead.

use super::edge::Edge;
use super::runs::{Run, RunRows};
use super::samples::SampleRows;
use crate::canvas::FillRule;
use trigon::lanes::Lanes;

/// Pixel rows of a band.
pub(crate) const BAND_ROWS: u32 = 16;

/// A rectangle of pixels: columns and rows, each `start..end`.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Bounds {
    pub(crate) columns: [u32; 2],
    pub(crate) rows: [u32; 2],
}

impl Bounds {
    /// True if it holds no pixel.
    pub(crate) fn is_empty(&self) -> bool {
        self.columns[0] >= self.columns[1] || self.rows[0] >= self.rows[1]
    }

    /// The pixels of both.
    pub(crate) fn intersect(&self, other: &Self) -> Self {
        let common = |a: [u32; 2], b: [u32; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        Self { columns: common(self.columns, other.columns), rows: common(self.rows, other.rows) }
    }

    /// The smallest rectangle around both.
    pub(crate) fn unite(&self, other: &Self) -> Self {
        if self.is_empty() {
            return *other;
        }
        if other.is_empty() {
            return *self;
        }
        let around = |a: [u32; 2], b: [u32; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        Self { columns: around(self.columns, other.columns), rows: around(self.rows, other.rows) }
    }
}

/// Turns the edges of one shape in one band into runs. Reused from shape to shape.
pub(crate) struct Scanner<'a> {
    samples: &'a SampleRows,
    width: u32,
    narrow: Cells<u32>,
    wide: Cells<u128>,
}

impl<'a> Scanner<'a> {
    /// A scanner for pictures up to `width` pixels.
    pub(crate) fn new(samples: &'a SampleRows, width: u32) -> Self {
        Self { samples, width, narrow: Cells::default(), wide: Cells::default() }
    }

    /// The width that it was made for.
    pub(crate) fn width(&self) -> usize {
        self.width as usize
    }

    /// The coverage of the shape with these edges, inside `bounds`: at most [`BAND_ROWS`] rows. Never inlined: it is large.
    #[inline(never)]
    pub(crate) fn scan<L: Lanes>(&mut self, l: L, edges: &[Edge], rule: FillRule, bounds: &Bounds, out: &mut RunRows) {
        out.restart(bounds.rows[0]);
        if bounds.is_empty() {
            return;
        }
        if edges.len() <= 127 || self.most_edges_met(edges, bounds) <= 127 {
            if self.samples.rows() == 4 {
                // The usual patterns are worth a kernel for each level.
                l.vectorize(
                    #[inline(always)]
                    || self.narrow.scan_rows::<4>(self.samples, edges, rule, bounds, out),
                );
            } else {
                self.narrow.scan(self.samples, edges, rule, bounds, out);
            }
        } else {
            self.wide.scan(self.samples, edges, rule, bounds, out);
        }
    }

    /// The largest number of edges that any sample row of `bounds` meets.
    fn most_edges_met(&self, edges: &[Edge], bounds: &Bounds) -> i32 {
        let rows = self.samples.rows() as i32;
        let (first, end) = (bounds.rows[0] as i32 * rows, bounds.rows[1] as i32 * rows);
        let mut changes = [0; BAND_ROWS as usize * super::samples::MAX_SAMPLE_ROWS + 1];
        for edge in edges {
            let rows = edge.rows();
            let (from, to) = (rows[0].max(first), rows[1].min(end));
            if from < to {
                changes[(from - first) as usize] += 1;
                changes[(to - first) as usize] -= 1;
            }
        }
        let (mut met, mut most) = (0, 0);
        for change in changes {
            met += change;
            most = most.max(met);
        }
        most
    }
}

/// The changes of the winding numbers of four samples side by side, summed as one integer.
trait Word: Copy + Default {
    /// The sum, with carries from sample to sample.
    fn add(self, other: Self) -> Self;
    /// `direction` (1 or -1) for each sample whose byte of `columns` is 1.
    fn change(columns: u32, direction: i32) -> Self;
    /// The bias alone: all winding numbers zero.
    const ZERO: Self;
    /// The last sample's number for all four.
    fn spread_last(self) -> Self;
    /// Four bits per word, one per sample whose number is inside; the first word's are the lowest.
    fn inside<const R: usize>(words: &[Self; R], rule: FillRule) -> u64;
}

impl Word for u32 {
    const ZERO: Self = 0x8080_8080;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn change(columns: u32, direction: i32) -> Self {
        columns.wrapping_mul(direction as u32)
    }

    #[inline(always)]
    fn spread_last(self) -> Self {
        (self >> 24) * 0x0101_0101
    }

    /// Two words at a time.
    #[inline(always)]
    fn inside<const R: usize>(words: &[Self; R], rule: FillRule) -> u64 {
        const LOW: u64 = 0x0101_0101_0101_0101;
        const SEVEN: u64 = 0x7F7F_7F7F_7F7F_7F7F;
        let mut mask = 0;
        for pair in 0..R.div_ceil(2) {
            let second = if 2 * pair + 1 < R { words[2 * pair + 1] } else { Self::ZERO };
            let winding = (u64::from(words[2 * pair]) | u64::from(second) << 32) ^ (LOW << 7);
            let inside = match rule {
                FillRule::NonZero => (((winding & SEVEN) + SEVEN) | winding) >> 7,
                FillRule::EvenOdd => winding,
            };
            // The lowest bits of the eight bytes, side by side.
            mask |= ((inside & LOW).wrapping_mul(0x0102_0408_1020_4080) >> 56) << (8 * pair);
        }
        mask
    }
}

impl Word for u128 {
    const ZERO: Self = 0x8000_0000_8000_0000_8000_0000_8000_0000;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.wrapping_add(other)
    }

    #[inline(always)]
    fn change(columns: u32, direction: i32) -> Self {
        let mut change = 0;
        for sample in 0..4 {
            change |= u128::from(columns >> (8 * sample) & 1) << (32 * sample);
        }
        if direction < 0 { change.wrapping_neg() } else { change }
    }

    #[inline(always)]
    fn spread_last(self) -> Self {
        (self >> 96) * 0x1_0000_0001_0000_0001_0000_0001
    }

    #[inline(always)]
    fn inside<const R: usize>(words: &[Self; R], rule: FillRule) -> u64 {
        let mut mask = 0;
        for (row, word) in words.iter().enumerate() {
            for sample in 0..4 {
                let winding = (word >> (32 * sample)) as u32 ^ 0x8000_0000;
                let inside = if rule == FillRule::NonZero { winding != 0 } else { winding & 1 == 1 };
                mask |= u64::from(inside) << (4 * row + sample);
            }
        }
        mask
    }
}

/// The words of the shape at hand; all zero between scans. Small shapes use the same few of them again and again.
#[derive(Default)]
struct Cells<W> {
    /// `[row][column][sample row]`, columns from the shape's first on.
    words: Vec<W>,
    /// One bit per column that is crossed: `[row][column / 64]`.
    crossed: Vec<u64>,
}

impl<W: Word> Cells<W> {
    fn scan(&mut self, samples: &SampleRows, edges: &[Edge], rule: FillRule, bounds: &Bounds, out: &mut RunRows) {
        match samples.rows() {
            1 => self.scan_rows::<1>(samples, edges, rule, bounds, out),
            2 => self.scan_rows::<2>(samples, edges, rule, bounds, out),
            3 => self.scan_rows::<3>(samples, edges, rule, bounds, out),
            4 => self.scan_rows::<4>(samples, edges, rule, bounds, out),
            8 => self.scan_rows::<8>(samples, edges, rule, bounds, out),
            _ => self.scan_rows::<16>(samples, edges, rule, bounds, out),
        }
    }

    #[inline(always)]
    fn scan_rows<const R: usize>(
        &mut self,
        samples: &SampleRows,
        edges: &[Edge],
        rule: FillRule,
        bounds: &Bounds,
        out: &mut RunRows,
    ) {
        // One more column than the bounds have, for what is crossed right of them.
        let columns = (bounds.columns[1] - bounds.columns[0]) as usize + 1;
        let rows = (bounds.rows[1] - bounds.rows[0]) as usize;
        let (words, crossed) = (rows * columns * R, rows * columns.div_ceil(64));
        if self.words.len() < words {
            self.words.resize(words, W::default());
        }
        if self.crossed.len() < crossed {
            self.crossed.resize(crossed, 0);
        }
        let (cells, _) = self.words.as_chunks_mut::<R>();
        let mut band = BandCells {
            samples,
            cells: &mut cells[..rows * columns],
            crossed: &mut self.crossed[..crossed],
            columns,
            bounds,
            masks: MaskShape::new(samples),
        };
        band.scatter(edges);
        for row in 0..rows {
            band.sweep(rule, row, out);
            out.end_row();
        }
    }
}

/// The words of a shape, by pixel.
struct BandCells<'a, W, const R: usize> {
    samples: &'a SampleRows,
    cells: &'a mut [[W; R]],
    crossed: &'a mut [u64],
    /// In each row of `cells`.
    columns: usize,
    bounds: &'a Bounds,
    masks: MaskShape,
}

impl<W: Word, const R: usize> BandCells<'_, W, R> {
    /// Adds each crossing's change to its pixel. What is crossed left of the bounds counts for their first column; right
    /// of them, for a column that is never drawn.
    #[inline(always)]
    fn scatter(&mut self, edges: &[Edge]) {
        let (offsets, mut shifts) = (self.samples.offsets_y::<R>(), self.samples.shifts_x::<R>());
        let left = (self.bounds.columns[0] as i32) << 8;
        for shift in &mut shifts {
            *shift -= left;
        }
        let columns_from = self.samples.columns_from();
        let (columns, crossed_words) = (self.columns, self.columns.div_ceil(64));
        let limit = ((columns - 1) as i32) << 8;
        let top = self.bounds.rows[0] as i32;
        let (first, end) = (top * R as i32, self.bounds.rows[1] as i32 * R as i32);
        for edge in edges {
            let (rows, direction) = (edge.rows(), edge.direction());
            let (mut next, end) = (rows[0].max(first), rows[1].min(end));
            while next < end {
                let (row, r) = ((next as u32 / R as u32) as i32, (next as u32 % R as u32) as usize);
                let index = (row - top) as usize;
                let cells = &mut self.cells[index * columns..(index + 1) * columns];
                let crossed = &mut self.crossed[index * crossed_words..(index + 1) * crossed_words];
                let stop = R.min(r + (end - next) as usize);
                // All four rows of a pixel side by side; those that the edge does not meet are not looked at.
                let computed = if R <= 4 { 0..R } else { r..stop };
                let mut xs = [0; R];
                for r in computed {
                    xs[r] = edge.crossing((row << 8) + offsets[r]).wrapping_add(shifts[r]).max(0).min(limit);
                }
                // Rows of a pixel are mostly crossed within the same 64 columns: one bit set is written, not four.
                let (mut index, mut bits) = ((xs[r] >> 14) as usize, 0);
                for r in r..stop {
                    let column = (xs[r] >> 8) as usize;
                    let word = &mut cells[column][r];
                    *word = word.add(W::change(columns_from[(xs[r] & 255) as usize], direction));
                    if column / 64 != index {
                        crossed[index] |= core::mem::take(&mut bits);
                        index = column / 64;
                    }
                    bits |= 1 << (column % 64);
                }
                crossed[index] |= bits;
                next += (stop - r) as i32;
            }
        }
    }

    /// Sums the changes of one pixel row from left to right, and leaves zeros behind.
    #[inline(always)]
    fn sweep(&mut self, rule: FillRule, row: usize, out: &mut RunRows) {
        let crossed_words = self.columns.div_ceil(64);
        let crossed = &mut self.crossed[row * crossed_words..(row + 1) * crossed_words];
        let cells = &mut self.cells[row * self.columns..(row + 1) * self.columns];
        let masks = self.masks;
        let left = self.bounds.columns[0] as usize;
        let last = self.columns - 1;
        let mut pen = Pen { x: left, mask: 0 };
        let mut winding = [W::ZERO; R];
        for (index, bits) in crossed.iter_mut().enumerate() {
            let mut bits = core::mem::take(bits);
            while bits != 0 {
                let column = index * 64 + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let Some(cell) = cells.get_mut(column) else { break };
                let changes = core::mem::replace(cell, [W::default(); R]);
                if column == last {
                    break;
                }
                pen.fill_up_to(left + column, out);
                for r in 0..R {
                    winding[r] = winding[r].add(changes[r]);
                }
                let mask = masks.of_samples(W::inside(&winding, rule));
                pen.one_pixel(mask, out);
                pen.mask = masks.spread_last(mask);
                for word in &mut winding {
                    *word = word.spread_last();
                }
            }
        }
        pen.fill_up_to(left + last, out);
    }
}

/// How the samples of a pixel lie in its mask.
#[derive(Clone, Copy)]
struct MaskShape {
    rows: u32,
    columns: u32,
    /// The first sample of each row.
    firsts: u32,
}

impl MaskShape {
    #[inline(always)]
    fn new(samples: &SampleRows) -> Self {
        let (rows, columns) = (samples.rows() as u32, samples.columns() as u32);
        let mut firsts = 0;
        for row in 0..rows {
            firsts |= 1 << (row * columns);
        }
        Self { rows, columns, firsts }
    }

    /// From four bits per row to one bit per sample.
    #[inline(always)]
    fn of_samples(self, four_per_row: u64) -> u16 {
        if self.columns == 4 {
            return four_per_row as u16;
        }
        let mut mask = 0;
        for row in 0..self.rows {
            mask |= (four_per_row >> (4 * row) & ((1 << self.columns) - 1)) << (row * self.columns);
        }
        mask as u16
    }

    /// The last sample's bit of each row, for all of the row.
    #[inline(always)]
    fn spread_last(self, mask: u16) -> u16 {
        let last = u32::from(mask) >> (self.columns - 1) & self.firsts;
        (last * ((1 << self.columns) - 1)) as u16
    }
}

/// The column up to which a row is done, and what holds from there on.
struct Pen {
    x: usize,
    mask: u16,
}

impl Pen {
    /// Writes what holds, up to column `x`.
    #[inline(always)]
    fn fill_up_to(&mut self, x: usize, out: &mut RunRows) {
        if self.mask != 0 && x > self.x {
            out.push(Run { x: self.x as u16, len: (x - self.x) as u16, mask: self.mask });
        }
        self.x = x;
    }

    /// Writes the pixel at the pen.
    #[inline(always)]
    fn one_pixel(&mut self, mask: u16, out: &mut RunRows) {
        if mask != 0 {
            out.push(Run { x: self.x as u16, len: 1, mask });
        }
        self.x += 1;
    }
}
