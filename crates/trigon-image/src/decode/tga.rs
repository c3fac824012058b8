//! TGA files to pixels: every image type of the specification, at 8, 15, 16, 24 and 32 bits, from any corner.
//!
//! Three steps: the header; the pixels in file order, from raw or run-length packets, each through one [`PixelLayout`];
//! then each row to its place by the origin bits. Memory is taken only after the size passed the limits, and for raw
//! pictures only if the file is long enough.
//!
//! Source: Truevision TGA File Format Specification, version 2.0 (1991), appendix C.

use super::DecodedImage;
use super::reader::Reader;
use crate::color::unpremultiply_u8;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut reader = Reader::new(Format::Tga, bytes);
    let header = Header::read(&mut reader)?;
    let count = limits.check(header.width, header.height, 4)?;
    reader.take(usize::from(header.id_length), "image identification")?;
    let layout = PixelLayout::read(&header, &mut reader)?;
    let mut pixels = if header.is_run_length_encoded {
        read_packets(&mut reader, &layout, count)?
    } else {
        read_raw(&mut reader, &layout, count)?
    };
    AlphaMeaning::find(bytes, &header, &pixels).apply(&mut pixels);
    let image = place_rows(&header, pixels)?;
    Ok(DecodedImage::Rgba8(image))
}

/// How a pixel's color is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ColorKind {
    ColorMapped,
    TrueColor,
    Grayscale,
}

/// The 18 bytes at the start of the file, checked.
struct Header {
    id_length: u8,
    has_color_map: bool,
    kind: ColorKind,
    is_run_length_encoded: bool,
    map_first: u16,
    map_length: u16,
    map_entry_bits: u8,
    width: u32,
    height: u32,
    pixel_bits: u8,
    /// Alpha bits of a pixel as the file declares them.
    alpha_bits: u8,
    is_right_to_left: bool,
    is_top_down: bool,
}

impl Header {
    fn read(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let bytes: [u8; 18] = reader.array("header")?;
        let u16_at = |i: usize| u16::from_le_bytes([bytes[i], bytes[i + 1]]);
        let malformed = |offset, rule: String| Err(DecodeError::malformed(Format::Tga, offset, rule));

        let has_color_map = match bytes[1] {
            0 => false,
            1 => true,
            other => return malformed(1, format!("the color map type is 0 or 1, not {other}")),
        };
        let kind = match bytes[2] {
            1 | 9 => ColorKind::ColorMapped,
            2 | 10 => ColorKind::TrueColor,
            3 | 11 => ColorKind::Grayscale,
            0 => return Err(DecodeError::unsupported(Format::Tga, "a file without a picture (image type 0)")),
            32 | 33 => {
                return Err(DecodeError::unsupported(Format::Tga, "Huffman-coded pixels (image types 32 and 33)"));
            }
            other => return malformed(2, format!("the image type is 1, 2, 3, 9, 10 or 11, not {other}")),
        };
        let header = Self {
            id_length: bytes[0],
            has_color_map,
            kind,
            is_run_length_encoded: bytes[2] >= 9,
            map_first: u16_at(3),
            map_length: u16_at(5),
            map_entry_bits: bytes[7],
            width: u32::from(u16_at(12)),
            height: u32::from(u16_at(14)),
            pixel_bits: bytes[16],
            alpha_bits: bytes[17] & 0x0f,
            is_right_to_left: bytes[17] & 0x10 != 0,
            is_top_down: bytes[17] & 0x20 != 0,
        };
        if header.width == 0 || header.height == 0 {
            return malformed(12, format!("width and height are at least 1, not {}x{}", header.width, header.height));
        }
        if bytes[17] & 0xc0 != 0 {
            return Err(DecodeError::unsupported(
                Format::Tga,
                "interleaved rows (bits 6 and 7 of the image descriptor)",
            ));
        }
        Ok(header)
    }
}

