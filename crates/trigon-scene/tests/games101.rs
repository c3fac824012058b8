//! The scenes of GAMES101: the formulas of homework 3 on a square, in both colour spaces, and the triangles of homework 2.
//!
//! Pictures of the program itself are compared by the tests of `trigon-cli`.

use trigon::pipeline::{Outputs, Picture, Renderer, RendererOptions};
use trigon::target::{ColorSpace, SamplePattern};
use trigon_image::{EncodeOptions, Format, Rgba8Image, encode};
use trigon_scene::load::{LoadOptions, MemoryResolver, load_bytes};
use trigon_scene::render::course::games101::{self, EYE_2, EYE_3, Homework3};
use trigon_scene::render::{RenderSettings, SceneRenderer, ShaderKind};
use trigon_scene::scene::{Camera, Scene};

fn render(scene: &Scene, camera: &Camera, settings: &RenderSettings) -> Picture {
    let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
    let mut picture = Picture::default();
    let drawn = SceneRenderer::new().render(&mut renderer, scene, camera, settings, &mut picture);
    assert_eq!(drawn.unwrap().1, []);
    picture
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 4] {
    picture.color.as_ref().unwrap().get(x, y).unwrap()
}

/// A square at the origin that faces +z, with texture coordinates and one normal.
fn square(normal: [f64; 3]) -> Scene {
    let [x, y, z] = normal;
    let text = format!(
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn {x} {y} {z}\n\
         f 1/1/1 2/2/1 3/3/1 4/4/1\n"
    );
    load_bytes("square_of_tests.obj", text.as_bytes(), &LoadOptions::default()).unwrap().scene
}

/// 2 x 2 pixels in a PNG file, rows from the top.
fn png(pixels: [[u8; 3]; 4]) -> Vec<u8> {
    let pixels = pixels.map(|[r, g, b]| [r, g, b, u8::MAX]).to_vec();
    let image = Rgba8Image::from_pixels(2, 2, pixels).unwrap();
    encode(&image, Format::Png, &EncodeOptions::default()).unwrap()
}

type V = [f64; 3];

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sum(a: V, b: V, scale: f64) -> V {
    [a[0] + b[0] * scale, a[1] + b[1] * scale, a[2] + b[2] * scale]
}

fn unit(v: V) -> V {
    v.map(|c| c / dot(v, v).sqrt())
}

/// The course's phong shader in doubles: `p` and `n` in view space, `kd` and the result in 0 to 1.
fn phong(p: V, n: V, kd: V) -> V {
    let to_viewer = unit(sum([0.0, 0.0, 10.0], p, -1.0));
    let mut color = [0.0; 3];
    for light in [[20.0, 20.0, 20.0], [-20.0, 20.0, 0.0]] {
        let way = sum(light, p, -1.0);
        let (to_light, strength) = (unit(way), 500.0 / dot(way, way));
        let half = unit(sum(to_light, to_viewer, 1.0));
        let highlight = (0..150).fold(1.0, |power, _| power * dot(n, half).max(0.0));
        for (c, kd) in color.iter_mut().zip(kd) {
            *c += 0.005 * 10.0 + kd * strength * dot(n, to_light).max(0.0) + 0.7937 * strength * highlight;
        }
    }
    color
}

/// The tilted normal of the course, for these heights at a point, a texel further along u, and one along v.
fn bumped(n: V, [here, right, above]: [f64; 3]) -> V {
    let [x, y, z] = n;
    let q = (x * x + z * z).sqrt();
    let t = [x * y / q, q, z * y / q];
    let b = [n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]];
    let (du, dv) = (0.02 * (right - here), 0.02 * (above - here));
    unit(sum(sum(n, t, -du), b, -dv))
}

