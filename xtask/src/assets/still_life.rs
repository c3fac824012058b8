//! The still life: a tea table with one object for each thing a material can be.
//!
//! One unit is about 5 cm. The table's top is at y = 0, its middle at the origin. The places below are those of a
//! viewer in front (+z) and a little to the right; all is then turned towards the view that trigon chooses by itself,
//! 35 degrees to the right. What is transparent comes last, the innermost first, as
//! blending in the order of the file wants it.

use super::bezier::Curve;
use super::material::{Map, Material};
use super::mesh::{Corner, Face, Form, Object, Part, faceted, grid, placed};
use super::shapes::{Stretch, block, disc, faceted_ball, quad, revolve, tile};
use super::teapot::{Fineness, teapot};
use super::vector::{Placement, cross, normalize, sub};

const FINENESS: Fineness = Fineness { quarter: 9, row_halves: 2, tube: 6 };
const TABLE_RADIUS: f64 = 5.85;
/// How far all is turned, in degrees, counter-clockwise from above.
const TURN: f64 = 17.0;

/// Everything, in the order of the file.
pub(crate) fn objects() -> Vec<Object> {
    let placed = [
        table(),
        trivet().placed(Placement::at([-1.3, 0.0, -1.2]).turned(14.0)),
        teapot(FINENESS).placed(Placement::at([-1.3, 0.34, -1.2]).turned(-20.0).scaled(1.12)),
        bowl().placed(Placement::at(BOWL)),
        oranges(),
        leaves(),
        lantern().placed(Placement::at([2.95, 0.0, -2.65]).turned(-28.0)),
        paperweight().placed(Placement::at([-4.0, 0.68, 1.7]).turned(20.0)),
        tea_glass().placed(Placement::at([-1.05, 0.0, 3.6])),
    ];
    placed.into_iter().map(|object| object.placed(Placement::at([0.0; 3]).turned(TURN))).collect()
}

const BOWL: [f64; 3] = [2.75, 0.0, 1.95];

pub(crate) const MATERIALS: [Material; 13] = [
    Material {
        name: "wood",
        about: "Oiled planks: a diffuse map, a faint wide highlight.",
        illum: 2,
        diffuse: [1.0; 3],
        specular: [0.10, 0.09, 0.08],
        exponent: 18.0,
        maps: &[Map::new("map_Ka", "wood.png"), Map::new("map_Kd", "wood.png")],
        ..PLAIN
    },
    Material {
        name: "zellige",
        about: "A glazed tile in relief: diffuse and tangent-space normal map.",
        illum: 2,
        diffuse: [1.0; 3],
        specular: [0.35; 3],
        exponent: 60.0,
        maps: &[
            Map::new("map_Ka", "zellige.png"),
            Map::new("map_Kd", "zellige.png"),
            Map::new("norm", "zellige-normal.png"),
        ],
        ..PLAIN
    },
    GLAZE,
    Material {
        name: "copper",
        about: "A hammered bowl: tangent-space normal map under a strong coloured highlight.",
        illum: 2,
        diffuse: [0.46, 0.17, 0.07],
        specular: [0.95, 0.52, 0.34],
        exponent: 48.0,
        maps: &[Map::new("norm", "hammered-normal.png")],
        ..PLAIN
    },
    Material {
        name: "orange",
        about: "The skin of a fruit: a height map.",
        illum: 2,
        diffuse: [0.93, 0.36, 0.03],
        specular: [0.22, 0.20, 0.18],
        exponent: 24.0,
        maps: &[Map::with_options("map_bump", "-bm 0.2 ", "peel-height.png")],
        ..PLAIN
    },
    Material {
        name: "leaf",
        about: "A flat leaf, cut out of its square by an alpha map.",
        illum: 2,
        diffuse: [1.0; 3],
        specular: [0.12, 0.14, 0.10],
        exponent: 20.0,
        maps: &[Map::new("map_Ka", "leaf.png"), Map::new("map_Kd", "leaf.png"), Map::new("map_d", "leaf-alpha.png")],
        ..PLAIN
    },
    Material {
        name: "lacquer",
        about: "The lantern's dark frame: no map, diffuse light only.",
        illum: 1,
        diffuse: [0.09, 0.035, 0.025],
        ..PLAIN
    },
    Material {
        name: "lattice",
        about: "Its panels: the pattern is one quad with a cut-out alpha map.",
        illum: 1,
        diffuse: [0.13, 0.05, 0.03],
        maps: &[Map::new("map_d", "lattice-alpha.png")],
        ..PLAIN
    },
    Material {
        name: "paper",
        about: "Lit from inside: an emissive map.",
        illum: 1,
        diffuse: [0.35, 0.30, 0.22],
        emissive: [1.0; 3],
        maps: &[Map::new("map_Ke", "glow.png")],
        ..PLAIN
    },
    Material {
        name: "brass",
        about: "A faceted ball without normals or texture coordinates: the reader makes them.",
        illum: 2,
        diffuse: [0.48, 0.31, 0.06],
        specular: [1.0, 0.80, 0.42],
        exponent: 30.0,
        ..PLAIN
    },
    Material {
        name: "tea",
        about: "Nearly opaque: blended over what is behind it.",
        illum: 2,
        diffuse: [0.56, 0.16, 0.015],
        specular: [0.4; 3],
        exponent: 120.0,
        dissolve: 0.9,
        ..PLAIN
    },
    Material {
        name: "glass",
        about: "Nearly clear: little colour of its own, a sharp highlight.",
        illum: 2,
        diffuse: [0.24, 0.30, 0.30],
        specular: [1.0; 3],
        exponent: 300.0,
        dissolve: 0.2,
        ..PLAIN
    },
    Material {
        name: "thread",
        about: "The gilded rim of the glass.",
        illum: 2,
        diffuse: [0.60, 0.42, 0.14],
        specular: [1.0, 0.85, 0.5],
        exponent: 60.0,
        ..PLAIN
    },
];

