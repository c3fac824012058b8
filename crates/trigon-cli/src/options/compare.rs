//! Options of `trigon compare`: those of a picture, what is varied, and what is shown enlarged.

use super::{Given, RenderCommandOptions, Written, command_line, command_line_for};
use crate::values::{Axis, Inset};
use clap::{Args, FromArgMatches};
use std::ffi::OsString;

#[derive(Debug, Args)]
pub(crate) struct CompareOptions {
    /// Option to vary, and its values; repeatable
    ///
    /// NAME is the long name of an option of trigon render, such as samples, pattern, shading, pixel-filter,
    /// level-filter, anisotropy, wrap, shader or azimuth; VALUES are written as on the command line, with commas between
    /// them, or with semicolons if they have commas in them. Every combination of several options is drawn: the last
    /// one goes along the rows of the sheet.
    #[arg(long = "vary", value_name = "NAME=VALUES", required = true, allow_hyphen_values = true)]
    pub(crate) axes: Vec<Axis>,

    /// Square to show enlarged beside each picture: left column, top row and side, in pixels
    #[arg(long, value_name = "X,Y,SIZE")]
    pub(crate) inset: Option<Inset>,

    /// Leave out the times; the sheet is then the same on every machine
    #[arg(long)]
    pub(crate) no_times: bool,

    #[command(flatten)]
    pub(crate) render: RenderCommandOptions,
}

/// Headings of options that change the picture or its time.
const VARIED_HEADINGS: [&str; 8] =
    ["Picture", "View", "Surface and light", "Effects", "Textures", "Input", "SVG", "Machine"];
/// Options that would change the size of a cell, or that say how to read.
const FIXED: [&str; 7] = ["size", "width", "height", "input-format", "limit", "time-limit", "language"];

impl CompareOptions {
    /// The names of all options that can be varied.
    pub(crate) fn variable_names() -> Vec<String> {
        let table = command_line();
        let arguments = table.find_subcommand("compare").into_iter().flat_map(clap::Command::get_arguments);
        let has_heading = |argument: &&clap::Arg| {
            argument.get_help_heading().is_some_and(|heading| VARIED_HEADINGS.contains(&heading))
        };
        let takes_value = |argument: &&clap::Arg| argument.get_action().takes_values();
        arguments
            .filter(has_heading)
            .filter(takes_value)
            .filter_map(clap::Arg::get_long)
            .filter(|name| !FIXED.contains(name))
            .map(ToOwned::to_owned)
            .collect()
    }

    /// The options of the same command line with other values for some options, by long name; what was given, and what
    /// was written that concerns one kind of input only.
    ///
    /// # Errors
    /// A value that its option does not take, in the words of the option table.
    pub(crate) fn with(
        arguments: &[OsString],
        values: &[(String, String)],
    ) -> Result<(Self, Given, Written), clap::Error> {
        let table = command_line_for(arguments).mut_subcommand("compare", |compare| compare.args_override_self(true));
        let end = arguments.iter().position(|argument| argument == "--").unwrap_or(arguments.len());
        let (before, after) = arguments.split_at(end);
        let written = values.iter().map(|(name, value)| OsString::from(format!("--{name}={value}")));
        let all: Vec<OsString> = before.iter().cloned().chain(written).chain(after.iter().cloned()).collect();
        let matches = table.try_get_matches_from(all)?;
        let (given, written) = (Given::of(&matches), Written::of(&matches));
        match matches.subcommand() {
            Some((_, matches)) => Ok((Self::from_arg_matches(matches)?, given, written)),
            None => Err(clap::Error::new(clap::error::ErrorKind::MissingSubcommand)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn later_values_replace_earlier_ones_and_axes_stay() {
        let arguments =
            ["trigon", "compare", "--vary=samples=1,4", "--samples", "2", "-o", "a.png", "--vary", "wrap=clamp"];
        let arguments: Vec<OsString> = arguments.iter().chain(&["--", "model.obj"]).map(OsString::from).collect();
        let (options, given, written) =
            CompareOptions::with(&arguments, &[("samples".to_owned(), "4".to_owned())]).unwrap();
        assert_eq!((options.axes.len(), options.render.render.picture.samples), (2, 4));
        assert!(given.samples && !given.pattern);
        assert_eq!((written.for_models, written.for_drawings), (None, None));
    }

    #[test]
    fn names_are_those_of_picture_options() {
        let names = CompareOptions::variable_names();
        for name in
            ["samples", "pattern", "shading", "pixel-filter", "level-filter", "anisotropy", "shader", "wrap", "fov"]
        {
            assert!(names.iter().any(|other| other == name), "{name}");
        }
        for name in ["output", "size", "json", "vary", "inset", "strict"] {
            assert!(!names.iter().any(|other| other == name), "{name}");
        }
    }
}
