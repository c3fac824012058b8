//! The course's files against its pictures and a second set of references, where the shared data is there.
//! `cargo test -p trigon-svg --test cs184_reference -- --nocapture` prints how well each agrees.

#![expect(clippy::print_stdout, reason = "the table of agreement")]

#[path = "../../../tests/shared_data.rs"]
mod shared_data;

use shared_data::shared_data;
use std::path::{Path, PathBuf};

use trigon_image::{Limits, Rgba8Image, decode};
use trigon_svg::cs184::{LevelSampling, NearestRule, Options, PixelSampling, draw};

/// The part of the pixels that must be within 2/255.
const AGREEMENT: f64 = 0.995;

fn check(svg: &Path, reference: &Path, options: &Options) -> bool {
    let bytes = std::fs::read(svg).unwrap_or_else(|error| panic!("{}: {error}", svg.display()));
    let options = Options { folder: svg.parent().map(Path::to_owned), threads: 2, ..options.clone() };
    let (drawn, warnings) = draw(&bytes, &options).unwrap();
    assert!(warnings.is_empty(), "{}: {warnings:?}", svg.display());
    let expected = decode(&std::fs::read(reference).unwrap(), None, &Limits::default()).unwrap().into_rgba8();
    let agreement = agreement(&drawn, &expected);
    println!("{:<60} {:.4} %", reference.file_name().unwrap().to_string_lossy(), agreement * 100.0);
    agreement >= AGREEMENT
}

fn agreement(a: &Rgba8Image, b: &Rgba8Image) -> f64 {
    assert_eq!((a.width(), a.height()), (b.width(), b.height()));
    let is_near = |(a, b): &(&[u8; 4], &[u8; 4])| (0..3).all(|i| a[i].abs_diff(b[i]) <= 2);
    let near = a.pixels().iter().zip(b.pixels()).filter(is_near).count();
    near as f64 / a.pixels().len() as f64
}

/// `basic_test1` is `basic/test1.svg`; some names leave the folder out.
fn file_of(svgs: &Path, name: &str) -> PathBuf {
    let of_folder = name.split_once('_').map(|(folder, file)| svgs.join(folder).join(format!("{file}.svg")));
    of_folder.filter(|path| path.exists()).unwrap_or_else(|| svgs.join("transforms").join(format!("{name}.svg")))
}

fn png_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(png_files(&path));
        } else if path.extension().is_some_and(|end| end == "png") {
            found.push(path);
        }
    }
    found.sort();
    found
}

#[test]
fn pictures_of_the_second_set() {
    let Some(data) = shared_data() else { return };
    let svgs = data.join("cs184-svg/svg");
    let mut failures = Vec::new();
    let references = png_files(&data.join("reference/cs184"));
    for reference in &references {
        let name = reference.file_stem().unwrap().to_string_lossy().into_owned();
        let (rest, samples) = name.rsplit_once("_s").unwrap();
        let samples_per_axis = match samples {
            "1" => 1,
            "4" => 2,
            "9" => 3,
            _ => 4,
        };
        let (rest, level) = rest.split_once("_lev-").unwrap_or((rest, "zero"));
        let (file, pixel) = rest.split_once("_pix-").unwrap_or((rest, "nearest"));
        let options = Options {
            samples_per_axis,
            pixel: if pixel == "bilinear" { PixelSampling::Bilinear } else { PixelSampling::Nearest },
            level: match level {
                "linear" => LevelSampling::Linear,
                "nearest" => LevelSampling::Nearest,
                _ => LevelSampling::Zero,
            },
            ..Options::new(960, 640)
        };
        if !check(&file_of(&svgs, file), reference, &options) {
            failures.push(name);
        }
    }
    assert!(!references.is_empty() && failures.is_empty(), "of {}: {failures:?}", references.len());
}

#[test]
fn pictures_that_the_course_gives_out() {
    let Some(data) = shared_data() else { return };
    let (svgs, folder) = (data.join("cs184-svg/svg"), data.join("cs184-svg/reference-1024x1024-rate1"));
    let options = Options { nearest: NearestRule::Course, ..Options::new(1024, 1024) };
    let references = png_files(&folder);
    let failures: Vec<_> = references
        .iter()
        .filter(|reference| {
            let svg = svgs.join(reference.strip_prefix(&folder).unwrap()).with_extension("svg");
            !check(&svg, reference, &options)
        })
        .collect();
    assert!(!references.is_empty() && failures.is_empty(), "of {}: {failures:?}", references.len());
}
