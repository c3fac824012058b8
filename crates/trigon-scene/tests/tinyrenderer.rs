//! The scene of tinyrenderer: its formulas on a square, and its models against pictures that the program made, where
//! the shared data is there.
//! `cargo test -p trigon-scene --test tinyrenderer -- --nocapture` prints how well each agrees.

#[path = "../../../tests/shared_data.rs"]
mod shared_data;

use shared_data::shared_data;
use std::path::Path;

use trigon::pipeline::{Picture, Renderer, RendererOptions};
use trigon_image::{Limits, Rgba8Image, decode};
use trigon_scene::load::{DirectoryResolver, LoadOptions, MemoryResolver, load_bytes, load_path};
use trigon_scene::render::SceneRenderer;
use trigon_scene::render::course::tinyrenderer::{self, EYE, Lesson};
use trigon_scene::scene::Scene;

/// The part of the pixels that must be within 3/255.
const AGREEMENT: f64 = 0.99;

/// The models, each with its pictures.
fn scene(folder: &Path, models: &[&str], lesson: Lesson) -> Scene {
    let mut scene = Scene::default();
    for model in models {
        let path = folder.join(model);
        let mut loaded = load_path(&path, &LoadOptions::default()).unwrap();
        assert_eq!(loaded.warnings, []);
        let beside = DirectoryResolver::new(path.parent().unwrap());
        let name = path.file_name().unwrap().to_string_lossy();
        let missing = tinyrenderer::dress(&mut loaded.scene, &name, lesson, &beside, 1 << 28);
        assert_eq!(missing, []);
        scene.merge(loaded.scene);
    }
    scene.lights.push(tinyrenderer::light());
    scene
}

fn draw(scene: &Scene, lesson: Lesson) -> Rgba8Image {
    let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
    let mut picture = Picture::default();
    let camera = tinyrenderer::camera(EYE, scene);
    let settings = tinyrenderer::settings(lesson);
    let (_, warnings) = SceneRenderer::new().render(&mut renderer, scene, &camera, &settings, &mut picture).unwrap();
    assert_eq!(warnings, []);
    Rgba8Image::from_pixels(800, 800, picture.color.unwrap().into_values()).unwrap()
}

#[test]
fn pictures_of_the_program() {
    let Some(data) = shared_data() else { return };
    let (models, pictures) = (data.join("tinyrenderer/obj"), data.join("reference/tinyrenderer"));
    let (diablo, head) = ("diablo3_pose/diablo3_pose.obj", "african_head/african_head.obj");
    let scenes: [(&str, &[&str]); 5] = [
        ("diablo3_floor", &[diablo, "floor.obj"]),
        ("diablo3", &[diablo]),
        ("african_head_eyes", &[head, "african_head/african_head_eye_inner.obj"]),
        ("african_head", &[head]),
        ("floor", &["floor.obj"]),
    ];
    let mut failures = Vec::new();
    for (name, parts) in scenes {
        let drawn = draw(&scene(&models, parts, Lesson::Final), Lesson::Final);
        let bytes = std::fs::read(pictures.join(name).with_extension("png")).unwrap();
        let expected = decode(&bytes, None, &Limits::default()).unwrap().into_rgba8();
        let comparison = trigon_image::compare(&drawn, &expected).unwrap();
        let agreement = 1.0 - comparison.pixels_over(3) as f64 / comparison.pixels() as f64;
        println!("{name:<20} {:.4} % within 3/255, rmse {:.3}", agreement * 100.0, comparison.rmse);
        if agreement < AGREEMENT {
            failures.push(name);
        }
    }
    assert_eq!(failures, Vec::<&str>::new());
}

/// A square that faces +z; its texture coordinates and normals are those of a poster.
const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n\
                      f 1/1/1 2/2/1 3/3/1 4/4/1\n";

/// A picture of one colour: 2 x 2 pixels in a TGA file.
fn tga([r, g, b]: [u8; 3]) -> Vec<u8> {
    let mut bytes = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0];
    (0..4).for_each(|_| bytes.extend([b, g, r]));
    bytes
}