/// The teapot's, alone or on the table.
pub(crate) const GLAZE: Material = Material {
    name: "glaze",
    about: "Painted porcelain: diffuse, specular and exponent map; the gold shines in its own colour, and wider.",
    illum: 2,
    diffuse: [1.0; 3],
    specular: [1.0; 3],
    exponent: 160.0,
    maps: &[
        Map::new("map_Ka", "glaze.png"),
        Map::new("map_Kd", "glaze.png"),
        Map::new("map_Ks", "glaze-specular.png"),
        Map::new("map_Ns", "glaze-exponent.png"),
    ],
    ..PLAIN
};

/// What most materials have in common.
const PLAIN: Material = Material {
    name: "",
    about: "",
    illum: 1,
    diffuse: [0.8; 3],
    specular: [0.0; 3],
    exponent: 1.0,
    emissive: [0.0; 3],
    dissolve: 1.0,
    maps: &[],
};

fn table() -> Object {
    const COLUMNS: u32 = 56;
    let (edge, low, round) = (TABLE_RADIUS, -0.5, 0.12);
    let top = disc(edge - round, 0.0, COLUMNS, 1.0, 0.25);
    let mut rim = revolve(
        &[
            Stretch::line([edge - 0.5, low - 0.18], [edge, low], [0.0, 0.06]),
            Stretch::line([edge, low], [edge, -round], [0.06, 0.16]),
            Stretch::new(
                Curve([[edge, -round], [edge, -0.05], [edge - 0.05, 0.0], [edge - round, 0.0]]),
                3,
                [0.16, 0.2],
            ),
        ],
        COLUMNS,
        8.0,
    );
    rim.extend(disc(edge - 0.5, low - 0.18, COLUMNS, -1.0, 0.25));
    Object::new("table", vec![Part::new("top", "wood", Form::Full, top), Part::new("rim", "wood", Form::Full, rim)])
}

fn trivet() -> Object {
    Object::new("trivet", vec![Part::new("tile", "zellige", Form::Full, tile(2.35, 0.34, 0.07, 3.0))])
}

fn bowl() -> Object {
    let profile = [
        Stretch::line([0.0, 0.0], [0.75, 0.0], [0.0, 0.3]),
        Stretch::new(Curve([[0.75, 0.0], [0.85, 0.0], [0.85, 0.12], [0.8, 0.16]]), 2, [0.3, 0.4]),
        Stretch::new(Curve([[0.8, 0.16], [1.6, 0.2], [2.0, 0.65], [2.1, 1.25]]), 5, [0.4, 1.3]),
        Stretch::new(Curve([[2.1, 1.25], [2.12, 1.36], [2.0, 1.38], [1.98, 1.27]]), 3, [1.3, 1.4]),
        Stretch::new(Curve([[1.98, 1.27], [1.86, 0.72], [1.45, 0.30], [0.0, 0.24]]), 5, [1.4, 2.6]),
    ];
    Object::new("bowl", vec![Part::new("hammered", "copper", Form::Full, revolve(&profile, 28, 6.0))])
}

