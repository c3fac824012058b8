//! Options of effects that take passes of their own.

use crate::values::{NonNegative, Positive};
use clap::Args;
use trigon_image::Color;
use trigon_scene::render::{AmbientOcclusion, Outline, Shadows};

#[derive(Debug, Args)]
#[command(next_help_heading = "Effects")]
pub(crate) struct EffectOptions {
    /// Let lights cast shadows
    ///
    /// All lights of --light, or the brightest of the default ones. Each of the options below switches shadows on too.
    #[arg(long)]
    pub(crate) shadows: bool,

    /// Texels along a side of a shadow map: more is sharper [default: 2048]
    ///
    /// At most 16384. A map is fitted around the whole scene; a point light has six.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16_384))]
    pub(crate) shadow_map_size: Option<u32>,

    /// Distance that surfaces are moved towards a light before they are compared with its map [default: fitted]
    ///
    /// In units of the scene. More, and shadows begin too far from what casts them; less, and surfaces shade themselves in
    /// stripes.
    #[arg(long, value_name = "DISTANCE", allow_hyphen_values = true)]
    pub(crate) shadow_bias: Option<NonNegative>,

    /// Softness of the edges of shadows, in texels of the map: 0 to 16 [default: 3]
    ///
    /// Half the width of the square that is averaged; 0 reads one texel.
    #[arg(long, value_name = "TEXELS", value_parser = parse_softness)]
    pub(crate) shadow_softness: Option<NonNegative>,

    /// Darken cracks and corners: ambient occlusion in screen space
    ///
    /// Dims light from all around: the sky of the default lights, and ambient ones. Each of the options below switches it
    /// on too; --shader occlusion shows it alone.
    #[arg(long)]
    pub(crate) ssao: bool,

    /// How near a surface has to be to darken another [default: a fifth of the scene's radius]
    ///
    /// In units of the scene.
    #[arg(long, value_name = "DISTANCE")]
    pub(crate) ssao_radius: Option<Positive>,

    /// How much darker: 0 is none, above 1 exaggerates [default: 1]
    #[arg(long, value_name = "FACTOR", allow_hyphen_values = true)]
    pub(crate) ssao_strength: Option<NonNegative>,

    /// Neighbours looked at per pixel, 1 to 256: more is smoother [default: 32]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=256))]
    pub(crate) ssao_samples: Option<u32>,

    /// Steps of light in --shader toon, 1 to 16
    #[arg(long, value_name = "N", default_value = "3", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub(crate) toon_levels: u32,

    /// Draw lines around things and along their creases
    ///
    /// Each of the options below switches them on too.
    #[arg(long)]
    pub(crate) outline: bool,

    /// Colour of these lines [default: near black]
    #[arg(long, value_name = "COLOUR")]
    pub(crate) outline_color: Option<Color>,

    /// Their width, 1 to 32 pixels [default: 1.5]
    #[arg(long, value_name = "PIXELS", value_parser = parse_outline_width)]
    pub(crate) outline_width: Option<Positive>,

    /// How large a change makes a line: less finds more lines [default: 0.5]
    ///
    /// 1 is a crease of 60 degrees, or a step in depth of eight times the width of a pixel.
    #[arg(long, value_name = "CHANGE")]
    pub(crate) outline_threshold: Option<Positive>,
}

impl EffectOptions {
    /// The shadows that are asked for.
    pub(crate) fn shadows(&self) -> Option<Shadows> {
        let Self { shadow_map_size, shadow_bias, shadow_softness, .. } = self;
        let is_asked = self.shadows || shadow_map_size.is_some() || shadow_bias.is_some() || shadow_softness.is_some();
        let default = Shadows::default();
        is_asked.then(|| Shadows {
            map_size: shadow_map_size.unwrap_or(default.map_size),
            bias: shadow_bias.map(NonNegative::to_f32),
            softness: shadow_softness.map_or(default.softness, NonNegative::to_f32),
        })
    }
}

impl EffectOptions {
    /// The ambient occlusion that is asked for.
    pub(crate) fn ambient_occlusion(&self) -> Option<AmbientOcclusion> {
        let Self { ssao_radius, ssao_strength, ssao_samples, .. } = self;
        let is_asked = self.ssao || ssao_radius.is_some() || ssao_strength.is_some() || ssao_samples.is_some();
        let default = AmbientOcclusion::default();
        is_asked.then(|| AmbientOcclusion {
            radius: ssao_radius.map(Positive::to_f32),
            strength: ssao_strength.map_or(default.strength, NonNegative::to_f32),
            samples: ssao_samples.unwrap_or(default.samples),
        })
    }

    /// The outlines that are asked for.
    pub(crate) fn outline(&self) -> Option<Outline> {
        let Self { outline_color, outline_width, outline_threshold, .. } = self;
        let is_asked =
            self.outline || outline_color.is_some() || outline_width.is_some() || outline_threshold.is_some();
        let default = Outline::default();
        is_asked.then(|| Outline {
            color: outline_color.map_or(default.color, |color| color.to_linear_premultiplied()),
            width_px: outline_width.map_or(default.width_px, Positive::to_f32),
            threshold: outline_threshold.map_or(default.threshold, Positive::to_f32),
        })
    }
}

fn parse_outline_width(text: &str) -> Result<Positive, String> {
    let width: Positive = text.parse()?;
    let most = Outline::MAX_WIDTH;
    let fits = (1.0..=most).contains(&width.to_f32());
    if fits { Ok(width) } else { Err(format!("{text} is not within 1 to {most} pixels")) }
}

fn parse_softness(text: &str) -> Result<NonNegative, String> {
    let softness: NonNegative = text.parse()?;
    let most = Shadows::MAX_SOFTNESS;
    if softness.to_f32() <= most { Ok(softness) } else { Err(format!("{text} is more than {most} texels")) }
}
