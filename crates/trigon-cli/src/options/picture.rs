//! Options about pixels and samples.

use super::{PatternChoice, RateChoice};
use crate::values::PictureSize;
use clap::Args;
use std::path::PathBuf;
use trigon_image::Color;

#[derive(Debug, Args)]
#[command(next_help_heading = "Picture")]
pub(crate) struct PictureOptions {
    /// Width and height: 1920x1080, 512, hd720, hd1080, qhd, 4k, 8k
    ///
    /// One number makes a square. qhd is 2560x1440, 4k is 3840x2160, 8k is 7680x4320; each side has at most 16384
    /// pixels.
    #[arg(short, long, default_value = "1024x768")]
    pub(crate) size: PictureSize,

    /// Colour behind the model, or none [default: light grey]
    ///
    /// The grey is #e6e8eb. none is transparent; formats without transparency show it as white. Behind shaders that look
    /// inside (normal, depth, uv and so on) the default is black, behind SVG it is none.
    #[arg(short, long, value_name = "COLOUR")]
    pub(crate) background: Option<Color>,

    /// Picture behind everything: PNG, JPEG, SVG and so on
    ///
    /// It fills the frame and keeps its proportions; what sticks out is cut off. It lies before the background's colour.
    #[arg(long, value_name = "FILE")]
    pub(crate) backdrop: Option<PathBuf>,

    /// Picture before everything, such as labels; as --backdrop
    #[arg(long, value_name = "FILE")]
    pub(crate) overlay: Option<PathBuf>,

    /// Samples per pixel, for smooth edges
    ///
    /// 1, 2, 4, 8 or 16 in the standard pattern; 1, 4, 9 or 16 on a grid.
    #[arg(long, value_name = "N", default_value = "4")]
    pub(crate) samples: u32,

    /// Where the samples lie
    #[arg(long, value_enum, default_value = "standard")]
    pub(crate) pattern: PatternChoice,

    /// How often a pixel is shaded
    #[arg(long, value_enum, value_name = "RATE", default_value = "pixel")]
    pub(crate) shading: RateChoice,

    /// Pixels of this picture along one of the picture that was asked for; more only where `trigon compare` draws what
    /// it measures against.
    #[arg(skip = 1_u16)]
    pub(crate) enlargement: u16,
}

impl PictureOptions {
    /// The files of the backdrop and the overlay.
    pub(crate) fn layer_files(&self) -> Vec<PathBuf> {
        self.backdrop.iter().chain(&self.overlay).cloned().collect()
    }
}
