//! View, surface and sample options: each changes the picture in the way its name says.

use crate::support::{CUBE, Folder, difference};
use trigon_image::Rgba8Image;

const SIZE: &str = "-s 80x60";

/// The part of the pixels that are not background.
fn covered(picture: &Rgba8Image) -> f64 {
    let count = picture.pixels().iter().filter(|pixel| pixel[3] > 0).count();
    count as f64 / picture.pixels().len() as f64
}

#[test]
fn render_may_be_left_out() {
    let folder = Folder::with_cube();
    assert_eq!(folder.picture(&format!("render cube.obj {SIZE}")), folder.picture(&format!("cube.obj {SIZE}")));
    assert_eq!(folder.picture(&format!("{SIZE} cube.obj")), folder.picture(&format!("cube.obj {SIZE}")));
}

#[test]
fn up_turns_a_model_upright() {
    // (x, y, z) with y up is (x, -z, y) with z up.
    let turned: String = CUBE
        .lines()
        .map(|line| match line.strip_prefix("v ").map(|rest| rest.split(' ').collect::<Vec<_>>()).as_deref() {
            Some([x, y, z]) => format!("v {x} -{z} {y}\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    let folder = Folder::with_cube().with("turned.obj", turned);
    let upright = folder.picture(&format!("cube.obj {SIZE}"));
    let lying = folder.picture(&format!("turned.obj {SIZE}"));
    let raised = folder.picture(&format!("turned.obj {SIZE} --up +Z"));
    assert!(difference(&upright, &lying) > 0.05);
    assert!(difference(&upright, &raised) < 0.01);
    let rotated = folder.picture(&format!("turned.obj {SIZE} --rotate-x -90"));
    assert!(difference(&upright, &rotated) < 0.01);
}

#[test]
fn zoom_and_scale() {
    let folder = Folder::with_cube();
    let area = |options: &str| covered(&folder.picture(&format!("cube.obj {SIZE} --background none {options}")));
    let whole = area("");
    assert!(whole > 0.2 && whole < 0.9, "{whole}");
    assert!((area("--zoom 0.5") / whole - 0.25).abs() < 0.03);
    // Framing undoes a change of size.
    assert!((area("--scale 10") - whole).abs() < 0.01);
    assert!((area("--orthographic=12") / area("--orthographic=6") - 0.25).abs() < 0.03);
}

#[test]
fn an_eye_at_the_framed_place_sees_the_framed_view() {
    let folder = Folder::with_cube();
    let finished = folder.run("cube.obj -s 80x60 -o a.png --json --fov 40").succeeds();
    let list = |name: &str| {
        let (_, after) = finished.text().split_once(&format!("\"{name}\": [")).unwrap();
        after[..after.find(']').unwrap()].split(',').map(str::trim).collect::<Vec<_>>().join(",")
    };
    let framed = folder.picture("cube.obj -s 80x60 --fov 40");
    let stood =
        folder.picture(&format!("cube.obj -s 80x60 --fov 40 --eye {} --target {}", list("eye"), list("target")));
    assert!(difference(&framed, &stood) < 0.02);
}

#[test]
fn near_and_far_cut_the_model() {
    let folder = Folder::with_cube();
    let area = |options: &str| {
        let view = format!("cube.obj {SIZE} --background none --eye 1,0.5,10 --target 1,0.5,0 --cull back --quiet");
        covered(&folder.picture(&format!("{view} {options}")))
    };
    let whole = area("");
    assert!(area("--near 6.9 --far 7.1") >= whole * 0.9);
    assert!(area("--near 7.5 --far 8") < whole * 0.2);
}

#[test]
fn lights_and_shaders_change_the_picture() {
    let folder = Folder::with_cube();
    let plain = folder.picture(&format!("cube.obj {SIZE}"));
    let options = [
        "--light directional:0,-1,0:1",
        "--light point:5,5,5:30:orange --light ambient:0.1",
        "--light spot:0,9,0:0,-1,0:20/30:50",
        "--shader unlit",
        "--shader normal",
        "--shader depth",
        "--shader barycentric",
        "--shader coverage",
        "--shader overdraw",
        "--shader ids",
        "--wireframe",
        "--wireframe=only",
        "--wireframe=hidden --line-width 3",
        "--cull front",
        "--azimuth -60",
        "--elevation 80deg",
        "--orthographic",
        "--target 0,0,0",
        "--rotate-y 0.25turn",
    ];
    let mut seen = vec![plain];
    for options in options {
        let picture = folder.picture(&format!("cube.obj {SIZE} {options}"));
        assert!(seen.iter().all(|other| difference(other, &picture) > 0.005), "{options} changes nothing");
        seen.push(picture);
    }
}

#[test]
fn edges_alone_stand_out_before_any_background() {
    let folder = Folder::with_cube();
    for (background, is_dark) in [("white", false), ("black", true), ("#234", true), ("lemonchiffon", false)] {
        for mode in ["only", "hidden"] {
            let options = format!("cube.obj {SIZE} --wireframe={mode} --line-width 3 --background {background}");
            let picture = folder.picture(&options);
            let is_edge = |pixel: &&[u8; 4]| if is_dark { pixel[1] > 180 } else { pixel[1] < 60 };
            assert!(picture.pixels().iter().filter(is_edge).count() > 100, "{options}");
        }
    }
}

#[test]
fn a_red_light_makes_red_pictures() {
    let folder = Folder::with_cube();
    let picture = folder.picture(&format!("cube.obj {SIZE} --light directional:-1,-1,-1:1:red"));
    let [r, g, b, _] = picture.pixel(40, 30);
    assert!(r > 50 && g == 0 && b == 0, "{r} {g} {b}");
}

#[test]
fn samples_smooth_edges() {
    let folder = Folder::with_cube();
    let shades = |options: &str| {
        let picture = folder.picture(&format!("cube.obj {SIZE} --shader coverage {options}"));
        let mut shades: Vec<u8> = picture.pixels().iter().map(|pixel| pixel[0]).collect();
        shades.sort_unstable();
        shades.dedup();
        shades.len()
    };
    assert_eq!(shades("--samples 1"), 2);
    assert_eq!(shades("--samples 4"), 5);
    assert_eq!(shades("--samples 9 --pattern grid"), 10);
    assert!(shades("--samples 16 --shading sample") > 10);
}

#[test]
fn a_texture_can_be_put_on_a_model_without_materials() {
    let square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 4 0\nvt 4 4\nvt 0 4\nf 1/1 2/2 3/3 4/4\n";
    let folder = Folder::with_cube().with("square.obj", square);
    folder.run("cube.obj -s 32 --shader barycentric -o texture.png").succeeds_quietly();
    let view = "square.obj -s 64 --shader unlit --azimuth 0 --elevation 0";
    let plain = folder.picture(view);
    let textured = folder.picture(&format!("{view} --texture texture.png"));
    assert!(difference(&plain, &textured) > 0.3);
    for options in ["--pixel-filter nearest --level-filter zero", "--wrap clamp", "--wrap border", "--wrap mirror"] {
        let other = folder.picture(&format!("{view} --texture texture.png {options}"));
        assert!(difference(&textured, &other) > 0.005, "{options} changes nothing");
    }
}
