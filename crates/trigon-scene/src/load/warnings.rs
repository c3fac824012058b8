//! Recoverable findings: returned beside the scene, never printed.

use super::{LoadError, Location, Place};
use std::collections::HashMap;
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
    /// A face that crosses itself is drawn as well as possible. Never an error.
    Approximated,
    /// The file holds nothing to draw.
    Empty,
    /// A statement or property is not drawn by this library or not known to it. Never an error.
    Ignored,
    /// Further findings were not recorded one by one. Never an error.
    Suppressed,
}

impl WarningKind {
    /// Whether strict loading turns such a finding into an error.
    #[must_use]
    pub fn is_error_if_strict(self) -> bool {
        !matches!(self, Self::Approximated | Self::Ignored | Self::Suppressed)
    }
}

/// Collects the findings of one load; keeps the first [`Findings::MAX`] and counts the rest, so that a hostile file
/// cannot fill the memory with complaints.
#[derive(Debug)]
pub(crate) struct Findings {
    strict: bool,
    warnings: Vec<Warning>,
    /// How often each message occurred, in each file.
    repetitions: HashMap<(String, String), usize>,
    suppressed: usize,
}

impl Findings {
    /// The number of findings kept.
    pub(crate) const MAX: usize = 100;

    /// The number of findings kept that say the same of different places.
    const MAX_REPETITIONS: usize = 3;

    pub(crate) fn new(strict: bool) -> Self {
        Self { strict, warnings: Vec::new(), repetitions: HashMap::new(), suppressed: 0 }
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
        let message = message.into();
        if !is_error {
            if self.warnings.len() >= Self::MAX {
                self.suppressed += 1;
                return Ok(());
            }
            let repetitions = self.repetitions.entry((file.to_owned(), message.clone())).or_default();
            *repetitions += 1;
            if *repetitions > Self::MAX_REPETITIONS {
                return Ok(());
            }
        }
        let location = Location { file: file.to_owned(), place };
        let warning = Warning { location, kind, message };
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

    /// The findings: those of the model `file` by line, then those of its side files; repetitions are counted at the
    /// last one listed, and a last one counts what is not listed.
    pub(crate) fn into_warnings(mut self, file: &str) -> Vec<Warning> {
        for warning in self.warnings.iter_mut().rev() {
            let key = (warning.location.file.clone(), warning.message.clone());
            let repetitions = self.repetitions.remove(&key).unwrap_or(0);
            if repetitions > Self::MAX_REPETITIONS {
                let more = repetitions - Self::MAX_REPETITIONS;
                warning.message = format!("{} (and {more} more like this)", warning.message);
            }
        }
        self.warnings.sort_by_key(|warning| match warning.location.file == file {
            true => (0, warning.location.place == Place::File, warning.location.place),
            false => (1, false, Place::File),
        });
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
            findings.warn("a.obj", Place::Line(line), WarningKind::InvalidElement, line.to_string()).unwrap();
        }
        let warnings = findings.into_warnings("a.obj");
        assert_eq!(warnings.len(), 101);
        assert_eq!(warnings[100].message, "50 more warnings are not listed");
        assert_eq!(warnings[3].to_string(), "a.obj:3: 3");
    }

    #[test]
    fn repetitions_are_counted_at_the_last_one_listed() {
        let mut findings = Findings::new(false);
        findings.warn("a.mtl", Place::Line(1), WarningKind::Ignored, "x").unwrap();
        for line in [9, 8, 7, 6, 5] {
            findings.warn("a.obj", Place::Line(line), WarningKind::Ignored, "x").unwrap();
        }
        let shown: Vec<_> = findings.into_warnings("a.obj").iter().map(ToString::to_string).collect();
        assert_eq!(shown, ["a.obj:7: x (and 2 more like this)", "a.obj:8: x", "a.obj:9: x", "a.mtl:1: x"]);
    }

    #[test]
    fn strict_loading_stops_at_the_first_fault_but_not_at_ignored_statements() {
        let mut findings = Findings::new(true);
        findings.warn("a.obj", Place::Line(1), WarningKind::Ignored, "x").unwrap();
        let error = findings.warn("a.obj", Place::Line(2), WarningKind::MissingFile, "no b.mtl").unwrap_err();
        assert_eq!(error.to_string(), "a.obj:2: no b.mtl (an error because loading is strict)");
    }
}
