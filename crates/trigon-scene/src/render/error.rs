//! Why a scene could not be drawn.

use std::fmt;
use trigon::pipeline::FrameError;
use trigon::target::MAX_SIZE;

/// Why a scene could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RenderError {
    /// The size of the picture or the number of primitives is out of range, or the time is over.
    Frame(FrameError),
    /// Shadow maps of this many texels a side, outside 1..=16 384.
    ShadowMapSize(u32),
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Frame(error) => write!(f, "{error}"),
            Self::ShadowMapSize(size) => {
                write!(f, "shadow maps of {size} texels a side are outside 1..={MAX_SIZE}; ask for another size")
            }
        }
    }
}

impl std::error::Error for RenderError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Frame(error) => Some(error),
            Self::ShadowMapSize(_) => None,
        }
    }
}

impl From<FrameError> for RenderError {
    fn from(error: FrameError) -> Self {
        Self::Frame(error)
    }
}
