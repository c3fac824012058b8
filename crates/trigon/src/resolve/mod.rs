//! Resolve: colours per sample in, one colour per pixel out, encoded as the target wants it.

mod block;
mod encode;

pub use block::{Blend, ColorBlock};
pub use encode::{encode_srgb8, resolve};
