//! From display list to pixels.

mod color;
mod draw;

pub(crate) use color::straight;
pub(crate) use draw::draw;
