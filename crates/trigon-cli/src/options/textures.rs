//! Options about reading textures.

use super::{LevelFilterChoice, PixelFilterChoice, WrapChoice};
use clap::Args;

#[derive(Debug, Args)]
#[command(next_help_heading = "Textures")]
pub(crate) struct TextureOptions {
    /// Filter within a mip level
    #[arg(long, value_enum, value_name = "FILTER", default_value = "bilinear")]
    pub(crate) pixel_filter: PixelFilterChoice,

    /// Filter between mip levels
    #[arg(long, value_enum, value_name = "FILTER", default_value = "linear")]
    pub(crate) level_filter: LevelFilterChoice,

    /// Most samples along a slanted view, 1 to 16; 1 is isotropic
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u8).range(1..=16))]
    pub(crate) anisotropy: u8,

    /// What lies outside a texture
    #[arg(long, value_enum, value_name = "MODE", default_value = "repeat")]
    pub(crate) wrap: WrapChoice,
}
