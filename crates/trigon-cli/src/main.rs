//! The trigon command: draws 3D models to pictures on machines without a GPU.
//!
//! `options` is the table of what can be written, `values` reads single values, `command` does the work of each
//! subcommand with the modules beside it, and `terminal` alone talks to the person.

mod app;
mod command;
mod compare;
mod deadline;
mod failure;
mod figure;
mod hash;
mod json;
mod load;
mod machine;
mod options;
mod output;
mod pictures;
mod progress;
mod report;
mod settings;
mod stdin;
mod story;
mod terminal;
mod turn;
mod values;
mod view;
mod warnings;

fn main() -> std::process::ExitCode {
    hide_reader_panics();
    app::run(std::env::args_os().collect())
}

/// What the reader of SVG files cannot bear is told as an error of ours; its own words would only confuse.
fn hide_reader_panics() {
    let show = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if std::thread::current().name() != Some(trigon_svg::svg::READER_THREAD) {
            show(panic);
        }
    }));
}
