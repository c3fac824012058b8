//! One number of each pixel: for maps of heights, opacities and exponents.

use super::Channel;

/// Where a scalar map takes its number from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum ScalarSource {
    /// One channel.
    Red,
    Green,
    Blue,
    Alpha,
    /// The weighted sum of the channels as stored (Rec. 709 weights).
    Luminance,
    /// Alpha if the picture has any, else luminance: what people mean by an opacity map.
    #[cfg_attr(not(feature = "render"), expect(dead_code, reason = "a choice of those who upload textures"))]
    AlphaOrLuminance,
}

impl ScalarSource {
    /// The channel of `-imfchan`, or else `default`.
    pub(crate) fn new(channel: Option<Channel>, default: Self) -> Self {
        match channel {
            None => default,
            Some(Channel::Red | Channel::Depth) => Self::Red,
            Some(Channel::Green) => Self::Green,
            Some(Channel::Blue) => Self::Blue,
            Some(Channel::Matte) => Self::Alpha,
            Some(Channel::Luminance) => Self::Luminance,
        }
    }

    /// The number of a pixel; of one that has alpha, where that is preferred.
    pub(crate) fn of(self, [r, g, b, a]: [f32; 4]) -> f32 {
        match self {
            Self::Red => r,
            Self::Green => g,
            Self::Blue => b,
            Self::Alpha => a,
            Self::Luminance | Self::AlphaOrLuminance => (0.2126 * r + 0.7152 * g) + 0.0722 * b,
        }
    }
}
