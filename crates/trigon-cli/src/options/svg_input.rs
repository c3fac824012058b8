//! Options about reading SVG files: as the picture, or as a texture or layer of one.

use crate::values::Positive;
use clap::Args;
use std::path::PathBuf;
use trigon_svg::svg::{FontOptions, Options};

#[derive(Debug, Args)]
#[command(next_help_heading = "SVG")]
pub(crate) struct SvgInputOptions {
    /// Pixels per inch, for lengths in mm, pt and so on
    #[arg(long, value_name = "N", default_value = "96")]
    pub(crate) dpi: Positive,

    /// Folder of fonts for text; repeatable
    #[arg(long = "font-dir", value_name = "FOLDER")]
    pub(crate) font_folders: Vec<PathBuf>,

    /// Font file for text; repeatable
    #[arg(long = "font-file", value_name = "FILE")]
    pub(crate) font_files: Vec<PathBuf>,

    /// Leave out the fonts installed on this machine
    ///
    /// Text then looks the same on every machine.
    #[arg(long)]
    pub(crate) no_system_fonts: bool,

    /// Font of text that names none
    #[arg(long, value_name = "NAME")]
    pub(crate) font_family: Option<String>,

    /// Font for serif
    #[arg(long, value_name = "NAME")]
    pub(crate) serif_family: Option<String>,

    /// Font for sans-serif
    #[arg(long, value_name = "NAME")]
    pub(crate) sans_serif_family: Option<String>,

    /// Font for cursive
    #[arg(long, value_name = "NAME")]
    pub(crate) cursive_family: Option<String>,

    /// Font for fantasy
    #[arg(long, value_name = "NAME")]
    pub(crate) fantasy_family: Option<String>,

    /// Font for monospace
    #[arg(long, value_name = "NAME")]
    pub(crate) monospace_family: Option<String>,

    /// Language for the parts of a file that depend on it, such as en or de-AT; repeatable [default: en]
    #[arg(long = "language", value_name = "CODE")]
    pub(crate) languages: Vec<String>,
}

impl SvgInputOptions {
    /// How a file in `folder` is read; without a folder, linked pictures are not.
    pub(crate) fn to_options(&self, folder: Option<PathBuf>, max_bytes: u64) -> Options {
        let mut options = Options { folder, dpi: self.dpi.to_f32(), ..Options::default() };
        if !self.languages.is_empty() {
            options.languages.clone_from(&self.languages);
        }
        options.fonts = FontOptions {
            use_system_fonts: !self.no_system_fonts,
            folders: self.font_folders.clone(),
            files: self.font_files.clone(),
            default_family: self.font_family.clone(),
            serif: self.serif_family.clone(),
            sans_serif: self.sans_serif_family.clone(),
            cursive: self.cursive_family.clone(),
            fantasy: self.fantasy_family.clone(),
            monospace: self.monospace_family.clone(),
        };
        options.limits.max_bytes = options.limits.max_bytes.min(usize::try_from(max_bytes).unwrap_or(usize::MAX));
        options
    }
}
