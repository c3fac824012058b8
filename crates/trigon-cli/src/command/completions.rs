//! `trigon completions`: the completion script of a shell, from the option table.

use crate::failure::Failure;
use crate::options::{CompletionsOptions, command_line};
use crate::terminal;

pub(crate) fn completions(options: &CompletionsOptions) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut command_line(), "trigon", &mut script);
    terminal::write_stdout(&script)
}
