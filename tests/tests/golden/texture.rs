//! Orientation, filters, wrapping and options of textures.

use trigon::shade::Interpolation;
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon_scene::render::TextureSampling;
use trigon_tests::golden::{Shot, floor, square};

const GRID: &str = "newmtl m\nillum 0\nKd 1 1 1\nmap_Kd textures/uv-grid.png\n";

/// The numbered grid on a floor that runs to the horizon.
fn on_floor(change: impl FnOnce(&mut TextureSampling), case: &str) {
    Shot::obj(&format!("usemtl m\n{}", floor(60)), GRID)
        .camera([0.1, 0.6, 0.3], [0.0, 0.0, -2.0])
        .with(|settings| change(&mut settings.sampling))
        .check(case);
}

fn filters(pixel: PixelFilter, level: LevelFilter, case: &str) {
    on_floor(|sampling| (sampling.pixel, sampling.level) = (pixel, level), case);
}

/// A square whose texture coordinates reach from -1/2 to 3/2.
fn wrapped(wrap: Wrap, case: &str) {
    let square = square().replace("vt 0 0", "vt -.5 -.5").replace("vt 1 0", "vt 1.5 -.5");
    let square = square.replace("vt 1 1", "vt 1.5 1.5").replace("vt 0 1", "vt -.5 1.5");
    Shot::obj(&format!("usemtl m\n{square}"), GRID).face_on().with(|s| s.sampling.wrap = Some(wrap)).check(case);
}

fn with_options(options: &str, case: &str) {
    let material = GRID.replace("map_Kd", &format!("map_Kd {options}"));
    Shot::obj(&format!("usemtl m\n{}", square()), &material).face_on().check(case);
}

/// A1 is at the bottom left, H8 at the top right.
#[test]
fn upright() {
    with_options("", "texture/upright");
}

#[test]
fn cube() {
    Shot::asset("cube.obj").check("texture/cube");
}

#[test]
fn nearest_level_zero() {
    filters(PixelFilter::Nearest, LevelFilter::Zero, "texture/nearest-level-zero");
}

#[test]
fn bilinear_level_zero() {
    filters(PixelFilter::Bilinear, LevelFilter::Zero, "texture/bilinear-level-zero");
}

#[test]
fn bilinear_level_nearest() {
    filters(PixelFilter::Bilinear, LevelFilter::Nearest, "texture/bilinear-level-nearest");
}

#[test]
fn trilinear() {
    filters(PixelFilter::Bilinear, LevelFilter::Linear, "texture/trilinear");
}

#[test]
fn anisotropy_16() {
    on_floor(|sampling| sampling.max_anisotropy = 16, "texture/anisotropy-16");
}

#[test]
fn lod_bias_of_two() {
    on_floor(|sampling| sampling.lod_bias = 2.0, "texture/lod-bias-of-two");
}

#[test]
fn wrap_repeat() {
    wrapped(Wrap::Repeat, "texture/wrap-repeat");
}

#[test]
fn wrap_mirror() {
    wrapped(Wrap::Mirror, "texture/wrap-mirror");
}

#[test]
fn wrap_clamp() {
    wrapped(Wrap::ClampToEdge, "texture/wrap-clamp");
}

#[test]
fn wrap_border() {
    wrapped(Wrap::Border([0.6, 0.05, 0.05, 1.0]), "texture/wrap-border");
}

/// Twice as often to the right, once upwards, moved a quarter to the left.
#[test]
fn scale_and_offset() {
    with_options("-s 2 1 1 -o 0.25 0 0", "texture/scale-and-offset");
}

/// Outside of the texture the map has no effect.
#[test]
fn clamp_option() {
    with_options("-s 2 2 1 -o -0.5 -0.5 0 -clamp on", "texture/clamp-option");
}

/// Lines of a pattern break where two triangles of a side meet.
#[test]
fn affine_interpolation() {
    Shot::asset("cube.obj")
        .camera([1.4, 1.3, 2.0], [0.0, 0.0, 0.0])
        .with(|settings| settings.interpolation = Interpolation::Affine)
        .check("texture/affine-interpolation");
}
