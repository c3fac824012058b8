//! 3D and 2D in one picture: SVG textures, pictures behind and before models and drawings; and what each kind of input
//! makes of the other's options.

use crate::support::{CUBE, Folder, TEXTURED, read_picture};

/// Left half red, right half transparent.
const HALF: &str =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 20'><rect width='10' height='20' fill='#f00'/></svg>";

/// Four squares: red, green over blue, white.
const SQUARES: &str = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2 2'><path d='M0 0h1v1h-1z' fill='#f00'/>
<path d='M1 0h1v1h-1z' fill='#0f0'/><path d='M0 1h1v1h-1z' fill='#00f'/><path d='M1 1h1v1h-1z' fill='#fff'/></svg>";

fn is_close(pixel: [u8; 4], expected: [u8; 4]) -> bool {
    pixel.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 1)
}

#[test]
fn a_drawing_is_a_texture() {
    let folder = Folder::new()
        .with("a.obj", TEXTURED)
        .with("m.mtl", "newmtl picture\nKa 1 1 1\nKd 1 1 1\nmap_Kd squares.svg\n")
        .with("squares.svg", SQUARES);
    let view = "--size 64 --shader unlit --orthographic --azimuth 0 --elevation 0 --background none";
    let picture = folder.picture(&format!("a.obj {view}"));
    for (at, color) in
        [([16, 16], [255, 0, 0, 255]), ([48, 16], [0, 255, 0, 255]), ([16, 48], [0, 0, 255, 255]), ([48, 48], [255; 4])]
    {
        assert_eq!(picture.pixel(at[0], at[1]), color, "{at:?}");
    }
    // As the option that gives materials a texture, too.
    let folder = folder.with("m.mtl", "newmtl picture\nKa 1 1 1\nKd 1 1 1\n");
    let same = folder.picture(&format!("a.obj {view} --texture squares.svg"));
    assert!(same == picture);
    // A broken one is a texture that cannot be used.
    let folder = folder.with("squares.svg", "<svg xmlns='http://www.w3.org/2000/svg'><rect</svg>");
    folder.run("a.obj --texture squares.svg -o b.png").succeeds().says(&["squares.svg", "not a valid SVG file"]);
    folder.run("a.obj --texture squares.svg -o c.png --strict").fails_with(&["squares.svg"]);
}

#[test]
fn a_backdrop_lies_behind_a_model() {
    let folder = Folder::with_cube().with("half.svg", HALF);
    let plain = folder.picture("cube.obj --size 90x60 --background #0000ff --samples 16");
    let layered = folder.picture("cube.obj --size 90x60 --background #0000ff --samples 16 --backdrop half.svg");
    let corner = |x: u32| layered.pixel(x, 0);
    assert_eq!(
        [corner(0), corner(44), corner(45), corner(89)],
        [[255, 0, 0, 255], [255, 0, 0, 255], [0, 0, 255, 255], [0, 0, 255, 255]]
    );
    // Right of the middle nothing changes, edges included; on the left, the inside of the model.
    for y in 0..60 {
        for x in 45..90 {
            assert!(is_close(layered.pixel(x, y), plain.pixel(x, y)), "{x} {y}");
        }
    }
    assert_eq!(layered.pixel(40, 30), plain.pixel(40, 30));
    // A picture of pixels, and one of another shape: it fills the frame.
    folder.run("half.svg -o half.png --size 20x20").succeeds_quietly();
    assert!(
        folder.picture("cube.obj --size 90x60 --background #0000ff --samples 16 --backdrop half.png").pixel(0, 0)[0]
            == 255
    );
    folder.run("cube.obj -o x.png --backdrop nothing.svg").fails_with(&["nothing.svg"]);
    folder.run("cube.obj -o half.svg --format png --backdrop half.svg").misuses_with(&["overwrite", "half.svg"]);
}

