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

/// Ambient occlusion in screen space: light from all around does not reach cracks and corners.
///
/// It dims the default rig's sky and ambient lights, not light that has a direction (that is what shadows are for).
/// What stands outside of the picture, or behind what is seen, hides nothing. Martin Mittring, "Finding Next Gen:
/// CryEngine 2", 2007; estimated as in McGuire, Mara, Luebke, "Scalable Ambient Obscurance", 2012.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmbientOcclusion {
    /// How far away a surface can be to count, in world units. `None` is [`AmbientOcclusion::FITTED_RADIUS`] of the scene's
    /// radius.
    pub radius: Option<f32>,
    /// How much darker: 0 is none, 1 is about as much as light would be missing, more exaggerates.
    pub strength: f32,
    /// Neighbours that are looked at per pixel, and as many for each pixel that the blur averages, 1 to [`AmbientOcclusion::MAX_SAMPLES`].
    pub samples: u32,
}

impl AmbientOcclusion {
    /// The default radius, as a part of half the diagonal of the box around the scene.
    pub const FITTED_RADIUS: f32 = 0.2;
    /// The most samples that are taken; more count as these.
    pub const MAX_SAMPLES: u32 = 256;
}

impl Default for AmbientOcclusion {
    /// A fitted radius, plain strength, 32 samples.
    fn default() -> Self {
        Self { radius: None, strength: 1.0, samples: 32 }
    }
}

/// Lines around things and along their creases, as in drawings.
///
/// A line is drawn where the object, the depth or the normal changes abruptly from pixel to pixel: where a Sobel filter
/// (Irwin Sobel and Gary Feldman, 1968) over the visible surfaces finds more than a threshold. (Saito and Takahashi,
/// "Comprehensible Rendering of 3-D Shapes", 1990.) Lines and points have no outlines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    /// Linear light, premultiplied by alpha.
    pub color: [f32; 4],
    /// Width of the lines in pixels, up to [`Outline::MAX_WIDTH`]. None is thinner than a pixel of the filter: half a pixel
    /// of the picture on either side of an edge.
    pub width_px: f32,
    /// How large a change has to be, above 0: 1 is a crease of 60 degrees, or a step in depth of eight pixels' width. Less
    /// finds more lines.
    pub threshold: f32,
}

impl Outline {
    /// The widest line that is drawn, in pixels; a wider one counts as this.
    pub const MAX_WIDTH: f32 = 32.0;
}

impl Default for Outline {
    /// Near black lines of one and a half pixels at clear edges.
    fn default() -> Self {
        Self { color: [0.01, 0.01, 0.012, 1.0], width_px: 1.5, threshold: 0.5 }
    }
}
