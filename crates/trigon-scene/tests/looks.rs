//! How scenes look: small OBJ files through the loader and the renderer, judged by the pixels that come out.

use std::sync::Arc;
use trigon::pipeline::{Picture, Renderer, RendererOptions};
use trigon_scene::load::{LoadOptions, Loaded, MemoryResolver, load_bytes};
use trigon_scene::math::Mat4;
use trigon_scene::render::{RenderError, RenderSettings, SceneRenderer, ShaderKind, Shadows};
use trigon_scene::scene::{Framing, Light, LightKind, Scene};

const SIZE: u32 = 96;

/// A square in the xy plane with texture coordinates.
const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\nf 1/1 2/2 3/3 4/4\n";

/// `shape` with one material, whose statements are `material`; `bumps.tga` and `heights.tga` are there to be used.
fn load(shape: &str, material: &str) -> Loaded {
    let files = MemoryResolver::new().with("m.mtl", format!("newmtl m\n{material}\n"));
    let files = files.with("bumps.tga", bumps()).with("heights.tga", heights());
    let mut options = LoadOptions::default();
    options.resolver = Some(Arc::new(files));
    load_bytes("a.obj", format!("mtllib m.mtl\nusemtl m\n{shape}").as_bytes(), &options).unwrap()
}

fn scene(shape: &str, material: &str) -> Scene {
    let loaded = load(shape, material);
    assert_eq!(loaded.warnings, []);
    loaded.scene
}

/// A unit sphere with normals and texture coordinates.
fn sphere() -> String {
    const ROWS: u32 = 24;
    let (mut vertices, mut faces) = (String::new(), String::new());
    let angle = |i: u32| std::f64::consts::PI * f64::from(i) / f64::from(ROWS);
    for (i, j) in (0..=ROWS).flat_map(|i| (0..=2 * ROWS).map(move |j| (i, j))) {
        let (ring, y) = (libm::sin(angle(i)), libm::cos(angle(i)));
        let (x, z) = (ring * libm::sin(angle(j)), ring * libm::cos(angle(j)));
        let (u, v) = (f64::from(j) / 12.0, 2.0 - f64::from(i) / 12.0);
        vertices += &format!("v {x} {y} {z}\nvn {x} {y} {z}\nvt {u} {v}\n");
        if i < ROWS && j < 2 * ROWS {
            let a = i * (2 * ROWS + 1) + j + 1;
            let c = a + 2 * ROWS + 1;
            let corners = [a, c, c + 1, a + 1].map(|n| format!("{n}/{n}/{n}"));
            faces += &format!("f {}\n", corners.join(" "));
        }
    }
    vertices + &faces
}

/// A normal map of 16 x 16 texels: ridges that run along u and, weaker, along v. An uncompressed TGA, bottom row first.
fn bumps() -> Vec<u8> {
    let mut bytes = TGA_HEADER.to_vec();
    for (row, column) in (0..16_u8).flat_map(|row| (0..16_u8).map(move |column| (row, column))) {
        let tilt = |i: u8, strength: u8| if i % 8 < 4 { 128 + strength } else { 128 - strength };
        bytes.extend([225, tilt(row, 40), tilt(column, 70)]);
    }
    bytes
}

/// A height map of 16 x 16 texels: steps along u.
fn heights() -> Vec<u8> {
    let mut bytes = TGA_HEADER.to_vec();
    (0..256_u32).for_each(|i| bytes.extend(if i % 8 < 4 { [200; 3] } else { [50; 3] }));
    bytes
}

/// 16 x 16 texels of blue, green, red.
const TGA_HEADER: [u8; 18] = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 16, 0, 16, 0, 24, 0];

fn settings() -> RenderSettings {
    RenderSettings::new(SIZE, SIZE)
}

