//! From what files store to what a renderer draws: triangles of polygons, normals, unified vertices, tangents.
//!
//! Shared by all readers; nothing here knows a file format.

mod facets;
mod normals;
mod polygon;
mod tangents;
mod unify;
mod weld;

pub(crate) use facets::{Extra, Facets};
pub(crate) use normals::{Smoothing, generate_normals, unit_normal};
pub(crate) use polygon::{Cut, Triangulator};
pub(crate) use unify::{ABSENT, Corner, Unifier, gather};
pub(crate) use weld::Welder;
