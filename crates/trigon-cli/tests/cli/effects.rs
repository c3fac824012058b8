//! Options of shadows and other effects: what each changes, and what is refused.

use crate::support::{Folder, difference};
use trigon_image::Rgba8Image;

/// A floor with a table top above it.
const TABLE: &str = "v -2 0 -2\nv 2 0 -2\nv 2 0 2\nv -2 0 2\nv -1 1 -1\nv 1 1 -1\nv 1 1 1\nv -1 1 1\n\
                     f 4 3 2 1\nf 8 7 6 5\n";
const VIEW: &str = "table.obj -s 100x80 --light directional:0.5,-1,0:0.8 --light ambient:0.1";

fn folder() -> Folder {
    Folder::new().with("table.obj", TABLE)
}

/// The part of the pixels that got darker.
fn darkened(before: &Rgba8Image, after: &Rgba8Image) -> f64 {
    let pixels = before.pixels().iter().zip(after.pixels());
    let darker = pixels.filter(|(before, after)| i32::from(before[0]) - i32::from(after[0]) > 30).count();
    darker as f64 / before.pixels().len() as f64
}

#[test]
fn shadows_darken_what_is_behind_a_table_top() {
    let folder = folder();
    let without = folder.picture(VIEW);
    let with = folder.picture(&format!("{VIEW} --shadows"));
    let part = darkened(&without, &with);
    assert!((0.03..0.3).contains(&part), "{part}");
    assert_eq!(darkened(&with, &without), 0.0, "nothing gets lighter");
    // Frames without light have no shadows.
    assert_eq!(
        folder.picture(&format!("{VIEW} --shader normal")),
        folder.picture(&format!("{VIEW} --shader normal --shadows"))
    );
}

#[test]
fn each_option_of_shadows_switches_them_on_and_changes_them() {
    let folder = folder();
    let plain = folder.picture(&format!("{VIEW} --shadows"));
    for options in ["--shadow-softness 16", "--shadow-map-size 64", "--shadow-bias 1.5"] {
        let picture = folder.picture(&format!("{VIEW} {options}"));
        assert!(difference(&plain, &picture) > 0.002, "{options} changes nothing");
    }
    // Moved beyond the table top, the floor is not in its shadow.
    assert_eq!(folder.picture(VIEW), folder.picture(&format!("{VIEW} --shadow-bias 1.5")));
    assert_eq!(plain, folder.picture(&format!("{VIEW} --shadow-map-size 2048 --shadow-softness 3")));
}

#[test]
fn values_out_of_range_are_refused() {
    let folder = folder();
    let check = |options: &str, words: &[&str]| {
        folder.run(&format!("{VIEW} -o a.png {options}")).misuses_with(words);
    };
    check("--shadow-map-size 0", &["--shadow-map-size", "1..=16384"]);
    check("--shadow-map-size 16385", &["--shadow-map-size", "1..=16384"]);
    check("--shadow-bias -0.1", &["--shadow-bias", "below zero"]);
    check("--shadow-softness 17", &["--shadow-softness", "16"]);
    check("--shadow-softness nan", &["--shadow-softness", "finite"]);
    check("--ssao-radius 0", &["--ssao-radius", "above zero"]);
    check("--ssao-strength -1", &["--ssao-strength", "below zero"]);
    check("--ssao-samples 257", &["--ssao-samples", "1..=256"]);
    check("--toon-levels 0", &["--toon-levels", "1..=16"]);
    check("--outline-width 0.5", &["--outline-width", "1 to 32"]);
    check("--outline-threshold 0", &["--outline-threshold", "above zero"]);
    check("--outline-color rde", &["--outline-color", "rde"]);
}

