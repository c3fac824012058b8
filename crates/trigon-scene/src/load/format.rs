//! Which format a file has: its first bytes decide, then its name.

use std::path::Path;

/// A model format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Wavefront OBJ with MTL materials.
    Obj,
    /// STL, text or binary.
    Stl,
    /// Stanford polygon format, text or binary.
    Ply,
}

impl Format {
    /// The format of a file by content, then by the extension of `name` (`.gz` ignored).
    ///
    /// PLY has a magic number. STL text begins with `solid`; binary STL is recognized by its length, which follows
    /// from its triangle count. OBJ has neither and is recognized by its extension or by its first statements.
    #[must_use]
    pub fn recognize(bytes: &[u8], name: &str) -> Option<Self> {
        let start = bytes.trim_ascii_start();
        let is_line_end = |b: &u8| matches!(b, b'\n' | b'\r' | b' ');
        if start.starts_with(b"ply") && start.get(3).is_some_and(is_line_end) {
            return Some(Self::Ply);
        }
        if has_binary_stl_length(bytes) {
            return Some(Self::Stl);
        }
        let by_name = Self::from_name(name);
        if by_name != Some(Self::Obj) && begins_with_word(start, b"solid") && contains_word(bytes, b"facet") {
            return Some(Self::Stl);
        }
        by_name.or_else(|| looks_like_obj(bytes).then_some(Self::Obj))
    }

    /// The format by the extension of `name`, case ignored, `.gz` ignored.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let path = Path::new(name);
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "gz" => Self::from_name(path.file_stem()?.to_str()?),
            "obj" => Some(Self::Obj),
            "stl" => Some(Self::Stl),
            "ply" => Some(Self::Ply),
            _ => None,
        }
    }
}

/// Whether the length is the one that a binary STL file of the stored triangle count has.
pub(crate) fn has_binary_stl_length(bytes: &[u8]) -> bool {
    let count = bytes.get(80..84).and_then(|b| b.try_into().ok()).map(u32::from_le_bytes);
    count.is_some_and(|count| u64::try_from(bytes.len()).ok() == Some(84 + 50 * u64::from(count)))
}

fn begins_with_word(bytes: &[u8], word: &[u8]) -> bool {
    let head = bytes.get(..word.len()).unwrap_or_default();
    head.eq_ignore_ascii_case(word) && bytes.get(word.len()).is_none_or(u8::is_ascii_whitespace)
}

/// Whether `word` is within the first kilobytes or the file ends there.
fn contains_word(bytes: &[u8], word: &[u8]) -> bool {
    let head = bytes.get(..4096).unwrap_or(bytes);
    let is_ended = begins_with_word(bytes.trim_ascii_start(), b"solid") && bytes.len() < 4096;
    is_ended || head.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word))
}

/// Whether one of the first lines is an OBJ statement with arguments.
fn looks_like_obj(bytes: &[u8]) -> bool {
    const STATEMENTS: [&[u8]; 10] = [b"v ", b"vn ", b"vt ", b"f ", b"o ", b"g ", b"s ", b"mtllib ", b"usemtl ", b"v\t"];
    let text = crate::text::to_single_byte_text(bytes.get(..4096).unwrap_or(bytes));
    text.split(|&b| b == b'\n').any(|line| {
        let line = line.trim_ascii_start();
        STATEMENTS.iter().any(|statement| line.starts_with(statement))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn content_wins_over_the_name() {
        let mut binary = vec![0_u8; 84 + 50];
        binary[80] = 1;
        binary[..5].copy_from_slice(b"solid");
        assert_eq!(Format::recognize(&binary, "a.obj"), Some(Format::Stl));
        assert_eq!(Format::recognize(b"ply\nformat ascii 1.0\n", "a.stl"), Some(Format::Ply));
        assert_eq!(Format::recognize(b"solid x\n facet normal", ""), Some(Format::Stl));
        assert_eq!(Format::recognize(b"# hi\nv 1 2 3\n", "-"), Some(Format::Obj));
        assert_eq!(Format::recognize(b"\0\x01\x02", "x.bin"), None);
    }

    #[test]
    fn the_name_decides_otherwise() {
        assert_eq!(Format::recognize(b"", "dir.v2/A.OBJ.gz"), Some(Format::Obj));
        assert_eq!(Format::from_name("x.PLY"), Some(Format::Ply));
        assert_eq!(Format::from_name("stl"), None);
    }
}
