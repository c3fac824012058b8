//! `--preset` for models: other defaults, which give way to what is written.

use crate::shared_data::shared_data;
use crate::support::{Folder, read_picture};

/// A square that faces +z, with texture coordinates and normals.
const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n\
                      f 1/1/1 2/2/1 3/3/1 4/4/1\n";

/// 2 x 2 pixels of one colour in a TGA file.
fn tga([r, g, b]: [u8; 3]) -> Vec<u8> {
    let mut bytes = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0];
    (0..4).for_each(|_| bytes.extend([b, g, r]));
    bytes
}

fn folder() -> Folder {
    let flat = tga([128, 128, 255]);
    Folder::new()
        .with("a.obj", SQUARE)
        .with("a_diffuse.tga", tga([200, 100, 50]))
        .with("a_spec.tga", tga([0; 3]))
        .with("a_nm_tangent.tga", flat)
}

#[test]
fn tinyrenderer_is_a_whole_scene_and_every_option_comes_before_it() {
    let folder = folder();
    let picture = folder.picture("a.obj --preset tinyrenderer");
    assert_eq!((picture.width(), picture.height()), (800, 800));
    assert_eq!(picture.pixel(2, 2), [209, 195, 177, 255]);
    // 0.4 + n.l = 0.4 + 1 / sqrt(3), and next to no highlight; the map's 128 is not quite zero.
    let [r, g, b, _] = picture.pixel(400, 400);
    for (got, texel) in [(r, 200.0), (g, 100.0), (b, 50.0)] {
        let want = texel * (0.4 + 1.0 / 3.0_f64.sqrt());
        assert!((f64::from(got) - want).abs() < 3.0, "{got} is not {want}");
    }
    let small = folder.picture("a.obj --preset tinyrenderer --size 64 --background #fff --shader tinyrenderer-flat");
    assert_eq!((small.width(), small.pixel(0, 0)), (64, [255; 4]));
    let [r, g, b, _] = small.pixel(32, 32);
    assert_eq!([r, g, b], [177; 3], "30 + 255 / sqrt(3)");
    let turned = folder.picture("a.obj --preset tinyrenderer --azimuth 85 --elevation 0");
    assert_eq!(turned.pixel(100, 400), [209, 195, 177, 255], "seen from the side it is narrow");
}

#[test]
fn tinyrenderer_has_the_general_effects() {
    let folder = folder();
    let plain = folder.picture("a.obj --preset tinyrenderer --size 64");
    let outlined = folder.picture("a.obj --preset tinyrenderer --size 64 --outline");
    assert_ne!(plain.pixels(), outlined.pixels());
    // Between the square and the light.
    let roof = SQUARE.replace("v -1 -1 0", "v -1 -1 1").replace("v 1 -1 0", "v 1 -1 1");
    let folder = folder.with("roof.obj", roof.replace("v 1 1 0", "v 1 1 1").replace("v -1 1 0", "v -1 1 1"));
    for name in ["roof_diffuse.tga", "roof_spec.tga"] {
        std::fs::write(folder.path(name), tga([99; 3])).unwrap();
    }
    std::fs::write(folder.path("roof_nm_tangent.tga"), tga([128, 128, 255])).unwrap();
    let lit = folder.picture("a.obj roof.obj --preset tinyrenderer --size 64 --scale 0.6 --eye -2,-1,2");
    let shadowed = folder.picture("a.obj roof.obj --preset tinyrenderer --size 64 --scale 0.6 --eye -2,-1,2 --shadows");
    assert_ne!(lit.pixels(), shadowed.pixels());
}

#[test]
fn pictures_that_a_preset_does_not_find_are_warnings() {
    let folder = Folder::new().with("a.obj", SQUARE);
    let finished = folder.run("a.obj --preset tinyrenderer -o b.png");
    assert_eq!(finished.code, Some(0));
    for name in ["a_diffuse.tga", "a_nm_tangent.tga", "a_spec.tga"] {
        assert!(finished.stderr.contains(name), "{}", finished.stderr);
    }
    folder.run("a.obj --preset tinyrenderer -o c.png --strict").fails_with(&["a_diffuse.tga", "--strict"]);
}

