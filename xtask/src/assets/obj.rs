//! Objects to OBJ text: few digits, each position, texture coordinate and normal written once.
//!
//! Shared positions are shared indices, so a closed shape stays closed in the file whatever its seams in texture or
//! normals are.

use std::collections::HashMap;
use std::fmt::Write as _;

use super::mesh::{Object, Part};

/// The text of an OBJ file with these objects, and the library `mtl` if it needs one.
pub(crate) fn text(about: &str, mtl: Option<&str>, objects: &[Object]) -> String {
    let mut writer = Writer::default();
    for line in about.lines() {
        writer.line(&format!("# {line}"));
    }
    if let Some(mtl) = mtl {
        writer.line(&format!("mtllib {mtl}"));
    }
    for object in objects {
        writer.line(&format!("o {}", object.name));
        for part in &object.parts {
            writer.part(part, mtl.is_some());
        }
    }
    writer.text
}

#[derive(Default)]
struct Writer {
    text: String,
    positions: Table,
    uvs: Table,
    normals: Table,
}

/// Lines of one kind that are already written, and their numbers.
#[derive(Default)]
struct Table(HashMap<String, usize>);

impl Table {
    /// The number of the values with that text, written to `out` if new.
    fn index(&mut self, keyword: &str, values: &str, out: &mut String) -> usize {
        let next = self.0.len() + 1;
        if let Some(index) = self.0.get(values) {
            return *index;
        }
        let _ = writeln!(out, "{keyword} {values}");
        self.0.insert(values.to_owned(), next);
        next
    }
}

impl Writer {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// Header lines, then the vertices that the part brings, then its faces.
    fn part(&mut self, part: &Part, with_material: bool) {
        self.line(&format!("g {}", part.group));
        if with_material {
            self.line(&format!("usemtl {}", part.material));
        }
        self.line(if part.form.has_normal() { "s 1" } else { "s off" });
        let mut faces = String::new();
        for face in &part.faces {
            faces.push('f');
            for corner in face {
                let v = self.positions.index("v", &numbers(&corner.position, 3), &mut self.text);
                let _ = write!(faces, " {v}");
                if part.form.has_uv() {
                    let vt = self.uvs.index("vt", &numbers(&corner.uv, 3), &mut self.text);
                    let _ = write!(faces, "/{vt}");
                }
                if part.form.has_normal() {
                    let vn = self.normals.index("vn", &numbers(&corner.normal, 3), &mut self.text);
                    let _ = write!(faces, "{}{vn}", if part.form.has_uv() { "/" } else { "//" });
                }
            }
            faces.push('\n');
        }
        self.text.push_str(&faces);
    }
}

fn numbers(values: &[f64], decimals: usize) -> String {
    values.iter().map(|value| number(*value, decimals)).collect::<Vec<_>>().join(" ")
}

/// The value with at most that many decimals: `1.5`, `-0.25`, `0`.
pub(crate) fn number(value: f64, decimals: usize) -> String {
    let fixed = format!("{value:.decimals$}");
    let short = if fixed.contains('.') { fixed.trim_end_matches('0').trim_end_matches('.') } else { &fixed };
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::mesh::{Corner, Form};

    #[test]
    fn numbers_are_short() {
        let written: Vec<String> = [1.5, -0.25, -0.0001, 0.1239, 100.0].iter().map(|x| number(*x, 3)).collect();
        assert_eq!(written, ["1.5", "-0.25", "0", "0.124", "100"]);
        assert_eq!(number(200.0, 0), "200");
    }

    fn square(form: Form) -> String {
        let corner = |x: f64, y: f64| Corner { position: [x, y, 0.0], uv: [x, y], normal: [0.0, 0.0, 1.0] };
        let faces = vec![
            vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)],
            vec![corner(0.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
        ];
        let object = Object::new("square", vec![Part::new("front", "paint", form, faces)]);
        text("A square.", Some("a.mtl"), &[object])
    }

    #[test]
    fn values_are_written_once_and_counted_from_one() {
        let expected = "# A square.\nmtllib a.mtl\no square\ng front\nusemtl paint\ns 1\n\
            v 0 0 0\nvt 0 0\nvn 0 0 1\nv 1 0 0\nvt 1 0\nv 1 1 0\nvt 1 1\nv 0 1 0\nvt 0 1\n\
            f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
        assert_eq!(square(Form::Full), expected);
    }

    #[test]
    fn each_index_form_is_written() {
        assert!(square(Form::Position).ends_with("s off\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n"));
        assert!(square(Form::PositionUv).ends_with("f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
        assert!(square(Form::PositionNormal).ends_with("f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n"));
    }
}
