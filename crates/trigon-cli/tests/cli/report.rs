//! The report: its fields, and the hash that is the same at every SIMD level and thread count.

use crate::support::{CUBE, Folder, read_picture};
use std::fs;

/// The value of a member, as text without quotes.
fn member<'a>(json: &'a str, name: &str) -> &'a str {
    let (_, after) = json.split_once(&format!("\"{name}\": ")).unwrap_or_else(|| panic!("no {name} in {json}"));
    let end = after.find([',', '\n']).unwrap();
    after[..end].trim_matches('"')
}

fn report(folder: &Folder, arguments: &str) -> String {
    let finished = folder.run(&format!("{arguments} -o picture.png --json")).succeeds();
    finished.text().to_owned()
}

#[test]
fn the_report_tells_what_was_drawn() {
    let folder = Folder::with_cube();
    let json = report(&folder, "cube.obj -s 64x48 --samples 8");
    for (name, value) in [
        ("output", "picture.png"),
        ("format", "PNG"),
        ("width", "64"),
        ("height", "48"),
        ("frames", "1"),
        ("samples", "standard 8"),
        ("shader", "blinn-phong"),
        ("triangles", "12"),
        ("submitted", "12"),
        ("drawn", "12"),
        ("clipped", "0"),
        ("dropped", "0"),
        ("culled", "0"),
        ("blank", "false"),
    ] {
        assert_eq!(member(&json, name), value, "{name}");
    }
    for name in ["load", "upload", "geometry", "tiles", "encode", "total"] {
        assert!(member(&json, name).trim_end_matches('}').trim().parse::<f64>().unwrap() >= 0.0, "{name}");
    }
    let culled = report(&folder, "cube.obj -s 64x48 --cull back");
    assert_eq!((member(&culled, "culled"), member(&culled, "drawn")), ("6", "6"));
}

#[test]
fn warnings_and_blank_pictures_are_in_the_report() {
    let folder = Folder::new().with("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    let json = report(&folder, "a.obj -s 16 --eye 0,0,5 --target 0,0,9 --quiet");
    assert_eq!(member(&json, "blank"), "true");
    assert!(json.contains("a.obj:5:") && json.contains("nothing of the model"), "{json}");
}

#[test]
fn the_hash_is_fnv_1a_of_the_pixels() {
    let folder = Folder::with_cube();
    for options in ["", "--bit-depth 16", "--background none"] {
        let json = report(&folder, &format!("cube.obj -s 32x20 {options}"));
        if options == "--bit-depth 16" {
            // The hash is always that of the 8-bit picture.
            folder.run("cube.obj -s 32x20 -o picture.png").succeeds_quietly();
        }
        let picture = read_picture(&folder.path("picture.png"));
        let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        let hash = picture.pixels().as_flattened().iter().fold(0xcbf2_9ce4_8422_2325, step);
        assert_eq!(member(&json, "hash"), format!("{hash:016x}"));
    }
}

#[test]
fn the_hash_depends_on_no_machine() {
    let folder = Folder::with_cube();
    let available: Vec<_> = ["scalar", "sse4.2", "avx2", "avx512", "neon"]
        .into_iter()
        .filter(|level| folder.run(&format!("cube.obj -s 8 -o a.png --simd {level}")).code == Some(0))
        .collect();
    assert!(available.contains(&"scalar"));
    for options in ["", "--shader normal --samples 16", "--wireframe --shading sample", "--shader overdraw"] {
        let mut hashes = Vec::new();
        for level in &available {
            for threads in [1, 2, 3, 7] {
                let json = report(&folder, &format!("cube.obj -s 300x200 {options} --simd {level} -j {threads}"));
                assert_eq!(member(&json, "simd"), *level);
                assert_eq!(member(&json, "threads"), threads.to_string());
                hashes.push(member(&json, "hash").to_owned());
            }
        }
        assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{options}: {hashes:?}");
    }
    let other = report(&folder, "cube.obj -s 300x200 --azimuth 36");
    assert_ne!(member(&other, "hash"), member(&report(&folder, "cube.obj -s 300x200"), "hash"));
}

#[test]
fn many_models_are_one_scene() {
    let moved = CUBE.replace("v 0", "v 5").replace("v 2", "v 7");
    let folder = Folder::with_cube().with("moved.obj", moved);
    let json = report(&folder, "cube.obj moved.obj -s 32");
    assert_eq!(member(&json, "triangles"), "24");
    folder.run("cube.obj moved.obj -s 32 -o a.png --json=r.json").succeeds_quietly();
    assert!(fs::read_to_string(folder.path("r.json")).unwrap().contains("\"moved.obj\""));
}
