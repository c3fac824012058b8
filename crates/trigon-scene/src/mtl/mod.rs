//! The MTL reader: the text of a material library in, named materials out, their textures found and read.
//!
//! Source: "MTL material format (Lightwave, OBJ)", Alias|Wavefront 1995, and the physically based extension (`Pr Pm Ps
//! Pc Pcr aniso anisor norm`). Keywords are recognized in any letter case. What happens to odd files is in
//! `FORMATS.md`.

mod library;
mod map_statement;
mod statement;

pub(crate) use library::{Context, read_library};