/// The formula of the program in doubles: the byte for a texel, the normal, and the weights of its terms.
fn byte(texel: f64, n: [f64; 3], [ambient, diffuse, specular]: [f64; 3]) -> f64 {
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let unit = |v: [f64; 3]| v.map(|c| c / dot(v, v).sqrt());
    let (n, l) = (unit(n), unit(tinyrenderer::TO_LIGHT));
    let r = [0, 1, 2].map(|i| 2.0 * n[i] * dot(n, l) - l[i]);
    let shine = (0..35).fold(1.0, |power, _| power * dot(r, unit(EYE)).max(0.0));
    (texel * (ambient + diffuse * dot(n, l).max(0.0) + specular * shine)).min(255.0).floor()
}

#[test]
fn every_lesson_follows_its_formula() {
    // A normal between the light and the eye, so that the highlight counts: x 0.1, y 0.35 and z 0.93, about.
    let tilted = [140, 172, 246];
    let normal = tilted.map(|code| f64::from(code) / 127.5 - 1.0);
    let files = MemoryResolver::new()
        .with("poster_diffuse.tga", tga([200, 100, 50]))
        .with("poster_nm_tangent.tga", tga(tilted))
        .with("poster_nm.tga", tga(tilted))
        .with("poster_spec.tga", tga([0, 0, 51]))
        .with("poster_glow.tga", tga([10, 20, 40]));
    // v of the picture runs down, so green of the tangent-space map points down.
    let [x, y, z] = normal;
    let (flat, down) = ([0.0, 0.0, 1.0], [x, -y, z]);
    let colors = [200.0, 100.0, 50.0];
    let glow = [10.0, 20.0, 40.0];
    for (lesson, want) in [
        (Lesson::Final, colors.map(|c| byte(c, down, [0.4, 1.0, 0.5 + 2.0 * 0.2]))),
        (Lesson::TangentNormals, colors.map(|c| byte(c, down, [0.4, 1.0, 3.0 * 0.2]))),
        (Lesson::ObjectNormals, [byte(255.0, normal, [0.3, 0.4, 0.9]); 3]),
        (Lesson::Phong, [byte(255.0, flat, [0.3, 0.4, 0.9]); 3]),
        (Lesson::Flat, [byte(255.0, flat, [30.0 / 255.0, 1.0, 0.0]); 3]),
        (Lesson::Glow, [0, 1, 2].map(|i| byte(colors[i], down, [0.4, 1.0, 0.9]) + glow[i])),
    ] {
        let mut scene = load_bytes("poster.obj", SQUARE.as_bytes(), &LoadOptions::default()).unwrap().scene;
        assert_eq!(tinyrenderer::dress(&mut scene, "poster.obj", lesson, &files, 1 << 10), []);
        scene.lights.push(tinyrenderer::light());
        let got = draw(&scene, lesson).pixel(400, 400);
        for (got, want) in got.into_iter().zip(want) {
            assert!((f64::from(got) - want).abs() <= 1.0, "{}: {got} is not {want}", lesson.name());
        }
    }
}

/// Two steps of a stair that faces the viewer: x below 0 lies `depth` behind x above 0.
fn stair(depth: f64) -> Scene {
    let text = format!(
        "v 0 -1 0\nv 1 -1 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n\
         v -1 -1 -{depth}\nv 0 -1 -{depth}\nv 0 1 -{depth}\nv -1 1 -{depth}\nf 5 6 7 8\n"
    );
    let mut scene = load_bytes("stair.obj", text.as_bytes(), &LoadOptions::default()).unwrap().scene;
    scene.lights.push(tinyrenderer::light());
    scene
}

/// As [`draw`], from the front.
fn draw_from_front(scene: &Scene, lesson: Lesson) -> Rgba8Image {
    let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
    let mut picture = Picture::default();
    let camera = tinyrenderer::camera([0.0, 0.0, 3.0], scene);
    let settings = tinyrenderer::settings(lesson);
    SceneRenderer::new().render(&mut renderer, scene, &camera, &settings, &mut picture).unwrap();
    Rgba8Image::from_pixels(800, 800, picture.color.unwrap().into_values()).unwrap()
}

