//! `cargo xtask assets`: everything under `assets/`, made from nothing by arithmetic.
//!
//! Out: OBJ and MTL text and PNG textures, the same bytes on every machine: only + - * / sqrt and the `libm` crate.
//! The models are a still life that uses every kind of map an MTL file knows, the teapot of it alone, and a cube.

mod bezier;
mod folder;
mod material;
mod mesh;
mod models;
mod obj;
mod shapes;
mod still_life;
mod teapot;
mod texture;
mod vector;

pub(crate) use folder::{check, write};
