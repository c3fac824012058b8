//! Pixels to the bytes of a picture file: one file a format, one entry point, and animations.

mod animation;
mod apng;
mod dispatch;
mod dither;
mod exr;
mod gif;
mod jpeg;
mod options;
mod png;
mod qoi;
mod quantize;
mod tga;

pub use animation::AnimationEncoder;
pub use dispatch::{ImageRef, encode};
pub use exr::{ExrChannel, ExrSamples, encode_exr};
pub use options::{BitDepth, Effort, EncodeOptions, ExrSample, GifPalette};
