//! Chores of the trigon workspace, each one command: `cargo xtask tidy | bless | report | assets | guide`.
//!
//! In: the working tree. Out: findings or files. Everything here runs the same at home and in `.ci/run`; a rule
//! that the compiler or clippy can hold does not belong here.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a command line tool speaks to its terminal")]

mod assets;
mod golden;
mod guide;
mod tidy;

use std::path::PathBuf;
use std::process::ExitCode;

const USAGE: &str = "\
usage: cargo xtask <command>

  tidy              check the rules that a compiler cannot hold
  bless [FILTER]    accept the pictures of failing golden tests whose name contains FILTER
  report            print where the HTML report of golden differences is
  assets            write everything under assets/
  assets --check    fail if assets/ differs from what the generator makes
  guide [PAGE]      make the pictures and texts of the pages in docs/guide/ whose name contains PAGE
  guide --check [PAGE]
                    fail if they differ from what the commands on the pages make
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let root = workspace_root();
    let outcome = match arguments[..] {
        ["tidy"] => tidy::run(&root),
        ["bless"] => golden::bless(&root, None),
        ["bless", filter] => golden::bless(&root, Some(filter)),
        ["report"] => golden::report(&root),
        ["assets"] => assets::write(&root),
        ["assets", "--check"] => assets::check(&root),
        ["guide"] => guide::write(&root, ""),
        ["guide", "--check"] => guide::check(&root, ""),
        ["guide", "--check", page] => guide::check(&root, page),
        ["guide", page] => guide::write(&root, page),
        ["help" | "--help" | "-h"] => {
            print!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        _ => {
            eprint!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The folder of the workspace's `Cargo.toml`: the parent of this package.
fn workspace_root() -> PathBuf {
    let mut root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    root.pop();
    root
}
