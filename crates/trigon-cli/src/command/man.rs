//! `trigon man`: a manual page in roff format, from the option table.

use crate::failure::Failure;
use crate::options::{ManOptions, command_line};
use crate::terminal;
use crate::values::closest;
use clap_mangen::Man;
use std::io;

pub(crate) fn man(options: &ManOptions) -> Result<(), Failure> {
    let command = documented(options.command.as_deref())?;
    let page = page(command).map_err(|error| Failure::work(format!("cannot make the page: {error}")))?;
    terminal::write_stdout(&page)
}

/// The page: the generator's sections, and the texts around the help as sections of their own.
fn page(command: clap::Command) -> io::Result<Vec<u8>> {
    let examples = command.get_before_help().map(ToString::to_string);
    let notes = command.get_after_long_help().or(command.get_after_help()).map(ToString::to_string);
    let has_subcommands = command.has_subcommands();
    let man = Man::new(command);
    let mut page = Vec::new();
    man.render_title(&mut page)?;
    man.render_name_section(&mut page)?;
    man.render_synopsis_section(&mut page)?;
    if let Some(examples) = examples {
        verbatim_section("EXAMPLES", examples.trim_start_matches("Examples:\n"), &mut page);
    }
    man.render_options_section(&mut page)?;
    if has_subcommands {
        man.render_subcommands_section(&mut page)?;
    }
    if let Some(notes) = notes {
        verbatim_section("NOTES", &notes, &mut page);
    }
    Ok(page)
}

/// A section whose lines stay as they are.
fn verbatim_section(title: &str, text: &str, page: &mut Vec<u8>) {
    page.extend(format!(".SH {title}\n.nf\n").bytes());
    for line in text.lines() {
        // A backslash begins a command, so does a point at the start of a line; a hyphen stays one to copy.
        let escaped = line.replace('\\', "\\e").replace('-', "\\-");
        let guard = if escaped.starts_with(['.', '\'']) { "\\&" } else { "" };
        page.extend(format!("{guard}{escaped}\n").bytes());
    }
    page.extend(b".fi\n");
}

/// The command whose page is asked for; building it gave it the name `trigon-render`, as manual pages have it.
fn documented(name: Option<&str>) -> Result<clap::Command, Failure> {
    let mut main = command_line();
    main.build();
    let Some(name) = name else { return Ok(main) };
    let Some(found) = main.find_subcommand(name) else {
        let names: Vec<_> = main.get_subcommands().map(clap::Command::get_name).collect();
        return Err(Failure::usage(match closest(name, names.iter().copied()) {
            Some(close) => format!("there is no command \"{name}\"; did you mean {close}?"),
            None => format!("there is no command \"{name}\"; the commands are {}", names.join(", ")),
        }));
    };
    Ok(found.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verbatim_lines_are_escaped() {
        let mut page = Vec::new();
        verbatim_section("NOTES", ".a\\b\n'c-d", &mut page);
        assert_eq!(String::from_utf8(page).unwrap(), ".SH NOTES\n.nf\n\\&.a\\eb\n\\&'c\\-d\n.fi\n");
    }
}
