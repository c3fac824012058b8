//! Turntables: animations and numbered pictures.

use crate::support::{Folder, difference, read_picture};
use std::fs;

/// How often a chunk or block marker occurs.
fn count(bytes: &[u8], marker: &[u8]) -> usize {
    bytes.windows(marker.len()).filter(|window| *window == marker).count()
}

#[test]
fn animations_have_all_frames() {
    let folder = Folder::with_cube();
    folder.run("turntable cube.obj -s 40x30 -n 5 -o spin.gif").succeeds_quietly();
    folder.run("turntable cube.obj -s 40x30 -n 5 -o spin.png --plays 2 --fps 10").succeeds_quietly();
    let gif = fs::read(folder.path("spin.gif")).unwrap();
    assert!(gif.starts_with(b"GIF89a"));
    // A graphic control extension before each frame.
    assert_eq!(count(&gif, &[0x21, 0xf9, 0x04]), 5);
    let png = fs::read(folder.path("spin.png")).unwrap();
    assert_eq!(count(&png, b"fcTL"), 5);
    let control = png.windows(4).position(|window| window == b"acTL").unwrap();
    assert_eq!(png[control + 4..control + 12], [0, 0, 0, 5, 0, 0, 0, 2]);
    // The first frame is the still picture, decoded by those that know no animations.
    assert_eq!(read_picture(&folder.path("spin.png")).width(), 40);
}

#[test]
fn numbered_pictures_show_the_model_turning() {
    let folder = Folder::with_cube();
    folder.run("turntable cube.obj -s 40x30 -n 3 -o frame-{frame:3}.png").succeeds_quietly();
    let names = ["cube.obj", "frame-000.png", "frame-001.png", "frame-002.png"];
    assert_eq!(folder.names(), names);
    let frames: Vec<_> = names[1..].iter().map(|name| read_picture(&folder.path(name))).collect();
    for (i, a) in frames.iter().enumerate() {
        for b in &frames[..i] {
            assert!(difference(a, b) > 0.02, "two frames show the same");
        }
    }
    folder.run("turntable cube.obj -s 40x30 -n 1 -o one-{frame}.png").succeeds_quietly();
    assert_eq!(read_picture(&folder.path("one-0.png")), frames[0]);
}

#[test]
fn other_formats_need_numbers() {
    let folder = Folder::with_cube();
    let refused = folder.run("turntable cube.obj -o spin.jpg");
    refused.misuses_with(&["JPEG has no animations", "frame-{frame:3}.jpg"]);
    folder.run("turntable cube.obj -o {fram}.png").misuses_with(&["{fram}", "frame-{frame:3}.png"]);
    folder.run("turntable cube.obj -o spin.png --bit-depth 16").misuses_with(&["8 bits"]);
    folder.run("turntable cube.obj -o a.gif --frames 0").misuses_with(&["--frames"]);
    folder.run("turntable cube.obj -o a.gif --fps 1e-300").misuses_with(&["--fps"]);
    folder.run("turntable cube.obj -s 8 -n 2 -o f{frame}.jpg").succeeds_quietly();
    assert_eq!(folder.names(), ["cube.obj", "f0.jpg", "f1.jpg"]);
}

#[test]
fn the_hash_covers_all_frames_and_is_the_same_everywhere() {
    let folder = Folder::with_cube();
    let hash = |options: &str| {
        let finished = folder.run(&format!("turntable cube.obj -s 80x60 -o a.gif --json {options}")).succeeds_quietly();
        let text = finished.text().to_owned();
        text.lines().find(|line| line.contains("\"hash\"")).unwrap().to_owned()
    };
    let two = hash("-n 2");
    assert_eq!(hash("-n 2 --simd scalar -j 3"), two);
    assert_ne!(hash("-n 3"), two);
}

#[test]
fn a_failure_leaves_no_animation() {
    let folder = Folder::with_cube();
    folder.run("turntable cube.obj no-such.obj -o a.gif").fails_with(&["no-such.obj"]);
    folder.run("turntable cube.obj -o out/{frame}.png").fails_with(&["create the folder"]);
    assert_eq!(folder.names(), ["cube.obj"]);
}
