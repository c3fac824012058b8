//! A picture, or a layer, in one band: one colour per pixel, and one per sample where an edge made them differ.
//!
//! A pixel begins as one colour. The first shape that covers only some of its samples expands it to a [`Line`] of sixteen
//! (64 bytes, a cache line); an opaque colour over all of it makes it one colour again. Lines of pixels side by side lie
//! side by side in memory, which is read ahead. Colours are premultiplied and packed, red in the lowest byte.

use super::coverage::Bounds;
use super::over::Pixels16;
use trigon::lanes::{LANES, Lanes};

/// The samples of one pixel. Those past the pattern's count are never covered; they hold no meaning.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Line(pub(crate) Pixels16);

/// Pixels side by side that get their lines together.
const GROUP: usize = 8;

/// Of a group without lines.
const NO_LINES: u32 = u32::MAX;

/// The pixels of a rectangle.
#[derive(Default)]
pub(crate) struct Surface {
    bounds: Bounds,
    width: usize,
    /// The colour of each pixel that is not expanded.
    words: Vec<u32>,
    /// One bit per pixel: `[row][column / 64]`.
    expanded: Vec<u64>,
    /// The first line of each group, or [`NO_LINES`]: `[row][column / GROUP]`.
    groups: Vec<u32>,
    /// Those past `used_lines` are memory.
    lines: Vec<Line>,
    used_lines: usize,
    /// Columns of each row that something was drawn on, relative to the bounds.
    drawn: Vec<[u32; 2]>,
}

/// One row of a surface.
pub(crate) struct Row<'a> {
    /// The column of the first pixel.
    pub(crate) left: u32,
    pub(crate) words: &'a mut [u32],
    pub(crate) expanded: &'a mut [u64],
    groups: &'a mut [u32],
    lines: &'a mut Vec<Line>,
    used_lines: &'a mut usize,
    drawn: &'a mut [u32; 2],
}

/// What a pixel holds.
#[derive(Clone, Copy)]
pub(crate) enum Pixel<'a> {
    /// One colour.
    Whole(u32),
    /// A colour per sample.
    Samples(&'a Line),
}

impl Surface {
    /// Makes it hold the pixels of `bounds`, all of one colour.
    pub(crate) fn restart(&mut self, bounds: Bounds, color: u32) {
        self.bounds = bounds;
        let [left, right] = bounds.columns;
        let rows = bounds.rows[1].saturating_sub(bounds.rows[0]) as usize;
        self.width = right.saturating_sub(left) as usize;
        self.words.clear();
        self.words.resize(self.width * rows, color);
        self.expanded.clear();
        self.expanded.resize(self.width.div_ceil(64) * rows, 0);
        self.groups.clear();
        self.groups.resize(self.width.div_ceil(GROUP) * rows, NO_LINES);
        self.used_lines = 0;
        self.drawn.clear();
        self.drawn.resize(rows, [u32::MAX, 0]);
    }

    /// Makes it hold these pixels, row by row: as many as `bounds` has.
    pub(crate) fn restart_with(&mut self, bounds: Bounds, pixels: &[[u8; 4]]) {
        self.restart(bounds, 0);
        for (word, pixel) in self.words.iter_mut().zip(pixels) {
            *word = u32::from_le_bytes(*pixel);
        }
    }

    /// The pixels that it holds.
    pub(crate) fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Row `y` of the picture; it must be one of the bounds.
    #[inline(always)]
    pub(crate) fn row_mut(&mut self, y: u32) -> Row<'_> {
        let row = (y - self.bounds.rows[0]) as usize;
        let (words_64, groups) = (self.width.div_ceil(64), self.width.div_ceil(GROUP));
        Row {
            left: self.bounds.columns[0],
            words: &mut self.words[row * self.width..(row + 1) * self.width],
            expanded: &mut self.expanded[row * words_64..(row + 1) * words_64],
            groups: &mut self.groups[row * groups..(row + 1) * groups],
            lines: &mut self.lines,
            used_lines: &mut self.used_lines,
            drawn: &mut self.drawn[row],
        }
    }

    /// The columns of row `y`, relative to the bounds, that something was drawn on: `start..end`.
    pub(crate) fn drawn(&self, y: u32) -> core::ops::Range<usize> {
        let [start, end] = self.drawn[(y - self.bounds.rows[0]) as usize];
        if start < end { start as usize..end as usize } else { 0..0 }
    }

    /// The pixels of row `y` from column `x` on, relative to the bounds, that hold one colour each: where they end, and
    /// those colours.
    #[inline(always)]
    pub(crate) fn whole_pixels(&self, x: usize, y: u32) -> (usize, &[u32]) {
        let row = (y - self.bounds.rows[0]) as usize;
        let words_64 = self.width.div_ceil(64);
        let expanded = &self.expanded[row * words_64..(row + 1) * words_64];
        let mut end = x;
        while end < self.width {
            let rest = expanded[end / 64] >> (end % 64);
            if rest != 0 {
                end += rest.trailing_zeros() as usize;
                break;
            }
            end = (end / 64 + 1) * 64;
        }
        let end = end.min(self.width);
        (end, &self.words[row * self.width + x..row * self.width + end])
    }

    /// Replaces every colour, of pixels and of samples.
    pub(crate) fn map(&mut self, change: impl Fn(u32) -> u32) {
        let (words_64, groups) = (self.width.div_ceil(64), self.width.div_ceil(GROUP));
        for (index, word) in self.words.iter_mut().enumerate() {
            let (row, x) = (index / self.width, index % self.width);
            if self.expanded[row * words_64 + x / 64] >> (x % 64) & 1 == 0 {
                *word = change(*word);
            } else {
                let line = self.groups[row * groups + x / GROUP] as usize + x % GROUP;
                for sample in &mut self.lines[line].0 {
                    *sample = change(*sample);
                }
            }
        }
    }

    /// The pixel at column `x`, relative to the bounds, of row `y`.
    #[inline(always)]
    pub(crate) fn pixel(&self, x: usize, y: u32) -> Pixel<'_> {
        let row = (y - self.bounds.rows[0]) as usize;
        let is_expanded = self.expanded[row * self.width.div_ceil(64) + x / 64] >> (x % 64) & 1 == 1;
        if is_expanded {
            let first = self.groups[row * self.width.div_ceil(GROUP) + x / GROUP] as usize;
            Pixel::Samples(&self.lines[first + x % GROUP])
        } else {
            Pixel::Whole(self.words[row * self.width + x])
        }
    }
}

