//! The stages of the pipeline made visible.

use trigon_scene::render::ShaderKind;
use trigon_tests::golden::{Shot, floor};

fn still_life(shader: ShaderKind, case: &str) {
    Shot::asset("still-life.obj").size(144, 96).shader(shader).check(case);
}

#[test]
fn normal() {
    Shot::asset("teapot.obj").shader(ShaderKind::Normal).check("overlays/normal");
}

#[test]
fn depth() {
    still_life(ShaderKind::Depth, "overlays/depth");
}

#[test]
fn uv() {
    still_life(ShaderKind::Uv, "overlays/uv");
}

#[test]
fn barycentric() {
    Shot::asset("cube.obj").shader(ShaderKind::Barycentric).check("overlays/barycentric");
}

/// Bands of levels across the floor.
#[test]
fn mip_level() {
    let material = "newmtl m\nmap_Kd textures/uv-grid.png\n";
    Shot::obj(&format!("usemtl m\n{}", floor(60)), material)
        .camera([0.1, 0.6, 0.3], [0.0, 0.0, -2.0])
        .shader(ShaderKind::MipLevel)
        .check("overlays/mip-level");
}

#[test]
fn overdraw() {
    still_life(ShaderKind::Overdraw, "overlays/overdraw");
}

#[test]
fn coverage() {
    still_life(ShaderKind::Coverage, "overlays/coverage");
}

#[test]
fn ids() {
    Shot::asset("cube.obj").shader(ShaderKind::Ids).check("overlays/ids");
}

#[test]
fn objects() {
    still_life(ShaderKind::Objects, "overlays/objects");
}
