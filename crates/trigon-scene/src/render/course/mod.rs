//! Scenes of courses: the camera, the light, the materials and the settings that their programs have built in.

pub mod learning_tinyrenderer;
pub mod tinyrenderer;
