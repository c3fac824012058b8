//! Shading: what is visible becomes colour. Shaders, their inputs, textures.

pub mod texture;
