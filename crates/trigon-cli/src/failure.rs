//! Why the command ends early, and the exit code that says so.

use std::process::ExitCode;

/// Why the command ends early.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The command line is wrong: exit code 2.
    Usage(String),
    /// The same, found by the option table: the whole text, as it explains itself.
    Table(String),
    /// Something could not be read, drawn or written: exit code 1.
    Work(String),
    /// Who read our standard output went away: nothing to report, nobody to report to.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn usage(message: impl Into<String>) -> Self {
        Self::Usage(message.into())
    }

    pub(crate) fn work(message: impl Into<String>) -> Self {
        Self::Work(message.into())
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::ClosedPipe => ExitCode::SUCCESS,
            Self::Work(_) => ExitCode::FAILURE,
            Self::Usage(_) | Self::Table(_) => ExitCode::from(2),
        }
    }
}
