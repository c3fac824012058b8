//! Why a file could not be loaded: what, where, and whose fault it is.

use super::Warning;
use std::fmt;
use std::io;

/// A place in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Location {
    /// The file's name as it was given or found.
    pub file: String,
    /// Where in it.
    pub place: Place,
}

/// Where in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of a text file; the first is 1.
    Line(u64),
    /// A byte of a binary file, after decompression; the first is 0.
    Byte(u64),
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Place::File => write!(f, "{}", self.file),
            Place::Line(line) => write!(f, "{}:{line}", self.file),
            Place::Byte(byte) => write!(f, "{} at byte {byte}", self.file),
        }
    }
}

/// Why a file could not be loaded.
#[derive(Debug)]
#[non_exhaustive]
pub enum LoadError {
    /// The file could not be read; trying again may help.
    Io {
        /// The file.
        file: String,
        /// The system's reason.
        source: io::Error,
    },
    /// The file breaks its format.
    Malformed {
        /// Where.
        location: Location,
        /// What is wrong and what was expected.
        message: String,
    },
    /// The file may be valid, but this library does not read it.
    Unsupported {
        /// Where.
        location: Location,
        /// What is not supported.
        message: String,
    },
    /// Loading would exceed one of the caller's [`Limits`](super::Limits).
    LimitExceeded {
        /// The file.
        file: String,
        /// The field of `Limits`.
        limit: &'static str,
        /// Its value.
        allowed: u64,
    },
    /// A finding that is a warning unless [`LoadOptions::strict`](super::LoadOptions::strict) is set.
    Strict(Warning),
}

impl LoadError {
    pub(crate) fn malformed(file: &str, place: Place, message: impl Into<String>) -> Self {
        Self::Malformed { location: Location { file: file.to_owned(), place }, message: message.into() }
    }

    pub(crate) fn unsupported(file: &str, message: impl Into<String>) -> Self {
        Self::Unsupported { location: Location { file: file.to_owned(), place: Place::File }, message: message.into() }
    }

    pub(crate) fn limit(file: &str, limit: &'static str, allowed: u64) -> Self {
        Self::LimitExceeded { file: file.to_owned(), limit, allowed }
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Io { file, source } => write!(f, "cannot read {file}: {source}"),
            Self::Malformed { location, message } | Self::Unsupported { location, message } => {
                write!(f, "{location}: {message}")
            }
            Self::LimitExceeded { file, limit, allowed } => {
                write!(f, "{file}: exceeds the limit {limit} = {allowed}; raise it if the file is trusted")
            }
            Self::Strict(warning) => write!(f, "{warning} (an error because loading is strict)"),
        }
    }
}

impl std::error::Error for LoadError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Io { source, .. } => Some(source),
            _ => None,
        }
    }
}
