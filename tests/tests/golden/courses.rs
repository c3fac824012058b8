//! The scenes of courses, on models of our own.

use trigon::shade::texture::PixelFilter;
use trigon::target::SamplePattern;
use trigon_scene::load::MemoryResolver;
use trigon_scene::math::Mat4;
use trigon_scene::render::course::games101::{self, Homework3};
use trigon_scene::render::course::tinyrenderer::{self, Lesson};
use trigon_scene::render::{RenderSettings, ShaderKind};
use trigon_scene::scene::{Camera, Scene};
use trigon_tests::golden::Shot;

const HEIGHTS: &[u8] = include_bytes!("../../../assets/textures/peel-height.png");

/// Homework 2 with so many samples a pixel.
fn homework_2(samples: u32) -> Shot {
    Shot::obj("v 0 0 0\n", "")
        .scene(|scene| *scene = games101::triangles())
        .seen_by(games101::camera(games101::EYE_2))
        .with(|settings| *settings = RenderSettings { shader: ShaderKind::Unlit, ..games101::settings() })
        .with(|settings| settings.samples = SamplePattern::grid(samples).expect("a number of the grid"))
        .size(96, 96)
}

#[test]
fn games101_homework_2() {
    homework_2(1).check("courses/games101-hw2");
}

/// Edges against black are half as bright in stored values.
#[test]
fn games101_homework_2_with_four_samples() {
    homework_2(4).check("courses/games101-hw2-four-samples");
}

/// Homework 3 with the teapot, whose pictures repeat; its peel is smooth enough for few pixels.
fn homework_3(shading: Homework3, case: &str) {
    let files = MemoryResolver::new().with("hmap.jpg", HEIGHTS);
    let camera = games101::camera(games101::EYE_3);
    Shot::asset("teapot.obj")
        .scene(|scene| {
            let missing = games101::dress(scene, "teapot.obj", shading, &files, 1 << 20);
            assert!(missing.is_empty(), "{missing:?}");
            scene.transform(Mat4::translation([0.0, -1.5, 0.0]));
            scene.transform(Mat4::rotation_y(games101::ANGLE.to_radians()));
            scene.lights = games101::lights(&camera);
        })
        .seen_by(camera)
        .with(|settings| *settings = RenderSettings { shader: ShaderKind::Games101(shading), ..games101::settings() })
        .with(|settings| settings.sampling.wrap = None)
        .with(|settings| settings.sampling.pixel = PixelFilter::Bilinear)
        .with(|settings| settings.relief.height = 0.03)
        .size(96, 96)
        .check(case);
}

#[test]
fn games101_normal() {
    homework_3(Homework3::Normal, "courses/games101-normal");
}

#[test]
fn games101_texture() {
    homework_3(Homework3::Texture, "courses/games101-texture");
}

#[test]
fn games101_phong() {
    homework_3(Homework3::Phong, "courses/games101-phong");
}

#[test]
fn games101_bump() {
    homework_3(Homework3::Bump, "courses/games101-bump");
}

#[test]
fn games101_displacement() {
    homework_3(Homework3::Displacement, "courses/games101-displacement");
}

/// Colours and gloss of the teapot itself.
#[test]
fn tinyrenderer_final() {
    let camera = Camera { near: 0.1, far: 10.0, ..tinyrenderer::camera(tinyrenderer::EYE, &Scene::default()) };
    Shot::asset("teapot.obj")
        .scene(|scene| {
            scene.transform(Mat4::translation([0.0, -1.5, 0.0]));
            scene.transform(Mat4::scaling([0.35; 3]));
            scene.lights = vec![tinyrenderer::light()];
        })
        .seen_by(camera)
        .with(|settings| *settings = tinyrenderer::settings(Lesson::Final))
        .with(|settings| settings.sampling.wrap = None)
        .size(96, 96)
        .check("courses/tinyrenderer");
}