/// What the bytes of one pixel mean.
enum PixelLayout {
    /// One byte: grey.
    Gray8,
    /// Two bytes: grey and alpha.
    GrayAlpha16,
    /// Two bytes: 5 bits each of red, green and blue, one bit of alpha, which counts only if declared.
    Rgb555 { has_alpha: bool },
    /// Three bytes: blue, green, red.
    Bgr24,
    /// Four bytes: blue, green, red, alpha.
    Bgra32,
    /// One or two bytes: an index into the color map, of which the first entry stands for index `first`.
    Mapped { index_bytes: usize, first: usize, colors: Vec<[u8; 4]> },
}

impl PixelLayout {
    /// Chooses the layout; reads the color map, or passes over one that is not needed.
    fn read(header: &Header, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let map_offset = reader.offset();
        let entry_bytes = usize::from(header.map_entry_bits).div_ceil(8);
        let map_bytes = match header.has_color_map {
            true => reader.take(usize::from(header.map_length) * entry_bytes, "color map")?,
            false => &[],
        };
        let bits = header.pixel_bits;
        let wrong_depth = |kind: &str| {
            Err(DecodeError::malformed(Format::Tga, 16, format!("{bits} bits a pixel in a {kind} picture")))
        };
        match header.kind {
            ColorKind::Grayscale => match bits {
                8 => Ok(Self::Gray8),
                16 => Ok(Self::GrayAlpha16),
                _ => wrong_depth("grayscale"),
            },
            ColorKind::TrueColor => Self::direct(bits, header.alpha_bits).map_or_else(|| wrong_depth("true-color"), Ok),
            ColorKind::ColorMapped => {
                if map_bytes.is_empty() {
                    let rule = "a color-mapped picture has a color map";
                    return Err(DecodeError::malformed(Format::Tga, map_offset, rule));
                }
                let Some(entry) = Self::direct(header.map_entry_bits, header.alpha_bits) else {
                    let rule = format!("color map entries have 15, 16, 24 or 32 bits, not {}", header.map_entry_bits);
                    return Err(DecodeError::malformed(Format::Tga, 7, rule));
                };
                let colors = map_bytes.chunks_exact(entry_bytes).map(|bytes| entry.direct_color(bytes)).collect();
                let index_bytes = match bits {
                    8 => 1,
                    15 | 16 => 2,
                    _ => return wrong_depth("color-mapped"),
                };
                Ok(Self::Mapped { index_bytes, first: usize::from(header.map_first), colors })
            }
        }
    }

    /// The layout of a color stored in the pixel or map entry itself.
    fn direct(bits: u8, alpha_bits: u8) -> Option<Self> {
        match bits {
            15 => Some(Self::Rgb555 { has_alpha: false }),
            16 => Some(Self::Rgb555 { has_alpha: alpha_bits == 1 }),
            24 => Some(Self::Bgr24),
            32 => Some(Self::Bgra32),
            _ => None,
        }
    }

    fn pixel_bytes(&self) -> usize {
        match self {
            Self::Gray8 => 1,
            Self::GrayAlpha16 | Self::Rgb555 { .. } => 2,
            Self::Bgr24 => 3,
            Self::Bgra32 => 4,
            Self::Mapped { index_bytes, .. } => *index_bytes,
        }
    }

    /// Converts `bytes`, a whole number of pixels that began at `offset`, and appends them to `pixels`.
    fn append(&self, bytes: &[u8], offset: usize, pixels: &mut Vec<[u8; 4]>) -> Result<(), DecodeError> {
        match self {
            Self::Mapped { index_bytes, first, colors } => {
                for (i, index) in bytes.chunks_exact(*index_bytes).enumerate() {
                    let index = usize::from(index[0]) | index.get(1).map_or(0, |&high| usize::from(high) << 8);
                    let Some(&color) = index.checked_sub(*first).and_then(|entry| colors.get(entry)) else {
                        let rule =
                            format!("index {index} is not in the color map of {} colors from {first}", colors.len());
                        return Err(DecodeError::malformed(Format::Tga, offset + i * index_bytes, rule));
                    };
                    pixels.push(color);
                }
            }
            Self::Bgr24 => pixels.extend(bytes.as_chunks().0.iter().map(|&[b, g, r]| [r, g, b, u8::MAX])),
            Self::Bgra32 => pixels.extend(bytes.as_chunks().0.iter().map(|&[b, g, r, a]| [r, g, b, a])),
            _ => pixels.extend(bytes.chunks_exact(self.pixel_bytes()).map(|bytes| self.direct_color(bytes))),
        }
        Ok(())
    }

