//! Bytes of a picture file to pixels: one file a format, one entry point.

mod decoded_image;
mod dispatch;
mod png;
mod reader;
mod tga;

pub use decoded_image::DecodedImage;
pub use dispatch::decode;