#[test]
fn an_overlay_lies_before_a_model_and_before_a_drawing() {
    let folder = Folder::with_cube().with("half.svg", HALF).with("squares.svg", SQUARES);
    for input in ["cube.obj", "squares.svg"] {
        let plain = folder.picture(&format!("{input} --size 40x40"));
        let layered = folder.picture(&format!("{input} --size 40x40 --overlay half.svg"));
        for (x, y) in [(3, 3), (19, 20), (19, 39)] {
            assert_eq!(layered.pixel(x, y), [255, 0, 0, 255], "{input} {x} {y}");
        }
        for (x, y) in [(20, 0), (25, 20), (39, 39)] {
            assert_eq!(layered.pixel(x, y), plain.pixel(x, y), "{input} {x} {y}");
        }
    }
    let between = folder.picture("half.svg --size 40x40 --backdrop squares.svg");
    assert_eq!(
        [between.pixel(3, 3), between.pixel(30, 3), between.pixel(30, 30)],
        [[255, 0, 0, 255], [0, 255, 0, 255], [255; 4]]
    );
    folder.run("half.svg --preset cs184 --overlay half.svg -o b.png").misuses_with(&["cs184", "--overlay"]);
}

#[test]
fn what_is_odd_about_a_layer_or_a_texture_is_told() {
    let broken =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2 2'><rect width='2' height='2'/><foreignObject/></svg>";
    let folder = Folder::with_cube()
        .with("half.svg", HALF)
        .with("broken.svg", broken)
        .with("a.obj", TEXTURED)
        .with("m.mtl", "newmtl picture\nmap_Kd broken.svg\n");
    for arguments in ["cube.obj --backdrop broken.svg", "half.svg --overlay broken.svg", "a.obj"] {
        let run = format!("{arguments} --size 20 -o b.png");
        folder.run(&run).succeeds().says(&["warning", "broken.svg", "foreignObject"]);
        folder.run(&format!("{run} --strict")).fails_with(&["broken.svg", "--strict"]);
        let report = folder.run(&format!("{run} --json"));
        assert!(report.text().contains("foreignObject"), "{}", report.text());
    }
}

#[test]
fn layers_are_bounded_as_textures_are() {
    let folder = Folder::with_cube().with("half.svg", HALF);
    folder.run("half.svg -o half.png --size 40x40").succeeds_quietly();
    folder.run("cube.obj -o b.png --size 20 --backdrop half.png --limit texture-pixels=1600").succeeds_quietly();
    folder.run("cube.obj -o b.png --size 20 --backdrop half.png --limit texture-pixels=1599").fails_with(&["half.png"]);
}

#[test]
fn layers_have_every_depth_and_stand_still_in_an_animation() {
    let folder = Folder::with_cube().with("half.svg", HALF);
    folder.run("cube.obj --size 20 --backdrop half.svg -o a.exr").succeeds_quietly();
    let float = read_picture(&folder.path("a.exr"));
    assert_eq!([float.pixel(0, 0), float.pixel(19, 0)], [[255, 0, 0, 255], [0; 4]]);
    folder.run("turntable cube.obj --size 20 --frames 2 --backdrop half.svg -o f{frame}.png").succeeds_quietly();
    for name in ["f0.png", "f1.png"] {
        assert_eq!(read_picture(&folder.path(name)).pixel(0, 0), [255, 0, 0, 255]);
    }
}

#[test]
fn options_that_say_nothing_about_the_input_are_refused() {
    let folder = Folder::new().with("a.svg", HALF).with("cube.obj", CUBE);
    folder.run("a.svg -o b.png --shader flat").misuses_with(&["--shader", "models", "a.svg"]);
    folder.run("a.svg -o b.png --azimuth 30").misuses_with(&["--azimuth", "models"]);
    folder.run("a.svg -o b.png --shading sample").misuses_with(&["--shading", "models"]);
    folder.run("cube.obj -o b.png --width 30").misuses_with(&["--width", "SVG", "--size"]);
    folder.run("cube.obj -o b.png --export-id a").misuses_with(&["--export-id", "SVG"]);
    folder.run("cube.obj -o b.png --preset cs184").misuses_with(&["cs184", "model"]);
    folder.run("a.svg -o c.png --samples 4 --zoom 2 --background red -j 1 --strict").succeeds_quietly();
}

#[test]
fn a_time_limit_ends_the_command_and_leaves_nothing() {
    let folder = Folder::with_cube();
    folder.run("cube.obj -o a.png --time-limit 600").succeeds_quietly();
    folder
        .run("turntable cube.obj -o b.gif --frames 100000 --size 4k --time-limit 0.5")
        .fails_with(&["0.5 s", "--time-limit"]);
    folder.run("cube.obj -o c.png --time-limit 0").misuses_with(&["--time-limit"]);
    assert_eq!(folder.names(), ["a.png", "cube.obj"]);
}
