//! Materials to MTL text.

use std::fmt::Write as _;

use super::obj::number;

/// One `newmtl`: what is `None` or empty is not written.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Material {
    pub(crate) name: &'static str,
    /// Why it looks so, for the reader of the file.
    pub(crate) about: &'static str,
    /// 1: ambient and diffuse; 2: and specular.
    pub(crate) illum: u8,
    /// `Kd`, and `Ka` with it.
    pub(crate) diffuse: [f64; 3],
    pub(crate) specular: [f64; 3],
    pub(crate) exponent: f64,
    pub(crate) emissive: [f64; 3],
    /// 1 is opaque.
    pub(crate) dissolve: f64,
    /// Lines such as `map_Kd wood.png`, without the folder of the textures.
    pub(crate) maps: &'static [Map],
}

/// One texture of a material.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Map {
    pub(crate) keyword: &'static str,
    /// Options in front of the file name, with a blank after them.
    pub(crate) options: &'static str,
    pub(crate) file: &'static str,
}

impl Map {
    pub(crate) const fn new(keyword: &'static str, file: &'static str) -> Self {
        Self { keyword, options: "", file }
    }

    pub(crate) const fn with_options(keyword: &'static str, options: &'static str, file: &'static str) -> Self {
        Self { keyword, options, file }
    }
}

/// The text of an MTL file.
pub(crate) fn text(about: &str, materials: &[Material]) -> String {
    let mut text = String::new();
    for line in about.lines() {
        let _ = writeln!(text, "# {line}");
    }
    for material in materials {
        push(&mut text, material);
    }
    text
}

fn push(text: &mut String, material: &Material) {
    let colour = |c: [f64; 3]| c.map(|x| number(x, 3)).join(" ");
    let _ = write!(text, "\n# {}\nnewmtl {}\nillum {}\n", material.about, material.name, material.illum);
    let _ = write!(text, "Ka {0}\nKd {0}\n", colour(material.diffuse));
    if material.illum == 2 {
        let _ = write!(text, "Ks {}\nNs {}\n", colour(material.specular), number(material.exponent, 1));
    }
    if material.emissive != [0.0; 3] {
        let _ = writeln!(text, "Ke {}", colour(material.emissive));
    }
    if material.dissolve < 1.0 {
        let _ = writeln!(text, "d {}", number(material.dissolve, 3));
    }
    for map in material.maps {
        let _ = writeln!(text, "{} {}textures/{}", map.keyword, map.options, map.file);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_a_material_has_is_written() {
        const MAPS: &[Map] = &[Map::with_options("map_bump", "-bm 0.1 ", "b.png")];
        let plain =
            Material { name: "a", about: "Plain.", illum: 1, diffuse: [0.5; 3], dissolve: 1.0, ..Material::default() };
        let glass = Material { name: "b", illum: 2, dissolve: 0.25, exponent: 90.0, maps: MAPS, ..plain };
        let expected = "# Two.\n\n# Plain.\nnewmtl a\nillum 1\nKa 0.5 0.5 0.5\nKd 0.5 0.5 0.5\n\n# Plain.\nnewmtl b\nillum 2\n\
            Ka 0.5 0.5 0.5\nKd 0.5 0.5 0.5\nKs 0 0 0\nNs 90\nd 0.25\nmap_bump -bm 0.1 textures/b.png\n";
        assert_eq!(text("Two.", &[plain, glass]), expected);
    }
}
