//! Pictures of any kind that stand beside models and drawings: textures that are SVG, and layers behind and before.

mod cover;
mod layers;
mod svg_textures;

pub(crate) use cover::cover;
pub(crate) use layers::Layers;
pub(crate) use svg_textures::SvgTextures;
