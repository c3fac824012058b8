//! A picture to see texture coordinates by: 8 x 8 numbered fields, u = 1 to 8 to the right, v = A to H upwards.

use super::canvas::{Grid, Linear, srgb};

/// Digits 1 to 8 and letters A to H, three columns by five rows, top row first.
const GLYPHS: [[&[u8; 3]; 5]; 16] = [
    [b" # ", b"## ", b" # ", b" # ", b"###"],
    [b"## ", b"  #", b" # ", b"#  ", b"###"],
    [b"## ", b"  #", b" # ", b"  #", b"## "],
    [b"# #", b"# #", b"###", b"  #", b"  #"],
    [b"###", b"#  ", b"## ", b"  #", b"## "],
    [b" ##", b"#  ", b"###", b"# #", b"###"],
    [b"###", b"  #", b" # ", b" # ", b" # "],
    [b"###", b"# #", b"###", b"# #", b"###"],
    [b" # ", b"# #", b"###", b"# #", b"# #"],
    [b"## ", b"# #", b"## ", b"# #", b"## "],
    [b" ##", b"#  ", b"#  ", b"#  ", b" ##"],
    [b"## ", b"# #", b"# #", b"# #", b"## "],
    [b"###", b"#  ", b"## ", b"#  ", b"###"],
    [b"###", b"#  ", b"## ", b"#  ", b"#  "],
    [b" ##", b"#  ", b"# #", b"# #", b" ##"],
    [b"# #", b"# #", b"###", b"# #", b"# #"],
];

pub(crate) fn uv_grid() -> Vec<u8> {
    Grid::new(256, 256, 1).colour(colour)
}

/// Every field has its own colour: red grows with u, blue with v; every second one is lighter.
fn colour(u: f64, v: f64) -> Linear {
    let (column, x) = cell(u * 8.0);
    let (row, y) = cell(v * 8.0);
    let paper = srgb(0x30_50_30)
        .mixed(srgb(0xe0_50_30), f64::from(column) / 7.0)
        .mixed(srgb(0x30_60_d0), f64::from(row) / 14.0);
    let paper = paper.mixed(srgb(0xff_ff_ff), if (column + row) % 2 == 0 { 0.55 } else { 0.12 });
    // The glyphs stand on a raster of 11 x 9 squares: letter, gap, digit, in the middle.
    let (dot_x, dot_y) = (whole(x * 11.0), whole((1.0 - y) * 9.0));
    let is_ink = is_set(8 + row, dot_x - 2, dot_y - 2) || is_set(column, dot_x - 6, dot_y - 2);
    if is_ink { srgb(0x10_10_18) } else { paper }
}

fn is_set(glyph: i32, x: i32, y: i32) -> bool {
    let at = |index: i32, count: i32| usize::try_from(index).ok().filter(|_| index < count);
    match (at(glyph, 16), at(x, 3), at(y, 5)) {
        (Some(glyph), Some(x), Some(y)) => GLYPHS[glyph][y][x] == b'#',
        _ => false,
    }
}

fn cell(x: f64) -> (i32, f64) {
    (whole(x), x - x.floor())
}

#[expect(clippy::cast_possible_truncation, reason = "less than a dozen cells")]
fn whole(x: f64) -> i32 {
    x.floor() as i32
}
