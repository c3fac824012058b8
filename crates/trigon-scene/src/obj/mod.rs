//! The Wavefront OBJ reader: text in, one mesh with named parts and materials out.
//!
//! In stages, each a file: [`split`] cuts the text into blocks of whole lines; [`block`] parses a block on its own, in
//! parallel; [`resolve`] turns the blocks' indices into indices of the file, drops what is invalid and cuts polygons
//! into triangles, again in parallel; [`runs`] groups the primitives by part and material; [`reader`] leads, and makes one
//! vertex of each distinct (position, uv, normal) triple, in order of first use ([`crate::geometry`]).
//! Blocks have a fixed size, so nothing depends on the number of threads.
//!
//! What is read, and what happens to odd files, is in `FORMATS.md`.

mod block;
mod element;
mod library;
mod reader;
mod resolve;
mod runs;
mod split;

pub(crate) use reader::read;
