//! The shaders of scenes: Rust types, generic over the lanes.
//!
//! `vertex` fetches and places vertices, `point` gathers what is known of a fragment, `normal` finds the shading normal
//! with its maps, `maps` reads factor maps, `lighting` sums up light, `obstacles` and `shadow` find what does not arrive; `blinn_phong`, `overlay`,
//! `stroke` and `caster` are the shaders made of them.

mod blinn_phong;
mod caster;
mod lighting;
mod maps;
mod normal;
mod obstacles;
mod overlay;
mod point;
mod shadow;
mod stroke;
mod vertex;

pub(super) use blinn_phong::BlinnPhong;
pub(super) use caster::Caster;
pub(super) use overlay::Overlay;
pub(super) use stroke::Stroke;
pub(super) use vertex::{Full, MeshView, Plain};
