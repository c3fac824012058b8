//! The shaders of scenes: Rust types, generic over the lanes.
//!
//! `vertex` fetches and places vertices, `point` gathers what is known of a fragment, `normal` finds the shading normal
//! with its maps, `maps` reads factor maps, `display` shows numbers as bytes, `lighting` sums up light, `obstacles`, `shadow` and `openness` find what does not arrive; `blinn_phong`,
//! `toon`, `overlay`, `stroke` and `shape` are the shaders made of them; `course` has
//! those of courses.

mod blinn_phong;
mod course;
mod display;
mod lighting;
mod maps;
mod normal;
mod obstacles;
mod openness;
mod overlay;
mod point;
mod shadow;
mod shape;
mod stroke;
mod toon;
mod vertex;

pub(super) use blinn_phong::BlinnPhong;
pub(super) use course::{Games101, Tinyrenderer};
pub(super) use overlay::Overlay;
pub(super) use shape::Shape;
pub(super) use stroke::Stroke;
pub(super) use vertex::{Full, MeshView, Plain};
