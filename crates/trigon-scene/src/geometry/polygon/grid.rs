//! A uniform grid over points in the plane: which points may lie in a triangle.

use super::ears::Point;

/// Points sorted into the cells of a grid about as fine as the points are many.
#[derive(Default)]
pub(super) struct Grid {
    min: Point,
    cells_per_unit: Point,
    columns: usize,
    /// Points of cell `i` are `points[starts[i]..starts[i + 1]]`.
    starts: Vec<usize>,
    points: Vec<usize>,
    /// Scratch: each point's cell.
    cells: Vec<usize>,
}

impl Grid {
    /// The most columns and rows.
    const MAX_COLUMNS: usize = 512;

    /// Sorts the `chosen` of all `points` into a new grid.
    pub(super) fn fill(&mut self, points: &[Point], chosen: impl Iterator<Item = usize> + Clone) {
        let count = chosen.clone().count();
        let root = libm::sqrt(f64::from(u32::try_from(count).unwrap_or(u32::MAX)));
        self.columns = to_cell(root, Self::MAX_COLUMNS - 1) + 1;
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for i in chosen.clone() {
            for axis in 0..2 {
                min[axis] = min[axis].min(points[i][axis]);
                max[axis] = max[axis].max(points[i][axis]);
            }
        }
        self.min = min;
        let columns = f64::from(u32::try_from(self.columns).unwrap_or(1));
        self.cells_per_unit =
            [0, 1].map(|axis| if max[axis] > min[axis] { columns / (max[axis] - min[axis]) } else { 0.0 });

        // Counting sort: counts, then starts, then places.
        self.cells.clear();
        self.cells.extend(chosen.clone().map(|i| {
            let [x, y] = cell_of(points[i], self.min, self.cells_per_unit, self.columns);
            y * self.columns + x
        }));
        self.starts.clear();
        self.starts.resize(self.columns * self.columns + 1, 0);
        for &cell in &self.cells {
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.points.clear();
        self.points.resize(count, 0);
        let mut places = self.starts.clone();
        for (i, &cell) in chosen.zip(&self.cells) {
            self.points[places[cell]] = i;
            places[cell] += 1;
        }
    }

    /// The points of all cells that the triangle's bounding box touches.
    pub(super) fn near(&self, triangle: [Point; 3]) -> impl Iterator<Item = usize> + '_ {
        let bound = |axis: usize, pick: fn(f64, f64) -> f64| {
            pick(pick(triangle[0][axis], triangle[1][axis]), triangle[2][axis])
        };
        let cell = |point: Point| cell_of(point, self.min, self.cells_per_unit, self.columns);
        let [x0, y0] = cell([bound(0, f64::min), bound(1, f64::min)]);
        let [x1, y1] = cell([bound(0, f64::max), bound(1, f64::max)]);
        (y0..=y1).flat_map(move |y| {
            let row = y * self.columns;
            self.points[self.starts[row + x0]..self.starts[row + x1 + 1]].iter().copied()
        })
    }
}

fn cell_of(point: Point, min: Point, cells_per_unit: Point, columns: usize) -> [usize; 2] {
    [0, 1].map(|axis| to_cell((point[axis] - min[axis]) * cells_per_unit[axis], columns - 1))
}

/// The integer part, clamped to `0..=last`.
fn to_cell(value: f64, last: usize) -> usize {
    if value >= 0.0 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not negative; the cast saturates"
        )]
        return (value as usize).min(last);
    }
    0
}
