//! Prints one line `name hash` for each frame of the corpus, drawn on one thread at the level that `TRIGON_SIMD` names
//! or else the best.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "its purpose")]

use std::process::ExitCode;
use trigon::lanes::SimdLevel;
use trigon_tests::corpus;
use trigon_tests::frames::plain_options;

fn main() -> ExitCode {
    match SimdLevel::from_env() {
        Ok(simd) => {
            eprintln!("SIMD level {simd}");
            print!("{}", corpus::report(trigon::pipeline::RendererOptions { simd, ..plain_options() }));
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
