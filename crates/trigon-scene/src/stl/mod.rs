//! The STL reader: text or binary in, one welded mesh out.
//!
//! STL stores loose triangles. Equal positions are welded, so that normals can be made smooth; the stored facet normals
//! are not used, because many writers leave them zero or wrong. Solids become parts. Colours of binary facets are read
//! in both of their dialects.
//!
//! An own reader, because the maintained crate (`stl_io`) knows no colours, solids or limits.

mod binary;
mod reader;
mod text;

pub(crate) use reader::read;
