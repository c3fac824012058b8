//! What is drawn into: the size and sample pattern of a frame, and the images that receive it.
//!
//! In: sizes and choices by the caller. Out: images, row 0 at the top, written once per tile when its last triangle is
//! done. Only the images that the caller asks for are computed: a frame without colour never shades.

use core::fmt;

/// Largest width and height of a target, in pixels.
pub const MAX_SIZE: u32 = 16_384;

/// Pixels along a side of a tile: the square that one thread draws from its first triangle to its stored pixels.
pub const TILE_SIZE: usize = 64;

/// Where in a pixel coverage and depth are tested.
///
/// Positions are multiples of 1/256 px from the pixel's top-left corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SamplePattern {
    positions: &'static [[i16; 2]],
    is_grid: bool,
}

impl SamplePattern {
    /// One sample, at the pixel centre.
    pub const CENTER: Self = Self { positions: &[[128, 128]], is_grid: false };

    /// A regular n x n grid: 1, 4, 9 or 16 samples, row by row. The thirds of the 3 x 3 grid are rounded to 1/256 px.
    #[must_use]
    pub fn grid(samples: u32) -> Option<Self> {
        let positions: &[[i16; 2]] = match samples {
            1 => &[[128, 128]],
            4 => &[[64, 64], [192, 64], [64, 192], [192, 192]],
            9 => &GRID_9,
            16 => &GRID_16,
            _ => return None,
        };
        Some(Self { positions, is_grid: true })
    }

    /// The standard positions for 1, 2, 4, 8 or 16 samples (Vulkan 1.3, "Multisampling", standard sample locations;
    /// Direct3D 11.1, standard multisample patterns).
    #[must_use]
    pub fn standard(samples: u32) -> Option<Self> {
        let positions: &[[i16; 2]] = match samples {
            1 => &[[128, 128]],
            2 => &[[192, 192], [64, 64]],
            4 => &[[96, 32], [224, 96], [32, 160], [160, 224]],
            8 => &STANDARD_8,
            16 => &STANDARD_16,
            _ => return None,
        };
        Some(Self { positions, is_grid: false })
    }

    /// How many samples a pixel has.
    #[must_use]
    pub fn count(self) -> usize {
        self.positions.len()
    }

    /// The samples' positions, in 1/256 px from the pixel's top-left corner; x right, y down.
    #[must_use]
    pub fn positions(self) -> &'static [[i16; 2]] {
        self.positions
    }

    /// The smallest and the largest offset along `axis` (0 is x, 1 is y), in 1/256 px.
    pub(crate) fn extent(self, axis: usize) -> (i32, i32) {
        let along = self.positions.iter().map(|p| i32::from(p[axis]));
        (along.clone().min().unwrap_or(128), along.max().unwrap_or(128))
    }
}

impl fmt::Display for SamplePattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", if self.is_grid { "grid" } else { "standard" }, self.count())
    }
}

const GRID_9: [[i16; 2]; 9] =
    [[43, 43], [128, 43], [213, 43], [43, 128], [128, 128], [213, 128], [43, 213], [128, 213], [213, 213]];

const GRID_16: [[i16; 2]; 16] = [
    [32, 32],
    [96, 32],
    [160, 32],
    [224, 32],
    [32, 96],
    [96, 96],
    [160, 96],
    [224, 96],
    [32, 160],
    [96, 160],
    [160, 160],
    [224, 160],
    [32, 224],
    [96, 224],
    [160, 224],
    [224, 224],
];

const STANDARD_8: [[i16; 2]; 8] = sixteenths([[9, 5], [7, 11], [13, 9], [5, 3], [3, 13], [1, 7], [11, 15], [15, 1]]);

const STANDARD_16: [[i16; 2]; 16] = sixteenths([
    [9, 9],
    [7, 5],
    [5, 10],
    [12, 7],
    [3, 6],
    [10, 13],
    [13, 11],
    [11, 3],
    [6, 14],
    [8, 1],
    [4, 2],
    [2, 12],
    [0, 8],
    [15, 4],
    [14, 15],
    [1, 0],
]);

const fn sixteenths<const N: usize>(mut positions: [[i16; 2]; N]) -> [[i16; 2]; N] {
    let mut i = 0;
    while i < N {
        positions[i] = [positions[i][0] * 16, positions[i][1] * 16];
        i += 1;
    }
    positions
}

/// How often a covered pixel is shaded.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ShadingRate {
    /// Once per pixel and triangle, at the pixel centre (multisampling).
    #[default]
    Pixel,
    /// Once per sample, at the sample (supersampling).
    Sample,
}

/// What the numbers of colours stand for while they are blended and averaged, and how they become bytes.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum ColorSpace {
    /// Linear light, encoded once per stored pixel: half of white and half of black make code 188.
    #[default]
    Linear,
    /// The stored values themselves, 0 to 1, as programs without a transfer function have it: they make code 128.
    Encoded,
}

/// One value per pixel, row 0 at the top; with `planes` > 1, one picture per sample, one after the other.
#[derive(Clone, Debug)]
pub struct Plane<T> {
    width: u32,
    height: u32,
    /// The values from `start` on, where a cache line begins: rows are written by whole lines.
    storage: Vec<T>,
    start: usize,
}

/// Bytes of a cache line.
const LINE: usize = 64;

impl<T: Copy + PartialEq> PartialEq for Plane<T> {
    fn eq(&self, other: &Self) -> bool {
        (self.width, self.height, self.values()) == (other.width, other.height, other.values())
    }
}

impl<T: Copy> Plane<T> {
    /// A picture of `width` x `height` values, all `value`; `planes` of them one after the other.
    pub(crate) fn new(width: u32, height: u32, planes: usize, value: T) -> Self {
        let len = width as usize * height as usize * planes;
        let mut storage = vec![value; len + LINE];
        let start = storage.as_ptr().align_offset(LINE).min(LINE);
        storage.truncate(start + len);
        Self { width, height, storage, start }
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The values: `[plane][y][x]`.
    #[must_use]
    pub fn values(&self) -> &[T] {
        &self.storage[self.start..]
    }

    /// The values, to take or change.
    #[must_use]
    pub fn into_values(mut self) -> Vec<T> {
        self.storage.drain(..self.start);
        self.storage
    }

    /// The value at (`x`, `y`) of the first plane; `None` outside.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<T> {
        let inside = x < self.width && y < self.height;
        inside.then(|| self.values()[y as usize * self.width as usize + x as usize])
    }

    /// The values, to change in place.
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.storage[self.start..]
    }
}