#[test]
fn every_shader_follows_its_formula() {
    let normal = unit([0.1, 0.35, 0.93]);
    let grey = |level: u8| [level; 3];
    let heights = png([grey(60), grey(20), grey(10), grey(30)]);
    let files = MemoryResolver::new().with("square_texture.png", png([[200, 100, 50]; 4])).with("hmap.jpg", heights);
    let length = |level: f64| level * 3.0_f64.sqrt();
    // At the lower left a step of half the picture leads to the other texels; at the upper right it leads outside.
    let tilted = bumped(normal, [10.0, 30.0, 60.0].map(length));
    let level = bumped(normal, [20.0; 3].map(length));
    let camera = games101::camera(EYE_3);
    let kd = [148.0, 121.0, 92.0].map(|code| code / 255.0);
    // The middle of the pixel in column 300 and row 400, at a distance of 10; the tangent of 22.5 degrees is sqrt(2) - 1.
    let per_pixel = 10.0 * (2.0_f64.sqrt() - 1.0) / 350.0;
    let p = [(300.5 - 350.0) * per_pixel, (350.0 - 400.5) * per_pixel, -10.0];
    let moved = sum(p, normal, 0.1 * length(10.0));
    for (shading, at, want) in [
        (Homework3::Normal, [300, 400], normal.map(|c| (c + 1.0) / 2.0)),
        (Homework3::Phong, [300, 400], phong(p, normal, kd)),
        (Homework3::Texture, [300, 400], phong(p, normal, [200.0, 100.0, 50.0].map(|code| code / 255.0))),
        (Homework3::Bump, [300, 400], tilted),
        (Homework3::Bump, [400, 300], level),
        (Homework3::Displacement, [300, 400], phong(moved, tilted, kd)),
    ] {
        for space in [ColorSpace::Encoded, ColorSpace::Linear] {
            let mut scene = square(normal);
            assert_eq!(games101::dress(&mut scene, "square_of_tests.obj", shading, &files, 1 << 10), []);
            scene.lights = games101::lights(&camera);
            let shader = ShaderKind::Games101(shading);
            let settings = RenderSettings { shader, color_space: space, ..games101::settings() };
            let got = pixel(&render(&scene, &camera, &settings), at[0], at[1]);
            for (got, want) in got.into_iter().zip(want) {
                let want = (want * 255.0).clamp(0.0, 255.0);
                assert!(
                    (f64::from(got) - want).abs() <= 1.0,
                    "{} {space:?} {at:?}: {got} is not {want}",
                    shader.name()
                );
            }
        }
    }
}

#[test]
fn lights_and_viewer_go_with_the_camera() {
    let draw = |eye: [f64; 3], offset: [f64; 3]| {
        let camera = games101::camera(eye);
        let mut scene = square([0.0, 0.0, 1.0]);
        games101::dress(&mut scene, "square.obj", Homework3::Phong, &MemoryResolver::new(), 1);
        scene.transform(trigon_scene::math::Mat4::translation(offset));
        scene.lights = games101::lights(&camera);
        let shader = ShaderKind::Games101(Homework3::Phong);
        pixel(&render(&scene, &camera, &RenderSettings { shader, ..games101::settings() }), 340, 360)
    };
    assert_eq!(draw([0.0, 0.0, 10.0], [0.0; 3]), draw([4.0, -8.0, 2.0], [4.0, -8.0, -8.0]));
}

#[test]
fn pictures_that_are_not_there_are_named_and_done_without() {
    for (shading, name) in [(Homework3::Texture, "square_texture.png"), (Homework3::Bump, "hmap.jpg")] {
        let mut scene = square([0.0, 0.0, 1.0]);
        let warnings = games101::dress(&mut scene, "square_of_tests.obj", shading, &MemoryResolver::new(), 1 << 10);
        let names: Vec<&str> = warnings.iter().map(|warning| warning.location.file.as_str()).collect();
        assert_eq!(names, [name]);
    }
}

/// Both colours at places where only one triangle is, and where the nearer one hides the other.
#[test]
fn triangles_of_homework_2() {
    let settings = RenderSettings { shader: ShaderKind::Unlit, ..games101::settings() };
    let scene = games101::triangles();
    let picture = render(&scene, &games101::camera(EYE_2), &settings);
    let (green, blue) = ([217, 238, 185, 255], [185, 217, 238, 255]);
    assert_eq!([(350, 250), (560, 300), (520, 340)].map(|(x, y)| pixel(&picture, x, y)), [green, blue, green]);
    assert_eq!(pixel(&picture, 10, 10), [0, 0, 0, 255]);
    // With four samples, an edge is the mean of bytes: a quarter, a half or three quarters of the colour.
    let settings = RenderSettings { samples: SamplePattern::grid(4).unwrap(), ..settings };
    let picture = render(&scene, &games101::camera(EYE_2), &settings);
    let shares: std::collections::BTreeSet<u8> = (0..350).map(|x| pixel(&picture, x, 250)[0]).collect();
    assert!(shares.iter().all(|share| [0, 54, 109, 163, 217].contains(share)), "{shares:?}");
}

/// Floats are linear light in both spaces, and say the same as the bytes.
#[test]
fn floats_are_linear_whatever_the_colour_space() {
    let outputs = Outputs { color_f32: true, ..Outputs::COLOR };
    let background = [0.25, 0.125, 0.0, 0.5];
    let settings = RenderSettings { shader: ShaderKind::Unlit, outputs, background, ..games101::settings() };
    let scene = games101::triangles();
    let [encoded, linear] = [ColorSpace::Encoded, ColorSpace::Linear]
        .map(|color_space| render(&scene, &games101::camera(EYE_2), &RenderSettings { color_space, ..settings }));
    assert_eq!(encoded.color.as_ref().unwrap().values(), linear.color.as_ref().unwrap().values());
    let floats = |picture: &Picture| picture.color_f32.as_ref().unwrap().values().to_vec();
    for (a, b) in floats(&encoded).as_flattened().iter().zip(floats(&linear).as_flattened()) {
        assert!((a - b).abs() < 1e-5, "{a} is not {b}");
    }
}
