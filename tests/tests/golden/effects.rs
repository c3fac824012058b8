//! Shadows, ambient occlusion, toon shading, outlines, displacement.

use trigon_scene::render::{AmbientOcclusion, Outline, ShaderKind, Shadows};
use trigon_scene::scene::{Displacement, Framing, Light, LightKind};
use trigon_tests::golden::{Shot, sphere};

/// A floor of 4 x 4 below the sphere about the origin.
const GROUND: &str = "v -2 -0.9 -2\nv 2 -0.9 -2\nv 2 -0.9 2\nv -2 -0.9 2\nf -1 -2 -3 -4\n";
/// An upright square beside it, with texture coordinates.
const PANE: &str = "v -1.9 -0.9 0.4\nv -0.9 -0.9 0.9\nv -0.9 0.3 0.9\nv -1.9 0.3 0.4\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                    f -4/-4 -3/-3 -2/-2 -1/-1\n";
const MATERIALS: &str = "newmtl grey\nKa 0.8 0.8 0.8\nKd 0.8 0.8 0.8\n\
                         newmtl leaf\nKa 0.3 0.3 0.3\nKd 1 1 1\nmap_Kd textures/leaf.png\nmap_d textures/leaf-alpha.png\n";

/// A sphere on a floor, and a leaf that is cut out of a square.
fn sphere_and_leaf() -> Shot {
    let text = format!("usemtl grey\n{}{GROUND}usemtl leaf\n{PANE}", sphere(0.0));
    Shot::obj(&text, MATERIALS).from(20.0, 35.0).size(112, 80)
}

fn shadows(shot: Shot, shadows: Shadows) -> Shot {
    shot.with(|settings| settings.shadows = Some(shadows))
}

fn small() -> Shadows {
    Shadows { map_size: 256, ..Shadows::default() }
}

fn ambient() -> Light {
    Light::new(LightKind::Ambient, 0.15)
}

/// The key light alone casts a shadow.
#[test]
fn shadows_of_the_default_lights() {
    shadows(sphere_and_leaf(), small()).check("effects/shadows-of-the-default-lights");
}

#[test]
fn shadow_of_a_directional_light_with_hard_edges() {
    let sun = Light::new(LightKind::Directional { direction: [1.0, -1.2, -0.5] }, 0.85);
    shadows(sphere_and_leaf().lights([sun, ambient()]), Shadows { softness: 0.0, ..small() })
        .check("effects/shadow-of-a-directional-light");
}

/// Inside of the scene: the shadows run apart over several faces of the cube, without a seam.
#[test]
fn shadow_of_a_point_light() {
    let bulb = Light::new(LightKind::Point { position: [-1.1, 0.7, 1.3] }, 2.2);
    shadows(sphere_and_leaf().lights([bulb, ambient()]), small()).check("effects/shadow-of-a-point-light");
}

#[test]
fn shadow_of_a_spot_light() {
    let kind = LightKind::Spot {
        position: [-1.5, 2.5, 2.0],
        direction: [1.4, -2.9, -1.7],
        inner_angle: 0.3,
        outer_angle: 0.45,
    };
    shadows(sphere_and_leaf().lights([Light::new(kind, 12.0), ambient()]), Shadows { softness: 8.0, ..small() })
        .check("effects/shadow-of-a-spot-light");
}

/// Too little bias, and surfaces shade themselves; too much, and the shadow leaves its object.
#[test]
fn bias_of_shadows() {
    let sun = Light::new(LightKind::Directional { direction: [1.0, -1.2, -0.5] }, 0.85);
    shadows(sphere_and_leaf().lights([sun, ambient()]), Shadows { bias: Some(0.5), ..small() })
        .check("effects/shadow-with-much-bias");
}

/// Dark where the sphere meets the floor, and where the leaf does.
#[test]
fn occlusion_alone() {
    sphere_and_leaf().shader(ShaderKind::Occlusion).check("effects/occlusion");
}

/// Light from all around is dimmed, the sun is not.
#[test]
fn ambient_occlusion_of_a_corner() {
    let corner =
        "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\nv -1 1 -1\nv 1 1 -1\nv -1 1 1\nf 4 3 2 1\nf 1 2 6 5\nf 4 1 5 7\n";
    let sun = Light::new(LightKind::Directional { direction: [-1.0, -0.2, -0.2] }, 0.3);
    Shot::obj(&format!("usemtl grey\n{corner}"), MATERIALS)
        .from(45.0, 30.0)
        .lights([sun, Light::new(LightKind::Ambient, 0.7)])
        .with(|settings| {
            settings.ambient_occlusion = Some(AmbientOcclusion { radius: Some(0.8), ..Default::default() });
        })
        .check("effects/ambient-occlusion-of-a-corner");
}

#[test]
fn toon_in_three_steps_and_in_six() {
    let text = format!("usemtl shiny\n{}", sphere(0.0));
    let ball = || Shot::obj(&text, "newmtl shiny\nKd 0.8 0.3 0.1\nKs 0.5 0.5 0.5\nNs 30\n").shader(ShaderKind::Toon);
    ball().check("effects/toon");
    ball().with(|settings| settings.toon_levels = 6).check("effects/toon-in-six-steps");
}

/// Toon, outlines and shadows together: a drawing.
#[test]
fn a_drawing() {
    shadows(sphere_and_leaf(), small())
        .shader(ShaderKind::Toon)
        .with(|settings| settings.outline = Some(Outline::default()))
        .check("effects/drawing");
}

/// Creases and silhouettes; a floor that recedes is neither.
#[test]
fn wide_outlines_over_nothing() {
    let outline = Outline { color: [0.5, 0.0, 0.05, 1.0], width_px: 4.0, ..Outline::default() };
    Shot::asset("cube.obj")
        .with(|settings| (settings.outline, settings.background) = (Some(outline), [0.0; 4]))
        .check("effects/wide-outlines");
}

/// A height map as geometry: the outline shows it, and the shadow.
#[test]
fn displaced_sphere() {
    let materials = format!("{MATERIALS}newmtl rough\nKd 0.8 0.5 0.2\ndisp textures/peel-height.png\n");
    let text = format!("usemtl rough\n{}usemtl grey\n{GROUND}", sphere(0.0));
    shadows(Shot::obj(&text, &materials).from(20.0, 25.0), small())
        .scene(|scene| {
            let camera = Framing::default().camera(scene);
            let settings = Displacement { scale: Some(0.5), middle: 0.5, ..Displacement::default() };
            let displaced = scene.displace(&camera, [96, 96], &settings);
            assert!(displaced.is_fine && displaced.meshes == 1, "{displaced:?}");
        })
        .check("effects/displaced-sphere");
}