/// The stored codes of the picture of a framed scene.
fn draw(scene: &Scene, settings: &RenderSettings) -> Vec<[u8; 4]> {
    let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
    let mut picture = Picture::default();
    let camera = Framing::default().camera(scene);
    let drawn = SceneRenderer::new().render(&mut renderer, scene, &camera, settings, &mut picture);
    assert_eq!(drawn.unwrap().1, []);
    picture.color.unwrap().values().to_vec()
}

/// The mean over all pixels of the largest difference of a channel.
fn difference(a: &[[u8; 4]], b: &[[u8; 4]]) -> f64 {
    let largest = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0);
    a.iter().zip(b).map(|pair| f64::from(largest(pair))).sum::<f64>() / a.len() as f64
}

fn without_tangents(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.meshes.iter_mut().for_each(|mesh| mesh.tangents.clear());
    scene
}

#[test]
fn the_default_lights_make_white_bright_but_do_not_clip_it() {
    let picture = draw(&scene(&sphere(), "Kd 1 1 1\nKs 0 0 0"), &settings());
    let brightest = picture.iter().flat_map(|pixel| &pixel[..3]).max().copied().unwrap();
    assert!((245..255).contains(&brightest), "{brightest}");
}

#[test]
fn an_exponent_of_zero_makes_no_highlight() {
    let dull = draw(&scene(&sphere(), "Kd 0.5 0.5 0.5\nKs 0 0 0"), &settings());
    assert_eq!(draw(&scene(&sphere(), "Kd 0.5 0.5 0.5\nKs 1 1 1\nNs 0"), &settings()), dull);
    assert!(difference(&draw(&scene(&sphere(), "Kd 0.5 0.5 0.5\nKs 1 1 1\nNs 20"), &settings()), &dull) > 1.0);
}

#[test]
fn what_only_tr_would_hide_is_drawn() {
    let loaded = load(SQUARE, "Kd 1 0 0\nTr 1");
    assert!(loaded.warnings[0].message.contains("drawn opaque"), "{:?}", loaded.warnings);
    let opaque = draw(&scene(SQUARE, "Kd 1 0 0"), &settings());
    assert_eq!(draw(&loaded.scene, &settings()), opaque);
    assert_ne!(draw(&scene(SQUARE, "Kd 1 0 0\nd 0"), &settings()), opaque);
}

#[test]
fn lines_and_points_without_a_colour_stand_out() {
    for (name, shape) in
        [("lines", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3 1\n"), ("points", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")]
    {
        let scene = load_bytes("a.obj", shape.as_bytes(), &LoadOptions::default()).unwrap().scene;
        for background in [RenderSettings::DEFAULT_BACKGROUND, [1.0; 4], [0.0, 0.0, 0.0, 1.0], [0.0; 4]] {
            let picture = draw(&scene, &RenderSettings { background, ..settings() });
            let contrast = picture.iter().map(|pixel| pixel[1].abs_diff(picture[0][1])).max().unwrap();
            // On nothing, what is dark and opaque.
            let is_ink = |pixel: &[u8; 4]| pixel[3] == 255 && pixel[1] < 60;
            assert!(contrast > 120 || picture.iter().any(is_ink), "{name} before {background:?}");
        }
    }
}

#[test]
fn colours_of_vertices_alone_are_shown_as_they_are() {
    let square: String = ["-1 -1", "1 -1", "1 1", "-1 1"].map(|corner| format!("v {corner} 0 255 128 0\n")).concat();
    let scene = load_bytes("a.obj", (square + "f 1 2 3 4\n").as_bytes(), &LoadOptions::default()).unwrap().scene;
    let picture = draw(&scene, &RenderSettings { shader: ShaderKind::Unlit, ..settings() });
    assert_eq!(picture[(SIZE * SIZE / 2 + SIZE / 2) as usize], [255, 128, 0, 255]);
}

