//! `trigon compare`: each cell is the picture of `trigon render`, errors fall as samples rise, misuse is explained.

use crate::support::{Folder, TEXTURED, read_picture};

/// Values of `"name": value`, in the order in which they come.
fn values<'t>(json: &'t str, name: &str) -> Vec<&'t str> {
    let key = format!("\"{name}\": ");
    let after: Vec<&str> = json.split(&key).skip(1).collect();
    after.into_iter().map(|rest| rest.split(['\n', ',']).next().unwrap().trim_matches('"')).collect()
}

fn textured() -> Folder {
    let texels = (0..48_u8).map(|i| if i / 3 % 2 == i / 12 % 2 { 250 } else { 10 });
    let tga: Vec<u8> = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 4, 0, 24, 0].into_iter().chain(texels).collect();
    let shape = TEXTURED.replace("vt 1", "vt 9").replace(" 1\nusemtl", " 9\nusemtl");
    Folder::with_cube().with("square.obj", shape).with("m.mtl", "newmtl picture\nmap_Kd t.tga\n").with("t.tga", tga)
}

#[test]
fn cells_are_the_pictures_of_render() {
    let folder = textured();
    let view = "square.obj --size 50x40 --rotate-x 60";
    let command = format!("compare {view} --vary samples=1,16 --vary level-filter=zero,linear -o sheet.png --json");
    let report = folder.run(&command).succeeds_quietly();
    let hashes = values(report.text(), "hash");
    let mut expected = Vec::new();
    for options in
        ["1 --level-filter zero", "1 --level-filter linear", "16 --level-filter zero", "16 --level-filter linear"]
    {
        let drawn = folder.run(&format!("render {view} --samples {options} -o a.png --json")).succeeds_quietly();
        expected.push(values(drawn.text(), "hash")[0].to_owned());
    }
    assert_eq!(hashes, expected);
    // Two columns of 50 pixels, apart enough for their labels, and a reference below.
    let sheet = read_picture(&folder.path("sheet.png"));
    assert!(sheet.width() > 2 * 18 + 2 * 100 + 20, "{}", sheet.width());
    assert!(sheet.height() > 3 * 40, "{}", sheet.height());
    let first = read_picture(&folder.path("a.png"));
    assert_eq!((first.width(), first.height()), (50, 40));
}

#[test]
fn errors_fall_as_samples_rise() {
    for (model, options) in [("cube.obj", "--size 60x50"), ("square.obj", "--size 60x50 --rotate-x 70"), ("a.svg", "")]
    {
        let svg =
            "<svg xmlns='http://www.w3.org/2000/svg' width='60' height='50'><circle cx='30.3' cy='25' r='20'/></svg>";
        let folder = textured().with("a.svg", svg);
        let report = folder.run(&format!("compare {model} {options} --vary samples=1,4,9,16 -o s.png --json"));
        let report = report.succeeds_quietly();
        let errors: Vec<f64> = values(report.text(), "rmse").iter().map(|value| value.parse().unwrap()).collect();
        assert_eq!(errors.len(), 4);
        assert!(errors.windows(2).all(|pair| pair[0] > pair[1]) && errors[3] > 0.0, "{model}: {errors:?}");
        // Nine samples exist on a grid alone, so all are on grids.
        let common = report.text().split_once("\"common\"").unwrap().1;
        assert!(common.contains("\"pattern\"") && common.contains("\"grid\""), "{}", report.text());
        let times = values(report.text(), "time_ms");
        assert!(times.iter().all(|time| time.parse::<f64>().unwrap() > 0.0), "{times:?}");
    }
}

#[test]
fn a_part_is_shown_enlarged() {
    let folder = textured();
    let options = "compare cube.obj --size 60x48 --vary shading=pixel,sample --inset 20,10,12 -o sheet.png";
    folder.run(options).succeeds_quietly();
    let sheet = read_picture(&folder.path("sheet.png"));
    let picture = folder.picture("render cube.obj --size 60x48");
    // Each pixel of the part is a square of 4 x 4 in the sheet, beside the picture.
    for (x, y) in [(1, 1), (6, 3), (10, 10)] {
        let shown = sheet.pixel(18 + 60 + 6 + 4 * x + 2, 18 + 4 * y + 2);
        assert_eq!(shown, picture.pixel(20 + x, 10 + y), "{x},{y}");
    }
}

