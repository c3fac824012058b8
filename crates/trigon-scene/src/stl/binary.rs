//! Binary STL: 80 bytes of header, a count, and 50 bytes per facet: normal, three positions, two bytes of attributes.
//!
//! The attribute bytes may hold a colour of 5 bits per channel. VisCAM and SolidView: blue in the low bits, valid if
//! bit 15 is set. Materialise Magics: red in the low bits, valid if bit 15 is clear; its header has `COLOR=` and the
//! RGBA of all other facets.

use super::reader::Soup;
use crate::color::linear_from_srgb;
use crate::load::{Findings, Limits, LoadError, Place, WarningKind};

const HEADER: usize = 84;
const FACET: usize = 50;

pub(super) fn read(bytes: &[u8], file: &str, limits: &Limits, findings: &mut Findings) -> Result<Soup, LoadError> {
    let Some((header, body)) = bytes.split_at_checked(HEADER) else {
        let message = "too short for an STL file, which is text that begins with solid, or has a header of 84 bytes";
        return Err(LoadError::malformed(file, Place::File, message));
    };
    let claimed = header.last_chunk::<4>().map_or(0, |count| u32::from_le_bytes(*count)) as usize;
    let (facets, _) = body.as_chunks::<FACET>();
    if facets.len() < claimed {
        let message = format!("file ends early: {claimed} facets announced, {} read", facets.len());
        let place = Place::Byte(u64::try_from(bytes.len()).unwrap_or(u64::MAX));
        if facets.is_empty() {
            return Err(LoadError::malformed(file, place, message));
        }
        findings.warn(file, place, WarningKind::InvalidElement, message)?;
    }
    let facets = &facets[..claimed.min(facets.len())];
    if u64::try_from(facets.len()).unwrap_or(u64::MAX) > limits.triangles {
        return Err(LoadError::limit(file, "triangles", limits.triangles));
    }

    let dialect = Dialect::of(&header[..80]);
    let mut soup = Soup::with_capacity(facets.len());
    for facet in facets {
        let (numbers, _) = facet.as_chunks::<4>();
        let number = |i: usize| f32::from_le_bytes(numbers[i]);
        // Numbers 0 to 2 are the facet normal.
        soup.push([3, 6, 9].map(|corner| [number(corner), number(corner + 1), number(corner + 2)]));
        let attributes = u16::from_le_bytes([facet[48], facet[49]]);
        if let Some((key, color)) = dialect.color(attributes) {
            soup.color_last(key, || linear_from_srgb(color, 1.0));
        }
    }
    Ok(soup)
}

/// How facets say their colour.
enum Dialect {
    VisCam,
    /// With the colour of facets that have none.
    Magics([u8; 4]),
}

impl Dialect {
    fn of(header: &[u8]) -> Self {
        let mark = header.windows(10).find(|window| window.starts_with(b"COLOR="));
        match mark.and_then(|window| window.last_chunk::<4>()) {
            Some(color) => Self::Magics(*color),
            None => Self::VisCam,
        }
    }

    /// The sRGB-encoded colour of a facet, and a number that identifies it in this file.
    fn color(&self, attributes: u16) -> Option<(u32, [f32; 4])> {
        let channel = |shift: u16| f32::from(attributes >> shift & 31) / 31.0;
        let is_marked = attributes & 0x8000 != 0;
        let key = u32::from(attributes & 0x7fff);
        match self {
            Self::VisCam => is_marked.then(|| (key, [channel(10), channel(5), channel(0), 1.0])),
            Self::Magics(all) if is_marked => Some((u32::MAX, all.map(|c| f32::from(c) / 255.0))),
            Self::Magics(_) => Some((key, [channel(0), channel(5), channel(10), 1.0])),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::load::{LoadOptions, load_bytes};

    fn file(header: &[u8], attributes: &[u16]) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, 0);
        bytes.extend(u32::try_from(attributes.len()).unwrap().to_le_bytes());
        for (i, attribute) in (0_u8..).zip(attributes) {
            let z = f32::from(i);
            let numbers = [0.0, 0.0, 0.0, 0.0, 0.0, z, 1.0, 0.0, z, 0.0, 1.0, z];
            bytes.extend(numbers.iter().flat_map(|n: &f32| n.to_le_bytes()));
            bytes.extend(attribute.to_le_bytes());
        }
        bytes
    }

    fn colors(bytes: &[u8]) -> Vec<[f32; 4]> {
        let loaded = load_bytes("a.stl", bytes, &LoadOptions::default()).unwrap();
        let mesh = &loaded.scene.meshes[0];
        mesh.validate().unwrap();
        mesh.triangles.iter().filter_map(|t| mesh.colors.get(t[0] as usize).copied()).collect()
    }

    #[test]
    fn both_dialects_of_colour_are_read() {
        let (low, middle, high) = (31, 31 << 5, 31 << 10);
        let red = [1.0, 0.0, 0.0, 1.0];
        let white = [1.0; 4];
        assert_eq!(colors(&file(b"x", &[0x8000 | high, low])), [red, white]);
        assert_eq!(colors(&file(b"COLOR=\xff\xff\xff\xff", &[low, 0x8000 | middle])), [red, white]);
        assert!(colors(&file(b"x", &[0, 0])).is_empty());
    }

    #[test]
    fn a_file_that_ends_early_keeps_its_whole_facets() {
        let bytes = file(b"x", &[0, 0, 0]);
        let options = LoadOptions { format: Some(crate::load::Format::Stl), ..LoadOptions::default() };
        let loaded = load_bytes("a.stl", &bytes[..bytes.len() - 20], &options).unwrap();
        assert_eq!(loaded.scene.triangle_count(), 2);
        assert_eq!(loaded.warnings.len(), 1);
        assert!(load_bytes("a.stl", &bytes[..90], &options).is_err());
        assert!(load_bytes("a.stl", &bytes[..10], &options).is_err());
    }
}
