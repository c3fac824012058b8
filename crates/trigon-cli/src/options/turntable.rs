//! Options of `trigon turntable`: those of a picture, and those of time.

use super::RenderOptions;
use crate::values::Positive;
use clap::Args;

#[derive(Debug, Args)]
pub(crate) struct TurntableOptions {
    #[command(flatten)]
    pub(crate) render: RenderOptions,
    #[command(flatten)]
    pub(crate) animation: AnimationOptions,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Animation")]
pub(crate) struct AnimationOptions {
    /// Frames of one turn
    #[arg(short = 'n', long, value_name = "N", default_value_t = 72, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) frames: u32,

    /// Frames per second
    ///
    /// GIF rounds the time of a frame to hundredths of a second; most programs play nothing faster than 50 a second.
    #[arg(long, value_name = "RATE", default_value = "24")]
    pub(crate) fps: Positive,

    /// How often the animation plays; 0 is forever
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub(crate) plays: u16,
}
