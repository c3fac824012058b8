//! The corpus: frames by name, each of which must have the same hash on every machine.
//!
//! [`all`] lists them. The tests draw them at every SIMD level and with several threads; `tests/cross` draws them on
//! other instruction sets. Between them they reach every kernel: all primitives, sample patterns, blends, texture
//! filters and formats, the functions of `trigon::math`, whole scenes from files in memory, and picture files.

mod clip_space;
mod files;
mod mathematics;
mod named_frame;
mod scenes;
mod textured;

pub use clip_space::soup;
pub use named_frame::{NamedFrame, all, report};
