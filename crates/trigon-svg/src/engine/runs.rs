//! Coverage as runs: which samples of which pixels of a few rows are inside, and the union and intersection of two such.
//!
//! A row is a list of [`Run`]s from left to right: pixels side by side of which the same samples are covered. Pixels that
//! no run names are not covered.

/// `len` pixels from column `x` on, of each of which the samples in `mask` are covered; never none, never zero samples.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Run {
    pub(crate) x: u16,
    pub(crate) len: u16,
    pub(crate) mask: u16,
}

impl Run {
    /// The column after the last one.
    #[inline(always)]
    pub(crate) fn end(self) -> u16 {
        self.x + self.len
    }
}

/// The coverage of consecutive pixel rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct RunRows {
    runs: Vec<Run>,
    /// Where each row's runs end; the first row begins at 0.
    ends: Vec<u32>,
    /// The first pixel row.
    first_row: u32,
}

impl RunRows {
    /// Forgets all rows; the next one will be `first_row`.
    pub(crate) fn restart(&mut self, first_row: u32) {
        self.runs.clear();
        self.ends.clear();
        self.first_row = first_row;
    }

    /// Adds a run to the row that is open. It lies right of the one before.
    #[inline(always)]
    pub(crate) fn push(&mut self, run: Run) {
        self.runs.push(run);
    }

    /// Ends the row that is open.
    #[inline(always)]
    pub(crate) fn end_row(&mut self) {
        self.ends.push(self.runs.len() as u32);
    }

    /// The pixel rows: `start..end`.
    pub(crate) fn rows(&self) -> core::ops::Range<u32> {
        self.first_row..self.first_row + self.ends.len() as u32
    }

    /// The runs of a pixel row; none outside of [`rows`](Self::rows).
    #[inline(always)]
    pub(crate) fn row(&self, row: u32) -> &[Run] {
        let Some(index) = row.checked_sub(self.first_row).map(|index| index as usize) else { return &[] };
        let Some(end) = self.ends.get(index) else { return &[] };
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        &self.runs[start as usize..*end as usize]
    }

    /// Makes every pixel that is covered at all covered whole.
    pub(crate) fn cover_whole(&mut self, full_mask: u16) {
        for run in &mut self.runs {
            run.mask = full_mask;
        }
    }

    /// True if nothing is covered.
    pub(crate) fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// What both cover, into `out`.
    pub(crate) fn intersect(&self, other: &Self, out: &mut Self) {
        let rows = self.rows().start.max(other.rows().start)..self.rows().end.min(other.rows().end);
        out.restart(rows.start);
        for row in rows {
            intersect_row(self.row(row), other.row(row), out);
            out.end_row();
        }
    }

    /// What either covers, into `out`.
    pub(crate) fn unite(&self, other: &Self, out: &mut Self) {
        if self.is_empty() || other.is_empty() {
            out.clone_from(if self.is_empty() { other } else { self });
            return;
        }
        let rows = self.rows().start.min(other.rows().start)..self.rows().end.max(other.rows().end);
        out.restart(rows.start);
        for row in rows {
            unite_row(self.row(row), other.row(row), out);
            out.end_row();
        }
    }
}

fn intersect_row(a: &[Run], b: &[Run], out: &mut RunRows) {
    let (mut i, mut j) = (0, 0);
    while let (Some(p), Some(q)) = (a.get(i), b.get(j)) {
        let (start, end) = (p.x.max(q.x), p.end().min(q.end()));
        if start < end && p.mask & q.mask != 0 {
            out.push(Run { x: start, len: end - start, mask: p.mask & q.mask });
        }
        // The one that ends first has met all it can.
        if p.end() <= q.end() {
            i += 1;
        } else {
            j += 1;
        }
    }
}

fn unite_row(a: &[Run], b: &[Run], out: &mut RunRows) {
    let (mut i, mut j, mut x) = (0, 0, 0);
    loop {
        // What each side covers at x, and how far that goes.
        let (mask_a, until_a) = at(a.get(i), x);
        let (mask_b, until_b) = at(b.get(j), x);
        let until = until_a.min(until_b);
        if mask_a | mask_b != 0 {
            out.push(Run { x, len: until - x, mask: mask_a | mask_b });
        } else if until == u16::MAX {
            return;
        }
        x = until;
        i += usize::from(a.get(i).is_some_and(|run| run.end() <= x));
        j += usize::from(b.get(j).is_some_and(|run| run.end() <= x));
    }
}

/// The mask at column `x`, where `run` is the first that ends after it, and the column up to which it holds.
#[inline(always)]
fn at(run: Option<&Run>, x: u16) -> (u16, u16) {
    match run {
        None => (0, u16::MAX),
        Some(run) if x < run.x => (0, run.x),
        Some(run) => (run.mask, run.end()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rows of runs from masks, one per pixel.
    fn from_masks(first_row: u32, rows: &[Vec<u16>]) -> RunRows {
        let mut out = RunRows::default();
        out.restart(first_row);
        for row in rows {
            for chunk in row.iter().enumerate().collect::<Vec<_>>().chunk_by(|a, b| a.1 == b.1) {
                if *chunk[0].1 != 0 {
                    out.push(Run { x: chunk[0].0 as u16, len: chunk.len() as u16, mask: *chunk[0].1 });
                }
            }
            out.end_row();
        }
        out
    }

    fn mask_at(runs: &RunRows, row: u32, x: u16) -> u16 {
        runs.row(row).iter().find(|run| run.x <= x && x < run.end()).map_or(0, |run| run.mask)
    }

    #[test]
    fn union_and_intersection_are_those_of_the_samples() {
        let mut random = 7u32;
        for _ in 0..500 {
            let mut rows = || -> Vec<Vec<u16>> {
                (0..3)
                    .map(|_| {
                        (0..12)
                            .map(|_| {
                                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                                [0, 0, 3, 0xFFFF, 0xF0][(random >> 24) as usize % 5]
                            })
                            .collect()
                    })
                    .collect()
            };
            let (a, b) = (from_masks(5, &rows()), from_masks(6, &rows()));
            let (mut both, mut either) = (RunRows::default(), RunRows::default());
            a.intersect(&b, &mut both);
            a.unite(&b, &mut either);
            for row in 4..10 {
                for x in 0..13 {
                    let (p, q) = (mask_at(&a, row, x), mask_at(&b, row, x));
                    assert_eq!(mask_at(&both, row, x), p & q);
                    assert_eq!(mask_at(&either, row, x), p | q);
                }
            }
        }
    }
}
