//! Lines, points and wireframes.

use std::fmt::Write;
use trigon::target::SamplePattern;
use trigon_scene::render::Wireframe;
use trigon_tests::golden::Shot;

/// Spokes in every direction, each from a quarter of the radius outwards.
fn star() -> String {
    let mut text = String::new();
    for i in 0..24 {
        let angle = (f64::from(i) + 0.3) / 24.0 * std::f64::consts::TAU;
        let (x, y) = (libm::cos(angle), libm::sin(angle));
        let _ = writeln!(text, "v {:.5} {:.5} 0\nv {x:.5} {y:.5} 0\nl -2 -1", x * 0.25, y * 0.25);
    }
    text
}

const BLACK: &str = "newmtl m\nillum 0\nKd 0 0 0\n";

fn star_of_width(width: f32, case: &str) {
    let samples = SamplePattern::standard(16).expect("a pattern");
    Shot::obj(&format!("usemtl m\n{}", star()), BLACK)
        .face_on()
        .with(|s| (s.line_width_px, s.samples) = (width, samples))
        .check(case);
}

#[test]
fn thin_star() {
    star_of_width(0.75, "lines/thin-star");
}

#[test]
fn wide_star() {
    star_of_width(6.0, "lines/wide-star");
}

/// A spiral of vertices, nearer ones larger in brightness by their colour.
#[test]
fn point_cloud() {
    let mut text = String::new();
    for i in 0..300 {
        let t = f64::from(i) / 300.0;
        let (x, y) = (libm::cos(t * 40.0) * t, libm::sin(t * 40.0) * t);
        let _ = writeln!(text, "v {x:.5} {y:.5} {t:.5} {:.3} {:.3} {:.3}", t, 1.0 - t, 0.5);
    }
    Shot::obj(&text, "").with(|s| s.point_size_px = 3.0).check("lines/point-cloud");
}

fn wireframe(change: impl FnOnce(&mut Wireframe), case: &str) {
    let mut wireframe = Wireframe::default();
    change(&mut wireframe);
    Shot::asset("cube.obj").with(|s| s.wireframe = Some(wireframe)).check(case);
}

#[test]
fn wireframe_over_the_surface() {
    wireframe(|w| w.width_px = 1.5, "lines/wireframe-over-the-surface");
}

#[test]
fn wireframe_alone() {
    wireframe(|w| w.surface = false, "lines/wireframe-alone");
}

#[test]
fn hidden_lines_too() {
    wireframe(|w| (w.hidden_lines, w.color) = (true, [0.8, 0.0, 0.0, 1.0]), "lines/hidden-lines-too");
}

#[test]
fn translucent_wireframe_of_a_teapot() {
    let wireframe = Wireframe { color: [0.0, 0.1, 0.3, 0.5], width_px: 0.6, ..Wireframe::default() };
    let shot = Shot::asset("teapot.obj").with(|s| s.wireframe = Some(wireframe));
    shot.check("lines/translucent-wireframe-of-a-teapot");
}
