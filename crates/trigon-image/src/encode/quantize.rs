//! A palette for any colors: exact if they are few, else by Wu's quantizer.
//!
//! Colors are counted in a grid of 32 x 32 x 32 cells of RGB with their moments (number, sums, sum of squares), summed up
//! along each axis, so that the moments of any box of cells are eight look-ups. Starting from one box, the box with
//! the largest squared error is split where the error falls most, until there are enough boxes; each gives its mean.
//!
//! Source: Xiaolin Wu, "Efficient Statistical Computations for Optimal Color Quantization", Graphics Gems II (1991).

use std::collections::HashSet;
use std::ops::{Add, Range, Sub};

/// Cells along an axis, and one more of zeros before them.
const SIDE: usize = 33;

/// The colors of one or more pictures, counted.
pub(super) struct ColorCounts {
    cells: Vec<Moments>,
    /// All different colors, while there are at most 256.
    few: Option<HashSet<[u8; 3]>>,
}

impl ColorCounts {
    pub(super) fn new() -> Self {
        Self { cells: vec![Moments::default(); SIDE * SIDE * SIDE], few: Some(HashSet::new()) }
    }

    /// Counts colors.
    pub(super) fn add(&mut self, colors: impl Iterator<Item = [u8; 3]>) {
        let mut last = None;
        for color in colors {
            let [r, g, b] = color.map(|code| usize::from(code >> 3) + 1);
            let cell = &mut self.cells[cell_index(r, g, b)];
            *cell = *cell + Moments::of(color);
            // Neighbouring pixels are often equal: skip the set.
            if last != Some(color) {
                last = Some(color);
                self.add_to_few(color);
            }
        }
    }

    fn add_to_few(&mut self, color: [u8; 3]) {
        if let Some(few) = &mut self.few {
            few.insert(color);
            if few.len() > 256 {
                self.few = None;
            }
        }
    }

    /// At most `size` colors in a fixed order; all colors counted, exactly, if they are not more.
    pub(super) fn palette(self, size: usize) -> Vec<[u8; 3]> {
        if let Some(few) = self.few.filter(|few| few.len() <= size) {
            let mut colors: Vec<_> = few.into_iter().collect();
            colors.sort_unstable();
            return colors;
        }
        let cumulative = Cumulative::sum_up(self.cells);
        split_boxes(&cumulative, size).iter().filter_map(|colors| cumulative.of_box(colors).mean()).collect()
    }
}

fn cell_index(r: usize, g: usize, b: usize) -> usize {
    (r * SIDE + g) * SIDE + b
}

/// Number of colors, sum of each channel, and sum of the squares of all channels.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Moments {
    count: i64,
    sums: [i64; 3],
    squares: i64,
}

impl Moments {
    fn of(color: [u8; 3]) -> Self {
        let sums = color.map(i64::from);
        Self { count: 1, sums, squares: sums.iter().map(|v| v * v).sum() }
    }

    /// The squared length of the sums over the count: what a split tries to make large.
    fn spread(&self) -> f64 {
        if self.count == 0 {
            return 0.0;
        }
        // Sums of up to 2^53 are exact; beyond, an error in the last bits moves a cut by nothing one could see.
        let [r, g, b] = self.sums.map(|sum| sum as f64);
        (r * r + g * g + b * b) / self.count as f64
    }

    /// The sum of the squared distances to the mean.
    fn error(&self) -> f64 {
        self.squares as f64 - self.spread()
    }

    fn mean(&self) -> Option<[u8; 3]> {
        (self.count > 0)
            .then(|| self.sums.map(|sum| u8::try_from((sum + self.count / 2) / self.count).unwrap_or(u8::MAX)))
    }
}

impl Add for Moments {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sums = [0, 1, 2].map(|i| self.sums[i] + other.sums[i]);
        Self { count: self.count + other.count, sums, squares: self.squares + other.squares }
    }
}

impl Sub for Moments {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let sums = [0, 1, 2].map(|i| self.sums[i] - other.sums[i]);
        Self { count: self.count - other.count, sums, squares: self.squares - other.squares }
    }
}

/// A box of cells: along each axis from the first number, exclusive, to the last, inclusive.
#[derive(Debug, Clone)]
struct ColorBox([Range<usize>; 3]);

impl ColorBox {
    fn can_split(&self, axis: usize) -> bool {
        self.0[axis].len() > 1
    }

    fn split(&self, axis: usize, at: usize) -> (Self, Self) {
        let (mut low, mut high) = (self.clone(), self.clone());
        low.0[axis].end = at;
        high.0[axis].start = at;
        (low, high)
    }
}

/// Moments of all cells up to and including each cell.
struct Cumulative(Vec<Moments>);

