//! Options of effects that take passes of their own.

use crate::values::NonNegative;
use clap::Args;
use trigon_scene::render::Shadows;

#[derive(Debug, Args)]
#[command(next_help_heading = "Shadows")]
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

fn parse_softness(text: &str) -> Result<NonNegative, String> {
    let softness: NonNegative = text.parse()?;
    let most = Shadows::MAX_SOFTNESS;
    if softness.to_f32() <= most { Ok(softness) } else { Err(format!("{text} is more than {most} texels")) }
}
