//! Reading text files of numbers and names: encodings, a cursor over bytes, exact decimal floats.
//!
//! Shared by the OBJ, MTL, STL and PLY readers. Works on bytes, since the files have no stated encoding and their
//! syntax is ASCII.

mod cursor;
mod encoding;
mod float;

pub(crate) use cursor::Cursor;
pub(crate) use encoding::{decode_name, to_single_byte_text};
