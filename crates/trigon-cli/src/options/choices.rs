//! Options whose values are one of a few words.

use clap::ValueEnum;

/// Which triangles are left out by the side they show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum CullChoice {
    /// Draw both sides
    None,
    /// Leave out back faces
    Back,
    /// Leave out front faces
    Front,
}

/// How edges are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum WireframeChoice {
    /// Edges over the shaded surface
    Over,
    /// Edges alone, those behind the surface too
    Only,
    /// Edges alone, those behind the surface left out
    Hidden,
}

/// Where in a pixel its samples lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PatternChoice {
    /// The rotated positions of Direct3D and Vulkan: 1, 2, 4, 8, 16
    Standard,
    /// A regular grid: 1, 4, 9, 16
    Grid,
}

/// How often a pixel is shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RateChoice {
    /// Once per pixel and triangle (multisampling)
    Pixel,
    /// Once per sample (supersampling)
    Sample,
}

/// What colours are while they are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorSpaceChoice {
    /// Linear light, encoded at the end
    Linear,
    /// Values as they are stored
    Encoded,
}

/// How attributes vary over triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum InterpolationChoice {
    /// Linearly over the surface, right in perspective
    Perspective,
    /// Linearly over the picture, as early hardware does
    Affine,
}

/// Where in its pixel a sample lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlaceChoice {
    /// Where it should
    Middle,
    /// Where whole coordinates are, if y runs up
    LowerLeft,
    /// Where whole coordinates are, if y runs down
    UpperLeft,
}

/// How texels of one mip level are combined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PixelFilterChoice {
    /// The texel that holds the point
    Nearest,
    /// The four texels around it, weighted
    Bilinear,
}

/// Which mip levels are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LevelFilterChoice {
    /// The full image always
    Zero,
    /// The level of nearest size
    Nearest,
    /// The two levels around it, mixed (trilinear)
    Linear,
}

/// What lies outside a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum WrapChoice {
    /// The image again
    Repeat,
    /// The image again, every other time mirrored
    Mirror,
    /// The colour of the edge
    Clamp,
    /// Nothing: transparent black
    Border,
}

/// The format of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum InputFormat {
    /// Wavefront OBJ
    Obj,
    /// STL, text or binary
    Stl,
    /// PLY, text or binary
    Ply,
}

/// Bits of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum BitDepth {
    /// Integers of 8 bits
    #[value(name = "8")]
    Eight,
    /// Integers of 16 bits; half floats in EXR
    #[value(name = "16")]
    Sixteen,
    /// Floats, EXR only
    #[value(name = "32")]
    ThirtyTwo,
}

/// Time spent on a smaller file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Compression {
    /// Least time
    Fast,
    /// Somewhat smaller, several times slower
    Balanced,
    /// Smallest
    Best,
}
