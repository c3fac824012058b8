//! Options about reading models.

use super::InputFormat;
use crate::values::{Angle, Limit};
use clap::Args;

#[derive(Debug, Args)]
#[command(next_help_heading = "Input")]
pub(crate) struct InputOptions {
    /// Format of the models, instead of recognizing it
    ///
    /// Models are recognized by their content, then by their name. All formats may be compressed with gzip.
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) input_format: Option<InputFormat>,

    /// Treat missing files, unreadable textures and broken elements as errors
    ///
    /// Without it they are warnings: what is missing is drawn in a neutral material, what is broken is left out.
    #[arg(long)]
    pub(crate) strict: bool,

    /// Largest angle that made normals smooth over [default: 45]
    ///
    /// For models without normals: edges between faces that meet at a larger angle are drawn sharp. Smoothing groups
    /// of OBJ files come first.
    #[arg(long, value_name = "ANGLE", allow_hyphen_values = true)]
    pub(crate) crease_angle: Option<Angle>,

    /// Diffuse texture for materials that have none
    #[arg(long, value_name = "FILE")]
    pub(crate) texture: Option<std::path::PathBuf>,

    /// Picture of heights for all materials, for --displace
    ///
    /// White is high. Without --displace it is drawn as a bump map where a material has none.
    #[arg(long, value_name = "FILE")]
    pub(crate) height_map: Option<std::path::PathBuf>,

    /// Bound on what is read, such as triangles=10M; repeatable
    ///
    /// For models of strangers. The limits are file-size, vertices, triangles, materials, textures, texture-size (bytes
    /// of a texture file) and texture-pixels (its width times height); k, M, G stand for powers of 1024.
    #[arg(long = "limit", value_name = "NAME=COUNT")]
    pub(crate) limits: Vec<Limit>,
}
