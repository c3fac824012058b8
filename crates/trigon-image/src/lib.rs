//! Pixels, colour, comparison, decoding and encoding of pictures for trigon.
//!
//! Bytes of a picture file go in, one of four concrete image types comes out, and back. The crate is the lowest of the
//! workspace: it knows no scene and no rasterizer, opens no window and never prints.
//!
//! ```
//! use trigon_image::{Color, EncodeOptions, Format, Limits, Rgba8Image, decode, encode};
//!
//! let teal = Color::parse("teal").unwrap();
//! let picture = Rgba8Image::filled(4, 3, teal.to_rgba8());
//! let bytes = encode(&picture, Format::Png, &EncodeOptions::default()).unwrap();
//! let back = decode(&bytes, None, &Limits::default()).unwrap().into_rgba8();
//! assert_eq!(back, picture);
//! assert_eq!(back.pixel(3, 2), [0, 128, 128, 255]);
//! ```
//!
//! Everything is exact: the same bytes in give the same bytes out on every machine. No decoder allocates more than its
//! [`Limits`] allow, and none panics on a broken file.
//!
//! # Non-goals
//!
//! - Colour management: profiles are ignored, every 8- and 16-bit picture is taken as sRGB.
//! - Metadata, thumbnails, and all frames but the first of animations that are read.
//! - Scaling, filters and drawing.

pub mod color;
pub mod compare;
pub mod decode;
pub mod encode;

mod error;
mod format;
mod half;
mod limits;
mod output;
mod pixels;

#[cfg(test)]
mod tests;

pub use color::Color;
pub use compare::{Comparison, compare};
pub use decode::{DecodedImage, decode};
pub use encode::{AnimationEncoder, EncodeOptions, ImageRef, encode};
pub use error::{DecodeError, EncodeError};
pub use format::Format;
pub use limits::Limits;
pub use output::{AtomicFile, write_atomically};
pub use pixels::{GrayF32Image, Rgba8Image, Rgba16Image, RgbaF32Image, SizeMismatch};