#[test]
fn ambient_occlusion_darkens_and_each_option_changes_it() {
    let folder = Folder::with_cube()
        .with("stand.obj", format!("{}v -3 0 -3\nv 5 0 -3\nv 5 0 6\nv -3 0 6\nf 9 12 11 10\n", crate::support::CUBE));
    let view = "stand.obj -s 100x80 --light ambient:0.8";
    let without = folder.picture(view);
    let plain = folder.picture(&format!("{view} --ssao"));
    assert!(difference(&without, &plain) > 0.02);
    assert_eq!(darkened(&plain, &without), 0.0, "nothing gets lighter");
    for options in ["--ssao-radius 0.3", "--ssao-strength 3", "--ssao-samples 2"] {
        assert!(plain != folder.picture(&format!("{view} {options}")), "{options} changes nothing");
    }
    assert_eq!(without, folder.picture(&format!("{view} --ssao-strength 0")));
    // Light with a direction is not dimmed.
    let sun = "stand.obj -s 100x80 --light directional:-1,-2,-1:0.8";
    assert_eq!(folder.picture(sun), folder.picture(&format!("{sun} --ssao")));
}

#[test]
fn toon_has_as_many_colours_as_levels() {
    let folder = Folder::with_cube();
    // Three faces of different brightness.
    let view = "cube.obj -s 60x60 --samples 1 --background black --light directional:-1,-2,-0.3:1.2 --shader toon";
    let colors = |options: &str| {
        let picture = folder.picture(&format!("{view} {options}"));
        picture.pixels().iter().map(|pixel| pixel[0]).filter(|red| *red > 0).collect::<std::collections::BTreeSet<_>>()
    };
    assert_eq!(colors("--toon-levels 1").len(), 1);
    assert!(colors("--toon-levels 16").len() > 1);
}

#[test]
fn outlines_are_drawn_in_their_colour_and_width() {
    let folder = Folder::with_cube();
    let red = |options: &str| {
        let picture = folder.picture(&format!("cube.obj -s 100x80 --background white --samples 1 {options}"));
        picture.pixels().iter().filter(|pixel| pixel[..3] == [255, 0, 0]).count()
    };
    let (thin, wide) = (red("--outline-color red"), red("--outline-color red --outline-width 6"));
    assert_eq!(red(""), 0);
    assert!(thin > 100 && wide > 2 * thin, "{thin}, {wide}");
    // Silhouettes stay, creases do not.
    let silhouette = red("--outline-color red --outline-threshold 3");
    assert!(silhouette > 50 && silhouette < thin, "{silhouette}, {thin}");
}

/// A square with texture coordinates and no material.
fn square() -> String {
    crate::support::TEXTURED.replace("mtllib m.mtl\n", "").replace("usemtl picture\n", "")
}

/// Steps of grey along x, as an uncompressed TGA of 4 x 4 pixels.
fn steps() -> Vec<u8> {
    let mut bytes = vec![0, 0, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 4, 0, 8, 0];
    bytes.extend([0_u8, 80, 160, 255].repeat(4));
    bytes
}

#[test]
fn displacement_changes_the_silhouette() {
    let folder = Folder::new().with("square.obj", square()).with("h.tga", steps());
    let view = "square.obj -s 60x60 --background none --eye 4,0,1 --target 0,0,0.3 --height-map h.tga";
    let covered = |options: &str| {
        let picture = folder.picture(&format!("{view} {options}"));
        picture.pixels().iter().filter(|pixel| pixel[3] > 0).count()
    };
    // Seen from its side, a square is a narrow strip until it has a relief.
    let (flat, raised) = (covered(""), covered("--displace=1.2"));
    assert!(raised as f64 > 1.2 * flat as f64, "{flat}, {raised}");
    assert!(covered("--displace=1.2 --displace-middle 1") != raised);
    assert_eq!(covered("--displace=0"), flat);
}

#[test]
fn displacement_needs_a_map_and_says_when_triangles_run_out() {
    let folder =
        Folder::new().with("square.obj", square()).with("h.tga", steps()).with("cube.obj", crate::support::CUBE);
    folder.run("square.obj -o a.png --displace").fails_with(&["--displace", "--height-map"]);
    folder.run("cube.obj -o a.png --displace --height-map h.tga").fails_with(&["texture coordinates"]);
    folder.run("square.obj -o a.png --displace --height-map none.png").fails_with(&["none.png"]);
    folder.run("square.obj -o a.png --displace --displace-edge 0.01 --height-map h.tga").misuses_with(&["0.1 pixels"]);
    let limited = "square.obj -o a.png -s 90x90 --height-map h.tga --displace --displace-limit 100";
    folder.run(limited).succeeds().says(&["100 triangles", "--displace-limit"]);
}
