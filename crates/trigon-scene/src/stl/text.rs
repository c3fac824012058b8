//! Text STL: `solid`, facets of three `vertex` lines, `endsolid`; keywords in any letter case.

use super::reader::Soup;
use crate::load::{Findings, Limits, LoadError, Place, WarningKind};
use crate::text::{Cursor, decode_name, to_single_byte_text};

/// Whether the file begins like text.
pub(super) fn begins_with_solid(bytes: &[u8]) -> bool {
    let text = to_single_byte_text(bytes.get(..64).unwrap_or(bytes));
    let start = text.trim_ascii_start();
    start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

pub(super) fn read(bytes: &[u8], file: &str, limits: &Limits, findings: &mut Findings) -> Result<Soup, LoadError> {
    let text = to_single_byte_text(bytes);
    let mut cursor = Cursor::new(&text);
    // A facet takes about 250 bytes, at least 60.
    let mut soup = Soup::with_capacity(text.len() / 250);
    let mut corners: Vec<[f32; 3]> = Vec::with_capacity(4);
    let mut is_closed = true;
    while !cursor.is_at_end() {
        let line = u64::from(cursor.lines()) + 1;
        let keyword = cursor.word();
        let mut warn = |message: String| findings.warn(file, Place::Line(line), WarningKind::InvalidElement, message);
        if keyword.eq_ignore_ascii_case(b"vertex") {
            corners.push(position(&mut cursor, file, line)?);
        } else if keyword.eq_ignore_ascii_case(b"endloop") {
            match corners.as_slice() {
                &[a, b, c] => soup.push([a, b, c]),
                _ => warn(format!("facet with {} corners left out; it must have 3", corners.len()))?,
            }
            corners.clear();
            if u64::try_from(soup.len()).unwrap_or(u64::MAX) > limits.triangles {
                return Err(LoadError::limit(file, "triangles", limits.triangles));
            }
        } else if keyword.eq_ignore_ascii_case(b"solid") {
            let name = decode_name(cursor.rest_of_line()).into_owned();
            soup.parts.push((name, soup.len()));
            is_closed = false;
        } else if keyword.eq_ignore_ascii_case(b"endsolid") {
            is_closed = true;
        } else if !(keyword.is_empty() || is_known(keyword)) {
            let shown = decode_name(keyword.get(..40).unwrap_or(keyword)).into_owned();
            return Err(LoadError::malformed(file, Place::Line(line), format!("{shown} is not a keyword of STL")));
        }
        // Keywords may share lines: `facet normal 0 0 1 outer loop`.
        if matches!(keyword, b"") || !is_known(keyword) && !keyword.eq_ignore_ascii_case(b"vertex") {
            cursor.finish_line();
        } else {
            skip_to_keyword(&mut cursor);
        }
    }
    if !is_closed {
        let message = "file ends without endsolid; it may be cut off";
        findings.warn(file, Place::File, WarningKind::InvalidElement, message)?;
    }
    Ok(soup)
}

/// Keywords that carry nothing that is used.
fn is_known(keyword: &[u8]) -> bool {
    [&b"facet"[..], b"normal", b"outer", b"loop", b"endloop", b"endfacet", b"color"]
        .iter()
        .any(|known| keyword.eq_ignore_ascii_case(known))
}

/// Skips numbers, up to the next keyword or line.
fn skip_to_keyword(cursor: &mut Cursor<'_>) {
    loop {
        cursor.skip_blanks();
        if cursor.is_at_line_end() {
            return cursor.finish_line();
        }
        let mut ahead = cursor.clone();
        if !matches!(ahead.float(), Ok(Some(_))) {
            return;
        }
        *cursor = ahead;
    }
}

fn position(cursor: &mut Cursor<'_>, file: &str, line: u64) -> Result<[f32; 3], LoadError> {
    let mut position = [0.0; 3];
    for coordinate in &mut position {
        *coordinate = match cursor.float() {
            Ok(Some(value)) => value,
            _ => return Err(LoadError::malformed(file, Place::Line(line), "vertex needs three numbers")),
        };
    }
    Ok(position)
}

#[cfg(test)]
mod tests {
    use crate::load::{LoadOptions, Loaded, load_bytes};

    fn load(text: &str) -> Loaded {
        load_bytes("a.stl", text.as_bytes(), &LoadOptions::default()).unwrap()
    }

    const FACET: &str =
        "facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1 0\n endloop\nendfacet\n";

    #[test]
    fn solids_become_parts_and_positions_are_welded() {
        let upper = FACET.to_uppercase();
        let loaded = load(&format!("solid first one\n{FACET}endsolid first one\nSOLID b\n{upper}{FACET}ENDSOLID b\n"));
        let mesh = &loaded.scene.meshes[0];
        mesh.validate().unwrap();
        assert_eq!(mesh.triangles, [[0, 1, 2]; 3]);
        assert_eq!(mesh.parts[0].object, "first one");
        assert_eq!((mesh.submeshes[1].triangles.clone(), mesh.submeshes.len()), (1..3, 2));
        assert!(loaded.warnings.is_empty());
        // z is up in STL files and y in scenes.
        let size = loaded.scene.bounding_box().size();
        assert_eq!(size, [1.0, 0.0, 1.0]);
    }

    #[test]
    fn one_line_and_carriage_returns_are_fine() {
        let one_line = format!("solid x\n{}", FACET.replace('\n', " ").replace("endfacet", "endfacet\nendsolid"));
        assert_eq!(load(&one_line).scene.triangle_count(), 1);
        assert_eq!(load(&format!("solid\n{FACET}endsolid").replace('\n', "\r\n")).scene.triangle_count(), 1);
    }

    #[test]
    fn damage_is_reported_with_its_line() {
        let error =
            load_bytes("a.stl", b"solid x\nfacet normal 0 0 1\nouter loop\nvertex 1 x 2\n", &LoadOptions::default());
        assert_eq!(error.unwrap_err().to_string(), "a.stl:4: vertex needs three numbers");
        let loaded = load(&format!("solid x\n{}", FACET.replace(" vertex 0 0 0\n", "")));
        assert_eq!(loaded.scene.triangle_count(), 0);
        assert_eq!(loaded.warnings[0].to_string(), "a.stl:6: facet with 2 corners left out; it must have 3");
    }
}
