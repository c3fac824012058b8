//! Options about surfaces and light.

use super::{ColorSpaceChoice, CullChoice, InterpolationChoice, PlaceChoice, WireframeChoice};
use crate::values::{LightValue, Positive, Real};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use trigon_scene::render::ShaderKind;
use trigon_scene::render::course::games101::Homework3;

#[derive(Debug, Args)]
#[command(next_help_heading = "Surface and light")]
pub(crate) struct ShadingOptions {
    /// What the colours show
    #[arg(long, value_name = "NAME", default_value = "blinn-phong", value_parser = shader_parser())]
    pub(crate) shader: ShaderKind,

    /// Add a light, instead of the default ones; repeatable
    ///
    /// ambient:INTENSITY, directional:X,Y,Z:INTENSITY (the way that the light travels), point:X,Y,Z:INTENSITY, or
    /// spot:X,Y,Z:DX,DY,DZ:ANGLE:INTENSITY (half the angle of the cone, or INNER/OUTER), each with :COLOUR at its end
    /// if it is not white. Point and spot lights lose strength with the square of the distance.
    #[arg(long = "light", value_name = "KIND:..")]
    pub(crate) lights: Vec<LightValue>,

    /// What colours are while they are computed
    ///
    /// In linear light, light adds up and samples average as in nature. Encoded, all is done with stored values, as in
    /// programs that know no gamma. Colours of lights and of the background are the same in both.
    #[arg(long, value_enum, value_name = "SPACE", default_value = "linear")]
    pub(crate) color_space: ColorSpaceChoice,

    /// How texture coordinates, normals and the like vary over triangles
    #[arg(long, value_enum, value_name = "WAY", default_value = "perspective")]
    pub(crate) interpolation: InterpolationChoice,

    /// Where in its pixel a sample lies; several samples are moved as one
    #[arg(long, value_enum, value_name = "PLACE", default_value = "middle")]
    pub(crate) sample_at: PlaceChoice,

    /// kh of the shaders games101-bump and games101-displacement: steepness [default: 0.2]
    #[arg(long, value_name = "KH", allow_hyphen_values = true)]
    pub(crate) bump_height: Option<Real>,

    /// kn of these shaders: how far heights move points, and times kh their steepness [default: 0.1]
    #[arg(long, value_name = "KN", allow_hyphen_values = true)]
    pub(crate) bump_scale: Option<Real>,

    /// Sides of triangles that are left out
    #[arg(long, value_enum, value_name = "SIDE", default_value = "none")]
    pub(crate) cull: CullChoice,

    /// Draw the edges of triangles; over the surface if no MODE
    #[arg(long, value_enum, value_name = "MODE", num_args = 0..=1, require_equals = true, default_missing_value = "over")]
    pub(crate) wireframe: Option<WireframeChoice>,

    /// Width of lines and edges, in pixels
    #[arg(long, value_name = "PIXELS", default_value = "1")]
    pub(crate) line_width: Positive,

    /// Size of points, in pixels
    #[arg(long, value_name = "PIXELS", default_value = "3")]
    pub(crate) point_size: Positive,
}

fn shader_parser() -> impl TypedValueParser<Value = ShaderKind> {
    let values = ShaderKind::ALL.map(|kind| PossibleValue::new(kind.name()).help(kind.description()));
    PossibleValuesParser::new(values).try_map(|name| name.parse::<ShaderKind>())
}

/// The same with the shaders of GAMES101's homework 3 by the names that the course gives them.
pub(super) fn homework_3_parser() -> impl TypedValueParser<Value = ShaderKind> {
    let short = |shading: Homework3| shading.name().trim_start_matches("games101-");
    let of_course = Homework3::ALL.map(|shading| PossibleValue::new(short(shading)).help(shading.description()));
    let others = ShaderKind::ALL.into_iter().filter(|kind| *kind != ShaderKind::Normal);
    let others = others.map(|kind| PossibleValue::new(kind.name()).help(kind.description()));
    PossibleValuesParser::new(of_course.into_iter().chain(others)).try_map(move |name| {
        let shading = Homework3::ALL.into_iter().find(|shading| short(*shading) == name);
        shading.map_or_else(|| name.parse(), |shading| Ok(ShaderKind::Games101(shading)))
    })
}
