//! Bytes of a picture file to pixels: one file a format, one entry point.

mod bmp;
mod bmp_rle;
mod decoded_image;
mod dispatch;
mod exr;
mod exr_block;
mod exr_header;
mod gif;
mod hdr;
mod jpeg;
mod png;
mod qoi;
mod reader;
mod tga;
mod tiff;
mod webp;

pub use decoded_image::DecodedImage;
pub use dispatch::decode;
pub(crate) use qoi::hash as qoi_hash;
