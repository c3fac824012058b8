//! The story of a pixel as people and programs read it: a [`SceneStory`](trigon_scene::render::SceneStory) in, text,
//! JSON or a diagram out.

mod diagram;
mod json;
mod number;
mod text;
mod triangle;

pub(crate) use diagram::to_picture;
pub(crate) use json::to_json;
pub(crate) use text::to_text;
