//! The PLY reader: text or binary of either byte order in, one mesh or point cloud out.
//!
//! The [`header`] declares elements (vertices, faces, ...) and their properties; [`layout`] finds the properties that are used;
//! [`values`] reads scalars in the file's encoding; [`reader`] walks the elements.
//!
//! An own reader, because the maintained crate (`ply-rs-bw`) keeps every element as a map from property names to values:
//! 2.9 s for a dragon of 871 000 triangles, against 0.06 s here, and memory to match.

mod header;
mod layout;
mod reader;
mod values;

pub(crate) use reader::read;
