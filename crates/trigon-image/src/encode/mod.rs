//! Pixels to the bytes of a picture file: one file a format, one entry point, and animations.

mod animation;
mod dispatch;
mod exr;
mod options;
mod png;
mod tga;

pub use animation::AnimationEncoder;
pub use dispatch::{ImageRef, encode};
pub use exr::{ExrChannel, ExrSamples, encode_exr};
pub use options::{BitDepth, Effort, EncodeOptions, ExrSample, GifPalette};