#[test]
fn depths_are_those_of_the_program() {
    let picture = draw_from_front(&stair(0.6), Lesson::Depth);
    // z/w with w = 1 - z/3, as a grey: 0 in the plane of the target.
    let grey = |z: f64| ((z / (1.0 - z / 3.0) + 1.0) * 127.5).floor();
    for (x, z) in [(600, 0.0), (200, -0.6)] {
        let [r, g, b, _] = picture.pixel(x, 400);
        assert!((f64::from(r) - grey(z)).abs() <= 1.0 && r == g && g == b, "{r} is not {}", grey(z));
    }
    assert_eq!(picture.pixel(5, 5), [0, 0, 0, 255], "black where nothing is");
}

#[test]
fn toon_has_three_steps_and_lines_at_steps_in_depth() {
    // n.l = 1 / sqrt(3), and 0.15: the brightest step. A step in depth of h makes 4 h of Sobel's filter.
    let outlined = draw_from_front(&stair(0.1), Lesson::Toon);
    assert_eq!(outlined.pixel(600, 400), [255, 224, 88, 255]);
    assert_eq!([399, 400].map(|x| outlined.pixel(x, 300)), [[0, 0, 0, 255]; 2], "both sides of the step");
    assert_eq!(outlined.pixel(402, 300), [255, 224, 88, 255]);
    let smooth = draw_from_front(&stair(0.02), Lesson::Toon);
    assert_eq!(smooth.pixel(400, 300), [255, 224, 88, 255], "0.08 is below the threshold of 0.15");
    // The second model is grey.
    let mut two = stair(0.1);
    let mut second = stair(0.1);
    second.instances[0].world_from_model.columns[3][0] = -0.2;
    second.instances[0].world_from_model.columns[3][2] = 0.2;
    two.merge(second);
    assert_eq!(draw_from_front(&two, Lesson::Toon).pixel(200, 400), [88, 98, 123, 255]);
}

#[test]
fn occlusion_darkens_the_foot_of_a_step_only() {
    let picture = draw_from_front(&stair(0.1), Lesson::Occlusion);
    let mean = |columns: std::ops::Range<u32>| {
        let n = f64::from((columns.end - columns.start) * 100);
        columns
            .flat_map(|x| (350..450).map(move |y| (x, y)))
            .map(|(x, y)| f64::from(picture.pixel(x, y)[0]))
            .sum::<f64>()
            / n
    };
    // On a plane half of the points lie behind it: smoothstep(1 - 0.4 / 2) = 0.896.
    let level = 0.896 * 255.0;
    assert!((mean(550..600) - level).abs() < 4.0, "{} is not {level}", mean(550..600));
    assert!((mean(200..250) - level).abs() < 4.0, "{} is not {level}", mean(200..250));
    let (foot, edge) = (mean(390..398), mean(402..410));
    assert!(foot < level - 15.0, "beside the step {foot} is darker than {level}");
    assert!(edge > level + 5.0, "on its edge {edge} is lighter");
    assert_eq!(picture.pixel(5, 5), [209, 195, 177, 255], "the background stays");
}

#[test]
fn pictures_that_are_not_there_are_named_and_done_without() {
    let mut scene = load_bytes("poster.obj", SQUARE.as_bytes(), &LoadOptions::default()).unwrap().scene;
    let warnings = tinyrenderer::dress(&mut scene, "poster.obj", Lesson::Final, &MemoryResolver::new(), 1 << 10);
    let names: Vec<&str> = warnings.iter().map(|warning| warning.location.file.as_str()).collect();
    assert_eq!(names, ["poster_diffuse.tga", "poster_nm_tangent.tga", "poster_spec.tga"]);
    scene.lights.push(tinyrenderer::light());
    assert_ne!(draw(&scene, Lesson::Final).pixel(400, 400), draw(&Scene::default(), Lesson::Final).pixel(400, 400));
}
