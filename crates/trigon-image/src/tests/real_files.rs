//! Files of other programs, where the shared test data is at hand: all decode, and to what they are known to hold.

use std::fs;
use std::path::{Path, PathBuf};

use crate::{DecodedImage, EncodeOptions, Format, Limits, decode, encode};

/// A folder of the shared data, or `None`, said aloud, where it is missing.
fn shared(folder: &str) -> Option<PathBuf> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data").join(folder);
    if path.is_dir() {
        return Some(path);
    }
    println!("skipped: {} is missing", path.display());
    None
}

/// All pictures below a folder.
fn pictures(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(pictures(&path));
        } else if Format::from_path(&path).is_some() {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn decode_file(path: &Path) -> DecodedImage {
    let bytes = fs::read(path).unwrap();
    let result = decode(&bytes, Format::from_path(path), &Limits::default());
    result.unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn all_textures_of_the_scenes_decode() {
    let folders =
        ["tinyrenderer/obj", "scene-lighthouse", "scene-spider", "games101", "environment", "svg-suite/resources"];
    for folder in folders.into_iter().filter_map(shared) {
        let paths = pictures(&folder);
        assert!(!paths.is_empty(), "{} holds pictures", folder.display());
        for path in paths {
            let image = decode_file(&path);
            assert!(image.width() > 0 && image.height() > 0);
        }
    }
}

#[test]
fn tga_files_survive_our_writer() {
    for folder in ["tinyrenderer/obj", "scene-lighthouse"].into_iter().filter_map(shared) {
        for path in pictures(&folder).iter().filter(|path| Format::from_path(path) == Some(Format::Tga)) {
            let image = decode_file(path).into_rgba8();
            let bytes = encode(&image, Format::Tga, &EncodeOptions::default()).unwrap();
            let back = decode(&bytes, None, &Limits::default()).unwrap();
            assert_eq!(back, DecodedImage::Rgba8(image), "{}", path.display());
        }
    }
}

#[test]
fn real_tga_files_cut_off_are_errors() {
    let Some(folder) = shared("tinyrenderer/obj/african_head") else { return };
    let path = folder.join("african_head_eye_outer_gloss.tga");
    let bytes = fs::read(&path).unwrap();
    let whole = decode_file(&path);
    for length in (0..bytes.len()).step_by(37) {
        if let Ok(image) = decode(&bytes[..length], Some(Format::Tga), &Limits::default()) {
            assert_eq!(image, whole, "cut to {length}");
        }
    }
}
