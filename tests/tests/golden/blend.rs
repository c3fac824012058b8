//! Translucent and cut-out surfaces.

use trigon_scene::render::AlphaMode;
use trigon_tests::golden::{Shot, sphere, square};

/// Three squares one behind the other, red in front; in the file the front one comes first.
const PANES: &str = "v -1 -1 1\nv 0.3 -1 1\nv 0.3 0.3 1\nv -1 0.3 1\nv -0.6 -0.6 0\nv 0.7 -0.6 0\nv 0.7 0.7 0\n\
     v -0.6 0.7 0\nv -0.2 -0.2 -1\nv 1 -0.2 -1\nv 1 1 -1\nv -0.2 1 -1\n\
     usemtl red\nf 1 2 3 4\nusemtl green\nf 5 6 7 8\nusemtl blue\nf 9 10 11 12\n";
const GLASS: &str = "newmtl red\nillum 0\nKd 0.9 0.1 0.1\nd 0.5\nnewmtl green\nillum 0\nKd 0.1 0.8 0.1\nd 0.5\n\
     newmtl blue\nillum 0\nKd 0.1 0.2 0.9\nd 0.5\n";
const LEAF: &str = "newmtl m\nKd 1 1 1\nmap_Kd textures/leaf.png\nmap_d textures/leaf-alpha.png\n";

/// Blended from back to front, whatever the order of the file.
#[test]
fn panes_are_sorted() {
    Shot::obj(PANES, GLASS).face_on().check("blend/panes-are-sorted");
}

/// Opacity is kept in the picture.
#[test]
fn transparent_background() {
    Shot::obj(PANES, GLASS).face_on().with(|s| s.background = [0.0; 4]).check("blend/transparent-background");
}

#[test]
fn panes_as_if_opaque() {
    Shot::obj(PANES, GLASS).face_on().with(|s| s.alpha = AlphaMode::Opaque).check("blend/panes-as-if-opaque");
}

#[test]
fn leaf_is_cut_out() {
    Shot::obj(&format!("usemtl m\n{}", square()), LEAF).from(20.0, 10.0).check("blend/leaf-is-cut-out");
}

#[test]
fn leaf_blended() {
    let shot = Shot::obj(&format!("usemtl m\n{}", square()), LEAF).from(20.0, 10.0);
    shot.with(|s| s.alpha = AlphaMode::Blend).check("blend/leaf-blended");
}

/// A sphere inside a glass sphere.
#[test]
fn glass_around_a_ball() {
    let ball = sphere(0.0).lines().map(shrink).collect::<String>();
    let text = format!("usemtl ball\n{ball}usemtl glass\n{}", sphere(0.0));
    let materials = "newmtl ball\nKd 0.8 0.3 0.1\nnewmtl glass\nKd 0.3 0.5 0.6\nKs 1 1 1\nNs 200\nd 0.3\n";
    Shot::obj(&text, materials).check("blend/glass-around-a-ball");
}

/// `d -halo`: clear in the middle, dense at the silhouette.
#[test]
fn halo() {
    let text = format!("usemtl m\n{}", sphere(0.0));
    Shot::obj(&text, "newmtl m\nillum 0\nKd 0.2 0.4 0.9\nd -halo 0.0\n").check("blend/halo");
}

/// A line of OBJ text with positions halved.
fn shrink(line: &str) -> String {
    match line.strip_prefix("v ") {
        Some(numbers) => {
            let halved = numbers.split(' ').map(|n| format!(" {}", n.parse::<f64>().expect("a number") * 0.5));
            format!("v{}\n", halved.collect::<String>())
        }
        None => format!("{line}\n"),
    }
}