#[test]
fn misuse_is_explained() {
    let folder = textured();
    folder.run("compare cube.obj -o a.png").misuses_with(&["--vary"]);
    folder.run("compare cube.obj -o a.png --vary samples").misuses_with(&["samples", "VALUE"]);
    folder.run("compare cube.obj -o a.png --vary sample=1,4").misuses_with(&[
        "did you mean samples?",
        "level-filter",
        "wrap",
    ]);
    folder.run("compare cube.obj -o a.png --vary size=1,4").misuses_with(&["\"size\" cannot be varied", "samples"]);
    folder.run("compare cube.obj -o a.png --vary wrap=clamp,around").misuses_with(&["around", "mirror", "--wrap"]);
    folder.run("compare cube.obj -o a.png --vary eye=1,2,3").misuses_with(&["--eye", "semicolons"]);
    folder.run("compare cube.obj -o a.png --vary samples=4,5").misuses_with(&["--samples 5"]);
    folder.run("compare cube.obj -o a.png --vary samples=1,4 --vary samples=2").misuses_with(&["samples comes twice"]);
    folder.run("compare cube.obj -o a.png --vary samples=1,4 --inset 310,0,20").misuses_with(&["--inset", "320x240"]);
    folder.run("compare cube.obj -o a.exr --vary samples=1,4").misuses_with(&["8 bits"]);
    // Before the model is read.
    folder.run("compare no.obj -o a.png --vary samples=1,4 --inset 400,0,2").misuses_with(&["--inset", "320x240"]);
    folder.run("compare no.obj -o a.png --vary samples=1 --size 9000x4").misuses_with(&["8192", "9000x4", "--size"]);
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>";
    let folder = folder.with("small.svg", svg);
    folder.run("compare small.svg -o a.png --vary samples=1,4 --inset 4,4,6").misuses_with(&["--inset", "9x9"]);
    assert!(!folder.names().iter().any(|name| name.starts_with("a.")));
}

/// The preset takes its samples half a pixel aside. A reference that did not would be off by a quarter of a pixel, and the
/// picture with most samples no nearer to it than the one with the fewest.
#[test]
fn the_reference_has_the_shift_of_a_preset() {
    let folder = Folder::with_cube();
    let line = "compare cube.obj --preset tinyrenderer --shader unlit --size 40 --eye 4,3,6 --vary samples=1,16";
    let report = folder.run(&format!("{line} -o sheet.png --no-times --quiet --json")).succeeds();
    let errors: Vec<f64> = values(report.text(), "rmse").iter().map(|value| value.parse().unwrap()).collect();
    assert!(errors[1] * 4.0 < errors[0], "{errors:?}");
}

/// Lines of CS184 are a pixel wide, whatever is chosen: what differs from the reference is triangles alone.
#[test]
fn the_reference_has_the_lines_of_cs184() {
    let lines = "<svg width='60' height='50'><line x1='3' x2='50' y1='5' y2='41' stroke='#0000ff'/></svg>";
    let triangle = "<svg width='60' height='50'><polygon points='3,5 50,9 30,41'/></svg>";
    let folder = Folder::new().with("lines.svg", lines).with("triangle.svg", triangle);
    let errors = |file: &str| -> Vec<f64> {
        let line =
            format!("compare {file} --preset cs184 --size 80x60 --vary samples=1,4,9,16 -o s.png --no-times --json");
        let report = folder.run(&line).succeeds_quietly();
        values(report.text(), "rmse").iter().map(|value| value.parse().unwrap()).collect()
    };
    assert_eq!(errors("lines.svg"), [0.0; 4]);
    let falling = errors("triangle.svg");
    assert!(falling.windows(2).all(|pair| pair[0] > pair[1]) && falling[3] > 0.0, "{falling:?}");
}
