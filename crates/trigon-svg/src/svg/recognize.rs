//! Whether bytes are an SVG file, by their content.

use std::io::Read;

/// True if the bytes look like an SVG file, plain or compressed with gzip: the first element is called `svg`.
#[must_use]
pub fn is_svg(bytes: &[u8]) -> bool {
    /// Comments and a document type may come before the first element, but not more than this.
    const SEARCHED_BYTES: usize = 1 << 16;
    if bytes.starts_with(&[0x1f, 0x8b]) {
        let mut start = Vec::new();
        // A broken file gives what could be unpacked.
        let _ = flate2::read::GzDecoder::new(bytes).take(SEARCHED_BYTES as u64).read_to_end(&mut start);
        return starts_with_svg(&start);
    }
    starts_with_svg(&bytes[..bytes.len().min(SEARCHED_BYTES)])
}

fn starts_with_svg(bytes: &[u8]) -> bool {
    let mut rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    loop {
        rest = match rest {
            [b'<', b'?', ..] => after(rest, b"?>"),
            [b'<', b'!', b'-', b'-', ..] => after(rest, b"-->"),
            [b'<', b'!', ..] => after_document_type(rest),
            [b'<', name @ ..] => return is_svg_name(name),
            _ => return false,
        }
        .trim_ascii_start();
    }
}

/// What follows the first `end`; nothing where there is none.
fn after<'a>(bytes: &'a [u8], end: &[u8]) -> &'a [u8] {
    let at = bytes.windows(end.len()).position(|window| window == end);
    at.map_or(&[], |at| &bytes[at + end.len()..])
}

/// What follows `<!DOCTYPE ..>`, whose declarations are in brackets.
fn after_document_type(bytes: &[u8]) -> &[u8] {
    let mut is_inside = false;
    for (at, byte) in bytes.iter().enumerate() {
        match byte {
            b'[' => is_inside = true,
            b']' => is_inside = false,
            b'>' if !is_inside => return &bytes[at + 1..],
            _ => {}
        }
    }
    &[]
}

/// `svg`, with or without a namespace prefix.
fn is_svg_name(bytes: &[u8]) -> bool {
    let is_end = |byte: &u8| byte.is_ascii_whitespace() || matches!(byte, b'>' | b'/');
    let name = bytes.split(is_end).next().unwrap_or_default();
    name == b"svg" || name.ends_with(b":svg")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_element_decides() {
        for text in [
            "<svg/>",
            "\u{feff}  <svg xmlns='http://www.w3.org/2000/svg'>",
            "<?xml version='1.0'?>\n<!-- <g> -->\n<!DOCTYPE svg [ <!ENTITY a \"<b>\"> ]><svg\n>",
            "<s:svg xmlns:s='http://www.w3.org/2000/svg'/>",
        ] {
            assert!(is_svg(text.as_bytes()), "{text}");
        }
        for text in ["", "<", "<html><svg/></html>", "<svgx/>", "v 0 0 0\n<svg/>", "<!-- <svg>", "solid svg"] {
            assert!(!is_svg(text.as_bytes()), "{text}");
        }
    }
}
