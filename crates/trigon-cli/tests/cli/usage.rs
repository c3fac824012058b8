//! Wrong command lines: exit code 2, what is wrong, what to write instead, and nothing written.

use crate::support::Folder;

/// Runs a command line that is wrong; checks the message and that no file appeared.
fn check(arguments: &str, words: &[&str]) {
    let folder = Folder::with_cube();
    folder.run(arguments).misuses_with(words);
    assert_eq!(folder.names(), ["cube.obj"], "{arguments}");
}

#[test]
fn unknown_options_and_commands() {
    check("render cube.obj -o a.png --sample 4", &["--sample", "--samples"]);
    check("render cube.obj -o a.png --frobnicate", &["unexpected argument '--frobnicate'"]);
    check("rendr cube.obj -o a.png", &["rendr", "render"]);
    check("cube.obj", &["--output"]);
    check("render -o a.png", &["<MODEL>"]);
}

#[test]
fn wrong_values_come_with_advice() {
    check("cube.obj -o a.png --shader blin-phong", &["'blin-phong'", "'blinn-phong'"]);
    check("cube.obj -o a.png --shader xyz", &["possible values", "barycentric"]);
    check("cube.obj -o a.png --size huge", &["1920x1080"]);
    check("cube.obj -o a.png --size hd1081", &["did you mean hd1080?"]);
    check("cube.obj -o a.png --size 0x10", &["1 to 16384"]);
    check("cube.obj -o a.png --eye 1,2", &["three numbers"]);
    check("cube.obj -o a.png --up W", &["+Y"]);
    check("cube.obj -o a.png --light pont:0,0,0:1", &["did you mean point?"]);
    check("cube.obj -o a.png --light sun:1", &["directional:X,Y,Z"]);
    check("cube.obj -o a.png --background redd", &["is no colour"]);
    check("cube.obj -o a.png --limit trangles=1", &["did you mean triangles?"]);
    check("cube.obj -o a.png --threads 0", &["1 to 1024"]);
    check("cube.obj -o a.png --anisotropy 17", &["17"]);
    check("cube.obj -o a.png --quality 0", &["0"]);
    check("cube.obj -o a.png --zoom 0", &["above zero"]);
    check("cube.obj -o a.png --fov 180", &["--fov", "between 0 and 180"]);
    check("cube.obj -o a.png --near 2 --far 1", &["--near 2", "--far 1"]);
    check("cube.obj -o a.png --near 0", &["--near", "above zero"]);
}

#[test]
fn sample_counts_follow_the_pattern() {
    check("cube.obj -o a.png --samples 9", &["1, 2, 4, 8 or 16", "--pattern grid"]);
    check("cube.obj -o a.png --samples 8 --pattern grid", &["1, 4, 9 or 16", "--pattern standard"]);
    check("cube.obj -o a.png --samples 5", &["standard"]);
}

#[test]
fn formats_are_suggested() {
    check("cube.obj -o picture", &["does not tell the format", "--format"]);
    check("cube.obj -o a.pgn", &["\"pgn\"", "did you mean png?"]);
    check("cube.obj -o a.bmp", &["BMP is only read", "png"]);
    check("cube.obj -o a.png --format xyz", &["\"xyz\"", "exr"]);
}

#[test]
fn contradictions() {
    check("cube.obj -o a.png --eye 1,2,3 --azimuth 3", &["--azimuth"]);
    check("cube.obj -o a.png --eye 1,2,3 --target 1,2,3", &["same point"]);
    check("- - -o a.png", &["only once"]);
}

#[test]
fn the_output_never_overwrites_an_input() {
    check("cube.obj -o ./cube.obj --format png", &["overwrite the input cube.obj"]);
    check("cube.obj -o a.png --json=cube.obj", &["overwrite the input cube.obj"]);
}

#[test]
fn simd_levels_are_checked_against_the_cpu() {
    check("cube.obj -o a.png --simd avx3", &["--simd", "\"avx3\"", "did you mean avx2?", "This CPU has scalar"]);
    check("cube.obj -o a.png --simd mmx", &["this CPU has scalar"]);
    let other = if cfg!(target_arch = "aarch64") { "avx2" } else { "neon" };
    check(&format!("cube.obj -o a.png --simd {other}"), &["lacks", other, "it has scalar"]);

    let folder = Folder::with_cube();
    let mut command = folder.command(["cube.obj", "-o", "a.png"]);
    let output = command.env("TRIGON_SIMD", "sse9").output().unwrap();
    crate::support::Finished::new(output).misuses_with(&["TRIGON_SIMD", "sse9"]);
}
