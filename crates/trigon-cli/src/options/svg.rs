//! Options about SVG pictures.

use super::RenderOptions;
use crate::values::{PageArea, Vector};
use clap::{Args, ValueEnum};
use trigon::target::MAX_SIZE;

/// Options of `trigon render`: those of models, and those of SVG pictures alone.
#[derive(Debug, Args)]
pub(crate) struct RenderCommandOptions {
    #[command(flatten)]
    pub(crate) render: RenderOptions,
    #[command(flatten)]
    pub(crate) svg: SvgOptions,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "SVG")]
pub(crate) struct SvgOptions {
    /// Width of the picture; the height follows
    ///
    /// Without --size, --width, --height and --zoom an SVG picture has the size that the file asks for.
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SIZE)))]
    #[arg(conflicts_with_all = ["height", "size"])]
    pub(crate) width: Option<u32>,

    /// Height of the picture; the width follows
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_SIZE)))]
    #[arg(conflicts_with = "size")]
    pub(crate) height: Option<u32>,

    /// Draw only the element with this id
    #[arg(long, value_name = "ID")]
    pub(crate) export_id: Option<String>,

    /// What is shown: page, drawing, or X,Y,WIDTH,HEIGHT
    ///
    /// The page is what the svg element asks for, the drawing all that is visible, without margins. [default: page; with
    /// --export-id: drawing]
    #[arg(long, value_name = "AREA", allow_hyphen_values = true)]
    pub(crate) export_area: Option<PageArea>,

    /// CX,CY,SPAN: what --preset cs184 shows
    ///
    /// The square round (CX, CY), in the file's units, that reaches SPAN to each side fills the shorter side of the
    /// picture. [default: all of the file, with a margin of a tenth]
    #[arg(long, value_name = "CX,CY,SPAN", allow_hyphen_values = true, requires = "preset")]
    pub(crate) view: Option<Vector>,

    /// Which texel --preset cs184 takes as the nearest
    #[arg(long, value_enum, value_name = "RULE", default_value = "holding")]
    pub(crate) nearest_texel: NearestTexel,
}

/// Which texel of a row of n is nearest to u.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum NearestTexel {
    /// The one that holds the point, floor(u n)
    Holding,
    /// As in the pictures that the course gives out, round(u (n - 1))
    Course,
}
