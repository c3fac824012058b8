//! The notes about a fragment, as plain data.

/// One step of a fragment's computation.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum Note {
    /// What the notes that follow belong to, such as the light of this number.
    Topic {
        /// In a word or two.
        name: &'static str,
        /// Which one, where there are several.
        number: Option<u32>,
    },
    /// A value: one number, or the components of a vector or colour.
    Value {
        /// In a word or two.
        name: &'static str,
        /// One to four.
        values: Vec<f32>,
    },
    /// A texture was read.
    Texture(TextureRead),
}

/// One read of a texture, from its footprint to its colour.
///
/// The colour is the mean of its taps; a tap is the sum of its levels, a level that of its texels, each times its weight.
#[derive(Clone, PartialEq, Debug)]
pub struct TextureRead {
    /// Width and height of level 0, in texels.
    pub size: [u32; 2],
    /// How many levels there are.
    pub levels: u32,
    /// Where it is read; v down.
    pub uv: [f32; 2],
    /// Change of uv per pixel to the right and per pixel down; `None` where the shader gave the level itself.
    pub footprint: Option<[[f32; 2]; 2]>,
    /// The level of detail after bias and clamps.
    pub lod: f32,
    /// The points that are read and averaged: several along the long axis of an anisotropic footprint.
    pub taps: Vec<Tap>,
    /// The result: linear light, premultiplied if alpha is coverage.
    pub color: [f32; 4],
}

/// One point of a texture read.
#[derive(Clone, PartialEq, Debug)]
pub struct Tap {
    /// Where.
    pub uv: [f32; 2],
    /// One level, or two.
    pub levels: Vec<LevelRead>,
}

/// What one mip level gives to a tap.
#[derive(Clone, PartialEq, Debug)]
pub struct LevelRead {
    /// 0 is the full image.
    pub level: u32,
    /// Width and height in texels.
    pub size: [u32; 2],
    /// The share of the tap.
    pub weight: f32,
    /// One texel, or four.
    pub texels: Vec<TexelRead>,
}

/// What one texel gives to a level.
#[derive(Clone, PartialEq, Debug)]
pub struct TexelRead {
    /// From the left.
    pub column: u32,
    /// From the top.
    pub row: u32,
    /// The share of the level.
    pub weight: f32,
    /// As filters see it: linear light, premultiplied if alpha is coverage.
    pub color: [f32; 4],
    /// The point lies outside of the image, and the border colour stands in for the texel.
    pub is_border: bool,
}

/// What the pipeline hands to the fragment shader.
#[derive(Clone, PartialEq, Debug)]
pub struct FragmentFacts {
    /// Framebuffer position of the shading point, in pixels.
    pub point: [f32; 2],
    /// Perspective-correct weights of the primitive's corners; they sum to one.
    pub barycentric: [f32; 3],
    /// 1/w, interpolated linearly in the framebuffer.
    pub inverse_w: f32,
    /// NDC depth: 1 near, 0 far.
    pub depth: f32,
    /// The vertices appear counter-clockwise.
    pub is_front: bool,
    /// The interpolated components, in the order of the shader's declaration.
    pub varyings: Vec<VaryingFacts>,
}

/// One component of a varying.
#[derive(Clone, PartialEq, Debug)]
pub struct VaryingFacts {
    /// Field and component, such as `normal.x`.
    pub name: String,
    /// At the shading point.
    pub value: f32,
    /// Its exact change per pixel to the right.
    pub dx: f32,
    /// Its exact change per pixel down.
    pub dy: f32,
}
