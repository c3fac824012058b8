//! Deadlines: a frame that is not done in time is an error and leaves no picture; a moment far away changes nothing.

use std::time::{Duration, Instant};
use trigon::lanes::SimdLevel;
use trigon::pipeline::{FrameError, Picture, Renderer, RendererOptions};
use trigon::schedule::{Deadline, TileOrder};
use trigon_scene::load::{LoadOptions, load_bytes};
use trigon_scene::render::{RenderError, RenderSettings, SceneRenderer};
use trigon_scene::scene::{Camera, Framing, Scene};

/// Squares behind each other, each larger than the picture, all seen through those before.
fn slow_scene() -> (Scene, Camera, RenderSettings) {
    let mut obj = String::from("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n");
    obj.push_str(&"f 1 2 3 4\n".repeat(1000));
    let scene = load_bytes("squares.obj", obj.as_bytes(), &LoadOptions::default()).unwrap().scene;
    let camera = Framing::default().camera(&scene);
    (scene, camera, RenderSettings::new(512, 512))
}

fn renderer(deadline: Deadline) -> Renderer {
    let options = RendererOptions { threads: 2, simd: SimdLevel::detect(), tile_order: TileOrder::default() };
    let mut renderer = Renderer::new(options).unwrap();
    renderer.set_deadline(deadline);
    renderer
}

#[test]
fn a_frame_after_its_time_is_an_error_without_a_picture() {
    let (scene, camera, settings) = slow_scene();
    let mut scenes = SceneRenderer::new();
    let mut picture = Picture::default();
    let mut renderer = renderer(Deadline::NEVER);
    scenes.render(&mut renderer, &scene, &camera, &settings, &mut picture).unwrap();
    let before = picture.color.clone().unwrap();

    // The same renderer, whose memory holds another frame.
    for allowed in [Duration::ZERO, Duration::from_millis(1)] {
        let small = RenderSettings { width: 64, height: 64, ..settings };
        renderer.set_deadline(Deadline::NEVER);
        scenes.render(&mut renderer, &scene, &camera, &small, &mut picture).unwrap();
        let started = Instant::now();
        renderer.set_deadline(Deadline::after(allowed));
        let drawn = scenes.render(&mut renderer, &scene, &camera, &settings, &mut picture);
        assert!(matches!(drawn, Err(RenderError::Frame(FrameError::TimeOver))), "{allowed:?}");
        assert!(picture.color.is_none(), "{allowed:?}");
        assert!(started.elapsed() < Duration::from_secs(10), "{:?}", started.elapsed());
    }
    renderer.set_deadline(Deadline::after(Duration::from_secs(3600)));
    scenes.render(&mut renderer, &scene, &camera, &settings, &mut picture).unwrap();
    assert!(picture.color.unwrap().values() == before.values());
}

#[test]
fn pixels_are_not_explained_after_the_time() {
    let (scene, camera, settings) = slow_scene();
    let told = SceneRenderer::new().explain(
        &mut renderer(Deadline::after(Duration::ZERO)),
        &scene,
        &camera,
        &settings,
        [9, 9],
    );
    assert!(matches!(told, Err(RenderError::Frame(FrameError::TimeOver))));
}
