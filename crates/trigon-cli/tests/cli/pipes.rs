//! Standard input and output: models in, pictures and reports out, and readers that go away.

use crate::support::{CUBE, Finished, Folder, TEXTURED, picture_of};
use std::io::Write;
use std::process::Stdio;
use trigon_image::Format;

/// Runs the command with a text on its standard input.
fn run_with_stdin(folder: &Folder, arguments: &str, input: &str) -> Finished {
    let mut command = folder.command(arguments.split_whitespace());
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    // Fails if the command does not read its input, which is then what the test is about.
    let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
    Finished::new(child.wait_with_output().unwrap())
}

#[test]
fn a_model_from_standard_input_is_the_same_picture() {
    let folder = Folder::with_cube();
    let reference = folder.picture("cube.obj -s 40x30");
    let finished = run_with_stdin(&folder, "render - -s 40x30 -o -", CUBE).succeeds_quietly();
    assert_eq!(Format::sniff(&finished.stdout), Some(Format::Png));
    assert_eq!(picture_of(&finished.stdout), reference);
    let finished = run_with_stdin(&folder, "- -s 40x30 -o - --format qoi --input-format obj", CUBE).succeeds_quietly();
    assert_eq!(Format::sniff(&finished.stdout), Some(Format::Qoi));
    assert_eq!(picture_of(&finished.stdout), reference);
}

#[test]
fn materials_of_standard_input_are_found_in_the_current_folder() {
    let folder = Folder::new().with("m.mtl", "newmtl picture\nKd 1 0 0\n");
    let arguments = "- -s 16 --shader unlit -o -";
    let finished = run_with_stdin(&folder, arguments, TEXTURED).succeeds_quietly();
    assert_eq!(picture_of(&finished.stdout).pixel(8, 8), [255, 0, 0, 255]);
}

#[test]
fn empty_and_unknown_input_is_refused() {
    let folder = Folder::new();
    run_with_stdin(&folder, "- -o a.png", "").fails_with(&["standard input is empty"]);
    run_with_stdin(&folder, "- -o a.png", "\u{1}\u{2}").fails_with(&["standard input"]);
    assert!(folder.names().is_empty());
}

#[test]
fn the_report_goes_where_the_picture_does_not() {
    let folder = Folder::with_cube();
    let finished = folder.run("cube.obj -s 16 -o - --json").succeeds().says(&["\"hash\""]);
    assert_eq!(Format::sniff(&finished.stdout), Some(Format::Png));
    let finished = folder.run("cube.obj -s 16 -o a.png --json").succeeds_quietly();
    assert!(finished.text().contains("\"hash\""));
    folder.run("cube.obj -s 16 -o - --json=r.json").succeeds_quietly();
    assert_eq!(folder.names(), ["a.png", "cube.obj", "r.json"]);
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let folder = Folder::with_cube();
    for arguments in
        ["cube.obj -s 600 -o -", "turntable cube.obj -s 32 -n 3 -o -", "completions bash", "man", "render --help"]
    {
        let mut command = folder.command(arguments.split_whitespace());
        let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        Finished::new(child.wait_with_output().unwrap()).succeeds_quietly();
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_standard_output_is_a_failure() {
    let folder = Folder::with_cube();
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = folder.command(["cube.obj", "-s", "64", "-o", "-"]).stdout(full).output().unwrap();
    Finished::new(output).fails_with(&["cannot write to standard output", "No space left"]);
}
