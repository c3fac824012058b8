//! `trigon man`: a manual page in roff format, from the option table.

use crate::failure::Failure;
use crate::options::{ManOptions, command_line};
use crate::terminal;
use crate::values::closest;
use clap_mangen::Man;

pub(crate) fn man(options: &ManOptions) -> Result<(), Failure> {
    let mut page = Vec::new();
    let command = documented(options.command.as_deref())?;
    Man::new(command).render(&mut page).map_err(|error| Failure::work(format!("cannot make the page: {error}")))?;
    terminal::write_stdout(&page)
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
