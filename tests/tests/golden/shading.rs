//! Materials, maps and lights.

use trigon::target::ColorSpace;
use trigon_scene::render::ShaderKind;
use trigon_scene::scene::{Light, LightKind};
use trigon_tests::golden::{Shot, sphere, square};

const SUN: LightKind = LightKind::Directional { direction: [-0.5, -0.7, -1.0] };

/// Three spheres with one material each, `a`, `b` and `c`, under sun and ambient light.
fn spheres(materials: &str) -> Shot {
    let (a, b, c) = (sphere(-2.0), sphere(0.0), sphere(2.0));
    Shot::obj(&format!("usemtl a\n{a}usemtl b\n{b}usemtl c\n{c}"), materials)
        .face_on()
        .size(160, 56)
        .lights([Light::new(SUN, 1.0), Light::new(LightKind::Ambient, 0.2)])
}

/// A square turned a little, with one material.
fn turned_square(material: &str) -> Shot {
    Shot::obj(&format!("usemtl m\n{}", square()), &format!("newmtl m\n{material}"))
        .from(25.0, 15.0)
        .lights([Light::new(SUN, 0.9), Light::new(LightKind::Ambient, 0.1)])
}

/// `illum` 0, 1 and 2.
#[test]
fn illumination_models() {
    let material = "Ka 0.2 0.5 0.7\nKd 0.2 0.5 0.7\nKs 1 1 1\nNs 40\n";
    spheres(&format!("newmtl a\nillum 0\n{material}newmtl b\nillum 1\n{material}newmtl c\nillum 2\n{material}"))
        .check("shading/illumination-models");
}

/// `Ns` 5, 40 and 400.
#[test]
fn exponents() {
    let material = "illum 2\nKd 0.5 0.1 0.1\nKs 0.8 0.8 0.8\n";
    spheres(&format!("newmtl a\n{material}Ns 5\nnewmtl b\n{material}Ns 40\nnewmtl c\n{material}Ns 400\n"))
        .check("shading/exponents");
}

/// Emission, a coloured highlight, none of both.
#[test]
fn emission_and_coloured_highlight() {
    spheres("newmtl a\nKd 0.1 0.1 0.1\nKe 0.1 0.5 0.1\nnewmtl b\nKd 0.3 0.2 0.1\nKs 1 0.6 0.2\nNs 20\nnewmtl c\nKd 0.8 0.8 0.8\n")
        .check("shading/emission-and-coloured-highlight");
}

/// What a model without lights gets, from the front and from behind.
#[test]
fn default_lights() {
    let grey = "newmtl a\nKd 0.8 0.8 0.8\nKs 0.2 0.2 0.2\n";
    Shot::obj(&format!("usemtl a\n{}", sphere(0.0)), grey).check("shading/default-lights");
}

#[test]
fn point_light_falls_off_with_distance() {
    let light = Light::new(LightKind::Point { position: [-0.5, -0.4, 0.35] }, 0.25).with_color([1.0, 0.8, 0.5]);
    turned_square("Kd 0.9 0.9 0.9\nillum 1\n").lights([light]).check("shading/point-light");
}

#[test]
fn spot_light_has_a_soft_edge() {
    let kind = LightKind::Spot {
        position: [1.0, 1.5, 2.0],
        direction: [-1.0, -1.5, -2.0],
        inner_angle: 0.15,
        outer_angle: 0.3,
    };
    turned_square("Kd 0.9 0.9 0.9\nillum 1\n").lights([Light::new(kind, 6.0)]).check("shading/spot-light");
}

#[test]
fn normal_map() {
    turned_square("Kd 0.7 0.7 0.7\nKs 0.3 0.3 0.3\nNs 30\nnorm textures/zellige-normal.png\n")
        .check("shading/normal-map");
}

/// The same map with tangents at the vertices.
#[test]
fn normal_map_with_tangents() {
    turned_square("Kd 0.7 0.7 0.7\nKs 0.3 0.3 0.3\nNs 30\nnorm textures/zellige-normal.png\n")
        .scene(trigon_scene::scene::Scene::generate_tangents)
        .check("shading/normal-map-with-tangents");
}

#[test]
fn bump_map() {
    turned_square("Kd 0.8 0.4 0.1\nmap_bump -bm 0.3 textures/peel-height.png\n").check("shading/bump-map");
}

/// Gold bands shine in their own colour, and wider.
#[test]
fn specular_and_exponent_maps() {
    Shot::asset("teapot.obj").check("shading/specular-and-exponent-maps");
}

#[test]
fn emission_map() {
    turned_square("Kd 0.05 0.05 0.05\nKe 1 1 1\nmap_Ke textures/glow.png\n").check("shading/emission-map");
}

#[test]
fn flat() {
    Shot::asset("teapot.obj").shader(ShaderKind::Flat).check("shading/flat");
}

#[test]
fn unlit() {
    Shot::asset("teapot.obj").shader(ShaderKind::Unlit).check("shading/unlit");
}

/// Both sides of a sheet are lit from their own side.
#[test]
fn sheets_are_two_sided() {
    let sheet = "v -1 0 -0.5\nv 0 0 0.5\nv 0 1 0.5\nv -1 1 -0.5\nv 1 0 -0.5\nv 1 1 -0.5\nf 1 2 3 4\nf 2 3 6 5\n";
    Shot::obj(sheet, "").from(0.0, 20.0).check("shading/sheets-are-two-sided");
}

#[test]
fn still_life() {
    Shot::asset("still-life.obj").size(144, 96).check("shading/still-life");
}

/// Light that adds up, edges and a translucent sphere in stored values.
#[test]
fn encoded_colors() {
    let material = "Kd 0.6 0.3 0.2\nKs 0.5 0.5 0.5\nNs 30\n";
    spheres(&format!("newmtl a\n{material}newmtl b\nd 0.5\n{material}newmtl c\nmap_Kd textures/zellige.png\n"))
        .with(|settings| settings.color_space = ColorSpace::Encoded)
        .check("shading/encoded-colours");
}
