//! How a texture is read: filters, wrapping, range of levels.

/// How a texture is filtered and what lies outside of it.
///
/// Any value of any field is valid: numbers out of range are clamped where they are used, NaN counts as 0.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sampler {
    /// Within a level, for magnification and minification alike.
    pub pixel: PixelFilter,
    /// Between levels.
    pub level: LevelFilter,
    /// Most samples along the long axis of a footprint, 1 to 16; 1 is isotropic.
    pub max_anisotropy: u8,
    /// Left and right of the image.
    pub wrap_u: Wrap,
    /// Above and below the image.
    pub wrap_v: Wrap,
    /// Added to the level of detail before it is clamped.
    pub lod_bias: f32,
    /// The smallest level of detail: 0 is the full image.
    pub lod_min: f32,
    /// The largest level of detail; the levels of the texture limit it further.
    pub lod_max: f32,
}

/// How texels of one level make a value.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum PixelFilter {
    /// The texel that holds the point.
    Nearest,
    /// The four texels whose centres surround the point, weighted by nearness along each axis.
    Bilinear,
}

/// Which levels are read, by the level of detail.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum LevelFilter {
    /// Level 0 always.
    Zero,
    /// The nearest level: floor(lod + 1/2).
    Nearest,
    /// The two levels around it, mixed by the fraction; with [`PixelFilter::Bilinear`], trilinear filtering.
    Linear,
}

/// What lies outside the image along one axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Wrap {
    /// The image again.
    Repeat,
    /// The image again, every other time mirrored.
    Mirror,
    /// The texels of the edge.
    ClampToEdge,
    /// One colour: linear light, premultiplied if the texture's samples are.
    Border([f32; 4]),
}

impl Sampler {
    /// Trilinear, isotropic, repeating: the usual way to texture a model.
    pub const TRILINEAR: Self = Self {
        pixel: PixelFilter::Bilinear,
        level: LevelFilter::Linear,
        max_anisotropy: 1,
        wrap_u: Wrap::Repeat,
        wrap_v: Wrap::Repeat,
        lod_bias: 0.0,
        lod_min: 0.0,
        lod_max: 1000.0,
    };

    /// The texel of level 0 that holds the point, repeating.
    pub const NEAREST: Self = Self { pixel: PixelFilter::Nearest, level: LevelFilter::Zero, ..Self::TRILINEAR };

    /// The same with other filters.
    #[must_use]
    pub const fn with_filters(self, pixel: PixelFilter, level: LevelFilter) -> Self {
        Self { pixel, level, ..self }
    }

    /// The same with one wrap mode on both axes.
    #[must_use]
    pub const fn with_wrap(self, wrap: Wrap) -> Self {
        Self { wrap_u: wrap, wrap_v: wrap, ..self }
    }

    /// The same with another limit of samples along the long axis of a footprint.
    #[must_use]
    pub const fn with_anisotropy(self, max_anisotropy: u8) -> Self {
        Self { max_anisotropy, ..self }
    }

    #[inline(always)]
    pub(super) fn has_border(&self) -> bool {
        matches!(self.wrap_u, Wrap::Border(_)) || matches!(self.wrap_v, Wrap::Border(_))
    }
}

impl Default for Sampler {
    fn default() -> Self {
        Self::TRILINEAR
    }
}
