//! The textures: each a function of (u, v), sampled into a small PNG. v runs up, as in OBJ.

mod canvas;
mod glaze;
mod lantern;
mod leaf;
mod metal;
mod noise;
mod peel;
mod relief;
mod uv_grid;
mod wood;
mod zellige;

pub(crate) use glaze::{glaze_colour, glaze_exponent, glaze_specular};
pub(crate) use lantern::{lantern_glow, lantern_lattice};
pub(crate) use leaf::{leaf_alpha, leaf_colour};
pub(crate) use metal::metal_normal;
pub(crate) use peel::peel_height;
pub(crate) use uv_grid::uv_grid;
pub(crate) use wood::wood_colour;
pub(crate) use zellige::{zellige_colour, zellige_normal};
