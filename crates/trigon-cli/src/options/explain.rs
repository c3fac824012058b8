//! Options of `trigon explain`: those of a picture, and the pixel.

use super::RenderOptions;
use crate::values::PixelPlace;
use clap::Args;

#[derive(Debug, Args)]
pub(crate) struct ExplainOptions {
    /// Column and row of the pixel, from 0 at the top left
    #[arg(short, long, value_name = "X,Y")]
    pub(crate) pixel: PixelPlace,

    #[command(flatten)]
    pub(crate) render: RenderOptions,
}
