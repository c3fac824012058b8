//! What a shader and its samplers say about single fragments while they are drawn.
//!
//! In: a choice of lanes to watch; then shading code that runs as always and, at the plain level, notes named values
//! with [`Lanes::note`](crate::lanes::Lanes::note). Out: [`Note`]s, in the order of computation. At every other level a
//! note compiles to nothing, and all levels compute the same bits; so what is told of a pixel is how every picture of
//! it comes about. [`Renderer::explain`](crate::pipeline::Renderer::explain) makes the whole story of a pixel of them.

mod note;
mod recorder;

pub use note::{FragmentFacts, LevelRead, Note, Tap, TexelRead, TextureRead, VaryingFacts};
pub(crate) use recorder::{enter_group, is_watching, take, watch};
pub(crate) use recorder::{note, note_level, note_tap, note_texel, note_texture, note_texture_color, note_topic};
