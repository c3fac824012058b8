//! Stories of pixels: each ends with the bytes of the picture, and its parts agree with each other.
//!
//! Thousands of random pixels of generated frames and of the scenes in `assets`, over sample patterns, both shading
//! rates, blending, discarding and the looks inside. Pictures are drawn at the best SIMD level, stories are told by the
//! plain one.

use trigon::explain::{LevelRead, Note, Tap, TextureRead};
use trigon::geometry::{Indices, Primitives};
use trigon::pipeline::{Draw, Frame, Outcome, Outputs, Picture, PixelStory, Renderer, TriangleStory};
use trigon::raster::DepthTest;
use trigon::resolve::Blend;
use trigon::target::{SamplePattern, ShadingRate};
use trigon_scene::load::{LoadOptions, load_path};
use trigon_scene::render::course::games101::Homework3;
use trigon_scene::render::course::tinyrenderer::Lesson;
use trigon_scene::render::{
    AlphaMode, AmbientOcclusion, RenderSettings, SceneRenderer, ShaderKind, Shadows, Wireframe,
};
use trigon_scene::scene::{Framing, Scene};
use trigon_tests::corpus::soup;
use trigon_tests::frames::plain_options;
use trigon_tests::random::Random;
use trigon_tests::shaders::ClipShader;

/// Every pattern, and its shading rates.
fn patterns() -> Vec<(SamplePattern, ShadingRate)> {
    let grids = [1, 4, 9, 16].into_iter().filter_map(SamplePattern::grid);
    let all = grids.chain([2, 4, 8, 16].into_iter().filter_map(SamplePattern::standard));
    all.flat_map(|pattern| [(pattern, ShadingRate::Pixel), (pattern, ShadingRate::Sample)]).collect()
}

#[test]
fn stories_of_generated_frames_end_with_the_pictures_pixels() {
    let opaque = soup(11, 600, 1.0);
    let translucent = soup(12, 300, 0.6);
    let cut = ClipShader { discard_below: 0.4, ..soup(13, 300, 1.0) };
    let lines = Primitives::Lines { indices: Indices::Sequence(60), width_px: 2.5 };
    let draws = [
        triangles(&opaque),
        triangles(&cut),
        Draw { blend: Blend::Over, depth: DepthTest::NEARER, ..triangles(&translucent) },
        Draw::new(&opaque, lines),
        Draw { blend: Blend::Add, depth: DepthTest::OFF, ..triangles(&cut) },
    ];
    let mut seen = Seen::default();
    for (samples, shading) in patterns() {
        let outputs = Outputs { color_f32: true, ..Outputs::COLOR };
        let frame = Frame { samples, shading, clear: [0.1, 0.2, 0.3, 0.9], outputs, ..Frame::new(150, 90) };
        let mut renderer = Renderer::new(plain_options()).unwrap();
        let mut picture = Picture::default();
        renderer.render(&frame, &draws, &mut picture).unwrap();
        let mut random = Random::new(samples.count() as u64);
        for _ in 0..50 {
            let [x, y] = [random.below(frame.width), random.below(frame.height)];
            let story = renderer.explain(&frame, &draws, [x, y]).unwrap();
            check_end(&story, &picture, story.resolve.bytes, &format!("{samples}, {shading:?}"));
            seen.check(&story);
        }
    }
    seen.has_all_outcomes();
    assert!(seen.clipped > 50 && seen.micro > 50 && seen.ordered > 200, "{seen:?}");
}

