//! The comparison: a case's name and what was drawn in, a panic with the place of the report out if they differ.

use super::report;
use std::fs;
use std::path::{Path, PathBuf};
use trigon_image::encode::Effort;
use trigon_image::{EncodeOptions, Format, Limits, Rgba8Image, compare, decode, encode};

/// Compares `actual` with `tests/golden/{case}.png`; a case is `topic/name`.
///
/// # Panics
/// If the pictures differ in any byte and `TRIGON_BLESS` is not 1.
pub fn check(case: &str, actual: &Rgba8Image) {
    let path = golden_path(&format!("{case}.png"));
    let expected = fs::read(&path).ok().map(|bytes| {
        let image = decode(&bytes, Some(Format::Png), &Limits::default());
        image.unwrap_or_else(|error| panic!("{}: {error}", path.display())).into_rgba8()
    });
    if expected.as_ref() == Some(actual) {
        report::forget(case);
    } else if is_blessing() {
        report::forget(case);
        write(&path, &png(actual));
    } else {
        let page = report::add(case, expected.as_ref(), actual);
        let problem = expected.as_ref().map_or("there is no such picture yet".to_owned(), |e| difference(e, actual));
        panic!("golden picture {case}: {problem}\nsee {}\nor accept it: cargo xtask bless", page.display());
    }
}

/// Compares `actual` with the text file `tests/golden/{name}`, line by line.
///
/// # Panics
/// If they differ and `TRIGON_BLESS` is not 1.
pub fn check_text(name: &str, actual: &str) {
    let path = golden_path(name);
    let expected = fs::read_to_string(&path).unwrap_or_default();
    if expected == actual {
        return;
    }
    if is_blessing() {
        write(&path, actual.as_bytes());
        return;
    }
    let missing =
        expected.lines().filter(|line| !actual.lines().any(|other| other == *line)).map(|l| format!("- {l}\n"));
    let new = actual.lines().filter(|line| !expected.lines().any(|other| other == *line)).map(|l| format!("+ {l}\n"));
    let lines: String = missing.chain(new).collect();
    panic!("tests/golden/{name} is not what is drawn:\n{lines}accept it: cargo xtask bless");
}

/// The names of all stored pictures, sorted.
///
/// # Panics
/// If the folder cannot be read.
#[must_use]
pub fn stored_cases() -> Vec<String> {
    let mut cases = Vec::new();
    for topic in fs::read_dir(golden_path("")).expect("the folder of golden pictures").flatten() {
        for file in fs::read_dir(topic.path()).into_iter().flatten().flatten() {
            let (topic, file) = (topic.file_name(), file.file_name());
            if let Some(name) = file.to_string_lossy().strip_suffix(".png") {
                cases.push(format!("{}/{name}", topic.to_string_lossy()));
            }
        }
    }
    cases.sort();
    cases
}

/// A path below `tests/golden`.
pub(super) fn golden_path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden").join(name)
}

/// As small as the encoder can make it: goldens stay in the history.
pub(super) fn png(image: &Rgba8Image) -> Vec<u8> {
    let mut options = EncodeOptions::default();
    options.effort = Effort::Best;
    encode(image, Format::Png, &options).expect("a picture with pixels")
}

pub(super) fn write(path: &Path, bytes: &[u8]) {
    let written = path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(path, bytes));
    written.unwrap_or_else(|error| panic!("cannot write {}: {error}", path.display()));
}

fn is_blessing() -> bool {
    std::env::var_os("TRIGON_BLESS").is_some_and(|value| value == "1")
}

fn difference(expected: &Rgba8Image, actual: &Rgba8Image) -> String {
    let Some(comparison) = compare(expected, actual) else {
        let size = |image: &Rgba8Image| format!("{}x{}", image.width(), image.height());
        return format!("{} pixels instead of {}", size(actual), size(expected));
    };
    let (count, most) = (comparison.pixels_over(0), comparison.max());
    format!("{count} pixels differ, by up to {most}, the first at {:?}", comparison.first_difference)
}
