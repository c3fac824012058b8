//! Coverage, depth and clipping.

use std::fmt::Write;
use trigon::geometry::Cull;
use trigon::target::SamplePattern;
use trigon_scene::render::ShaderKind;
use trigon_tests::golden::{Shot, floor};

/// A disc of 61 slivers about its centre.
fn fan() -> String {
    let mut text = "v 0.03 -0.02 0\n".to_owned();
    for i in 0..61 {
        let angle = f64::from(i) / 61.0 * std::f64::consts::TAU;
        let _ = writeln!(text, "v {:.5} {:.5} 0", libm::cos(angle), libm::sin(angle));
    }
    for i in 0..61 {
        let _ = writeln!(text, "f 1 {} {}", i + 2, (i + 1) % 61 + 2);
    }
    text
}

/// A triangle whose edges have three different slopes.
const TRIANGLE: &str = "v -1 -0.8 0\nv 1 -0.4 0\nv -0.2 0.9 0\nf 1 2 3\n";

/// Two squares that cross each other along a slanted line, in two colours.
const CROSSING: &str = "v -1 -1 -0.5\nv 1 -1 0.7\nv 1 1 0.3\nv -1 1 -0.9\nv -1 -1 0.5\nv 1 -1 -0.7\nv 1 1 -0.3\n\
     v -1 1 0.9\nusemtl a\nf 1 2 3 4\nusemtl b\nf 5 6 7 8\n";
const TWO_COLORS: &str = "newmtl a\nillum 0\nKd 0.9 0.3 0.2\nnewmtl b\nillum 0\nKd 0.2 0.4 0.8\n";

fn samples(pattern: Option<SamplePattern>, case: &str) {
    let pattern = pattern.expect("a pattern");
    Shot::obj(TRIANGLE, "")
        .face_on()
        .size(32, 32)
        .shader(ShaderKind::Coverage)
        .with(|s| s.samples = pattern)
        .check(case);
}

#[test]
fn coverage_one_sample() {
    samples(Some(SamplePattern::CENTER), "raster/coverage-one-sample");
}

#[test]
fn coverage_standard_4() {
    samples(SamplePattern::standard(4), "raster/coverage-standard-4");
}

#[test]
fn coverage_standard_16() {
    samples(SamplePattern::standard(16), "raster/coverage-standard-16");
}

#[test]
fn coverage_grid_9() {
    samples(SamplePattern::grid(9), "raster/coverage-grid-9");
}

/// One colour inside: each sample is covered once, along the spokes too.
#[test]
fn fan_covers_each_sample_once() {
    Shot::obj(&fan(), "").face_on().shader(ShaderKind::Overdraw).check("raster/fan-covers-each-sample-once");
}

#[test]
fn crossing_squares() {
    Shot::obj(CROSSING, TWO_COLORS).face_on().check("raster/crossing-squares");
}

/// The floor passes below the eye and behind it.
#[test]
fn near_plane() {
    let material = "newmtl m\nillum 0\nKd 1 1 1\nmap_Kd textures/uv-grid.png\n";
    Shot::obj(&format!("usemtl m\n{}", floor(30)), material)
        .camera([0.4, 0.25, -3.0], [0.0, 0.0, -8.0])
        .check("raster/near-plane");
}

#[test]
fn cull_front_shows_the_inside() {
    Shot::asset("cube.obj").with(|s| s.cull = Cull::Front).check("raster/cull-front-shows-the-inside");
}

#[test]
fn cull_back_changes_nothing_of_a_closed_mesh() {
    Shot::asset("cube.obj").with(|s| s.cull = Cull::Back).check("raster/cull-back-of-a-closed-mesh");
}
