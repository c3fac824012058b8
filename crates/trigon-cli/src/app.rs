//! From arguments to an exit code.

use crate::command;
use crate::deadline;
use crate::failure::Failure;
use crate::options::{Cli, Command, Given, Written, command_line_for, with_implied_render};
use crate::terminal::{self, Terminal};
use clap::FromArgMatches;
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the command line; the first argument is the program's name.
pub(crate) fn run(arguments: Vec<OsString>) -> ExitCode {
    let arguments = with_implied_render(arguments);
    let matches = command_line_for(&arguments).try_get_matches_from(&arguments);
    let read =
        matches.and_then(|matches| Ok((Cli::from_arg_matches(&matches)?, Given::of(&matches), Written::of(&matches))));
    let done = match read {
        Ok((cli, given, written)) => execute(&cli.command, given, &written, &arguments),
        // What was asked for: help or the version.
        Err(text) if !text.use_stderr() => terminal::write_stdout(text.render().to_string().as_bytes()),
        Err(error) => Err(Failure::Table(error.render().to_string())),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            Terminal::detect(false).failure(&failure);
            failure.exit_code()
        }
    }
}

fn execute(command: &Command, given: Given, written: &Written, arguments: &[OsString]) -> Result<(), Failure> {
    match command {
        Command::Render(options) => {
            deadline::start(options.render.machine.time_limit)?;
            command::render(options, given, written)
        }
        Command::Turntable(options) => {
            deadline::start(options.render.machine.time_limit)?;
            command::turntable(options)
        }
        Command::Compare(options) => {
            deadline::start(options.render.render.machine.time_limit)?;
            command::compare(options, given, arguments)
        }
        Command::Explain(options) => {
            deadline::start(options.render.machine.time_limit)?;
            command::explain(options, written)
        }
        Command::Completions(options) => command::completions(options),
        Command::Man(options) => command::man(options),
    }
}
