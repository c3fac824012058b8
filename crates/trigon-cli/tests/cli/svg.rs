//! SVG files through the command: recognition, size, area, report, messages.

use crate::support::{Finished, Folder, picture_of, read_picture};
use std::io::Write;
use std::process::Stdio;

const SVG: &str = "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='20' viewBox='0 0 40 20'>
<rect width='20' height='20' fill='#f00'/>
<g transform='translate(20 0)'><rect id='right' x='5' y='5' width='10' height='10' fill='#00f'/></g>
</svg>";

fn folder() -> Folder {
    Folder::new().with("a.svg", SVG).with("no-name", SVG)
}

#[test]
fn a_picture_has_the_size_that_the_file_asks_for() {
    let folder = folder();
    for name in ["a.svg", "no-name"] {
        let picture = folder.picture(&format!("render {name}"));
        assert_eq!((picture.width(), picture.height()), (40, 20));
        assert_eq!(picture.pixel(3, 3), [255, 0, 0, 255]);
        assert_eq!(picture.pixel(30, 10), [0, 0, 255, 255]);
        assert_eq!(picture.pixel(39, 19), [0, 0, 0, 0]);
    }
}

#[test]
fn sizes_can_be_chosen() {
    let folder = folder();
    for (option, size) in
        [("--width 100", (100, 50)), ("--height 10", (20, 10)), ("--zoom 2", (80, 40)), ("--size 60x60", (60, 60))]
    {
        let picture = folder.picture(&format!("a.svg {option}"));
        assert_eq!((picture.width(), picture.height()), size, "{option}");
    }
    // The page stands in the middle of a picture of another shape.
    let picture = folder.picture("a.svg --size 60x60 --background #0f0");
    assert_eq!([picture.pixel(5, 5), picture.pixel(5, 20)], [[0, 255, 0, 255], [255, 0, 0, 255]]);
}

#[test]
fn an_element_or_an_area_can_be_drawn_alone() {
    let folder = folder();
    let picture = folder.picture("a.svg --export-id right");
    assert_eq!((picture.width(), picture.height()), (10, 10));
    assert!(picture.pixels().iter().all(|pixel| *pixel == [0, 0, 255, 255]));
    let picture = folder.picture("a.svg --export-id right --export-area page");
    assert_eq!((picture.width(), picture.pixel(3, 3), picture.pixel(30, 10)), (40, [0; 4], [0, 0, 255, 255]));
    let picture = folder.picture("a.svg --export-area 10,0,20,20");
    assert_eq!((picture.width(), picture.pixel(3, 3), picture.pixel(16, 10)), (20, [255, 0, 0, 255], [0, 0, 255, 255]));
    folder.run("a.svg --export-id left -o b.png").fails_with(&["a.svg", "'left'"]);
    folder.run("a.svg --export-area 1,2 -o b.png").misuses_with(&["--export-area", "X,Y,WIDTH,HEIGHT"]);
}

#[test]
fn standard_input_is_recognized() {
    let folder = folder();
    let mut command = folder.command(["render", "-", "-o", "-"]);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(SVG.as_bytes()).unwrap();
    let finished = Finished::new(child.wait_with_output().unwrap()).succeeds_quietly();
    assert_eq!(picture_of(&finished.stdout).pixel(30, 10), [0, 0, 255, 255]);
}

#[test]
fn the_report_names_what_is_not_drawn() {
    let svg = SVG.replace("</svg>", "<foreignObject/></svg>");
    let folder = Folder::new().with("a.svg", svg);
    let finished = folder.run("a.svg -o a.png --json").succeeds().says(&["a.svg: 'foreignObject' is not drawn"]);
    for word in ["\"width\": 40", "'foreignObject' is not drawn", "\"hash\": \"", "\"samples\": \"grid 16\""] {
        assert!(finished.text().contains(word), "\"{word}\" is not in {}", finished.text());
    }
    folder.run("a.svg -o b.png --strict").fails_with(&["foreignObject", "--strict"]);
    assert_eq!(folder.names(), ["a.png", "a.svg"]);
}

