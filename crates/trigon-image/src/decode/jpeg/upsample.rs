//! Planes of fewer samples than pixels: rows of samples in, rows with a value per pixel out.
//!
//! Halved planes are widened by a triangle filter, three parts of the nearer sample and one of the farther, whose
//! rounding alternates so that it does not shift the mean; others are repeated. As `jdsample.c` does it by default.

/// One component's samples, row by row, with room up to whole blocks behind those that count.
pub(super) struct Plane {
    /// Samples that count in a row.
    pub(super) width: usize,
    /// Rows that count.
    pub(super) height: usize,
    /// Samples from one row to the next.
    pub(super) stride: usize,
    pub(super) samples: Vec<u8>,
}

impl Plane {
    fn row(&self, y: usize) -> &[u8] {
        &self.samples[y.min(self.height - 1) * self.stride..][..self.width]
    }
}

/// How a plane becomes as large as the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Upsampling {
    /// Smoothly, twice as wide.
    Wide,
    /// Smoothly, twice as high.
    High,
    /// Smoothly, twice as wide and high.
    WideAndHigh,
    /// Each sample as often as said in x and y.
    Repeat(usize, usize),
}

impl Upsampling {
    /// For a plane `width` samples wide that the picture is `x` and `y` times as wide and high as.
    pub(super) fn new(width: usize, x: usize, y: usize) -> Self {
        match (x, y) {
            // The filter needs neighbours.
            (2, 1) if width > 2 => Self::Wide,
            (2, 2) if width > 2 => Self::WideAndHigh,
            (1, 2) => Self::High,
            _ => Self::Repeat(x, y),
        }
    }

    /// Row `y` of the picture, put into `row`, which may become a little longer than the picture is wide.
    pub(super) fn write_row(self, plane: &Plane, y: usize, row: &mut Vec<u8>) {
        row.clear();
        match self {
            Self::Repeat(1, rows) => row.extend_from_slice(plane.row(y / rows)),
            Self::Repeat(columns, rows) => {
                row.extend(plane.row(y / rows).iter().flat_map(|&sample| std::iter::repeat_n(sample, columns)));
            }
            Self::Wide => {
                let sums = plane.row(y).iter().map(|&sample| u16::from(sample));
                widen::<2>(sums.collect::<Vec<_>>().as_slice(), [1, 2], row);
            }
            Self::High => {
                let rounding = if y.is_multiple_of(2) { 1 } else { 2 };
                row.extend(column_sums(plane, y).map(|sum| narrow((sum + rounding) >> 2)));
            }
            Self::WideAndHigh => widen::<4>(column_sums(plane, y).collect::<Vec<_>>().as_slice(), [8, 7], row),
        }
    }
}

/// Three parts of the nearer row and one of the farther, which at the borders is the nearer once more.
fn column_sums(plane: &Plane, y: usize) -> impl Iterator<Item = u16> {
    let near = y / 2;
    let far = if y.is_multiple_of(2) { near.saturating_sub(1) } else { near + 1 };
    plane.row(near).iter().zip(plane.row(far)).map(|(&near, &far)| 3 * u16::from(near) + u16::from(far))
}

/// Twice as many values: three parts of each and one of its left or right neighbour, which at the borders is itself;
/// a quarter of that, or with `BITS` 4 a sixteenth. `rounding` is added on the left and on the right.
#[inline(always)]
fn widen<const BITS: u32>(values: &[u16], rounding: [u16; 2], row: &mut Vec<u8>) {
    let last = values.len() - 1;
    let mut push = |value: u16, left: u16, right: u16| {
        row.push(narrow((3 * value + left + rounding[0]) >> BITS));
        row.push(narrow((3 * value + right + rounding[1]) >> BITS));
    };
    push(values[0], values[0], values[1]);
    for window in values.windows(3) {
        push(window[1], window[0], window[2]);
    }
    push(values[last], values[last - 1], values[last]);
}

/// Means of samples are samples.
#[inline(always)]
fn narrow(value: u16) -> u8 {
    (value & 0xff) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(width: usize, samples: &[u8]) -> Plane {
        // A column of padding that must not be read.
        let padded = samples.chunks(width).flat_map(|row| row.iter().copied().chain([77])).collect();
        Plane { width, height: samples.len() / width, stride: width + 1, samples: padded }
    }

    fn row(plane: &Plane, x: usize, y: usize, at: usize) -> Vec<u8> {
        let mut row = Vec::new();
        Upsampling::new(plane.width, x, y).write_row(plane, at, &mut row);
        row
    }

    #[test]
    fn borders_keep_their_values_and_roundings_alternate() {
        let wide = plane(3, &[0, 10, 101]);
        assert_eq!(row(&wide, 2, 1, 0), [0, 3, 7, 33, 78, 101]);
        let high = plane(1, &[0, 10]);
        assert_eq!([0, 1, 2, 3].map(|y| row(&high, 1, 2, y)[0]), [0, 3, 7, 10]);
        let both = plane(3, &[0, 16, 16, 0, 16, 16]);
        assert_eq!(row(&both, 2, 2, 3), [0, 4, 12, 16, 16, 16]);
    }

    #[test]
    fn an_even_plane_stays_even() {
        let plane = plane(4, &[201; 8]);
        for (x, y) in [(1, 1), (2, 1), (1, 2), (2, 2), (4, 1), (4, 4)] {
            for at in 0..2 * y {
                assert_eq!(row(&plane, x, y, at), vec![201; 4 * x], "{x} x {y}");
            }
        }
    }

    #[test]
    fn narrow_planes_and_odd_ratios_repeat() {
        assert_eq!(row(&plane(2, &[1, 9]), 2, 1, 0), [1, 1, 9, 9]);
        assert_eq!(row(&plane(3, &[1, 9, 5]), 3, 2, 1), [1, 1, 1, 9, 9, 9, 5, 5, 5]);
    }
}
