//! What can go wrong, split by whose fault it is: the machine's, the file's, ours, or the caller's limits.

use std::borrow::Cow;
use std::fmt;
use std::io;

use crate::Format;

/// Why a picture could not be decoded.
#[derive(Debug)]
#[non_exhaustive]
pub enum DecodeError {
    /// Reading failed; trying again may help.
    Io(io::Error),
    /// The file breaks the specification of its format.
    Malformed {
        /// The format it was read as.
        format: Format,
        /// Where, in bytes from the start of the file, if the decoder can tell.
        offset: Option<u64>,
        /// The rule that is broken.
        rule: Cow<'static, str>,
    },
    /// The file may be valid, but this crate cannot read it.
    Unsupported {
        /// The format it was read as; `None` if it was not recognized.
        format: Option<Format>,
        /// The feature that is missing.
        feature: Cow<'static, str>,
    },
    /// The picture is larger than the caller's [`Limits`](crate::Limits).
    LimitExceeded {
        /// The name of the field of `Limits`.
        limit: &'static str,
        /// What the file asks for.
        asked: u64,
        /// What the caller allows.
        allowed: u64,
    },
}

impl DecodeError {
    /// A broken rule at a known offset.
    pub(crate) fn malformed(format: Format, offset: usize, rule: impl Into<Cow<'static, str>>) -> Self {
        Self::Malformed { format, offset: Some(offset as u64), rule: rule.into() }
    }

    /// A broken rule found by a decoder that does not say where.
    pub(crate) fn malformed_somewhere(format: Format, rule: impl Into<Cow<'static, str>>) -> Self {
        Self::Malformed { format, offset: None, rule: rule.into() }
    }

    pub(crate) fn unsupported(format: Format, feature: impl Into<Cow<'static, str>>) -> Self {
        Self::Unsupported { format: Some(format), feature: feature.into() }
    }
}

impl fmt::Display for DecodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "cannot read the picture: {error}"),
            Self::Malformed { format, offset: Some(offset), rule } => {
                write!(f, "malformed {format} at byte {offset}: {rule}")
            }
            Self::Malformed { format, offset: None, rule } => write!(f, "malformed {format}: {rule}"),
            Self::Unsupported { format: Some(format), feature } => write!(f, "unsupported {format}: {feature}"),
            Self::Unsupported { format: None, feature } => write!(f, "unsupported picture: {feature}"),
            Self::LimitExceeded { limit, asked, allowed } => {
                write!(f, "the picture needs {limit} of {asked}, the limit is {allowed}")
            }
        }
    }
}

impl std::error::Error for DecodeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for DecodeError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

/// Why a picture could not be encoded.
#[derive(Debug)]
#[non_exhaustive]
pub enum EncodeError {
    /// Writing failed; trying again may help.
    Io(io::Error),
    /// The format cannot hold this picture, or this crate does not write the format.
    Unsupported {
        /// The format asked for.
        format: Format,
        /// What it cannot do.
        feature: Cow<'static, str>,
    },
    /// The call is wrong: an empty picture, a frame of another size, a channel of the wrong length.
    Invalid {
        /// The format asked for.
        format: Format,
        /// The rule that is broken.
        rule: Cow<'static, str>,
    },
}

impl EncodeError {
    pub(crate) fn unsupported(format: Format, feature: impl Into<Cow<'static, str>>) -> Self {
        Self::Unsupported { format, feature: feature.into() }
    }

    pub(crate) fn invalid(format: Format, rule: impl Into<Cow<'static, str>>) -> Self {
        Self::Invalid { format, rule: rule.into() }
    }
}

impl fmt::Display for EncodeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io(error) => write!(f, "cannot write the picture: {error}"),
            Self::Unsupported { format, feature } => write!(f, "cannot write {format}: {feature}"),
            Self::Invalid { format, rule } => write!(f, "cannot write this as {format}: {rule}"),
        }
    }
}

impl std::error::Error for EncodeError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for EncodeError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}
