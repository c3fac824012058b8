//! Every preset on models of our own, drawn by the command as anybody would, compared with `tests/golden/courses`.
//!
//! So a golden has the constants of the preset itself. What models of our own need is written out: where they stand.

use crate::support::{Folder, read_picture};
use std::path::{Path, PathBuf};
use trigon_image::{EncodeOptions, Format, Limits, Rgba8Image, decode, encode};
use trigon_tests::golden::{check, sphere};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn asset(name: &str) -> Vec<u8> {
    let path = root().join("assets").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Draws with these options in the folder, and compares.
fn draws(folder: &Folder, options: &str, case: &str) {
    check(case, &folder.picture(options));
}

/// Draws the picture `file` of the goldens as the program of CS184 does, all of it.
fn cs184(file: &str, options: &str, case: &str) {
    let path = root().join("tests/golden/courses").join(file);
    let folder = Folder::new();
    let words = ["render", "--preset", "cs184", "-o", "picture.png"].into_iter().chain(options.split(' '));
    let output = folder.command(words).arg(path).output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
    check(case, &read_picture(&folder.path("picture.png")));
}

#[test]
fn cs184_elements() {
    let view = "--size 144x108 --view 60,45,47";
    cs184("cs184.svg", view, "courses/cs184");
    cs184("cs184.svg", &format!("{view} --samples 4"), "courses/cs184-4-samples");
    cs184("cs184.svg", &format!("{view} --samples 9"), "courses/cs184-9-samples");
    cs184("cs184.svg", &format!("{view} --samples 16"), "courses/cs184-16-samples");
}

/// All six ways to read a texture: made smaller on the left, enlarged on the right.
#[test]
fn cs184_textures() {
    let draw = |pixel: &str, level: &str, case: &str| {
        let options = format!("--size 96x64 --view 48,32,33 --pixel-filter {pixel} --level-filter {level}");
        cs184("cs184-texture.svg", &options, case);
    };
    draw("nearest", "zero", "courses/cs184-nearest-zero");
    draw("nearest", "nearest", "courses/cs184-nearest-nearest");
    draw("nearest", "linear", "courses/cs184-nearest-linear");
    draw("bilinear", "zero", "courses/cs184-bilinear-zero");
    draw("bilinear", "nearest", "courses/cs184-bilinear-nearest");
    draw("bilinear", "linear", "courses/cs184-bilinear-linear");
}

/// Edges against black are half as bright in stored values.
#[test]
fn games101_homework_2() {
    let folder = Folder::new();
    draws(&folder, "--preset games101-hw2 --size 96", "courses/games101-hw2");
    draws(&folder, "--preset games101-hw2 --size 96 --samples 4", "courses/games101-hw2-four-samples");
}

/// The teapot with the pictures that homework 3 looks for beside a model.
#[test]
fn games101_homework_3() {
    let folder = Folder::new()
        .with("teapot.obj", asset("teapot.obj"))
        .with("teapot.mtl", "newmtl glaze\n")
        .with("teapot_texture.png", asset("textures/glaze.png"))
        .with("hmap.jpg", asset("textures/peel-height.png"));
    let view = "teapot.obj --size 96 --scale 1 --eye 0,1.5,10 --target 0,1.5,0 --wrap repeat";
    let draw = |options: &str, case: &str| draws(&folder, &format!("{view} --preset games101-hw3 {options}"), case);
    draw("", "courses/games101-phong");
    draw("--shader normal", "courses/games101-normal");
    draw("--shader texture", "courses/games101-texture");
    draw("--shader texture --pixel-filter bilinear", "courses/games101-texture-bilinear");
    draw("--shader texture --interpolation affine", "courses/games101-texture-affine");
    // Few pixels want smooth heights.
    draw("--shader bump --pixel-filter bilinear --bump-height 0.03", "courses/games101-bump");
    draw("--shader displacement --pixel-filter bilinear --bump-height 0.03", "courses/games101-displacement");
}

/// The teapot with the pictures that tinyrenderer looks for by the name of a model.
fn painted_teapot() -> Folder {
    Folder::new()
        .with("teapot.obj", asset("teapot.obj"))
        .with("teapot.mtl", "newmtl glaze\n")
        .with("teapot_diffuse.tga", tga(&texture("glaze.png")))
        .with("teapot_spec.tga", tga(&texture("glaze-specular.png")))
        .with("teapot_nm_tangent.tga", tga(&texture("hammered-normal.png")))
        .with("teapot_glow.tga", tga(&texture("lattice-alpha.png")))
}

fn texture(name: &str) -> Rgba8Image {
    decode(&asset(&format!("textures/{name}")), None, &Limits::default()).unwrap().into_rgba8()
}

fn tga(image: &Rgba8Image) -> Vec<u8> {
    encode(image, Format::Tga, &EncodeOptions::default()).unwrap()
}

const TEAPOT: &str = "teapot.obj --size 96 --scale 0.35 --eye -1,0.9,2 --target 0,0.5,0 --wrap repeat";

#[test]
fn tinyrenderer_lessons() {
    let folder = painted_teapot();
    let draw = |options: &str, case: &str| draws(&folder, &format!("{TEAPOT} --preset tinyrenderer {options}"), case);
    draw("", "courses/tinyrenderer");
    draw("--shader tinyrenderer-flat", "courses/tinyrenderer-flat");
    draw("--shader tinyrenderer-phong", "courses/tinyrenderer-phong");
    draw("--shader tinyrenderer-tangent-normals", "courses/tinyrenderer-tangent-normals");
    draw("--shader tinyrenderer-glow", "courses/tinyrenderer-glow");
    draw("--shader tinyrenderer-depth", "courses/tinyrenderer-depth");
    let folder = folder.with("cube.obj", asset("cube.obj"));
    let lines = "cube.obj --preset tinyrenderer --quiet --size 96 --scale 0.5 --wireframe=only --background #000";
    draws(&folder, lines, "courses/tinyrenderer-lines");
}

#[test]
fn tinyrenderer_passes() {
    let folder = painted_teapot();
    let draw = |options: &str, case: &str| draws(&folder, &format!("{TEAPOT} --preset tinyrenderer {options}"), case);
    draw("--shadows --shadow-map-size 256", "courses/tinyrenderer-shadows");
    draw("--shader tinyrenderer-ssao", "courses/tinyrenderer-occlusion");
    draw("--shader tinyrenderer-toon", "courses/tinyrenderer-toon");
}

/// Normals in the model's coordinates: those of a sphere, with ripples around its axis.
#[test]
fn tinyrenderer_object_normals() {
    let (columns, rows) = (64_u32, 32_u32);
    let mut normals = Rgba8Image::new(columns, rows);
    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
        let longitude = ((f64::from(x) + 0.5) / f64::from(columns) - 0.5) * std::f64::consts::TAU;
        let height = 1.0 - 2.0 * (f64::from(y) + 0.5) / f64::from(rows);
        let latitude = height * std::f64::consts::FRAC_PI_2 + 0.4 * libm::sin(12.0 * height);
        let radius = libm::cos(latitude);
        let normal = [libm::sin(longitude) * radius, libm::sin(latitude), libm::cos(longitude) * radius];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
        let [r, g, b] = normal.map(|c| libm::round((c + 1.0) * 127.5) as u8);
        normals.set_pixel(x, y, [r, g, b, 255]);
    }
    let folder = Folder::new().with("ball.obj", sphere(0.0)).with("ball_nm.tga", tga(&normals));
    let options = "ball.obj --preset tinyrenderer --shader tinyrenderer-object-normals --size 96";
    draws(&folder, options, "courses/tinyrenderer-object-normals");
}

