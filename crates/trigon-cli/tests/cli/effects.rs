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
}
