//! What a shape is filled with, ready to be evaluated: rows of premultiplied pixels at pixel centres.

mod gradient;
mod image;
mod kind;
mod tile;

pub(crate) use gradient::Gradient;
pub(crate) use image::ImageShader;
pub(crate) use kind::Shader;
pub(crate) use tile::Tile;