#[test]
fn learning_tinyrenderer_turns_on_black() {
    let folder = folder();
    let picture = folder.picture("a.obj --preset learning-tinyrenderer");
    assert_eq!((picture.width(), picture.pixel(1, 1)), (700, [0, 0, 0, 255]));
    assert!(picture.pixel(350, 350)[0] > 60);
    folder.run("turntable a.obj --preset learning-tinyrenderer --size 32 -n 4 -o f{frame}.png").succeeds_quietly();
    let frames = folder.names().into_iter().filter(|name| name.starts_with('f')).count();
    assert_eq!(frames, 4);
}

#[test]
fn presets_are_about_models_or_about_pictures() {
    let folder = folder().with("a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>");
    folder.run("a.svg --preset tinyrenderer -o b.png").misuses_with(&["--preset tinyrenderer", "SVG picture"]);
    folder.run("a.obj --preset cs184 -o b.png").misuses_with(&["--preset cs184", "model"]);
    folder.run("turntable a.obj --preset cs184 -o b.gif").misuses_with(&["--preset cs184", "model"]);
    folder.run("a.obj --preset tinyrenderer --view 0,0,5 -o b.png").misuses_with(&["--view"]);
}

#[test]
fn tinyrenderer_agrees_with_a_picture_of_the_program() {
    let Some(data) = shared_data() else { return };
    let models = data.join("tinyrenderer/obj");
    let (diablo, floor) = (models.join("diablo3_pose/diablo3_pose.obj"), models.join("floor.obj"));
    let drawn = Folder::new().picture(&format!("{} {} --preset tinyrenderer", diablo.display(), floor.display()));
    let expected = read_picture(&data.join("reference/tinyrenderer/diablo3_floor.png"));
    let comparison = trigon_image::compare(&drawn, &expected).unwrap();
    assert!(comparison.pixels_over(3) * 100 < comparison.pixels(), "{} pixels differ", comparison.pixels_over(3));
}

#[test]
fn games101_hw2_needs_no_model() {
    let folder = Folder::new();
    let picture = folder.picture("--preset games101-hw2");
    assert_eq!((picture.width(), picture.height()), (700, 700));
    assert_eq!([picture.pixel(350, 250), picture.pixel(560, 300)], [[217, 238, 185, 255], [185, 217, 238, 255]]);
    let edge = folder.picture("--preset games101-hw2 --samples 4 --size 70");
    // One, two or three of four samples, as the mean of stored values.
    let is_edge = |pixel: &[u8; 4]| {
        (1..4).any(|samples| {
            [217, 238, 185].iter().zip(pixel).all(|(code, got)| (code * samples - i32::from(*got) * 4).abs() <= 2)
        })
    };
    assert!(edge.pixels().iter().any(is_edge));
    let linear = folder.picture("--preset games101-hw2 --samples 4 --size 70 --color-space linear");
    assert!(!linear.pixels().iter().any(is_edge));
    folder.run("a.obj --preset games101-hw2 -o b.png").misuses_with(&["games101-hw2", "leave out a.obj"]);
    folder.run("--preset games101-hw3 -o b.png").misuses_with(&["<MODEL>"]);
}

#[test]
fn games101_hw3_finds_its_pictures_unless_they_are_given() {
    let folder = folder().with("a_texture.tga", tga([9; 3])).with("high.tga", tga([9; 3]));
    let normal = folder.picture("a.obj --preset games101-hw3 --shader normal --rotate-y 0");
    assert_eq!(normal.pixel(350, 350), [128, 128, 255, 255]);
    folder.run("a.obj --preset games101-hw3 --shader texture -o b.png").succeeds().says(&["a_texture.png"]);
    let given = folder.picture("a.obj --preset games101-hw3 --shader texture --texture a_diffuse.tga --rotate-y 0");
    let brown = folder.picture("a.obj --preset games101-hw3 --rotate-y 0");
    assert_ne!(given.pixel(350, 350), brown.pixel(350, 350));
    // A level height map moves all points alike: with a larger kn, out of the light.
    let options = "a.obj --preset games101-hw3 --shader displacement --height-map high.tga --rotate-y 0 --size 64";
    let near = folder.picture(options);
    let far = folder.picture(&format!("{options} --bump-scale 2"));
    assert_ne!(near.pixel(32, 32), far.pixel(32, 32));
    assert_eq!(near.pixels(), folder.picture(&format!("{options} --bump-height 3")).pixels(), "no slope");
}

#[test]
fn options_of_the_relief_want_a_shader_that_has_one() {
    let folder = folder();
    folder.run("a.obj --bump-scale 1 -o b.png").misuses_with(&["--bump-scale", "games101-bump", "blinn-phong"]);
    folder
        .run("a.obj --preset games101-hw3 --shader phong --bump-height 1 -o b.png")
        .misuses_with(&["--bump-height", "games101-displacement"]);
}