impl Cumulative {
    fn sum_up(mut cells: Vec<Moments>) -> Self {
        for axis_step in [SIDE * SIDE, SIDE, 1] {
            for i in axis_step..cells.len() {
                // The zeros before the first cell of an axis stop a sum from running into the next line.
                if i / axis_step % SIDE != 0 {
                    cells[i] = cells[i] + cells[i - axis_step];
                }
            }
        }
        Self(cells)
    }

    fn of_box(&self, ColorBox([r, g, b]): &ColorBox) -> Moments {
        let at = |r, g, b| self.0[cell_index(r, g, b)];
        let up_to = |r| at(r, g.end, b.end) - at(r, g.start, b.end) - at(r, g.end, b.start) + at(r, g.start, b.start);
        up_to(r.end) - up_to(r.start)
    }

    /// The two halves of a box that lower its error most, if it can be split at all.
    fn best_split(&self, whole: &ColorBox) -> Option<(ColorBox, ColorBox)> {
        let total = self.of_box(whole);
        let mut best = None;
        let mut largest_spread = 0.0;
        for axis in (0..3).filter(|&axis| whole.can_split(axis)) {
            for at in whole.0[axis].start + 1..whole.0[axis].end {
                let (low, high) = whole.split(axis, at);
                let below = self.of_box(&low);
                let above = total - below;
                let spread = below.spread() + above.spread();
                if below.count > 0 && above.count > 0 && spread > largest_spread {
                    largest_spread = spread;
                    best = Some((low, high));
                }
            }
        }
        best
    }
}

fn split_boxes(cumulative: &Cumulative, size: usize) -> Vec<ColorBox> {
    let mut boxes = vec![ColorBox([0..SIDE - 1, 0..SIDE - 1, 0..SIDE - 1])];
    // The error left in each box; 0 once it cannot be split.
    let mut errors = vec![cumulative.of_box(&boxes[0]).error()];
    while boxes.len() < size {
        let Some((worst, _)) = errors.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1)).filter(|(_, e)| **e > 0.0)
        else {
            break;
        };
        match cumulative.best_split(&boxes[worst]) {
            Some((low, high)) => {
                errors[worst] = cumulative.of_box(&low).error();
                errors.push(cumulative.of_box(&high).error());
                boxes[worst] = low;
                boxes.push(high);
            }
            None => errors[worst] = 0.0,
        }
    }
    boxes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn palette(colors: &[[u8; 3]], size: usize) -> Vec<[u8; 3]> {
        let mut counts = ColorCounts::new();
        counts.add(colors.iter().copied());
        counts.palette(size)
    }

    /// A cloud of colors without structure.
    fn many_colors() -> Vec<[u8; 3]> {
        (0..5000_u32).map(|i| i.wrapping_mul(2_654_435_761).to_le_bytes()).map(|[_, r, g, b]| [r, g, b]).collect()
    }

    #[test]
    fn few_colors_are_kept_exactly() {
        let colors = [[1, 2, 3], [1, 2, 4], [250, 0, 7], [1, 2, 3]];
        assert_eq!(palette(&colors, 3), [[1, 2, 3], [1, 2, 4], [250, 0, 7]]);
        assert_eq!(palette(&[], 256), [[0; 3]; 0]);
    }

    #[test]
    fn many_colors_fill_the_palette() {
        for size in [1, 2, 16, 255, 256] {
            assert_eq!(palette(&many_colors(), size).len(), size);
        }
    }

    #[test]
    fn clusters_are_found() {
        // Around each of eight corners of a cube a hundred colors.
        let jitter = |i: usize, corner: usize| if corner == 0 { 30 + (i % 10) } else { 200 + (i % 10) };
        let colors: Vec<[u8; 3]> = (0..800)
            .map(|i| [i & 1, i >> 1 & 1, i >> 2 & 1].map(|corner| u8::try_from(jitter(i / 8, corner)).unwrap()))
            .collect();
        let found = palette(&colors, 8);
        assert_eq!(found.len(), 8);
        for color in found {
            assert!(color.iter().all(|v| (30..40).contains(v) || (200..210).contains(v)), "{color:?}");
        }
    }

    #[test]
    fn more_colors_lower_the_error() {
        let colors = many_colors();
        let error = |size| -> u32 {
            let palette = palette(&colors, size);
            let distance = |a: [u8; 3], b: [u8; 3]| (0..3).map(|i| u32::from(a[i].abs_diff(b[i])).pow(2)).sum::<u32>();
            colors.iter().map(|&color| palette.iter().map(|&p| distance(color, p)).min().unwrap()).sum()
        };
        let errors = [2, 8, 32, 128].map(error);
        assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
        // Evenly spread colors in a grid of 5 x 5 x 5 cells would be off by this much.
        let grid_error = 5000 * 3 * 51 * 51 / 12;
        assert!(errors[3] < grid_error * 5 / 4, "{errors:?}, {grid_error}");
    }
}
