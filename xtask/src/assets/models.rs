//! The files of `assets/`: names and contents.

use super::material::{self, Map, Material};
use super::mesh::{Form, Object, Part};
use super::shapes::quad;
use super::teapot::{Fineness, teapot};
use super::{obj, still_life, texture};

const ORIGIN: &str = "Made by `cargo xtask assets`; CC0.";

/// Path below `assets/` and content of every generated file.
pub(crate) fn files() -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    let mut push = |name: &str, content: Vec<u8>| files.push((name.to_owned(), content));

    let about = format!("A still life on a tea table; one unit is 5 cm, y is up. {ORIGIN}");
    push("still-life.obj", obj::text(&about, Some("still-life.mtl"), &still_life::objects()).into_bytes());
    push("still-life.mtl", material::text(&about, &still_life::MATERIALS).into_bytes());

    let about = format!("The Utah teapot with painted glaze; y is up. {ORIGIN}");
    let fine = Fineness { quarter: 11, row_halves: 2, tube: 7 };
    push("teapot.obj", obj::text(&about, Some("teapot.mtl"), &[teapot(fine)]).into_bytes());
    push("teapot.mtl", material::text(&about, &[still_life::GLAZE]).into_bytes());

    let about = format!("A cube whose sides show their texture coordinates. {ORIGIN}");
    push("cube.obj", obj::text(&about, Some("cube.mtl"), &[cube()]).into_bytes());
    push("cube.mtl", material::text(&about, &[GRID]).into_bytes());

    for (name, make) in TEXTURES {
        push(&format!("textures/{name}.png"), make());
    }
    files
}

type Texture = (&'static str, fn() -> Vec<u8>);

const TEXTURES: [Texture; 13] = [
    ("wood", texture::wood_colour),
    ("glaze", texture::glaze_colour),
    ("glaze-specular", texture::glaze_specular),
    ("glaze-exponent", texture::glaze_exponent),
    ("zellige", texture::zellige_colour),
    ("zellige-normal", texture::zellige_normal),
    ("hammered-normal", texture::metal_normal),
    ("peel-height", texture::peel_height),
    ("leaf", texture::leaf_colour),
    ("leaf-alpha", texture::leaf_alpha),
    ("lattice-alpha", texture::lantern_lattice),
    ("glow", texture::lantern_glow),
    ("uv-grid", texture::uv_grid),
];

const GRID: Material = Material {
    name: "uv-grid",
    about: "Numbered fields: u = 1 to 8, v = A to H.",
    illum: 1,
    diffuse: [1.0; 3],
    specular: [0.0; 3],
    exponent: 1.0,
    emissive: [0.0; 3],
    dissolve: 1.0,
    maps: &[Map::new("map_Ka", "uv-grid.png"), Map::new("map_Kd", "uv-grid.png")],
};

/// Two units a side around the origin; every side shows the whole texture upright, top and bottom seen from the front.
fn cube() -> Object {
    let sides = [
        ([-1.0, -1.0, 1.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]),
        ([1.0, -1.0, 1.0], [0.0, 0.0, -2.0], [0.0, 2.0, 0.0]),
        ([1.0, -1.0, -1.0], [-2.0, 0.0, 0.0], [0.0, 2.0, 0.0]),
        ([-1.0, -1.0, -1.0], [0.0, 0.0, 2.0], [0.0, 2.0, 0.0]),
        ([-1.0, 1.0, 1.0], [2.0, 0.0, 0.0], [0.0, 0.0, -2.0]),
        ([-1.0, -1.0, -1.0], [2.0, 0.0, 0.0], [0.0, 0.0, 2.0]),
    ];
    let faces = sides.map(|(origin, right, up)| quad(origin, right, up, [1.0, 1.0])).to_vec();
    Object::new("cube", vec![Part::new("sides", "uv-grid", Form::PositionUv, faces)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::mesh::checks::{assert_sound, open_edges};

    #[test]
    fn the_cube_is_closed() {
        let cube = cube();
        assert_sound(&cube.parts[0], 1.0);
        assert_eq!(open_edges(&cube.parts[0].faces), 0);
    }

    #[test]
    fn every_map_is_made_and_every_texture_used() {
        let mut maps: Vec<&str> = still_life::MATERIALS
            .iter()
            .chain([&GRID])
            .flat_map(|material| material.maps)
            .map(|map| map.file)
            .collect();
        maps.sort_unstable();
        maps.dedup();
        let mut made: Vec<String> = TEXTURES.iter().map(|(name, _)| format!("{name}.png")).collect();
        made.sort_unstable();
        assert_eq!(maps, made);
    }
}
