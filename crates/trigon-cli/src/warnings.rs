//! Warnings as they are told: with the file that each is about; and errors where the person wants them to be.

use crate::failure::Failure;
use std::fmt::Display;
use std::path::Path;

/// What is odd about a file, each with its name.
pub(crate) fn about<'a>(
    file: &'a Path,
    warnings: impl IntoIterator<Item = impl Display> + 'a,
) -> impl Iterator<Item = String> + 'a {
    warnings.into_iter().map(|warning| format!("{}: {warning}", file.display()))
}

/// The error that `--strict` makes of a warning.
pub(crate) fn strict(warning: &impl Display) -> Failure {
    Failure::work(format!("{warning} (an error because of --strict)"))
}
