//! Options of displacement: height maps as geometry.

use crate::values::{Positive, Real};
use clap::Args;
use trigon_scene::scene::Displacement;

#[derive(Debug, Args)]
#[command(next_help_heading = "Displacement")]
pub(crate) struct DisplacementOptions {
    /// Make geometry of height maps; SCALE is how far white moves [default: fitted]
    ///
    /// The maps are those of --height-map, or disp and map_Disp of the materials. SCALE is in units of the model; without
    /// it, white is a twentieth of the model's radius. Surfaces need texture coordinates.
    #[arg(long, value_name = "SCALE", num_args = 0..=1, require_equals = true, allow_hyphen_values = true)]
    pub(crate) displace: Option<Option<Real>>,

    /// The height that stays in place: 0 is black, 1 white
    #[arg(long, value_name = "HEIGHT", default_value = "0", allow_hyphen_values = true)]
    pub(crate) displace_middle: Real,

    /// Halve edges until they are no longer than this
    #[arg(long, value_name = "PIXELS", default_value = "2", value_parser = parse_edge)]
    pub(crate) displace_edge: Positive,

    /// Most triangles that displacement may make, such as 500k
    #[arg(long, value_name = "N", default_value = "4M")]
    pub(crate) displace_limit: crate::values::Count,
}

impl DisplacementOptions {
    /// The displacement that is asked for.
    pub(crate) fn displacement(&self) -> Option<Displacement> {
        let scale = self.displace?;
        Some(Displacement {
            scale: scale.map(Real::to_f32),
            middle: self.displace_middle.to_f32(),
            max_edge_px: self.displace_edge.to_f32(),
            max_triangles: usize::try_from(self.displace_limit.0).unwrap_or(usize::MAX),
        })
    }
}

/// Below this, triangles outnumber pixels a hundred times.
fn parse_edge(text: &str) -> Result<Positive, String> {
    let edge: Positive = text.parse()?;
    if edge.0 >= 0.1 { Ok(edge) } else { Err(format!("{text} is less than 0.1 pixels")) }
}
