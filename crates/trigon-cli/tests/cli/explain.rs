//! `trigon explain`: its last word is the pixel of the picture, and it says what led there.

use crate::support::{Folder, TEXTURED, read_picture};

fn textured() -> Folder {
    let material = "newmtl picture\nmap_Kd picture.tga\nKs 0.5 0.5 0.5\nNs 20\nillum 2\n";
    Folder::with_cube().with("square.obj", TEXTURED).with("m.mtl", material).with("picture.tga", picture())
}

/// 4 x 4 texels as an uncompressed TGA file.
fn picture() -> Vec<u8> {
    let mut bytes = vec![0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 4, 0, 24, 0];
    bytes.extend((0..48_u8).map(|i| i * 5));
    bytes
}

/// The numbers between the brackets after `"name": `, the first time that it comes.
fn numbers<'t>(json: &'t str, name: &str) -> Vec<&'t str> {
    let (_, rest) = json.split_once(&format!("\"{name}\": [")).unwrap();
    rest.split_once(']').unwrap().0.split(", ").collect()
}

#[test]
fn the_story_ends_with_the_pixel_of_the_picture() {
    let folder = textured();
    for options in [
        "square.obj --size 40x30 --samples 8",
        "square.obj --size 40x30 --samples 9 --pattern grid --shading sample --anisotropy 16 --rotate-x 70",
        "cube.obj --size 40x30 --wireframe",
        "cube.obj --size 40x30 --shader overdraw",
        "cube.obj --size 40x30 --background none",
        "square.obj --size 40x30 --color-space encoded --interpolation affine --rotate-x 50 --background #204060",
    ] {
        let picture = folder.picture(&format!("render {options}"));
        for (x, y) in [(20, 15), (9, 9), (0, 0), (13, 8), (30, 20)] {
            let told = folder.run(&format!("explain {options} --pixel {x},{y} --json"));
            let told = told.succeeds_quietly();
            let color: Vec<u8> = numbers(told.text(), "color").iter().map(|n| n.parse().unwrap()).collect();
            assert_eq!(color, picture.pixel(x, y), "{options}: {x},{y}");
        }
    }
}

#[test]
fn the_text_names_every_step() {
    let told = textured().run("explain square.obj --pixel 20,15 --size 40x30").succeeds_quietly();
    for words in [
        "Pixel 20,15 of 40x30: 4 samples",
        "Triangles whose box touches the pixel",
        "clip space",
        "edge 0-1",
        "drawn",
        "perspective",
        "normal.x",
        "diffuse map",
        "texture of 4x4 texels, 3 levels",
        "level of detail",
        "weight",
        "light 0",
        "N.L",
        "specular term",
        "sample 3",
        "mean",
        "as sRGB of 8 bits",
    ] {
        assert!(told.text().contains(words), "{words}: {}", told.text());
    }
    let empty = textured().run("explain cube.obj -p 0,0 --size 40x30").succeeds_quietly();
    assert!(empty.text().contains("No triangle's box touches the pixel."), "{}", empty.text());
    assert!(empty.text().contains("Colour #e6e8ebff"), "{}", empty.text());
}

#[test]
fn json_can_go_to_a_file() {
    let folder = textured();
    let told = folder.run("explain cube.obj -p 20,15 --size 40x30 --json=pixel.json").succeeds_quietly();
    assert_eq!(told.text(), "");
    let json = std::fs::read_to_string(folder.path("pixel.json")).unwrap();
    assert_eq!(numbers(&json, "pixel"), ["20", "15"]);
    for name in ["\"triangles\"", "\"edges\"", "\"depth_there\"", "\"fragments\"", "\"weights_by_area\"", "\"srgb8\""] {
        assert!(json.contains(name), "{name}: {json}");
    }
}

#[test]
fn the_diagram_shows_the_pixels_and_the_samples_colours() {
    let folder = textured();
    let options = "cube.obj --size 60x48 --samples 8";
    let picture = folder.picture(&format!("render {options}"));
    let told = folder.run(&format!("explain {options} -p 30,20 -o diagram.png")).succeeds_quietly();
    assert_eq!(told.text(), "");
    let diagram = read_picture(&folder.path("diagram.png"));
    // A corner of the neighbourhood: 9 x 9 pixels of 48 x 48, with a line of the grid around.
    let corner = picture.pixel(26, 16);
    let square = (24 + 4..24 + 44).flat_map(|x| (24 + 4..24 + 44).map(move |y| (x, y)));
    let same = square.filter(|(x, y)| diagram.pixel(*x, *y) == corner).count();
    assert!(same > 1000, "{same} of 1600");
    folder.run(&format!("explain {options} -p 30,20 -o diagram.exr")).misuses_with(&["8 bits"]);
}

#[test]
fn misuse_is_explained() {
    let folder = textured().with("a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>");
    folder.run("explain cube.obj").misuses_with(&["--pixel"]);
    folder.run("explain cube.obj -p 40,3 --size 40x30").misuses_with(&["--pixel 40,3", "40x30", "0 to 39"]);
    folder.run("explain cube.obj -p 3").misuses_with(&["column and row", "320,240"]);
    folder.run("explain a.svg -p 3,3").misuses_with(&["a.svg", "SVG"]);
    folder.run("explain missing.obj -p 3,3").fails_with(&["missing.obj"]);
}

#[test]
fn shaders_of_courses_name_their_terms() {
    let folder = textured();
    let view = "--size 40x30 --pixel 20,15 --quiet";
    let heights = "--shader displacement --height-map picture.tga";
    let bump = folder.run(&format!("explain square.obj --preset games101-hw3 {heights} {view}"));
    for words in ["tilted normal n'", "dU", "height a texel up", "kd, diffuse", "N.H", "specular term", "as 8 bits"] {
        assert!(bump.text().contains(words), "{words}: {}", bump.text());
    }
    let toward_light = "--eye 0,0,3 --target 0,0,0";
    let red = folder.run(&format!("explain square.obj --preset tinyrenderer {toward_light} {view}"));
    for words in ["unit normal n", "n.l", "l mirrored, r", "its power of 35", "weight, s + m gloss", "bytes"] {
        assert!(red.text().contains(words), "{words}: {}", red.text());
    }
}
