//! From what files store to what a renderer draws: triangles of polygons, normals, unified vertices, tangents.
//!
//! Shared by all readers; nothing here knows a file format.

mod normals;
mod polygon;
mod unify;

pub(crate) use normals::{Smoothing, generate_normals};
pub(crate) use polygon::{Cut, Triangulator};
pub(crate) use unify::{ABSENT, Corner, Unifier, gather};
