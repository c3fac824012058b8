//! A file of the course: XML in, a list of primitives in the file's units (transforms applied) out.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::Arc;

use trigon_image::{Rgba8Image, decode};
use usvg::roxmltree::{Document, Node, ParsingOptions};

use super::element;
use super::number;
use super::primitive::Primitive;
use super::texture::Texture;
use super::transform;
use crate::canvas::Transform;
use crate::linked;
use crate::svg::SvgError;

/// What a file holds.
pub(super) struct Scene {
    /// Width and height, in the file's units.
    pub(super) size: [f64; 2],
    pub(super) primitives: Vec<Primitive>,
    pub(super) warnings: Vec<String>,
}

/// Textures by their id, and what went wrong.
pub(super) struct Reader {
    folder: Option<PathBuf>,
    textures: HashMap<String, Option<Arc<Texture>>>,
    pub(super) primitives: Vec<Primitive>,
    pub(super) warnings: Vec<String>,
}

/// Groups inside each other; more is an error.
const MAX_DEPTH: usize = 256;
/// Pixels of one texture; more is not read.
const MAX_TEXTURE_PIXELS: u64 = 1 << 26;
/// Most bytes of a file of a texture.
const MAX_TEXTURE_BYTES: usize = 1 << 28;

/// Reads a file; `folder` is where textures are looked for.
pub(super) fn read(bytes: &[u8], folder: Option<PathBuf>) -> Result<Scene, SvgError> {
    let malformed = |what: &dyn std::fmt::Display| SvgError::Malformed(what.to_string());
    let text = std::str::from_utf8(bytes).map_err(|_| malformed(&"it is not UTF-8 text"))?;
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let xml = Document::parse_with_options(text, options).map_err(|error| malformed(&error))?;
    let root = xml.root_element();
    if root.tag_name().name() != "svg" {
        return Err(malformed(&"its first element is not 'svg'"));
    }
    let length = |name: &str| root.attribute(name).and_then(number::leading).filter(|length| *length > 0.0);
    let (Some(width), Some(height)) = (length("width"), length("height")) else {
        return Err(malformed(&"its 'svg' element has no width or no height"));
    };
    let mut reader = Reader { folder, textures: HashMap::new(), primitives: Vec::new(), warnings: Vec::new() };
    reader.children(root, Transform::IDENTITY, 0)?;
    Ok(Scene { size: [width, height], primitives: reader.primitives, warnings: reader.warnings })
}

impl Reader {
    fn children(&mut self, parent: Node<'_, '_>, outer: Transform, depth: usize) -> Result<(), SvgError> {
        if depth > MAX_DEPTH {
            return Err(SvgError::LimitExceeded(format!("more than {MAX_DEPTH} groups are inside each other")));
        }
        for node in parent.children().filter(Node::is_element) {
            let own = node.attribute("transform").map_or(Transform::IDENTITY, transform::parse);
            let map = outer * own;
            match node.tag_name().name() {
                "g" => self.children(node, map, depth + 1)?,
                "texture" => self.texture(node),
                name => element::read(self, name, node, map),
            }
        }
        Ok(())
    }

    /// The texture of this id; `None`, with a warning, where there is none.
    pub(super) fn texture_of(&mut self, id: &str) -> Option<Arc<Texture>> {
        let known = self.textures.get(id);
        if known.is_none() {
            self.warnings.push(format!("no texture before it has the id '{id}': its triangles are not drawn"));
            self.textures.insert(id.to_owned(), None);
        }
        self.textures.get(id).cloned().flatten()
    }

    fn texture(&mut self, node: Node<'_, '_>) {
        let (Some(id), Some(file)) = (node.attribute("texid"), node.attribute("filename")) else {
            self.warnings.push("a texture without 'texid' or 'filename' is left out".to_owned());
            return;
        };
        let picture = linked::picture(self.folder.as_deref(), file, MAX_TEXTURE_BYTES, MAX_TEXTURE_PIXELS);
        let texture = picture.and_then(|picture| to_texture(&picture));
        if let Err(error) = &texture {
            self.warnings.push(format!("the texture '{file}' is not drawn: {error}"));
        }
        self.textures.insert(id.to_owned(), texture.ok());
    }

    /// A picture embedded as `data:..,BASE64`.
    pub(super) fn embedded(&mut self, link: &str) -> Option<Arc<Texture>> {
        let (_, data) = link.split_once(',')?;
        let limits = trigon_image::Limits::default().with_max_pixels(MAX_TEXTURE_PIXELS);
        let bytes = from_base64(data).ok_or_else(|| "it is not base64".to_owned());
        let picture = bytes.and_then(|bytes| decode(&bytes, None, &limits).map_err(|error| error.to_string()));
        let texture = picture.and_then(|picture| to_texture(&picture.into_rgba8()));
        texture.map_err(|error| self.warnings.push(format!("an image is not drawn: {error}"))).ok()
    }
}

fn to_texture(picture: &Rgba8Image) -> Result<Arc<Texture>, String> {
    Texture::new(picture).map(Arc::new).ok_or_else(|| "it has no pixels".to_owned())
}

/// RFC 4648, blanks left out.
fn from_base64(text: &str) -> Option<Vec<u8>> {
    let mut bytes = Vec::with_capacity(text.len() / 4 * 3);
    let (mut bits, mut count) = (0u32, 0);
    for character in text.bytes().filter(|byte| !byte.is_ascii_whitespace()) {
        let value = match character {
            b'A'..=b'Z' => character - b'A',
            b'a'..=b'z' => character - b'a' + 26,
            b'0'..=b'9' => character - b'0' + 52,
            b'+' => 62,
            b'/' => 63,
            b'=' => break,
            _ => return None,
        };
        bits = bits << 6 | u32::from(value);
        count += 6;
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count).to_le_bytes()[0]);
            bits &= (1 << count) - 1;
        }
    }
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_read() {
        assert_eq!(from_base64("aGVsbG8g\n d29ybGQ=").unwrap(), b"hello world");
        assert_eq!(from_base64("aGVsb*"), None);
    }

    #[test]
    fn files_without_a_size_or_root_are_refused() {
        for text in ["<g/>", "<svg/>", "<svg width='5px' height='x'/>", "<svg width='5' height='5'>"] {
            assert!(read(text.as_bytes(), None).is_err(), "{text}");
        }
    }

    #[test]
    fn unknown_elements_are_skipped_with_what_is_in_them() {
        let text =
            "<svg width='9px' height='9'><defs><line stroke='#000000'/></defs><circle/><g><line stroke='0'/></g></svg>";
        let scene = read(text.as_bytes(), None).unwrap();
        assert_eq!((scene.size, scene.primitives.len()), ([9.0, 9.0], 1));
    }
}
