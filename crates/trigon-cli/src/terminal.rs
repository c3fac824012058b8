//! Standard output and standard error: the only module that writes to them.
//!
//! Data goes to standard output, everything meant for a person to standard error. A closed standard output ends the
//! command quietly; a closed standard error is ignored.

use crate::failure::Failure;
use std::env;
use std::io::{self, ErrorKind, IsTerminal, Write};

/// How to talk to the person at the terminal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Terminal {
    is_colored: bool,
    is_quiet: bool,
    shows_progress: bool,
}

impl Terminal {
    /// Colours and progress where standard error is a terminal that can show them.
    pub(crate) fn detect(is_quiet: bool) -> Self {
        let is_set = |name: &str| env::var_os(name).is_some_and(|value| !value.is_empty());
        let is_dumb = env::var_os("TERM").is_some_and(|term| term == "dumb");
        let is_capable = io::stderr().is_terminal() && !is_dumb;
        Self { is_colored: is_capable && !is_set("NO_COLOR"), is_quiet, shows_progress: is_capable && !is_quiet }
    }

    /// Whether a progress bar is seen.
    pub(crate) fn shows_progress(self) -> bool {
        self.shows_progress
    }

    /// `warning: file:line: ..`, unless quiet.
    pub(crate) fn warning(self, message: &str) {
        if !self.is_quiet {
            self.message("warning", "33", message);
        }
    }

    /// `error: ..`
    pub(crate) fn failure(self, failure: &Failure) {
        match failure {
            Failure::ClosedPipe => {}
            Failure::Table(text) => match text.strip_prefix("error: ") {
                Some(message) => self.message("error", "31", message),
                None => self.note(text.trim_end()),
            },
            Failure::Work(message) => self.message("error", "31", message),
            Failure::Usage(message) => {
                self.message("error", "31", message);
                self.note("\nFor more information, try '--help'.");
            }
        }
    }

    /// A line of its own to standard error.
    pub(crate) fn note(self, line: &str) {
        to_stderr(&format!("{line}\n"));
    }

    /// Replaces the current line of the terminal; an empty one clears it.
    pub(crate) fn status(self, line: &str) {
        if self.shows_progress {
            to_stderr(&format!("\r{line}\x1b[K"));
        }
    }

    fn message(self, kind: &str, color: &str, message: &str) {
        // A status line may be showing: start at the left and clear what is there.
        let clear = if self.shows_progress { "\r\x1b[K" } else { "" };
        to_stderr(&format!("{clear}{}\n", labelled(kind, self.is_colored.then_some(color), message)));
    }
}

/// `kind: message`, the kind bold and in a colour (an SGR code) if there is one.
fn labelled(kind: &str, color: Option<&str>, message: &str) -> String {
    let message = printable(message.trim_end());
    match color {
        Some(color) => format!("\x1b[1;{color}m{kind}:\x1b[0m {message}"),
        None => format!("{kind}: {message}"),
    }
}

/// Names in files may hold anything, but must not control the terminal.
fn printable(message: &str) -> String {
    message.replace(|c: char| c.is_control() && c != '\n' && c != '\t', "\u{fffd}")
}

fn to_stderr(text: &str) {
    // There is nowhere left to report a failure to.
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Writes to standard output, all of it.
pub(crate) fn write_stdout(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Failure::ClosedPipe,
        _ => Failure::work(format!("cannot write to standard output: {error}")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_optional() {
        assert_eq!(labelled("error", None, "no such file\n"), "error: no such file");
        assert_eq!(labelled("error", Some("31"), "x"), "\u{1b}[1;31merror:\u{1b}[0m x");
    }

    #[test]
    fn names_cannot_control_the_terminal() {
        assert_eq!(labelled("error", None, "\u{1b}[2Ja\u{9b}b\r\n\tc"), "error: \u{fffd}[2Ja\u{fffd}b\u{fffd}\n\tc");
    }
}
