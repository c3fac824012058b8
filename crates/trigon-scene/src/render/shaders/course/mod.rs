//! The shaders of courses, written to be read beside the course: each begins with its formula and its source.

mod games101;
mod tinyrenderer;

pub(in crate::render) use games101::Games101;
pub(in crate::render) use tinyrenderer::Tinyrenderer;