#[test]
fn tangents_are_made_where_there_are_normal_maps_and_bend_as_frames_of_fragments_do() {
    assert!(scene(&sphere(), "Kd 0.8 0.8 0.8").meshes[0].tangents.is_empty());
    let plain = draw(&scene(&sphere(), "Kd 0.8 0.8 0.8"), &settings());
    for options in ["", "-s -1 1 1 ", "-s 1 -1 1 ", "-s -2 -2 1 -o 0.25 "] {
        let scene = scene(&sphere(), &format!("Kd 0.8 0.8 0.8\nnorm {options}bumps.tga"));
        assert!(!scene.meshes[0].tangents.is_empty());
        let (baked, found) = (draw(&scene, &settings()), draw(&without_tangents(&scene), &settings()));
        let bend = difference(&baked, &plain);
        let apart = difference(&baked, &found);
        assert!(bend > 6.0 && apart < 0.25 * bend, "'{options}': {apart} apart, {bend} bent");
    }
}

#[test]
fn mirrored_instances_keep_their_relief() {
    let plain = draw(&scene(SQUARE, "Kd 0.8 0.8 0.8"), &settings());
    let mut scene = scene(SQUARE, "Kd 0.8 0.8 0.8\nnorm bumps.tga");
    scene.transform(Mat4::scaling([-1.0, 1.0, 1.0]));
    let mirrored = draw(&scene, &settings());
    // The relief shows, and leans as the frames of fragments have it, which need no handedness.
    let (bend, apart) =
        (difference(&mirrored, &plain), difference(&mirrored, &draw(&without_tangents(&scene), &settings())));
    assert!(bend > 1.0 && apart < 0.1 * bend, "{bend} bent, {apart} apart");
}

#[test]
fn bump_maps_of_normals_are_normal_maps_unless_a_channel_is_named() {
    let normal_map = without_tangents(&scene(&sphere(), "Kd 0.8 0.8 0.8\nnorm bumps.tga"));
    let as_bump = draw(&scene(&sphere(), "Kd 0.8 0.8 0.8\nmap_Bump -bm 1 bumps.tga"), &settings());
    assert_eq!(as_bump, draw(&normal_map, &settings()));
    assert_ne!(draw(&scene(&sphere(), "Kd 0.8 0.8 0.8\nbump -imfchan l bumps.tga"), &settings()), as_bump);
    // Beside a material with tangents, too, in the same mesh.
    let pair = "Kd 0.8 0.8 0.8\nmap_Bump bumps.tga\nnewmtl other\nnorm bumps.tga";
    let both = scene(&format!("{}usemtl other\nf 1/1/1 2/2/2 3/3/3\n", sphere()), pair);
    assert!(!both.meshes[0].tangents.is_empty());
    assert!(difference(&draw(&both, &settings()), &as_bump) < 0.1);
}

#[test]
fn displacement_is_drawn_like_bumps_where_there_are_none() {
    let picture = |maps: &str| draw(&scene(&sphere(), &format!("Kd 0.8 0.8 0.8\n{maps}")), &settings());
    let bump = picture("bump -bm 2 heights.tga");
    let bend = difference(&bump, &picture(""));
    assert!(bend > 0.2, "{bend}");
    assert_eq!(picture("disp -bm 2 heights.tga"), bump);
    assert_eq!(picture("disp -bm 9 heights.tga\nbump -bm 2 heights.tga"), bump);
}

#[test]
fn what_is_kept_but_not_drawn_is_said() {
    let loaded = load(SQUARE, "refl -type sphere heights.tga\ndecal heights.tga\nmap_Pr heights.tga");
    let shown: Vec<_> = loaded.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(shown, ["m.mtl:2: map refl is read but not drawn", "m.mtl:3: map decal is read but not drawn"]);
    assert!(loaded.scene.materials[0].maps.roughness.is_some());
}