#[test]
fn lights_of_games101_hw3_give_way_to_those_that_are_written() {
    let folder = folder();
    let line = "a.obj --preset games101-hw3 --rotate-y 0 --size 64";
    let dark = folder.picture(&format!("{line} --light ambient:0"));
    assert_eq!(dark.pixel(32, 32), [0, 0, 0, 255]);
    assert_ne!(folder.picture(line).pixel(32, 32), dark.pixel(32, 32));
}

#[test]
fn every_command_for_models_has_the_defaults_of_the_preset() {
    let folder = folder();
    let run = |line: &str| assert_eq!(folder.run(line).succeeds_quietly().text(), "");
    run("compare a.obj --preset games101-hw3 --vary shader=normal,phong --size 32 --no-times -o sheet.png");
    run("turntable a.obj --preset games101-hw3 --size 16 -n 2 -o f{frame}.png");
    let story =
        folder.run("explain a.obj --preset games101-hw3 --rotate-y 0 --pixel 350,350 --json").succeeds_quietly();
    let [r, g, b, _] = folder.picture("a.obj --preset games101-hw3 --rotate-y 0").pixel(350, 350);
    assert!(story.text().contains(&format!("[{r}, {g}, {b}, 255]")), "{}", story.text());
}

/// The scenes of both homeworks, each with the part of the pixels that must be within 2/255.
///
/// The program that made the affine pictures has weights of corners with errors of a tenth of a texel, which bump
/// mapping, that takes differences of neighbouring texels, shows.
const GAMES101: [(&str, &str, f64); 18] = [
    ("games101-hw2/zbuffer", "--preset games101-hw2", 0.995),
    ("games101-hw2/ss2x2", "--preset games101-hw2 --samples 4", 0.995),
    ("games101-hw3/standard_normal", "--shader normal", 0.995),
    ("games101-hw3/standard_phong", "--shader phong", 0.995),
    ("games101-hw3/standard_texture", "--shader texture", 0.995),
    ("games101-hw3/standard_texture_bilinear", "--shader texture --pixel-filter bilinear", 0.995),
    ("games101-hw3/affine_normal", "--shader normal --interpolation affine", 0.995),
    ("games101-hw3/affine_phong", "--shader phong --interpolation affine", 0.995),
    ("games101-hw3/affine_texture", "--shader texture --interpolation affine", 0.995),
    ("games101-hw3/standard_bump", "--shader bump", 0.995),
    ("games101-hw3/standard_displacement", "--shader displacement", 0.995),
    ("games101-hw3/affine_bump", "--shader bump --interpolation affine", 0.99),
    ("games101-hw3/affine_displacement", "--shader displacement --interpolation affine", 0.99),
    ("games101-hw3/course_normal", "--shader normal --sample-at upper-left", 0.995),
    ("games101-hw3/course_phong", "--shader phong --sample-at upper-left", 0.995),
    ("games101-hw3/course_texture", "--shader texture --sample-at upper-left", 0.995),
    ("games101-hw3/course_bump", "--shader bump --sample-at upper-left", 0.995),
    ("games101-hw3/course_displacement", "--shader displacement --sample-at upper-left", 0.995),
];

/// `cargo test -p trigon-cli --test cli games101_agrees -- --nocapture` prints how well each agrees.
#[test]
fn games101_agrees_with_pictures_of_the_programs() {
    let Some(data) = shared_data() else { return };
    let spot = data.join("games101/models/spot/spot_triangulated_good.obj");
    let mut failures = Vec::new();
    for (name, options, wanted) in GAMES101 {
        let line = match options.starts_with("--preset") {
            true => options.to_owned(),
            false => format!("{} --preset games101-hw3 {options} --quiet", spot.display()),
        };
        let drawn = Folder::new().picture(&line);
        let expected = read_picture(&data.join("reference").join(name).with_extension("png"));
        let comparison = trigon_image::compare(&drawn, &expected).unwrap();
        let agreement = 1.0 - comparison.pixels_over(2) as f64 / comparison.pixels() as f64;
        println!("{name:<40} {:.4} % within 2/255, rmse {:.3}", agreement * 100.0, comparison.rmse);
        if agreement < wanted {
            failures.push(name);
        }
    }
    assert_eq!(failures, Vec::<&str>::new());
}