    /// The color of one pixel of [`pixel_bytes`](Self::pixel_bytes) bytes, for the layouts without a map.
    fn direct_color(&self, bytes: &[u8]) -> [u8; 4] {
        match (self, bytes) {
            (Self::Gray8, &[v]) => [v, v, v, u8::MAX],
            (Self::GrayAlpha16, &[v, a]) => [v, v, v, a],
            (Self::Rgb555 { has_alpha }, &[low, high]) => {
                let bits = u16::from_le_bytes([low, high]);
                let alpha = if *has_alpha && bits & 0x8000 == 0 { 0 } else { u8::MAX };
                [widen_5_bits(bits >> 10), widen_5_bits(bits >> 5), widen_5_bits(bits), alpha]
            }
            (Self::Bgr24, &[b, g, r]) => [r, g, b, u8::MAX],
            (Self::Bgra32, &[b, g, r, a]) => [r, g, b, a],
            _ => unreachable!("callers cut pixels by pixel_bytes and look up mapped ones"),
        }
    }
}

/// The low 5 bits as 8 bits: 31 becomes 255.
fn widen_5_bits(bits: u16) -> u8 {
    let [five, _] = (bits & 0x1f).to_le_bytes();
    five << 3 | five >> 2
}

/// Raw pixels, all at once.
fn read_raw(reader: &mut Reader<'_>, layout: &PixelLayout, count: usize) -> Result<Vec<[u8; 4]>, DecodeError> {
    let offset = reader.offset();
    let bytes = reader.take(count * layout.pixel_bytes(), "pixels")?;
    let mut pixels = Vec::with_capacity(count);
    layout.append(bytes, offset, &mut pixels)?;
    Ok(pixels)
}

/// Run-length packets: a head byte, then either one pixel to repeat or up to 128 raw pixels.
///
/// Packets should end with their row, but many writers let them run on, so only the end of the picture ends them. A
/// packet that runs past the end of the picture is an error.
fn read_packets(reader: &mut Reader<'_>, layout: &PixelLayout, count: usize) -> Result<Vec<[u8; 4]>, DecodeError> {
    let pixel_bytes = layout.pixel_bytes();
    // A packet makes at most 128 pixels from 1 + pixel_bytes bytes: a short file cannot claim a large picture.
    let most_pixels = (reader.rest().len() / (1 + pixel_bytes)).saturating_mul(128);
    if most_pixels < count {
        return Err(
            reader.malformed(format!("the file is too short for {count} pixels, even if all packets were runs"))
        );
    }
    let mut pixels = Vec::with_capacity(count);
    while pixels.len() < count {
        let head = reader.u8("run-length packets")?;
        let length = usize::from(head & 0x7f) + 1;
        if length > count - pixels.len() {
            return Err(reader.malformed("a run-length packet goes past the end of the picture"));
        }
        let offset = reader.offset();
        if head & 0x80 == 0 {
            layout.append(reader.take(length * pixel_bytes, "run-length packets")?, offset, &mut pixels)?;
        } else {
            layout.append(reader.take(pixel_bytes, "run-length packets")?, offset, &mut pixels)?;
            let color = pixels[pixels.len() - 1];
            pixels.resize(pixels.len() + length - 1, color);
        }
    }
    Ok(pixels)
}

/// Whether the alpha bytes are alpha.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum AlphaMeaning {
    Straight,
    Premultiplied,
    /// Something else, or nothing: the picture is opaque.
    Ignored,
}

impl AlphaMeaning {
    /// Asks the extension area of version 2.0 if there is one, else the declared number of alpha bits.
    ///
    /// Files of 32 bits that declare no alpha bits are common; most writers of such files mean alpha, and those that do
    /// not leave it 0 everywhere.
    fn find(bytes: &[u8], header: &Header, pixels: &[[u8; 4]]) -> Self {
        match attributes_type(bytes) {
            Some(0..=2) => Self::Ignored,
            Some(4) => Self::Premultiplied,
            Some(_) => Self::Straight,
            None if header.alpha_bits == 0 && pixels.iter().all(|p| p[3] == 0) => Self::Ignored,
            None => Self::Straight,
        }
    }

