//! The trigon command: draws 3D models to pictures on machines without a GPU.
//!
//! `options` is the table of what can be written, `values` reads single values, `command` does the work of each
//! subcommand with the modules beside it, and `terminal` alone talks to the person.

mod app;
mod command;
mod failure;
mod hash;
mod json;
mod load;
mod machine;
mod options;
mod output;
mod progress;
mod report;
mod settings;
mod stdin;
mod terminal;
mod turn;
mod values;
mod view;

fn main() -> std::process::ExitCode {
    app::run(std::env::args_os().collect())
}
