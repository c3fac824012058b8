//! Textures: images as the sampler wants them, and the sampler.
//!
//! Pixels and a description ([`TextureDesc`]) go in; a [`Texture`] comes out: immutable, with its mip chain, tiled. With
//! a [`Sampler`] and the footprints of sixteen fragments it gives sixteen filtered colours in linear light.

mod address;
mod desc;
mod fetch;
mod filter;
mod footprint;
mod layout;
mod mips;
mod notes;
mod pyramid;
mod sampler;
mod texel;

pub use desc::{Alpha, MAX_TEXTURE_SIZE, MipChain, TexelFormat, TextureDesc, TextureError};
pub use pyramid::Texture;
pub use sampler::{LevelFilter, PixelFilter, Sampler, Wrap};

#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "small test values")]
mod reference;
#[cfg(test)]
#[expect(clippy::cast_possible_truncation, reason = "small test values")]
mod tests;
