//! SVG, by topic: each `tests/golden/svg-*/NAME.svg` beside its picture, 96 pixels wide, without fonts.

use std::path::Path;
use trigon_image::Color;
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, FontOptions, Options, Size, View};
use trigon_tests::golden::{check, stored_cases};

/// Draws each case as `trigon render` does, and compares.
fn check_all(cases: &[&str]) {
    let fonts = FontOptions { use_system_fonts: false, ..FontOptions::default() };
    let options = Options { fonts, ..Options::default() };
    for case in cases {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("golden/{case}.svg"));
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let document = Document::parse(&bytes, &options).unwrap_or_else(|error| panic!("{case}: {error}"));
        let view = View { size: Size::Width(96), ..View::default() };
        let (picture, warnings) = document.draw(&view, &Renderer::new(), Color::TRANSPARENT).unwrap();
        assert!(warnings.is_empty(), "{case}: {warnings:?}");
        check(case, &picture.to_image());
    }
}

#[test]
fn svg_fills() {
    check_all(&["svg-fills/curves", "svg-fills/no-seams", "svg-fills/opacity", "svg-fills/rules"]);
}

#[test]
fn svg_strokes() {
    check_all(&["svg-strokes/caps", "svg-strokes/joins", "svg-strokes/miter-limit", "svg-strokes/tight-curves"]);
    check_all(&[
        "svg-strokes/dashes",
        "svg-strokes/dash-corners",
        "svg-strokes/stretched-pen",
        "svg-strokes/hairlines",
    ]);
}

#[test]
fn svg_paints() {
    check_all(&["svg-paints/linear-gradients", "svg-paints/radial-gradients", "svg-paints/gradient-strokes"]);
    check_all(&["svg-paints/patterns"]);
}

#[test]
fn svg_groups() {
    check_all(&["svg-groups/clip-paths", "svg-groups/masks", "svg-groups/blend-modes", "svg-groups/isolation"]);
    check_all(&["svg-groups/plus-lighter"]);
}

#[test]
fn svg_structure() {
    check_all(&["svg-structure/use-and-symbol", "svg-structure/markers", "svg-structure/styles"]);
    check_all(&["svg-structure/letters", "svg-structure/crisp-edges"]);
}

#[test]
fn svg_images() {
    check_all(&["svg-images/smooth-and-pixelated", "svg-images/reduced", "svg-images/svg-in-svg"]);
}

#[test]
fn svg_filters() {
    check_all(&["svg-filters/blur", "svg-filters/drop-shadow", "svg-filters/morphology", "svg-filters/convolve"]);
    check_all(&["svg-filters/color-matrix", "svg-filters/component-transfer", "svg-filters/composite-and-tile"]);
    check_all(&["svg-filters/turbulence", "svg-filters/displacement", "svg-filters/lighting"]);
    check_all(&["svg-filters/on-a-turned-group"]);
}

/// Every picture has its file, and every file its picture.
#[test]
fn svg_files_and_pictures_belong_together() {
    let mut files = Vec::new();
    for topic in std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")).unwrap().flatten() {
        for file in std::fs::read_dir(topic.path()).into_iter().flatten().flatten() {
            let (topic, file) = (topic.file_name(), file.file_name());
            // Those of courses are drawn in several ways.
            let is_alone = topic.to_string_lossy().starts_with("svg-");
            if let Some(name) = file.to_string_lossy().strip_suffix(".svg").filter(|_| is_alone) {
                files.push(format!("{}/{name}", topic.to_string_lossy()));
            }
        }
    }
    files.sort();
    let pictures: Vec<String> = stored_cases().into_iter().filter(|case| case.starts_with("svg-")).collect();
    assert!(files.len() > 30);
    assert_eq!(files, pictures);
}
