//! Golden pictures, by topic: what whole pictures of small scenes look like, compared with tolerance zero.
//!
//! `cargo xtask bless [FILTER]` accepts what is drawn now. Look at each changed picture before committing it.

mod blend;
mod effects;
mod lines;
mod loaders;
mod overlays;
mod raster;
mod shading;
mod svg;
mod texture;

use trigon_tests::corpus;
use trigon_tests::frames::plain_options;
use trigon_tests::golden::{check_text, stored_cases};

/// Every hash of the corpus, in a list that `tests/cross` needs no second build to compare with.
#[test]
fn frame_hashes() {
    check_text("frame-hashes.txt", &corpus::report(plain_options()));
}

#[test]
fn every_stored_picture_belongs_to_a_case() {
    let sources = [
        include_str!("blend.rs"),
        include_str!("effects.rs"),
        include_str!("lines.rs"),
        include_str!("loaders.rs"),
        include_str!("overlays.rs"),
        include_str!("raster.rs"),
        include_str!("shading.rs"),
        include_str!("svg.rs"),
        include_str!("texture.rs"),
        include_str!("../../../crates/trigon-cli/tests/cli/goldens.rs"),
    ];
    let is_drawn = |case: &String| sources.iter().any(|source| source.contains(&format!("\"{case}\"")));
    let orphans: Vec<String> = stored_cases().into_iter().filter(|case| !is_drawn(case)).collect();
    assert!(orphans.is_empty(), "no test draws these pictures of tests/golden: {orphans:?}");
}
