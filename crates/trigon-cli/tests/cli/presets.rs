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
    folder.run("turntable a.obj --preset cs184 -o b.gif").misuses_with(&["--preset cs184", "models"]);
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