/// The teapot in its own materials, a sphere in those of the program, and a picture of the turn.
#[test]
fn learning_tinyrenderer() {
    let folder = Folder::new()
        .with("teapot.obj", asset("teapot.obj"))
        .with("teapot.mtl", asset("teapot.mtl"))
        .with("ball.obj", sphere(0.0));
    std::fs::create_dir(folder.path("textures")).unwrap();
    for name in ["glaze.png", "glaze-specular.png", "glaze-exponent.png"] {
        std::fs::write(folder.path("textures").join(name), asset(&format!("textures/{name}"))).unwrap();
    }
    let preset = "--preset learning-tinyrenderer --size 96";
    let teapot = format!("teapot.obj {preset} --scale 0.3 --target 0,0.45,0");
    draws(&folder, &teapot, "courses/learning-tinyrenderer");
    // It looks for pictures by the name of the model, and does without.
    draws(&folder, &format!("ball.obj {preset} --quiet"), "courses/learning-tinyrenderer-plain");
    folder.run(&format!("turntable {teapot} -n 3 -o f{{frame}}.png")).succeeds_quietly();
    let last = folder.names().into_iter().rfind(|name| name.starts_with('f')).unwrap();
    check("courses/learning-tinyrenderer-turned", &read_picture(&folder.path(&last)));
}
