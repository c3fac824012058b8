//! Figures of the command: labels, lines and pictures on one sheet.

mod font;
mod picture;
mod sketch;

pub(crate) use picture::{enlarged, lay_over};
pub(crate) use sketch::{Anchor, Sketch, line_height, text_width};
