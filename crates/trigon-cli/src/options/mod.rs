//! The option table: the one place from which the parser, the help, the man pages and the shell completions come.
//!
//! Only what the user may write; what it means is decided by the modules that read these structs.

mod choices;
mod cli;
mod compare;
mod displacement;
mod effects;
mod explain;
mod given;
mod input;
mod machine;
mod output;
mod picture;
mod preset;
mod render;
mod shading;
mod svg;
mod svg_input;
mod texts;
mod textures;
mod turntable;
mod view;
mod written;

pub(crate) use choices::{
    BitDepth, ColorSpaceChoice, Compression, CullChoice, InputFormat, InterpolationChoice, LevelFilterChoice,
    PatternChoice, PixelFilterChoice, PlaceChoice, RateChoice, WireframeChoice, WrapChoice,
};
pub(crate) use cli::{Cli, Command, CompletionsOptions, ManOptions, command_line, with_implied_render};
pub(crate) use compare::CompareOptions;
pub(crate) use displacement::DisplacementOptions;
pub(crate) use effects::EffectOptions;
pub(crate) use explain::ExplainOptions;
pub(crate) use given::Given;
pub(crate) use input::InputOptions;
pub(crate) use machine::MachineOptions;
pub(crate) use output::OutputOptions;
pub(crate) use picture::PictureOptions;
pub(crate) use preset::{Preset, PresetOptions, command_line_for};
pub(crate) use render::RenderOptions;
pub(crate) use shading::ShadingOptions;
pub(crate) use svg::{NearestTexel, RenderCommandOptions};
pub(crate) use svg_input::SvgInputOptions;
pub(crate) use textures::TextureOptions;
pub(crate) use turntable::TurntableOptions;
pub(crate) use view::ViewOptions;
pub(crate) use written::Written;
