//! The command line as a whole: `trigon COMMAND ..`, and the rule that lets `render` be left out.

use super::{CompareOptions, ExplainOptions, RenderCommandOptions, TurntableOptions, texts};
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// The widest line of a help page.
const HELP_WIDTH: usize = 79;

/// Draws 3D models and SVG to pictures on the CPU, bit for bit the same on every machine
#[derive(Debug, Parser)]
#[command(
    name = "trigon",
    version,
    before_help = texts::MAIN_EXAMPLES,
    after_long_help = texts::EXIT_CODES,
    after_help = "trigon MODEL.. is short for trigon render MODEL..",
    subcommand_required = true,
    arg_required_else_help = true
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Draw models, or an SVG file, to a picture
    #[command(before_help = texts::RENDER_EXAMPLES, after_help = texts::RENDER_NOTES)]
    Render(Box<RenderCommandOptions>),
    /// Draw a model turning around, as an animation or numbered pictures
    #[command(before_help = texts::TURNTABLE_EXAMPLES, after_help = texts::TURNTABLE_NOTES)]
    Turntable(Box<TurntableOptions>),
    /// Draw every combination of some options, side by side on a sheet
    #[command(before_help = texts::COMPARE_EXAMPLES, after_help = texts::COMPARE_NOTES)]
    Compare(Box<CompareOptions>),
    /// Tell how one pixel of a model's picture comes about, step by step
    #[command(before_help = texts::EXPLAIN_EXAMPLES, after_help = texts::EXPLAIN_NOTES)]
    Explain(Box<ExplainOptions>),
    /// Print the completion script of a shell
    #[command(before_help = texts::COMPLETIONS_EXAMPLES)]
    Completions(CompletionsOptions),
    /// Print a manual page in roff format
    #[command(before_help = texts::MAN_EXAMPLES)]
    Man(ManOptions),
}

/// Options of `trigon completions`.
#[derive(Debug, clap::Args)]
pub(crate) struct CompletionsOptions {
    /// The shell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

/// Options of `trigon man`.
#[derive(Debug, clap::Args)]
pub(crate) struct ManOptions {
    /// The command that the page is about; trigon itself if left out
    pub(crate) command: Option<String>,
}

/// The table of all commands and options, ready to parse, to print or to complete.
pub(crate) fn command_line() -> clap::Command {
    let with_layout = |command: clap::Command| command.help_template(texts::TEMPLATE).max_term_width(HELP_WIDTH);
    with_layout(Cli::command()).mut_subcommands(|subcommand| match subcommand.get_name() {
        // An animation has many frames: a smaller default.
        "turntable" => with_layout(subcommand).mut_arg("size", |size| size.default_value("512x512")),
        "compare" => with_layout(subcommand).mut_arg("size", |size| size.default_value("320x240")),
        "explain" => with_layout(subcommand)
            .mut_arg("output", |output| {
                let output = output.required(false).default_value("-").hide_default_value(true);
                output.help("Picture to draw of the pixel, in place of text").long_help(texts::EXPLAIN_OUTPUT)
            })
            .mut_arg("json", |json| {
                json.help("The story as JSON, to standard output or to FILE").long_help(texts::EXPLAIN_JSON)
            }),
        _ => with_layout(subcommand),
    })
}

/// Inserts `render` where the first argument is no command: `trigon model.obj` means `trigon render model.obj`.
///
/// A word that looks like neither a file nor an option stays, so that a misspelt command is reported as such.
pub(crate) fn with_implied_render(mut arguments: Vec<OsString>) -> Vec<OsString> {
    if arguments.get(1).is_some_and(|first| implies_render(first)) {
        arguments.insert(1, OsString::from("render"));
    }
    arguments
}

fn implies_render(first: &OsStr) -> bool {
    match first.to_str() {
        Some("-h" | "--help" | "-V" | "--version" | "help") => false,
        Some(word) if Cli::command().find_subcommand(word).is_some() => false,
        Some(word) if word.starts_with('-') => true,
        _ => {
            let path = Path::new(first);
            path.extension().is_some() || path.components().count() > 1 || path.exists()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn implied(arguments: &[&str]) -> Vec<OsString> {
        with_implied_render(arguments.iter().map(OsString::from).collect())
    }

    #[test]
    fn the_table_is_consistent() {
        command_line().debug_assert();
    }

    #[test]
    fn render_is_implied_for_files_and_options_only() {
        for arguments in [["trigon", "a.obj"], ["trigon", "-o"], ["trigon", "-"], ["trigon", "dir/model"]] {
            assert_eq!(implied(&arguments)[1], "render", "{arguments:?}");
        }
        for arguments in [["trigon", "turntable"], ["trigon", "--help"], ["trigon", "-V"], ["trigon", "rendr"]] {
            assert_eq!(implied(&arguments), arguments);
        }
        assert_eq!(implied(&["trigon"]), ["trigon"]);
    }
}