/// Two in the bowl, one on the table: the same faces three times, so that they share normals and coordinates.
fn oranges() -> Object {
    // A ball a little flattened, with a dimple at the stalk.
    let profile = [
        Stretch::new(Curve([[0.0, 0.0], [0.56, 0.0], [1.0, 0.42], [1.0, 0.94]]), 5, [0.0, 1.5]),
        Stretch::new(Curve([[1.0, 0.94], [1.0, 1.5], [0.54, 1.90], [0.12, 1.86]]), 5, [1.5, 2.9]),
        Stretch::new(Curve([[0.12, 1.86], [0.08, 1.85], [0.04, 1.80], [0.0, 1.80]]), 1, [2.9, 3.0]),
    ];
    let orange = revolve(&profile, 18, 6.0);
    let [x, _, z] = BOWL;
    let places = [([x - 0.72, 0.44, z + 0.30], 0.86), ([x + 0.72, 0.42, z - 0.20], 0.90), ([0.75, 0.0, 4.0], 0.84)];
    let mut faces = Vec::new();
    for (position, size) in places {
        faces.extend(placed(orange.clone(), Placement::at(position).scaled(size)));
    }
    Object::new("oranges", vec![Part::new("fruit", "orange", Form::Full, faces)])
}

/// Leaves at the orange on the table and on the rim of the bowl.
fn leaves() -> Object {
    let at = |position, turn: f64, pitch: f64, size: f64| {
        placed(leaf(), Placement::at(position).scaled(size).pitched(pitch).turned(turn))
    };
    let [x, _, z] = BOWL;
    let mut faces = at([0.78, 1.50, 4.0], 118.0, 8.0, 1.0);
    faces.extend(at([0.70, 1.53, 4.05], -12.0, 12.0, 0.85));
    faces.extend(at([x - 0.72, 2.0, z + 0.3], 150.0, 4.0, 1.05));
    faces.extend(at([-2.4, 0.12, 4.2], 75.0, 0.0, 1.1));
    Object::new("leaves", vec![Part::new("leaf", "leaf", Form::Full, faces)])
}

/// A leaf from the origin towards +z, 1.7 long, folded along its midrib and hanging towards the tip.
fn leaf() -> Vec<Face> {
    let surface = |s: f64, t: f64| {
        let x = (s - 0.5) * 0.72;
        let z = t * 1.7;
        [x, 0.34 * t * (1.0 - t) - 0.16 * t * t + 0.55 * x * x + 0.22 * x.abs(), z]
    };
    // Wound to be seen from above, the stalk (v = 0) at the origin; the texture mirrored to fit.
    grid(4, 6, |s, t| {
        let h = 1e-4;
        let side = if s < 0.5 { -h } else { h };
        let ds = sub(surface(s + side, t), surface(s, t)).map(|d| d / side);
        let dt = sub(surface(s, t + h), surface(s, t - h)).map(|d| d / h);
        let up = normalize(cross(dt, ds));
        Corner { position: surface(s, t), uv: [s, t], normal: up }
    })
    .into_iter()
    .map(|face| face.into_iter().rev().collect())
    .collect()
}

fn lantern() -> Object {
    let (half, post, low, high) = (1.05, 0.11, 0.12, 3.55);
    let mut frame = Vec::new();
    for (x, z) in [(-half, -half), (half, -half), (-half, half), (half, half)] {
        frame.extend(block([x - post, 0.0, z - post], [x + post, high, z + post], 0.5));
    }
    for (bottom, top) in [(low, low + 0.2), (high - 0.2, high)] {
        for side in [-half, half] {
            frame.extend(block([-half + post, bottom, side - 0.07], [half - post, top, side + 0.07], 0.5));
            frame.extend(block([side - 0.07, bottom, -half + post], [side + 0.07, top, half - post], 0.5));
        }
    }
    let roof = faceted(revolve(&roof(half), 4, 1.0));
    frame.extend(placed(roof, Placement::at([0.0, high, 0.0]).turned(45.0)));
    let width = 2.0 * (half - post);
    let height = high - 0.2 - (low + 0.2);
    let mut panels = Vec::new();
    for turn in [0.0, 90.0, 180.0, 270.0] {
        // 1.5 repeats across are three sides of a triangle; as many up as keep the triangles equal-sided.
        let repeats = [1.5, 1.5 * height / width / 3.0_f64.sqrt() * 2.0];
        let panel = quad([-half + post, low + 0.2, half], [width, 0.0, 0.0], [0.0, height, 0.0], repeats);
        panels.extend(placed(vec![panel], Placement::at([0.0; 3]).turned(turn)));
    }
    let paper = [Stretch::line([0.82, low], [0.82, high - 0.1], [0.0, 1.0])];
    Object::new(
        "lantern",
        vec![
            Part::new("frame", "lacquer", Form::PositionNormal, frame),
            Part::new("paper", "paper", Form::Full, revolve(&paper, 20, 1.0)),
            Part::new("panels", "lattice", Form::Full, panels),
        ],
    )
}