    fn apply(self, pixels: &mut [[u8; 4]]) {
        match self {
            Self::Straight => {}
            Self::Ignored => pixels.iter_mut().for_each(|p| p[3] = u8::MAX),
            Self::Premultiplied => pixels.iter_mut().for_each(|p| *p = unpremultiply_u8(*p)),
        }
    }
}

/// Field 24 of the extension area, if the file ends with the footer of version 2.0 and has such an area.
fn attributes_type(bytes: &[u8]) -> Option<u8> {
    let (_, footer) = bytes.split_last_chunk::<26>()?;
    if !footer.ends_with(crate::format::TGA_SIGNATURE) {
        return None;
    }
    let area = usize::try_from(u32::from_le_bytes([footer[0], footer[1], footer[2], footer[3]])).ok()?;
    if area == 0 {
        return None;
    }
    bytes.get(area.checked_add(494)?).copied()
}

/// File order to rows from the top, columns from the left.
fn place_rows(header: &Header, mut pixels: Vec<[u8; 4]>) -> Result<Rgba8Image, DecodeError> {
    let width = header.width as usize;
    if header.is_right_to_left {
        pixels.chunks_exact_mut(width).for_each(<[_]>::reverse);
    }
    if !header.is_top_down {
        let height = header.height as usize;
        for y in 0..height / 2 {
            let (above, below) = pixels.split_at_mut((height - 1 - y) * width);
            above[y * width..][..width].swap_with_slice(&mut below[..width]);
        }
    }
    Rgba8Image::from_pixels(header.width, header.height, pixels)
        .map_err(|error| DecodeError::malformed_somewhere(Format::Tga, error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Builds files by the specification, field by field.
    #[derive(Clone)]
    struct Tga {
        image_type: u8,
        map: Option<(u16, u16, u8)>,
        map_bytes: Vec<u8>,
        size: (u16, u16),
        bits: u8,
        descriptor: u8,
        id: &'static [u8],
        body: Vec<u8>,
    }

    impl Tga {
        fn new(image_type: u8, size: (u16, u16), bits: u8, body: &[u8]) -> Self {
            let body = body.to_vec();
            Self { image_type, map: None, map_bytes: Vec::new(), size, bits, descriptor: 0x20, id: b"", body }
        }

        fn with_map(mut self, first: u16, entry_bits: u8, entries: &[u8]) -> Self {
            let count = entries.len() / usize::from(entry_bits.div_ceil(8));
            self.map = Some((first, u16::try_from(count).unwrap(), entry_bits));
            self.map_bytes = entries.to_vec();
            self
        }

        fn bytes(&self) -> Vec<u8> {
            let (first, count, entry_bits) = self.map.unwrap_or_default();
            let mut file = vec![u8::try_from(self.id.len()).unwrap(), u8::from(self.map.is_some()), self.image_type];
            file.extend(first.to_le_bytes().into_iter().chain(count.to_le_bytes()).chain([entry_bits, 7, 0, 9, 0]));
            file.extend(self.size.0.to_le_bytes().into_iter().chain(self.size.1.to_le_bytes()));
            file.extend([self.bits, self.descriptor]);
            file.extend(self.id.iter().chain(&self.map_bytes).chain(&self.body));
            file
        }

        fn decode(&self) -> Result<Rgba8Image, DecodeError> {
            decode(&self.bytes(), &Limits::default()).map(DecodedImage::into_rgba8)
        }

        fn pixels(&self) -> Vec<[u8; 4]> {
            self.decode().unwrap().into_pixels()
        }

        fn error(&self) -> String {
            self.decode().unwrap_err().to_string()
        }
    }

    /// The same pixels raw and as run-length packets: two equal ones in a run, then one raw.
    fn raw_and_packed(kind: u8, bits: u8, a: &[u8], b: &[u8]) -> [Tga; 2] {
        let raw = [a, a, b].concat();
        let packed = [&[0x81], a, &[0x00], b].concat();
        [Tga::new(kind, (3, 1), bits, &raw), Tga::new(kind + 8, (3, 1), bits, &packed)]
    }

    #[test]
    fn every_depth_is_read_raw_and_packed() {
        let opaque = 255;
        for (kind, bits, descriptor, a, b, expected) in [
            (3, 8, 0x20, &[7][..], &[200][..], [[7, 7, 7, opaque], [200, 200, 200, opaque]]),
            (3, 16, 0x28, &[7, 80], &[200, 255], [[7, 7, 7, 80], [200, 200, 200, 255]]),
            (2, 15, 0x20, &[0x1f, 0x00], &[0x00, 0x7c], [[0, 0, 255, opaque], [255, 0, 0, opaque]]),
            (2, 16, 0x20, &[0xe0, 0x03], &[0x10, 0x80], [[0, 255, 0, opaque], [0, 0, 132, opaque]]),
            // With a declared alpha bit.
            (2, 16, 0x21, &[0xe0, 0x03], &[0x10, 0x80], [[0, 255, 0, 0], [0, 0, 132, opaque]]),
            (2, 24, 0x20, &[1, 2, 3], &[4, 5, 6], [[3, 2, 1, opaque], [6, 5, 4, opaque]]),
            (2, 32, 0x28, &[1, 2, 3, 99], &[4, 5, 6, 0], [[3, 2, 1, 99], [6, 5, 4, 0]]),
        ] {
            for mut file in raw_and_packed(kind, bits, a, b) {
                file.descriptor = descriptor;
                assert_eq!(file.pixels(), [expected[0], expected[0], expected[1]], "type {kind}, {bits} bits");
            }
        }
    }

    #[test]
    fn color_maps_are_read_at_every_depth() {
        for (entry_bits, entries, expected) in [
            (15, &[0x1f, 0x00, 0x00, 0x7c][..], [[0, 0, 255, 255], [255, 0, 0, 255]]),
            (16, &[0x1f, 0x00, 0x00, 0x7c], [[0, 0, 255, 255], [255, 0, 0, 255]]),
            (24, &[1, 2, 3, 4, 5, 6], [[3, 2, 1, 255], [6, 5, 4, 255]]),
            (32, &[1, 2, 3, 9, 4, 5, 6, 8], [[3, 2, 1, 9], [6, 5, 4, 8]]),
        ] {
            for (bits, a, b) in [(8, &[5][..], &[6][..]), (16, &[5, 0], &[6, 0])] {
                for file in raw_and_packed(1, bits, a, b) {
                    // The first entry stands for index 5.
                    let file = file.with_map(5, entry_bits, entries);
                    assert_eq!(file.pixels(), [expected[0], expected[0], expected[1]], "{entry_bits} bits an entry");
                }
            }
        }
    }

    #[test]
    fn indices_outside_of_the_map_are_errors() {
        for index in [4, 7, 255] {
            let file = Tga::new(1, (1, 1), 8, &[index]).with_map(5, 24, &[1, 2, 3, 4, 5, 6]);
            assert_eq!(
                file.error(),
                format!("malformed TGA at byte 24: index {index} is not in the color map of 2 colors from 5")
            );
        }
        assert!(Tga::new(1, (1, 1), 8, &[0]).error().contains("has a color map"));
    }

    #[test]
    fn all_four_origins_are_honored() {
        // Two rows of three, as stored.
        let body = [1, 2, 3, 4, 5, 6];
        for (descriptor, expected) in [
            (0x00, [4, 5, 6, 1, 2, 3]),
            (0x10, [6, 5, 4, 3, 2, 1]),
            (0x20, [1, 2, 3, 4, 5, 6]),
            (0x30, [3, 2, 1, 6, 5, 4]),
        ] {
            let file = Tga { descriptor, ..Tga::new(3, (3, 2), 8, &body) };
            assert_eq!(file.pixels().iter().map(|p| p[0]).collect::<Vec<_>>(), expected, "{descriptor:#x}");
        }
    }

    #[test]
    fn packets_may_cross_rows_but_not_the_end() {
        let crossing = Tga::new(11, (2, 2), 8, &[0x82, 9, 0x00, 4]);
        assert_eq!(crossing.pixels().iter().map(|p| p[0]).collect::<Vec<_>>(), [9, 9, 9, 4]);
        for body in [&[0x84, 9][..], &[0x04, 1, 2, 3, 4, 5]] {
            assert!(Tga::new(11, (2, 2), 8, body).error().contains("past the end"));
        }
    }

    #[test]
    fn the_identification_and_an_unneeded_map_are_passed_over() {
        let mut file = Tga::new(3, (1, 1), 8, &[77]).with_map(0, 24, &[0; 9]);
        file.id = b"made by hand";
        assert_eq!(file.pixels(), [[77, 77, 77, 255]]);
    }

    #[test]
    fn undeclared_alpha_counts_unless_it_is_0_everywhere() {
        let file = |body| Tga { descriptor: 0x20, ..Tga::new(2, (2, 1), 32, body) };
        assert_eq!(file(&[1, 2, 3, 0, 4, 5, 6, 0]).pixels().map_alpha(), [255, 255]);
        assert_eq!(file(&[1, 2, 3, 0, 4, 5, 6, 9]).pixels().map_alpha(), [0, 9]);
        // Declared alpha of 0 is transparent.
        let declared = Tga { descriptor: 0x28, ..file(&[1, 2, 3, 0, 4, 5, 6, 0]) };
        assert_eq!(declared.pixels().map_alpha(), [0, 0]);
    }

    trait MapAlpha {
        fn map_alpha(&self) -> Vec<u8>;
    }

    impl MapAlpha for Vec<[u8; 4]> {
        fn map_alpha(&self) -> Vec<u8> {
            self.iter().map(|pixel| pixel[3]).collect()
        }
    }

    #[test]
    fn the_extension_area_tells_what_alpha_means() {
        for (attributes_type, expected) in
            [(0, [3, 2, 100, 255]), (2, [3, 2, 100, 255]), (3, [3, 2, 100, 128]), (4, [6, 4, 199, 128])]
        {
            let mut file = Tga { descriptor: 0x28, ..Tga::new(2, (1, 1), 32, &[100, 2, 3, 128]) }.bytes();
            let area = u32::try_from(file.len()).unwrap();
            file.extend([0; 494]);
            file.push(attributes_type);
            file.extend(area.to_le_bytes().into_iter().chain([0; 4]));
            file.extend(crate::format::TGA_SIGNATURE);
            assert_eq!(Format::sniff(&file), Some(Format::Tga));
            let image = decode(&file, &Limits::default()).unwrap().into_rgba8();
            assert_eq!(image.pixel(0, 0), expected, "attributes type {attributes_type}");
        }
    }

    #[test]
    fn bad_headers_say_which_rule_they_break() {
        let valid = Tga::new(2, (1, 1), 24, &[1, 2, 3]);
        for (file, part) in [
            (Tga { image_type: 0, ..valid.clone() }, "without a picture"),
            (Tga { image_type: 4, ..valid.clone() }, "at byte 2: the image type"),
            (Tga { image_type: 32, ..valid.clone() }, "Huffman"),
            (Tga { size: (0, 1), ..valid.clone() }, "0x1"),
            (Tga { bits: 8, ..valid.clone() }, "8 bits a pixel in a true-color picture"),
            (Tga { image_type: 3, ..valid.clone() }, "24 bits a pixel in a grayscale picture"),
            (Tga { descriptor: 0x60, ..valid.clone() }, "interleaved"),
            (Tga { size: (2, 1), ..valid.clone() }, "the file ends inside the pixels"),
            (Tga { image_type: 10, size: (60000, 60000), ..valid.clone() }, "max_width of 60000"),
        ] {
            let error = file.error();
            assert!(error.contains(part), "{error}");
        }
        let mut bytes = valid.bytes();
        bytes[1] = 2;
        assert!(decode(&bytes, &Limits::default()).unwrap_err().to_string().contains("at byte 1"));
    }

    #[test]
    fn a_short_file_cannot_claim_a_large_picture() {
        // 30000 x 4000 pixels from 18 + 4 bytes: refused before memory is taken.
        for image_type in [2, 10] {
            let file = Tga::new(image_type, (30000, 4000), 24, &[0xff, 1, 2, 3]);
            assert!(matches!(file.decode(), Err(DecodeError::Malformed { .. })));
        }
    }
}