#[test]
fn stories_of_scenes_end_with_the_pictures_pixels() {
    let mut seen = Seen::default();
    let looks = [
        ShaderKind::BlinnPhong,
        ShaderKind::BlinnPhong,
        ShaderKind::MipLevel,
        ShaderKind::Overdraw,
        ShaderKind::Coverage,
        ShaderKind::Flat,
        ShaderKind::Normal,
        ShaderKind::Toon,
        ShaderKind::Tinyrenderer(Lesson::Final),
        ShaderKind::Games101(Homework3::Phong),
    ];
    for (name, seed) in [("cube", 1), ("teapot", 2), ("still-life", 3)] {
        let scene = asset(name);
        for (i, (samples, shading)) in patterns().into_iter().enumerate() {
            let mut settings = RenderSettings { samples, shading, ..RenderSettings::new(120, 84) };
            settings.shader = looks[i % looks.len()];
            settings.sampling.max_anisotropy = [1, 8, 16][i % 3];
            settings.alpha = [AlphaMode::Auto, AlphaMode::Blend][i % 2];
            settings.wireframe = (i % 5 == 4).then(Wireframe::default);
            settings.shadows = (i % 3 == 1).then(|| Shadows { map_size: 200, ..Shadows::default() });
            settings.ambient_occlusion = (i % 4 == 2).then(AmbientOcclusion::default);
            check_scene(&scene, &settings, seed * 100 + i as u64, 30, &mut seen);
        }
    }
    assert!(seen.textures > 500 && seen.fragments > 1000 && seen.ordered > 100, "{seen:?}");
}

#[test]
fn pixels_outside_are_errors_that_say_so() {
    let mut renderer = Renderer::new(plain_options()).unwrap();
    let error = renderer.explain(&Frame::new(8, 4), &[], [3, 4]).unwrap_err().to_string();
    assert!(error.contains("3,4") && error.contains("8x4"), "{error}");
    let empty = renderer.explain(&Frame::new(8, 4), &[], [3, 3]).unwrap();
    assert_eq!((empty.resolve.bytes, empty.triangles.len()), ([0, 0, 0, 255], 0));
}

fn triangles(shader: &ClipShader) -> Draw<'_> {
    let count = u32::try_from(shader.positions.len()).unwrap();
    Draw::new(shader, Primitives::Triangles(Indices::Sequence(count)))
}

fn asset(name: &str) -> Scene {
    let path = format!("{}/../assets/{name}.obj", env!("CARGO_MANIFEST_DIR"));
    load_path(path, &LoadOptions::default()).unwrap().scene
}

/// Explains random pixels of a scene's picture.
fn check_scene(scene: &Scene, settings: &RenderSettings, seed: u64, count: usize, seen: &mut Seen) {
    let mut renderer = Renderer::new(plain_options()).unwrap();
    let mut scenes = SceneRenderer::new();
    let mut picture = Picture::default();
    let camera = Framing { zoom: 1.3, ..Framing::default() }.camera(scene);
    let outputs = Outputs { color_f32: true, ..Outputs::COLOR };
    let settings = RenderSettings { outputs, ..*settings };
    scenes.render(&mut renderer, scene, &camera, &settings, &mut picture).unwrap();
    let mut random = Random::new(seed);
    for _ in 0..count {
        let pixel = [random.below(settings.width), random.below(settings.height)];
        let (story, _) = scenes.explain(&mut renderer, scene, &camera, &settings, pixel).unwrap();
        let context = format!("{}, {}, {:?}", settings.shader, settings.samples, settings.shading);
        if settings.shader == ShaderKind::Overdraw {
            assert_eq!(picture.color.as_ref().unwrap().get(pixel[0], pixel[1]), Some(story.color), "{context}");
        } else {
            check_end(&story.pixel, &picture, story.color, &context);
        }
        seen.check(&story.pixel);
    }
}

/// The story ends with the picture's pixel, bit for bit.
fn check_end(story: &PixelStory, picture: &Picture, color: [u8; 4], context: &str) {
    let [x, y] = story.pixel;
    assert_eq!(picture.color.as_ref().unwrap().get(x, y), Some(color), "{context}: pixel {x},{y}");
    let bits = |values: [f32; 4]| values.map(f32::to_bits);
    let linear = picture.color_f32.as_ref().unwrap().get(x, y).unwrap();
    assert_eq!(bits(linear), bits(story.resolve.mean), "{context}: pixel {x},{y}");
}

/// What the stories of a test told of.
#[derive(Default, Debug)]
struct Seen {
    outcomes: [usize; 4],
    clipped: usize,
    micro: usize,
    ordered: usize,
    fragments: usize,
    textures: usize,
}

