//! Cutting polygons into triangles: the corners of a polygon in space in, corner triples out.
//!
//! Triangles and convex polygons become fans about their first corner; concave ones are cut by ear clipping in the
//! polygon's own plane.

mod ears;
mod grid;
mod triangulate;

pub(crate) use triangulate::{Cut, Triangulator};
