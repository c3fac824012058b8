//! Recoverable findings: returned beside the scene, never printed.

use super::{LoadError, Location, Place};
use std::fmt;

/// Something wrong or ignored in a file that loaded anyway.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// Where.
    pub location: Location,
    /// What sort of finding.
    pub kind: WarningKind,
    /// What was found and what was done about it.
    pub message: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.location, self.message)
    }
}

/// The sort of a [`Warning`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum WarningKind {
    /// A material library or texture could not be found or read.
    MissingFile,
    /// A material is used but defined nowhere.
    MissingMaterial,
    /// A face, line or point was left out, or an index of it.
    InvalidElement,
    /// A value could not be read or used; a default stands in.
    InvalidValue,
    /// A statement or property is not drawn by this library or not known to it. Never an error.
    Ignored,
    /// Further findings were not recorded one by one. Never an error.
    Suppressed,
}

impl WarningKind {
    /// Whether strict loading turns such a finding into an error.
    #[must_use]
    pub fn is_error_if_strict(self) -> bool {
        !matches!(self, Self::Ignored | Self::Suppressed)
    }
}

/// Collects the findings of one load; keeps the first [`Findings::MAX`] and counts the rest, so that a hostile file
/// cannot fill the memory with complaints.
#[derive(Debug)]
pub(crate) struct Findings {
    strict: bool,
    warnings: Vec<Warning>,
    suppressed: usize,
}

impl Findings {
    /// The number of findings kept.
    pub(crate) const MAX: usize = 100;

    pub(crate) fn new(strict: bool) -> Self {
        Self { strict, warnings: Vec::new(), suppressed: 0 }
    }

    /// Records a finding; an error if loading is strict and the kind demands it.
    pub(crate) fn warn(
        &mut self,
        file: &str,
        place: Place,
        kind: WarningKind,
        message: impl Into<String>,
    ) -> Result<(), LoadError> {
        let is_error = self.strict && kind.is_error_if_strict();
        if self.warnings.len() >= Self::MAX && !is_error {
            self.suppressed += 1;
            return Ok(());
        }
        let location = Location { file: file.to_owned(), place };
        let warning = Warning { location, kind, message: message.into() };
        if is_error {
            return Err(LoadError::Strict(warning));
        }
        self.warnings.push(warning);
        Ok(())
    }

    /// Counts findings that were dropped before they got here.
    pub(crate) fn suppress(&mut self, count: usize) {
        self.suppressed += count;
    }

    /// The findings in order, with a last one that counts what is not listed.
    pub(crate) fn into_warnings(mut self, file: &str) -> Vec<Warning> {
        if self.suppressed > 0 {
            let location = Location { file: file.to_owned(), place: Place::File };
            let message = format!("{} more warnings are not listed", self.suppressed);
            self.warnings.push(Warning { location, kind: WarningKind::Suppressed, message });
        }
        self.warnings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn findings_are_bounded_and_counted() {
        let mut findings = Findings::new(false);
        for line in 0..150 {
            findings.warn("a.obj", Place::Line(line), WarningKind::InvalidElement, "x").unwrap();
        }
        let warnings = findings.into_warnings("a.obj");
        assert_eq!(warnings.len(), 101);
        assert_eq!(warnings[100].message, "50 more warnings are not listed");
        assert_eq!(warnings[3].to_string(), "a.obj:3: x");
    }

    #[test]
    fn strict_loading_stops_at_the_first_fault_but_not_at_ignored_statements() {
        let mut findings = Findings::new(true);
        findings.warn("a.obj", Place::Line(1), WarningKind::Ignored, "x").unwrap();
        let error = findings.warn("a.obj", Place::Line(2), WarningKind::MissingFile, "no b.mtl").unwrap_err();
        assert_eq!(error.to_string(), "a.obj:2: no b.mtl (an error because loading is strict)");
    }
}
