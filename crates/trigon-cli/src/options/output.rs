//! Options about what is written, and where.

use super::{BitDepth, Compression};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(next_help_heading = "Output")]
pub(crate) struct OutputOptions {
    /// File to write, or - for standard output
    ///
    /// The extension says the format. The file appears whole or not at all.
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// png, tga, qoi, jpeg, gif or exr, instead of by the extension
    ///
    /// PNG to standard output unless given.
    #[arg(short, long)]
    pub(crate) format: Option<String>,

    /// Bits per channel: 8 or 16 in PNG, 16 or 32 in EXR
    ///
    /// PNG has 8 and EXR 16 unless given; all other formats have 8.
    #[arg(long, value_enum, value_name = "BITS", hide_possible_values = true)]
    pub(crate) bit_depth: Option<BitDepth>,

    /// Quality of JPEG, 1 to 100
    #[arg(long, value_name = "PERCENT", default_value_t = 90, value_parser = clap::value_parser!(u8).range(1..=100))]
    pub(crate) quality: u8,

    /// Time spent on a smaller PNG or EXR
    #[arg(long, value_enum, value_name = "EFFORT", default_value = "fast")]
    pub(crate) compression: Compression,

    /// Report as JSON to standard output, or to FILE
    ///
    /// Counts of triangles, warnings, times of the stages in milliseconds, and a hash of the picture: FNV-1a, 64 bits,
    /// of its bytes red, green, blue, alpha, row by row from the top. If the picture goes to standard output, the
    /// report goes to standard error.
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    pub(crate) json: Option<Option<PathBuf>>,

    /// No warnings and no progress bar
    #[arg(short, long)]
    pub(crate) quiet: bool,
}
