//! Options of `trigon render`.

use super::{
    DisplacementOptions, EffectOptions, InputOptions, MachineOptions, OutputOptions, PictureOptions, PresetOptions,
    ShadingOptions, SvgInputOptions, TextureOptions, ViewOptions,
};
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct RenderOptions {
    /// Models to draw together: OBJ, STL or PLY; or one SVG file; - for standard input
    ///
    /// Materials and textures of a model are looked for in its folder, those of standard input in the current one.
    #[arg(value_name = "MODEL", required = true)]
    pub(crate) models: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) output: OutputOptions,
    #[command(flatten)]
    pub(crate) picture: PictureOptions,
    #[command(flatten)]
    pub(crate) preset: PresetOptions,
    #[command(flatten)]
    pub(crate) view: ViewOptions,
    #[command(flatten)]
    pub(crate) shading: ShadingOptions,
    #[command(flatten)]
    pub(crate) effects: EffectOptions,
    #[command(flatten)]
    pub(crate) displacement: DisplacementOptions,
    #[command(flatten)]
    pub(crate) textures: TextureOptions,
    #[command(flatten)]
    pub(crate) input: InputOptions,
    #[command(flatten)]
    pub(crate) machine: MachineOptions,
    #[command(flatten)]
    pub(crate) svg_input: SvgInputOptions,
}