impl Seen {
    fn has_all_outcomes(&self) {
        assert!(self.outcomes.iter().all(|count| *count > 20), "{self:?}");
    }

    /// The parts of a story agree with each other.
    fn check(&mut self, story: &PixelStory) {
        let mut depths = vec![0.0; story.samples.len()];
        for triangle in &story.triangles {
            self.clipped += usize::from(triangle.is_clipped);
            self.micro += usize::from(triangle.is_micro);
            self.check_tests(triangle, &mut depths);
        }
        let mut colors = vec![story.clear; story.samples.len()];
        for fragment in &story.fragments {
            self.fragments += 1;
            let triangle = &story.triangles[fragment.triangle];
            let drawn = |s: usize| triangle.tests[s].outcome == Outcome::Drawn;
            let sum: f32 = fragment.facts.barycentric.iter().sum();
            assert!((sum - 1.0).abs() < 1e-4, "{:?}", fragment.facts);
            for note in &fragment.notes {
                if let Note::Texture(read) = note {
                    self.textures += 1;
                    check_texture(read);
                }
            }
            let Some(color) = fragment.color else { continue };
            self.ordered += usize::from(triangle.blend != Blend::Replace);
            for s in (0..story.samples.len()).filter(|s| fragment.samples >> s & 1 == 1) {
                assert!(drawn(s), "{triangle:?}");
                colors[s] = combined(triangle.blend, color, colors[s]);
                assert_eq!(colors[s], fragment.after[s], "{triangle:?}");
            }
        }
        // Samples that nothing changes keep what they were; so the last word on each is the resolved colour.
        assert_eq!(colors, story.resolve.samples);
    }

    fn check_tests(&mut self, triangle: &TriangleStory, depths: &mut [f32]) {
        for (test, stored) in triangle.tests.iter().zip(depths) {
            self.outcomes[test.outcome as usize] += 1;
            assert_eq!(test.is_covered, test.edges.iter().all(|edge| *edge >= 0), "{triangle:?}");
            assert_eq!(test.is_covered, test.outcome != Outcome::Outside, "{triangle:?}");
            assert_eq!(test.stored, *stored, "{triangle:?}");
            if triangle.depth_test == DepthTest::NEARER_WRITE && test.is_covered {
                assert_eq!(test.outcome != Outcome::Hidden, test.depth > test.stored, "{triangle:?}");
            }
            if test.outcome == Outcome::Drawn && triangle.depth_test.write {
                *stored = test.depth;
            }
        }
    }
}

fn combined(blend: Blend, [r, g, b, a]: [f32; 4], [dr, dg, db, da]: [f32; 4]) -> [f32; 4] {
    let t = 1.0 - a;
    match blend {
        Blend::Replace => [r, g, b, a],
        Blend::Over => [r + dr * t, g + dg * t, b + db * t, a + da * t],
        Blend::Add => [r + dr, g + dg, b + db, a + da],
        Blend::Multiply => [r * dr, g * dg, b * db, da],
    }
}

/// The weighted texels add up to the colour.
fn check_texture(read: &TextureRead) {
    let mut sum = [0.0_f64; 4];
    let mut add = |tap: &Tap, level: &LevelRead| {
        assert!(level.weight > 0.0 && [1, 4].contains(&level.texels.len()), "{tap:?}");
        for texel in &level.texels {
            assert!(texel.column < level.size[0] && texel.row < level.size[1], "{tap:?}");
            for (sum, channel) in sum.iter_mut().zip(texel.color) {
                *sum += f64::from(channel) * f64::from(texel.weight * level.weight) / read.taps.len() as f64;
            }
        }
    };
    for tap in &read.taps {
        tap.levels.iter().for_each(|level| add(tap, level));
    }
    for (sum, channel) in sum.iter().zip(read.color) {
        assert!((sum - f64::from(channel)).abs() < 1e-4, "{sum} is not {channel}: {read:?}");
    }
}