#[test]
fn the_picture_is_the_same_with_any_number_of_threads_and_at_any_level() {
    let folder = folder();
    let first = folder.picture("a.svg --width 333 --threads 1 --simd scalar");
    for options in ["--threads 3", "--threads 2 --simd scalar"] {
        assert!(folder.picture(&format!("a.svg --width 333 {options}")) == first, "{options}");
    }
}

#[test]
fn the_course_draws_points_and_frames_its_page() {
    let file = "<svg width='10px' height='10px'><rect x='5' y='5' width='0' height='0' fill='#ff0000'/></svg>";
    let folder = Folder::new().with("a.svg", file);
    let picture = folder.picture("a.svg --preset cs184");
    assert_eq!((picture.width(), picture.height()), (960, 640));
    assert_eq!([picture.pixel(480, 320), picture.pixel(3, 3)], [[255, 0, 0, 255], [255; 4]]);
    let picture = folder.picture("a.svg --preset cs184 --size 40x20 --view 0,0,5 --samples 4");
    assert_eq!(picture.pixel(30, 20 - 1 - 1), [255; 4]);
    assert_eq!(picture.pixel(19, 11), [0, 0, 0, 255]);
    folder.run("a.svg --preset cs184 --samples 8 -o b.png").misuses_with(&["--samples 8", "1, 4, 9 or 16"]);
}

#[test]
fn linked_pictures_are_found_beside_the_file() {
    let inner =
        "<svg xmlns='http://www.w3.org/2000/svg' width='4' height='4'><rect width='4' height='4' fill='lime'/></svg>";
    let folder = Folder::new().with("inner.svg", inner);
    folder.run("inner.svg -o inner.png").succeeds_quietly();
    for name in ["inner.png", "inner.svg"] {
        let outer = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' width='8' height='8'>
             <image xlink:href='{name}' width='8' height='8'/></svg>"
        );
        let folder_with_outer = std::fs::write(folder.path("outer.svg"), outer);
        folder_with_outer.unwrap();
        folder.run("outer.svg -o outer.png").succeeds_quietly();
        assert_eq!(read_picture(&folder.path("outer.png")).pixel(4, 4), [0, 255, 0, 255], "{name}");
    }
}

#[test]
fn textures_of_triangles_are_read_as_the_options_say() {
    let mut tga = [0; 18];
    (tga[2], tga[12], tga[14], tga[16], tga[17]) = (2, 2, 1, 24, 0x20);
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='40' height='40'><texture texid='t' filename='two.tga'/>
        <textri texid='t' points='0 0 80 0 0 80' uvs='0 0 4 0 0 4'/></svg>";
    let texels = [&tga[..], &[0, 0, 255, 0, 255, 0]].concat();
    let folder = Folder::new().with("a.svg", svg).with("two.tga", texels);
    let (red, green, none) = ([255, 0, 0, 255], [0, 255, 0, 255], [0; 4]);
    for (options, expected) in [
        ("", [red, green, green, green]),
        ("--wrap repeat --anisotropy 8", [red, green, red, green]),
        ("--wrap mirror", [red, green, green, red]),
        ("--wrap border", [red, green, none, none]),
    ] {
        let picture = folder.picture(&format!("a.svg --pixel-filter nearest {options}"));
        assert_eq!([5, 15, 25, 35].map(|x| picture.pixel(x, 5)), expected, "{options}");
    }
    folder.run("a.svg --preset cs184 --wrap repeat -o b.png").misuses_with(&["--wrap", "cs184"]);
}

#[test]
fn broken_files_are_refused_with_a_reason() {
    let folder =
        Folder::new().with("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'><g></svg>").with("b.svg", "no xml");
    folder.run("a.svg -o a.png").fails_with(&["a.svg", "not a valid SVG file"]);
    folder.run("b.svg -o a.png").fails_with(&["b.svg", "not a valid SVG file"]);
    let far = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><filter id='f' x='0' width='.5'><feFlood/></filter>
        <rect x='2147483648' width='160' height='160' filter='url(#f)' transform='scale(.1)'/></svg>";
    let folder = Folder::new().with("c.svg", far);
    folder.run("c.svg -o a.png").fails_with(&["c.svg", "not a valid SVG file", "too large"]);
}
