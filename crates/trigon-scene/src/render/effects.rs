//! Settings of the effects that take passes of their own. Without them a frame does none of their work.

/// Shadows by shadow maps: one depth picture from each light, compared with at every lit point.
///
/// Every directional, point and spot light casts them, and of the default rig the key light; light from all around does
/// not.
/// Surfaces cast from both sides, where their opacity is at least one half; lines and points cast none.
///
/// Lance Williams, "Casting Curved Shadows on Curved Surfaces", 1978; softened by percentage-closer filtering (Reeves,
/// Salesin, Cook, "Rendering Antialiased Shadows with Depth Maps", 1987).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shadows {
    /// Texels along a side of each map, 1..=16 384. A map is fitted around the whole scene; a point light has six.
    pub map_size: u32,
    /// How far a surface is moved towards the light before it is compared, in world units. `None` moves it by about a
    /// texel of the map, which suits most models. More loses shadows where things touch (they seem to hover), less lets
    /// surfaces shade themselves in stripes.
    pub bias: Option<f32>,
    /// Half the width of the square of texels that are compared and averaged, 0 to [`Shadows::MAX_SOFTNESS`]: the edge
    /// of a shadow is about twice as wide. 0 reads one texel, for hard edges; 0.5 is bilinear.
    pub softness: f32,
}

impl Shadows {
    /// The largest softness that is drawn; a greater one counts as this.
    pub const MAX_SOFTNESS: f32 = 16.0;
}

impl Default for Shadows {
    /// Maps of 2048 texels a side, edges of about six texels, a fitted bias.
    fn default() -> Self {
        Self { map_size: 2048, bias: None, softness: 3.0 }
    }
}