/// A floor, and a plate of half its width above it; light from straight above.
#[test]
fn a_plate_shades_the_floor_below_it_and_nothing_else() {
    let square = |y: f32, half: f32| {
        format!(
            "v -{half} {y} -{half}\nv {half} {y} -{half}\nv {half} {y} {half}\nv -{half} {y} {half}\nf -1 -2 -3 -4\n"
        )
    };
    let light = |kind| Light::new(kind, 40.0);
    let kinds = [
        LightKind::Directional { direction: [0.0, -1.0, 0.0] },
        LightKind::Point { position: [0.0, 30.0, 0.0] },
        LightKind::Spot { position: [0.0, 30.0, 0.0], direction: [0.0, -1.0, 0.0], inner_angle: 0.4, outer_angle: 0.5 },
    ];
    for kind in kinds {
        let mut scene = scene(&(square(0.0, 2.0) + &square(1.0, 1.0)), "Kd 1 1 1");
        scene.lights = vec![light(kind)];
        let mut settings = settings();
        settings.outputs.position = true;
        settings.samples = trigon::target::SamplePattern::CENTER;
        let without = draw(&scene, &settings);
        let (positions, with) =
            positions_and_codes(&scene, &RenderSettings { shadows: Some(Shadows::default()), ..settings });
        let (mut dark, mut bright) = (0, 0);
        for ((p, with), without) in positions.iter().zip(&with).zip(&without).filter(|((p, _), _)| **p != [0.0; 3]) {
            let from_middle = p[0].abs().max(p[2].abs());
            if p[1] < 0.5 && from_middle < 0.9 {
                assert_eq!(*with, [0, 0, 0, 255], "{kind:?} {p:?}");
                dark += 1;
            } else if p[1] > 0.5 || from_middle > 1.2 {
                assert_eq!(with, without, "{kind:?} {p:?}");
                bright += 1;
            }
        }
        assert!(dark > 100 && bright > 1000, "{kind:?}: {dark}, {bright}");
    }
}

/// No acne: on a sphere, shadows change only what lies near the edge of the lit side.
#[test]
fn a_convex_body_does_not_shade_its_lit_side() {
    let mut scene = scene(&sphere(), "Kd 1 1 1");
    let direction = [-0.6, -0.5, -0.4];
    scene.lights = vec![Light::new(LightKind::Directional { direction }, 1.0)];
    let mut settings = settings();
    settings.outputs.normal = true;
    settings.outputs.position = true;
    settings.samples = trigon::target::SamplePattern::CENTER;
    let without = draw(&scene, &settings);
    for map_size in [64, 512, 4096] {
        let shadows = Some(Shadows { map_size, ..Shadows::default() });
        let (positions, with) = positions_and_codes(&scene, &RenderSettings { shadows, ..settings });
        for ((p, with), without) in positions.iter().zip(with).zip(&without) {
            // The sphere is the unit one: its points are its normals.
            let cosine = -(p[0] * -0.6 + p[1] * -0.5 + p[2] * -0.4) / 0.877;
            assert!(cosine < 0.3 || with == *without, "{map_size} {p:?}: {with:?} instead of {without:?}");
        }
    }
}

#[test]
fn shadow_maps_of_no_size_are_an_error() {
    let scene = scene(SQUARE, "Kd 1 1 1");
    for map_size in [0, 16_385] {
        let settings = RenderSettings { shadows: Some(Shadows { map_size, ..Shadows::default() }), ..settings() };
        let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
        let camera = Framing::default().camera(&scene);
        let drawn = SceneRenderer::new().render(&mut renderer, &scene, &camera, &settings, &mut Picture::default());
        assert_eq!(drawn.unwrap_err(), RenderError::ShadowMapSize(map_size));
    }
}

/// World positions, zero where nothing is, and the stored codes.
fn positions_and_codes(scene: &Scene, settings: &RenderSettings) -> (Vec<[f32; 3]>, Vec<[u8; 4]>) {
    let mut renderer = Renderer::new(RendererOptions::from_env().unwrap()).unwrap();
    let mut picture = Picture::default();
    let camera = Framing::default().camera(scene);
    let drawn = SceneRenderer::new().render(&mut renderer, scene, &camera, settings, &mut picture);
    assert_eq!(drawn.unwrap().1, []);
    (picture.position.unwrap().into_values(), picture.color.unwrap().into_values())
}
