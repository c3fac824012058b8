//! The PLY header: lines of text up to `end_header`.

use crate::load::{LoadError, Place};
use crate::text::decode_name;

/// What the header declares.
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// `comment TextureFile NAME`, as MeshLab writes it.
    pub(super) texture_file: Option<Vec<u8>>,
    /// Where the values begin.
    pub(super) body: usize,
    /// Lines of the header.
    pub(super) lines: u64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    BinaryLittleEndian,
    BinaryBigEndian,
}

/// A declared list of equal records.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

pub(super) struct Property {
    pub(super) name: String,
    pub(super) shape: Shape,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    Scalar(Scalar),
    /// A count of the first type, then that many items of the second.
    List(Scalar, Scalar),
}

/// The types of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// The value that integer colours call full; 1 for floating point.
    pub(super) fn full_scale(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32_767.0,
            Self::U16 => 65_535.0,
            Self::I32 => 2_147_483_647.0,
            Self::U32 => 4_294_967_295.0,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

impl Header {
    /// More elements or properties than any file needs are refused.
    const MAX_DECLARATIONS: usize = 1024;

    pub(super) fn parse(bytes: &[u8], file: &str) -> Result<Self, LoadError> {
        let start = bytes.len() - bytes.trim_ascii_start().len();
        let mut lines = Lines { bytes, at: start, number: 0 };
        let fail = |line: u64, message: &str| Err(LoadError::malformed(file, Place::Line(line), message));
        if lines.next_line() != Some(b"ply") {
            return fail(1, "a PLY file begins with a line `ply`");
        }
        let mut header =
            Self { encoding: Encoding::Ascii, elements: Vec::new(), texture_file: None, body: 0, lines: 0 };
        let mut encoding = None;
        let mut declarations = 0;
        while let Some(line) = lines.next_line() {
            let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
            let keyword = words.next().unwrap_or_default();
            let words: Vec<&[u8]> = words.take(8).collect();
            declarations += 1;
            let outcome = match keyword {
                b"format" => encoding_named(&words).map(|found| encoding = Some(found)),
                b"element" => element(&words).map(|element| header.elements.push(element)),
                b"property" => match (property(&words), header.elements.last_mut()) {
                    (Ok(property), Some(element)) => {
                        element.properties.push(property);
                        Ok(())
                    }
                    (Ok(_), None) => Err("property before the first element"),
                    (Err(message), _) => Err(message),
                },
                b"comment" | b"obj_info" | b"" => {
                    declarations -= 1;
                    header.comment(line);
                    Ok(())
                }
                b"end_header" => {
                    let Some(encoding) = encoding else { return fail(lines.number, "the header lacks a format line") };
                    return Ok(Self { encoding, body: lines.at, lines: lines.number, ..header });
                }
                _ => Err("not a statement of PLY headers"),
            };
            if let Err(message) = outcome {
                return fail(lines.number, message);
            }
            if declarations > Self::MAX_DECLARATIONS {
                return fail(lines.number, "more than 1024 declarations");
            }
        }
        fail(lines.number, "file ends within the header")
    }

    fn comment(&mut self, line: &[u8]) {
        let text = line.trim_ascii().strip_prefix(b"comment").unwrap_or_default().trim_ascii();
        if text.len() > 12 && text[..11].eq_ignore_ascii_case(b"TextureFile") {
            self.texture_file = Some(text[11..].trim_ascii().to_vec());
        }
    }
}

fn encoding_named(words: &[&[u8]]) -> Result<Encoding, &'static str> {
    match words.first() {
        Some(&b"ascii") => Ok(Encoding::Ascii),
        Some(&b"binary_little_endian") => Ok(Encoding::BinaryLittleEndian),
        Some(&b"binary_big_endian") => Ok(Encoding::BinaryBigEndian),
        _ => Err("format must be ascii, binary_little_endian or binary_big_endian"),
    }
}

fn element(words: &[&[u8]]) -> Result<Element, &'static str> {
    let &[name, count, ..] = words else { return Err("element needs a name and a count") };
    let count = std::str::from_utf8(count).ok().and_then(|count| count.parse().ok());
    let count = count.ok_or("element count is not a whole number")?;
    Ok(Element { name: decode_name(name).to_ascii_lowercase(), count, properties: Vec::new() })
}

fn property(words: &[&[u8]]) -> Result<Property, &'static str> {
    let scalar = |name: &[u8]| Scalar::from_name(&name.to_ascii_lowercase()).ok_or("property has an unknown type");
    let (shape, name) = match words {
        [b"list", count, item, name, ..] => (Shape::List(scalar(count)?, scalar(item)?), name),
        [ty, name, ..] => (Shape::Scalar(scalar(ty)?), name),
        _ => return Err("property needs a type and a name"),
    };
    Ok(Property { name: decode_name(name).to_ascii_lowercase(), shape })
}

/// Lines that end with LF, CR LF or CR; which of them, the first line decides, because binary values that follow the
/// header may begin with any byte.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: u64,
}

impl<'a> Lines<'a> {
    fn next_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..)?;
        let end = rest.iter().position(|b| matches!(b, b'\n' | b'\r'))?;
        let width = if rest[end..].starts_with(b"\r\n") { 2 } else { 1 };
        self.at += end + width;
        self.number += 1;
        Some(rest[..end].trim_ascii_end())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn declarations_are_read_whatever_the_line_ends() {
        let text = "ply\nformat binary_big_endian 1.0   \ncomment TextureFile my wood.png \nelement vertex 3\n\
                    property float x\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\n";
        for end in ["\n", "\r\n", "\r"] {
            let text = text.trim_end().replace('\n', end) + end;
            let header = Header::parse(format!("{text}\nX").as_bytes(), "a").unwrap();
            assert_eq!(header.encoding, Encoding::BinaryBigEndian);
            assert_eq!(header.texture_file.as_deref(), Some(&b"my wood.png"[..]));
            assert_eq!((header.elements[0].name.as_str(), header.elements[0].count), ("vertex", 3));
            assert_eq!(header.elements[1].properties[0].shape, Shape::List(Scalar::U8, Scalar::I32));
            // With bare CR the line feed that follows cannot be told from a CR LF.
            assert_eq!(header.body, text.len() + usize::from(end == "\r"));
        }
    }

    #[test]
    fn faults_name_their_line() {
        let error = |text: &str| Header::parse(text.as_bytes(), "a").err().map(|e| e.to_string()).unwrap();
        assert_eq!(error("plx\n"), "a:1: a PLY file begins with a line `ply`");
        assert_eq!(error("ply\nformat ascii 1.0\nproperty float x\n"), "a:3: property before the first element");
        assert_eq!(error("ply\nformat ascii 1.0\nelement v -3\n"), "a:3: element count is not a whole number");
        assert_eq!(error("ply\nformat ascii 1.0\n"), "a:2: file ends within the header");
        assert_eq!(error("ply\nend_header\n"), "a:2: the header lacks a format line");
    }
}
