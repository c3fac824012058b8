//! What can be chosen: size, view, samples, texture sampling.

use std::path::PathBuf;

/// How a picture is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Samples a pixel along each axis: 1 to 4 stand for the rates 1, 4, 9, 16.
    pub samples_per_axis: u32,
    /// Within a level.
    pub pixel: PixelSampling,
    /// Which levels of the mip chain.
    pub level: LevelSampling,
    /// Which texel is the nearest.
    pub nearest: NearestRule,
    /// The centre and half of the side, in the file's units, of the square seen in the shorter side of the picture; without
    /// it the whole file, with a margin of a tenth.
    pub view: Option<[f64; 3]>,
    /// Pixels along a side that stand for one of the course's, at least 1: points and lines, which are a pixel wide
    /// whatever the view, are as much wider. For pictures that are scaled down afterwards.
    pub enlargement: u32,
    /// Where the files of textures are looked for.
    pub folder: Option<PathBuf>,
    /// Threads at work; changes no pixel.
    pub threads: usize,
}

/// How texels of a level are combined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PixelSampling {
    /// The nearest one.
    #[default]
    Nearest,
    /// The four around the point.
    Bilinear,
}

/// Which levels of the mip chain are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LevelSampling {
    /// The full image.
    #[default]
    Zero,
    /// The level of nearest size.
    Nearest,
    /// The two levels around it, mixed.
    Linear,
}

/// Which texel of a row of n is nearest to u.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum NearestRule {
    /// The one that holds the point: `floor(u n)`.
    #[default]
    Holding,
    /// As in the pictures the course gives out: `round(u (n - 1))`.
    Course,
}

impl Options {
    /// The course's defaults for a picture of this size: one sample, nearest texel, level zero, all of the file.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            samples_per_axis: 1,
            pixel: PixelSampling::Nearest,
            level: LevelSampling::Zero,
            nearest: NearestRule::Holding,
            view: None,
            enlargement: 1,
            folder: None,
            threads: 1,
        }
    }
}
