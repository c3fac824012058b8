//! Why an SVG file gives no picture.

use std::fmt;

use crate::canvas::DrawError;

/// Why an SVG file gives no picture.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum SvgError {
    /// The file is not SVG: not text, not XML, broken compression, or no `svg` element of any size.
    Malformed(String),
    /// The file asks for more than [`Limits`](super::Limits) allow; says what.
    LimitExceeded(String),
    /// No element that is drawn has this id.
    UnknownId(String),
    /// The element, or the drawing, has no extent that could be a picture.
    Empty,
    /// [`Options::deadline`](super::Options::deadline) came before the file was read.
    TimeOver,
    /// The picture could not be drawn.
    Draw(DrawError),
}

impl fmt::Display for SvgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Malformed(what) => write!(f, "not a valid SVG file: {what}"),
            Self::LimitExceeded(what) => write!(f, "{what}"),
            Self::UnknownId(id) => write!(f, "no element that is drawn has the id '{id}'"),
            Self::Empty => write!(f, "there is nothing to draw: the area has no width or no height"),
            Self::TimeOver => write!(f, "not read in the time allowed; allow more, or make the file simpler"),
            Self::Draw(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for SvgError {}

impl From<DrawError> for SvgError {
    fn from(error: DrawError) -> Self {
        Self::Draw(error)
    }
}
