//! Small models as OBJ text, counter-clockwise seen from outside.

use std::fmt::Write;

/// The square from (-1, -1, 0) to (1, 1, 0), seen from +z; the texture fits once.
#[must_use]
pub fn square() -> String {
    "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n".to_owned()
}

/// A floor from z = 0 away to z = -`length`, three units wide; a texture repeats once per unit.
#[must_use]
pub fn floor(length: u32) -> String {
    format!(
        "v -1.5 0 0\nv 1.5 0 0\nv 1.5 0 -{length}\nv -1.5 0 -{length}\nvt 0 0\nvt 3 0\nvt 3 {length}\nvt 0 {length}\n\
         f 1/1 2/2 3/3 4/4\n"
    )
}

/// A sphere of radius 0.9 about (`x`, 0, 0) with normals and texture coordinates; indices count back, so that texts of
/// several spheres can follow each other.
#[must_use]
pub fn sphere(x: f32) -> String {
    const ROWS: u32 = 16;
    const COLUMNS: u32 = 32;
    let mut text = String::new();
    for row in 0..=ROWS {
        for column in 0..=COLUMNS {
            let (u, v) = (f64::from(column) / f64::from(COLUMNS), f64::from(row) / f64::from(ROWS));
            let (longitude, latitude) = ((u - 0.5) * std::f64::consts::TAU, (v - 0.5) * std::f64::consts::PI);
            let radius = libm::cos(latitude);
            let n = [libm::sin(longitude) * radius, libm::sin(latitude), libm::cos(longitude) * radius];
            let p = n.map(|c| c * 0.9);
            let x = p[0] + f64::from(x);
            let _ =
                writeln!(text, "v {x:.5} {:.5} {:.5}\nvn {:.5} {:.5} {:.5}\nvt {u} {v}", p[1], p[2], n[0], n[1], n[2]);
        }
    }
    let count = i64::from((ROWS + 1) * (COLUMNS + 1));
    for row in 0..i64::from(ROWS) {
        for column in 0..i64::from(COLUMNS) {
            let corner = |row: i64, column: i64| {
                let index = row * i64::from(COLUMNS + 1) + column - count;
                format!("{index}/{index}/{index}")
            };
            let [a, b] = [corner(row, column), corner(row, column + 1)];
            let [c, d] = [corner(row + 1, column + 1), corner(row + 1, column)];
            let _ = writeln!(text, "f {a} {b} {c} {d}");
        }
    }
    text
}
