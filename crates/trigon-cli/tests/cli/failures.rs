//! Files that cannot be read, drawn or written: exit code 1, a message with the place, and no half-written output.

use crate::support::{Folder, TEXTURED};
use std::fs;

#[test]
fn a_missing_model_is_named() {
    let folder = Folder::new();
    folder.run("no-such.obj -o a.png").fails_with(&["no-such.obj"]);
    folder.run("no-such-folder/model -o a.png").fails_with(&["no-such-folder/model"]);
    assert!(folder.names().is_empty());
}

#[test]
fn a_broken_model_is_reported_with_its_line() {
    let folder = Folder::new().with("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 99\n");
    folder.run("broken.obj -o a.png -s 16").succeeds().says(&["warning: broken.obj:5:"]);
    fs::remove_file(folder.path("a.png")).unwrap();
    folder.run("broken.obj -o a.png -s 16 --strict").fails_with(&["broken.obj:5:"]);
    let quiet = folder.run("broken.obj -o b.png -s 16 --quiet").succeeds();
    assert_eq!(quiet.stderr, "");
    assert_eq!(folder.names(), ["b.png", "broken.obj"]);
}

#[test]
fn what_is_no_model_is_refused() {
    let folder = Folder::new().with("noise.bin", [0_u8, 1, 2, 255, 254]);
    folder.run("noise.bin -o a.png").fails_with(&["noise.bin", "OBJ"]);
    assert_eq!(folder.names(), ["noise.bin"]);
}

#[test]
fn an_empty_model_gives_an_empty_picture_and_a_warning() {
    let folder = Folder::new().with("empty.obj", "# nothing\n");
    let finished = folder.run("empty.obj -o a.png -s 16").succeeds();
    assert_eq!(finished.stderr, "warning: empty.obj: the file holds nothing to draw\n");
    folder.run("empty.obj -o b.png -s 16 --strict").fails_with(&["nothing to draw"]);
    assert_eq!(folder.names(), ["a.png", "empty.obj"]);
}

#[test]
fn a_model_out_of_view_is_warned_of() {
    let folder = Folder::with_cube();
    let away = "cube.obj -o a.png -s 16 --eye 0,0,10 --target 0,0,20";
    folder.run(away).succeeds().says(&["warning: nothing of the model is in the picture"]);
}

#[test]
fn missing_and_unreadable_textures_are_warnings_or_strict_errors() {
    let material = "newmtl picture\nKd 1 1 1\nmap_Kd picture.png\n";
    let folder = Folder::new().with("a.obj", TEXTURED);
    folder.run("a.obj -o a.png -s 16").succeeds().says(&["warning: a.obj:1:", "m.mtl"]);
    folder.run("a.obj -o b.png -s 16 --strict").fails_with(&["m.mtl"]);
    let folder = folder.with("m.mtl", material);
    folder.run("a.obj -o a.png -s 16").succeeds().says(&["warning: m.mtl:3:", "picture.png"]);
    folder.run("a.obj -o b.png -s 16 --strict").fails_with(&["m.mtl:3:", "picture.png"]);
    let folder = folder.with("picture.png", "this is no PNG");
    folder.run("a.obj -o a.png -s 16").succeeds().says(&["warning: ", "picture.png"]);
    folder.run("a.obj -o b.png -s 16 --strict").fails_with(&["picture.png"]);
    assert_eq!(folder.names(), ["a.obj", "a.png", "m.mtl", "picture.png"]);
    folder.run("a.obj -o a.png --texture no-such.png").fails_with(&["no-such.png"]);
}

#[test]
fn textures_are_inputs_too() {
    let material = "newmtl picture\nmap_Kd picture.png\n";
    let folder = Folder::with_cube().with("a.obj", TEXTURED).with("m.mtl", material);
    folder.run("cube.obj -s 8 -o picture.png").succeeds_quietly();
    let before = fs::read(folder.path("picture.png")).unwrap();
    folder.run("a.obj -o picture.png").misuses_with(&["overwrite the input", "picture.png"]);
    assert_eq!(fs::read(folder.path("picture.png")).unwrap(), before);
}

#[test]
fn limits_hold() {
    let folder = Folder::with_cube();
    folder.run("cube.obj -o a.png --limit triangles=11").fails_with(&["triangles", "11"]);
    folder.run("cube.obj -o a.png --limit file-size=10").fails_with(&["file_bytes", "10"]);
    folder.run("cube.obj -o a.png -s 16 --limit triangles=12").succeeds_quietly();
    folder.run("cube.obj -o t.png -s 20x10").succeeds_quietly();
    let textured = "cube.obj -o a.png -s 16 --texture t.png --limit";
    folder.run(&format!("{textured} texture-pixels=200")).succeeds_quietly();
    folder.run(&format!("{textured} texture-pixels=199")).succeeds().says(&["warning: t.png", "199"]);
    folder.run(&format!("{textured} texture-size=10")).fails_with(&["texture-size", "10"]);
}

#[test]
fn a_missing_folder_is_found_before_the_model_is_read() {
    let folder = Folder::new();
    // The model is missing too, but the output is looked at first.
    folder.run("no-such.obj -o out/a.png").fails_with(&["out does not exist", "create the folder"]);
    folder.run("no-such.obj -o .").misuses_with(&["does not tell the format"]);
    fs::create_dir(folder.path("a.png")).unwrap();
    folder.run("no-such.obj -o a.png").fails_with(&["is a folder"]);
    folder.run("no-such.obj -o b.png --json=out/r.json").fails_with(&["out does not exist"]);
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_told() {
    let folder = Folder::with_cube();
    folder.run("cube.obj -s 64 -o /dev/full").fails_with(&[
        "cannot write /dev/full",
        "No space left",
        "free some space",
    ]);
    folder.run("turntable cube.obj -n 3 -s 16 -o /dev/full").fails_with(&["No space left"]);
    assert!(fs::metadata("/dev/full").is_ok_and(|metadata| !metadata.is_file()), "the device is still one");
    assert_eq!(folder.names(), ["cube.obj"]);
}

#[test]
#[cfg(unix)]
fn a_file_that_cannot_be_finished_leaves_nothing() {
    let folder = Folder::with_cube();
    // The shell's limit on file sizes makes writing fail after a few hundred bytes, as a full disk does.
    let script = "trap '' XFSZ; ulimit -f 1; exec \"$@\"";
    let output = std::process::Command::new("sh")
        .args(["-c", script, "sh", env!("CARGO_BIN_EXE_trigon"), "cube.obj", "-s", "300", "-o", "a.png"])
        .current_dir(folder.path("."))
        .output()
        .unwrap();
    crate::support::Finished::new(output).fails_with(&["cannot write a.png"]);
    assert_eq!(folder.names(), ["cube.obj"]);
}

#[test]
#[cfg(unix)]
fn an_existing_picture_survives_a_failure() {
    let folder = Folder::with_cube().with("a.png", "precious");
    folder.run("no-such.obj -o a.png").fails_with(&["no-such.obj"]);
    assert_eq!(fs::read(folder.path("a.png")).unwrap(), b"precious");
}
