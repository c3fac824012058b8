//! What a caller may choose when writing a picture; every choice has a default that suits most.

use crate::Color;

/// Choices of all formats; each format reads those that concern it.
///
/// ```
/// use trigon_image::{EncodeOptions, encode::BitDepth};
///
/// let mut options = EncodeOptions::default();
/// options.depth = BitDepth::Sixteen;
/// options.jpeg_quality = 75;
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct EncodeOptions {
    /// Bits a channel (PNG).
    pub depth: BitDepth,
    /// Time spent to make the file smaller (PNG, EXR).
    pub effort: Effort,
    /// Quality from 1 to 100 (JPEG); larger or smaller values are clamped. 90 by default.
    pub jpeg_quality: u8,
    /// What shows through where a format has no alpha (JPEG). White by default; its own alpha is ignored.
    pub background: Color,
    /// Run-length packets (TGA). On by default.
    pub tga_run_length: bool,
    /// The type of color channels (EXR).
    pub exr_sample: ExrSample,
    /// Which palettes an animation has (GIF).
    pub gif_palette: GifPalette,
    /// Ordered dither to hide the steps of a palette (GIF). On by default; pictures of up to 256 colors never need it.
    pub gif_dither: bool,
    /// How often an animation plays (GIF, APNG); 0, the default, is forever.
    pub plays: u16,
}

impl Default for EncodeOptions {
    fn default() -> Self {
        Self {
            depth: BitDepth::default(),
            effort: Effort::default(),
            jpeg_quality: 90,
            background: Color::WHITE,
            tga_run_length: true,
            exr_sample: ExrSample::default(),
            gif_palette: GifPalette::default(),
            gif_dither: true,
            plays: 0,
        }
    }
}

/// Bits a channel of a PNG file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum BitDepth {
    /// 8 for `Rgba8` and `RgbaF32` images, 16 for `Rgba16` and `GrayF32` images.
    #[default]
    Auto,
    /// 8 bits.
    Eight,
    /// 16 bits.
    Sixteen,
}

/// Time spent to make a lossless file smaller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Effort {
    /// Fastest: for pictures made in bulk.
    #[default]
    Fast,
    /// About ten times slower, somewhat smaller.
    Balanced,
    /// For pictures made once and downloaded often.
    Best,
}

/// The type of an EXR file's color channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum ExrSample {
    /// 16-bit floating point: 11 bits of precision, up to 65504. What most programs write for color.
    #[default]
    F16,
    /// 32-bit floating point: exact.
    F32,
}

/// The palettes of an animated GIF.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum GifPalette {
    /// 256 colors for each frame: best colors, and frames are written as they come.
    #[default]
    PerFrame,
    /// 256 colors for all frames: steady colors, but all frames are held in memory until the end.
    Global,
}
