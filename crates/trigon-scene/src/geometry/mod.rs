//! From what files store to what a renderer draws: triangles of polygons, normals, unified vertices, tangents; and
//! meshes made finer, with the relief of height maps.
//!
//! Shared by all readers; nothing here knows a file format.

mod displace;
mod facets;
mod height_map;
mod normals;
mod polygon;
mod subdivide;
mod tangents;
mod unify;
mod weld;

pub(crate) use displace::{Relief, displace};
pub(crate) use facets::{Extra, Facets};
pub(crate) use height_map::HeightMap;
pub(crate) use normals::{Smoothing, generate_normals, unit_normal};
pub(crate) use polygon::{Cut, Triangulator};
pub(crate) use unify::{ABSENT, Corner, Unifier, gather};
pub(crate) use weld::Welder;
