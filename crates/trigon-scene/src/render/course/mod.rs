//! Scenes of courses: the camera, the light, the materials and the settings that their programs have built in.

pub(in crate::render) mod depth_buffer;
pub mod games101;
pub mod learning_tinyrenderer;
mod pictures;
pub mod tinyrenderer;