impl Row<'_> {
    /// Notes that pixels `start..end` were drawn on.
    #[inline(always)]
    pub(crate) fn mark_drawn(&mut self, start: usize, end: usize) {
        *self.drawn = [self.drawn[0].min(start as u32), self.drawn[1].max(end as u32)];
    }

    /// True if the pixel at `x` has a line.
    #[inline(always)]
    pub(crate) fn is_expanded(&self, x: usize) -> bool {
        self.expanded[x / 64] >> (x % 64) & 1 == 1
    }

    /// The line of the pixel at `x`, which is expanded if it was not.
    #[inline(always)]
    pub(crate) fn expand<L: Lanes>(&mut self, l: L, x: usize) -> &mut Line {
        let (index, bit) = (x / 64, 1 << (x % 64));
        if self.expanded[index] & bit != 0 {
            return &mut self.lines[self.groups[x / GROUP] as usize + x % GROUP];
        }
        self.expanded[index] |= bit;
        let group = &mut self.groups[x / GROUP];
        if *group == NO_LINES {
            *group = *self.used_lines as u32;
            *self.used_lines += GROUP;
            if self.lines.len() < *self.used_lines {
                self.lines.resize(*self.used_lines, Line([0; LANES]));
            }
        }
        let line = &mut self.lines[*group as usize + x % GROUP];
        line.0 = l.u32(self.words[x]).to_array();
        line
    }

    /// Makes pixels `start..end` hold one colour each; the caller then sets it.
    #[inline(always)]
    pub(crate) fn collapse(&mut self, start: usize, end: usize) {
        let mut next = start;
        while next < end {
            let index = next / 64;
            let stop = end.min((index + 1) * 64);
            self.expanded[index] &= !bits(next, stop);
            next = stop;
        }
    }

    /// The first pixels from `start` on, before `end`, that are all expanded or all not: where they end, and which.
    #[inline(always)]
    pub(crate) fn same_kind(&self, start: usize, end: usize) -> (usize, bool) {
        let is_expanded = self.is_expanded(start);
        let mut next = start;
        while next < end {
            let index = next / 64;
            let stop = end.min((index + 1) * 64);
            let word = self.expanded[index];
            let others = if is_expanded { !word } else { word } & bits(next, stop);
            if others != 0 {
                return (index * 64 + others.trailing_zeros() as usize, is_expanded);
            }
            next = stop;
        }
        (end, is_expanded)
    }
}

/// Ones for columns `start..end` of one word, within which both lie (`end` may be its end).
#[inline(always)]
fn bits(start: usize, end: usize) -> u64 {
    (u64::MAX << (start % 64)) & (u64::MAX >> (63 - (end - 1) % 64))
}

/// The mean of the first `count` samples, each channel rounded to nearest, halves up.
#[inline(always)]
pub(crate) fn mean(line: &Line, count: u32) -> u32 {
    const PAIR: u32 = 0x00FF_00FF;
    let (mut low, mut high) = (0, 0);
    if count as usize == LANES {
        for sample in &line.0 {
            low += sample & PAIR;
            high += sample >> 8 & PAIR;
        }
        return (low + 0x0008_0008) >> 4 & PAIR | ((high + 0x0008_0008) >> 4 & PAIR) << 8;
    }
    for sample in &line.0[..count as usize] {
        low += sample & PAIR;
        high += sample >> 8 & PAIR;
    }
    let divide = |sum: u32| (sum + count / 2) / count;
    let pair = |sums: u32| divide(sums & 0xFFFF) | divide(sums >> 16) << 16;
    pair(low) | pair(high) << 8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_rounded_to_nearest() {
        let mut line = Line([0; 16]);
        for count in [2, 4, 8, 9, 16] {
            for ones in 0..=count {
                line.0 = [0; 16];
                line.0[..ones as usize].fill(0xFF01_80FF);
                let channel = |value: u32| (2 * ones * value + count) / (2 * count);
                let expected = channel(255) | channel(0x80) << 8 | channel(1) << 16 | channel(255) << 24;
                assert_eq!(mean(&line, count), expected, "{ones} of {count}");
            }
        }
    }
}
