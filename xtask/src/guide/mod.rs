//! `cargo xtask guide`: every picture and every printed line in `docs/guide/` comes from a command that is on its page.
//!
//! A page marks what is run by what follows the language of a fence: the commands in ` ```sh guide ` are run from the
//! workspace's root, one a line (`\` at the end of a line goes on on the next); ` ```text output ` holds what the command before it
//! prints. Commands are those of `trigon`; `-o` names the picture. `guide` writes pictures and texts anew, `guide --check` makes them
//! aside and compares. It is also an error if a page shows a picture that no command on it makes, or if the folder of
//! pictures holds one that no page makes.

mod command;
mod page;
mod program;
mod tour;

pub(crate) use tour::{check, write};
