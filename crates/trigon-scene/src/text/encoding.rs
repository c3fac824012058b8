//! Text encodings: the bytes of a text file in, bytes with ASCII syntax out.
//!
//! Mesh files state no encoding. Byte order marks are honoured (UTF-8, UTF-16), UTF-16 without one is recognized by
//! its zero bytes; anything else is taken as it is, and only names are decoded: as UTF-8, else as Latin-1.

use std::borrow::Cow;

/// The text with one byte per syntax character: UTF-16 is converted to UTF-8, a byte order mark is dropped.
pub(crate) fn to_single_byte_text(bytes: &[u8]) -> Cow<'_, [u8]> {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => Cow::Borrowed(rest),
        [0xff, 0xfe, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_le_bytes)),
        [0xfe, 0xff, rest @ ..] => Cow::Owned(from_utf16(rest, u16::from_be_bytes)),
        [first, 0, _, 0, ..] if first.is_ascii() && *first != 0 => Cow::Owned(from_utf16(bytes, u16::from_le_bytes)),
        [0, second, 0, _, ..] if second.is_ascii() && *second != 0 => Cow::Owned(from_utf16(bytes, u16::from_be_bytes)),
        _ => Cow::Borrowed(bytes),
    }
}

fn from_utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Vec<u8> {
    let (pairs, _) = bytes.as_chunks::<2>();
    let mut text = String::with_capacity(pairs.len());
    let units = pairs.iter().map(|pair| unit(*pair));
    text.extend(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)));
    text.into_bytes()
}

/// A name from a file: UTF-8 if it is valid, else Latin-1. Continued line ends in it become blanks.
pub(crate) fn decode_name(bytes: &[u8]) -> Cow<'_, str> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().copied().map(char::from).collect()),
    };
    if bytes.iter().any(|b| matches!(b, b'\n' | b'\r')) {
        let joined = text.replace("\\\r\n", " ").replace("\\\n", " ").replace("\\\r", " ");
        return Cow::Owned(joined.split_ascii_whitespace().collect::<Vec<_>>().join(" "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_encoding_of_the_same_text_reads_the_same() {
        let text = "v 1 2 3\nusemtl \u{e4}\n";
        let wide: Vec<u16> = text.encode_utf16().collect();
        let little: Vec<u8> = wide.iter().flat_map(|unit| unit.to_le_bytes()).collect();
        let big: Vec<u8> = wide.iter().flat_map(|unit| unit.to_be_bytes()).collect();
        let with_mark = |mark: &[u8], bytes: &[u8]| [mark, bytes].concat();
        let files = [
            text.as_bytes().to_vec(),
            with_mark(&[0xef, 0xbb, 0xbf], text.as_bytes()),
            with_mark(&[0xff, 0xfe], &little),
            with_mark(&[0xfe, 0xff], &big),
            little,
            big,
        ];
        for file in files {
            assert_eq!(to_single_byte_text(&file), text.as_bytes());
        }
    }

    #[test]
    fn names_fall_back_to_latin_1() {
        assert_eq!(decode_name(b"Terraind\xe4k"), "Terraind\u{e4}k");
        assert_eq!(decode_name("Terraind\u{e4}k".as_bytes()), "Terraind\u{e4}k");
        assert_eq!(decode_name(b"a \\\r\n b"), "a b");
    }
}