/// A low pyramid with a rim and a knob, for a square of that half width.
fn roof(half: f64) -> [Stretch; 5] {
    let corner = (half + 0.28) * std::f64::consts::SQRT_2;
    let knob = 0.16 * std::f64::consts::SQRT_2;
    [
        Stretch::line([0.0, 0.0], [corner, 0.0], [0.0; 2]),
        Stretch::line([corner, 0.0], [corner, 0.13], [0.0; 2]),
        Stretch::line([corner, 0.13], [knob, 0.62], [0.0; 2]),
        Stretch::line([knob, 0.62], [knob, 0.86], [0.0; 2]),
        Stretch::line([knob, 0.86], [0.0, 0.86], [0.0; 2]),
    ]
}

fn paperweight() -> Object {
    Object::new("paperweight", vec![Part::new("facets", "brass", Form::Position, faceted_ball(0.72))])
}

/// A glass of tea: the gilded rim, the liquid, then the thin wall around it.
fn tea_glass() -> Object {
    let wall = Curve([[0.62, 0.06], [1.05, 0.5], [0.52, 0.95], [0.82, 1.75]]);
    let tea = [
        Stretch::line([0.0, 0.14], [0.58, 0.14], [0.0; 2]),
        Stretch::new(Curve([[0.58, 0.14], [0.94, 0.52], [0.56, 0.85], [0.64, 1.30]]), 6, [0.0; 2]),
        Stretch::line([0.64, 1.30], [0.0, 1.30], [0.0; 2]),
    ];
    let glass = [
        Stretch::line([0.0, 0.0], [0.58, 0.0], [0.0; 2]),
        Stretch::new(Curve([[0.58, 0.0], [0.63, 0.0], [0.64, 0.04], [0.62, 0.06]]), 3, [0.0; 2]),
        Stretch::new(wall, 8, [0.0; 2]),
    ];
    let rim = [Stretch::new(Curve([[0.82, 1.75], [0.83, 1.80], [0.77, 1.80], [0.78, 1.75]]), 2, [0.0; 2])];
    let part = |group, material, profile: &[Stretch]| {
        Part::new(group, material, Form::PositionNormal, revolve(profile, 24, 1.0))
    };
    Object::new(
        "tea-glass",
        vec![part("rim", "thread", &rim), part("liquid", "tea", &tea), part("wall", "glass", &glass)],
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::mesh::checks::{assert_sound, open_edges};
    use std::collections::HashSet;

    #[test]
    fn every_part_is_sound() {
        for part in objects().iter().flat_map(|object| &object.parts) {
            assert_sound(part, 8.0);
        }
    }

    #[test]
    fn solids_are_closed() {
        for object in objects() {
            let faces: Vec<Face> = object.parts.iter().flat_map(|part| part.faces.clone()).collect();
            let open = open_edges(&faces);
            match object.name {
                // The table's rim has the corners of its n-gons, the rest are solids.
                "table" | "trivet" | "bowl" | "oranges" | "paperweight" => assert_eq!(open, 0, "{}", object.name),
                _ => {}
            }
        }
    }

    #[test]
    fn materials_and_uses_are_the_same() {
        let used: HashSet<&str> = objects().iter().flat_map(|object| &object.parts).map(|part| part.material).collect();
        let known: HashSet<&str> = MATERIALS.iter().map(|material| material.name).collect();
        assert_eq!(used, known);
    }

    #[test]
    fn everything_stands_on_the_table() {
        for object in objects().iter().filter(|object| object.name != "table") {
            for corner in object.parts.iter().flat_map(|part| part.faces.iter().flatten()) {
                let [x, y, z] = corner.position;
                assert!(y > -0.06, "{} at {y}", object.name);
                assert!(x * x + z * z < TABLE_RADIUS * TABLE_RADIUS, "{} hangs over", object.name);
            }
        }
    }

    #[test]
    fn transparent_parts_come_last() {
        let is_blended = |name: &str| MATERIALS.iter().any(|material| material.name == name && material.dissolve < 1.0);
        let objects = objects();
        let blended: Vec<bool> =
            objects.iter().flat_map(|object| &object.parts).map(|part| is_blended(part.material)).collect();
        assert!(blended.is_sorted());
    }
}
