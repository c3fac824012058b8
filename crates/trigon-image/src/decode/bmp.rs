//! BMP files to pixels: Windows versions 2 to 5 and OS/2, 1 to 32 bits, palettes, bit fields, run-length coding.
//!
//! The header says where the pixels begin, how rows are stored and which bits are which channel. The fourth byte of a
//! 32-bit pixel is alpha only if the header has a mask for it.
//!
//! Source: Microsoft, "Bitmap Storage" and "BITMAPV5HEADER structure", Windows GDI reference.

use super::DecodedImage;
use super::bmp_rle;
use super::reader::Reader;
use crate::{DecodeError, Format, Limits, Rgba8Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut reader = Reader::new(Format::Bmp, bytes);
    let header = Header::read(&mut reader)?;
    let count = limits.check(header.width, header.height, 4)?;
    let layout = PixelLayout::read(&header, &mut reader)?;
    reader.seek(header.pixels_offset, "headers")?;

    let mut image = match layout {
        PixelLayout::RunLength { bits, palette } => {
            let indices = bmp_rle::read_indices(&mut reader, bits, header.width, header.height, count)?;
            let mut pixels = Vec::with_capacity(count);
            for index in indices {
                pixels.push(color_of(&palette, index, &reader)?);
            }
            from_pixels(&header, pixels)?
        }
        layout => read_rows(&mut reader, &header, &layout)?,
    };
    if !header.is_top_down {
        flip(&mut image);
    }
    Ok(DecodedImage::Rgba8(image))
}

/// How the pixels are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Compression {
    None,
    /// Run-length coded with indices of 4 or 8 bits.
    RunLength(u8),
    BitFields,
}

/// The file header and the bitmap header, checked.
struct Header {
    pixels_offset: usize,
    /// The size of the bitmap header tells its version.
    header_size: u32,
    width: u32,
    height: u32,
    is_top_down: bool,
    bits: u16,
    compression: Compression,
    palette_colors: u32,
    /// Masks of red, green, blue and alpha, if the header has them.
    masks: Option<[u32; 4]>,
}

/// Bytes of the header that comes before the bitmap header.
const FILE_HEADER: usize = 14;

/// The size of the bitmap header of OS/2 1, with 16-bit sides and palette entries of 3 bytes.
const CORE_HEADER: u32 = 12;

impl Header {
    fn read(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        if reader.array("header")? != *b"BM" {
            return Err(DecodeError::malformed(Format::Bmp, 0, "the file begins with \"BM\""));
        }
        reader.take(8, "header")?;
        let pixels_offset = reader.u32_le("header")? as usize;
        let header_size = reader.u32_le("header")?;
        let mut header = Self {
            pixels_offset,
            header_size,
            width: 0,
            height: 0,
            is_top_down: false,
            bits: 0,
            compression: Compression::None,
            palette_colors: 0,
            masks: None,
        };
        match header_size {
            CORE_HEADER => header.read_core(reader)?,
            16 | 40 | 52 | 56 | 64 | 108 | 124 => header.read_windows(reader)?,
            other => {
                let rule = format!("the size of the bitmap header is one of the known versions, not {other}");
                return Err(DecodeError::malformed(Format::Bmp, FILE_HEADER, rule));
            }
        }
        if header.width == 0 || header.height == 0 {
            return Err(DecodeError::malformed(Format::Bmp, FILE_HEADER + 4, "width and height are at least 1"));
        }
        Ok(header)
    }

    fn read_core(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        self.width = reader.u16_le("header")?.into();
        self.height = reader.u16_le("header")?.into();
        reader.take(2, "header")?;
        self.bits = reader.u16_le("header")?;
        Ok(())
    }

    fn read_windows(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        let signed_width = reader.u32_le("header")?.cast_signed();
        let signed_height = reader.u32_le("header")?.cast_signed();
        let Ok(width) = u32::try_from(signed_width) else {
            return Err(DecodeError::malformed(Format::Bmp, FILE_HEADER + 4, "the width is positive"));
        };
        self.width = width;
        self.height = signed_height.unsigned_abs();
        self.is_top_down = signed_height < 0;
        reader.take(2, "header")?;
        self.bits = reader.u16_le("header")?;
        if self.header_size == 16 {
            return Ok(());
        }
        let compression_offset = reader.offset();
        let compression = reader.u32_le("header")?;
        reader.take(12, "header")?;
        self.palette_colors = reader.u32_le("header")?;
        reader.take(4, "header")?;
        self.compression = match (compression, self.header_size) {
            (0, _) => Compression::None,
            (1, _) => Compression::RunLength(8),
            (2, _) => Compression::RunLength(4),
            (3 | 6, 40 | 52 | 56 | 108 | 124) => Compression::BitFields,
            (3, _) => return Err(DecodeError::unsupported(Format::Bmp, "Huffman-coded pixels of OS/2")),
            (4, _) => return Err(DecodeError::unsupported(Format::Bmp, "JPEG inside BMP")),
            (5, _) => return Err(DecodeError::unsupported(Format::Bmp, "PNG inside BMP")),
            (other, _) => {
                let rule = format!("the compression is 0 to 6, not {other}");
                return Err(DecodeError::malformed(Format::Bmp, compression_offset, rule));
            }
        };
        self.read_masks(reader, compression == 6)?;
        // The palette follows the bitmap header, whose rest holds nothing of interest.
        if self.header_size > 40 {
            reader.seek(FILE_HEADER + self.header_size as usize, "header")?;
        }
        Ok(())
    }

    /// Masks lie in the later headers, or behind the header of 40 bytes.
    fn read_masks(&mut self, reader: &mut Reader<'_>, has_alpha: bool) -> Result<(), DecodeError> {
        if self.compression != Compression::BitFields {
            return Ok(());
        }
        let mut mask = || reader.u32_le("channel masks");
        let (r, g, b) = (mask()?, mask()?, mask()?);
        let a = if has_alpha || self.header_size >= 56 { mask()? } else { 0 };
        self.masks = Some([r, g, b, a]);
        Ok(())
    }
}

/// What the bits of a row mean.
enum PixelLayout {
    /// Indices of 1, 2, 4 or 8 bits, the first in the high bits.
    Indexed { bits: u8, palette: Vec<[u8; 4]> },
    /// Indices of 4 or 8 bits in packets.
    RunLength { bits: u8, palette: Vec<[u8; 4]> },
    /// Blue, green, red.
    Bgr24,
    /// Little-endian numbers of 2 or 4 bytes with a field for each channel.
    Fields { pixel_bytes: usize, fields: [Field; 4] },
}

impl PixelLayout {
    /// Chooses the layout; reads the palette if there is one.
    fn read(header: &Header, reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let malformed = |rule: String| Err(DecodeError::malformed(Format::Bmp, FILE_HEADER, rule));
        let bits = header.bits;
        match (header.compression, bits) {
            (Compression::None, 1 | 2 | 4 | 8) => {
                let bits = u8::try_from(bits).unwrap_or(8);
                Ok(Self::Indexed { bits, palette: read_palette(header, reader)? })
            }
            (Compression::RunLength(packed), 4 | 8) if u16::from(packed) == bits => {
                if header.is_top_down {
                    return malformed("run-length coded pictures are stored bottom row first".into());
                }
                Ok(Self::RunLength { bits: packed, palette: read_palette(header, reader)? })
            }
            (Compression::None, 24) => Ok(Self::Bgr24),
            (Compression::None, 16) => Self::fields(2, [0x7c00, 0x03e0, 0x001f, 0]),
            (Compression::None, 32) => Self::fields(4, [0x00ff_0000, 0x0000_ff00, 0x0000_00ff, 0]),
            (Compression::BitFields, 16 | 32) => Self::fields(usize::from(bits / 8), header.masks.unwrap_or_default()),
            (Compression::None, other) => malformed(format!("a pixel has 1, 2, 4, 8, 16, 24 or 32 bits, not {other}")),
            (_, other) => malformed(format!("{other} bits a pixel do not go with this compression")),
        }
    }

    fn fields(pixel_bytes: usize, masks: [u32; 4]) -> Result<Self, DecodeError> {
        let mut fields = [Field::default(); 4];
        for (field, mask) in fields.iter_mut().zip(masks) {
            *field = Field::of(mask)?;
        }
        Ok(Self::Fields { pixel_bytes, fields })
    }

    fn row_bits(&self, width: u32) -> u64 {
        let bits = match self {
            Self::Indexed { bits, .. } | Self::RunLength { bits, .. } => u64::from(*bits),
            Self::Bgr24 => 24,
            Self::Fields { pixel_bytes, .. } => *pixel_bytes as u64 * 8,
        };
        u64::from(width) * bits
    }
}

/// Neighbouring bits of a pixel that hold a channel.
#[derive(Debug, Clone, Copy, Default)]
struct Field {
    shift: u32,
    /// The largest value, all ones; 0 if the channel is missing.
    largest: u32,
}

impl Field {
    fn of(mask: u32) -> Result<Self, DecodeError> {
        let shift = if mask == 0 { 0 } else { mask.trailing_zeros() };
        let largest = mask >> shift;
        if largest & largest.wrapping_add(1) != 0 {
            return Err(DecodeError::malformed(
                Format::Bmp,
                FILE_HEADER + 40,
                "the bits of a channel mask are neighbours",
            ));
        }
        Ok(Self { shift, largest })
    }

    /// The channel of a pixel as 0..=255, rounded to nearest; `missing` if there is no such channel.
    fn value(self, pixel: u32, missing: u8) -> u8 {
        if self.largest == 0 {
            return missing;
        }
        let (value, largest) = (u64::from(pixel >> self.shift & self.largest), u64::from(self.largest));
        u8::try_from((value * 255 + largest / 2) / largest).unwrap_or(u8::MAX)
    }
}

/// Entries of blue, green, red, and but for the oldest version a byte more.
///
/// A header that does not tell the number of colors means all of them, but files end the palette where the pixels
/// begin.
fn read_palette(header: &Header, reader: &mut Reader<'_>) -> Result<Vec<[u8; 4]>, DecodeError> {
    let entry_bytes = if header.header_size == CORE_HEADER { 3 } else { 4 };
    let most = 1_usize << header.bits;
    let declared = match header.palette_colors as usize {
        0 => most,
        colors => colors.min(most),
    };
    let room = header.pixels_offset.saturating_sub(reader.offset()) / entry_bytes;
    let bytes = reader.take(declared.min(room) * entry_bytes, "palette")?;
    Ok(bytes.chunks_exact(entry_bytes).map(|entry| [entry[2], entry[1], entry[0], u8::MAX]).collect())
}

fn color_of(palette: &[[u8; 4]], index: u8, reader: &Reader<'_>) -> Result<[u8; 4], DecodeError> {
    palette
        .get(usize::from(index))
        .copied()
        .ok_or_else(|| reader.malformed(format!("index {index} is not in the palette of {} colors", palette.len())))
}

/// Rows in file order, each padded to a multiple of 4 bytes.
fn read_rows(reader: &mut Reader<'_>, header: &Header, layout: &PixelLayout) -> Result<Rgba8Image, DecodeError> {
    let width = header.width as usize;
    let row_bytes = usize::try_from(layout.row_bits(header.width).div_ceil(32) * 4).unwrap_or(usize::MAX);
    if reader.rest().len() / row_bytes < header.height as usize - 1 {
        return Err(reader.malformed(format!("the file is too short for {} rows of {row_bytes} bytes", header.height)));
    }
    let mut pixels = Vec::with_capacity(width * header.height as usize);
    for y in 0..header.height {
        // Some writers leave out the padding of the last row.
        let is_last = y + 1 == header.height;
        let length = if is_last { row_bytes.min(reader.rest().len()) } else { row_bytes };
        let row = reader.take(length, "pixels")?;
        match layout {
            PixelLayout::Indexed { bits, palette } | PixelLayout::RunLength { bits, palette } => {
                let per_byte = 8 / bits;
                let mask = u8::MAX >> (8 - bits);
                let indices = row.iter().flat_map(|byte| (1..=per_byte).map(move |i| byte >> (8 - i * bits) & mask));
                for index in indices.take(width) {
                    pixels.push(color_of(palette, index, reader)?);
                }
            }
            PixelLayout::Bgr24 => {
                pixels.extend(row.as_chunks().0.iter().take(width).map(|&[b, g, r]| [r, g, b, u8::MAX]));
            }
            PixelLayout::Fields { pixel_bytes, fields } => {
                pixels.extend(row.chunks_exact(*pixel_bytes).take(width).map(|bytes| {
                    let pixel = bytes.iter().rev().fold(0, |pixel, &byte| pixel << 8 | u32::from(byte));
                    let [r, g, b, a] = fields;
                    [r.value(pixel, 0), g.value(pixel, 0), b.value(pixel, 0), a.value(pixel, u8::MAX)]
                }));
            }
        }
    }
    if pixels.len() < width * header.height as usize {
        return Err(reader.malformed("the file ends inside the pixels"));
    }
    from_pixels(header, pixels)
}

fn from_pixels(header: &Header, pixels: Vec<[u8; 4]>) -> Result<Rgba8Image, DecodeError> {
    Rgba8Image::from_pixels(header.width, header.height, pixels)
        .map_err(|error| DecodeError::malformed_somewhere(Format::Bmp, error.to_string()))
}

/// Turns the rows upside down.
fn flip(image: &mut Rgba8Image) {
    let (width, height) = (image.width() as usize, image.height() as usize);
    for y in 0..height / 2 {
        let (above, below) = image.pixels_mut().split_at_mut((height - 1 - y) * width);
        above[y * width..][..width].swap_with_slice(&mut below[..width]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::samples::{bmp_24, bmp_header, bmp_rle_8, picture};

    fn image(bytes: &[u8]) -> Rgba8Image {
        decode(bytes, &Limits::default()).unwrap().into_rgba8()
    }

    fn error(bytes: &[u8]) -> String {
        decode(bytes, &Limits::default()).unwrap_err().to_string()
    }

    /// A file with a header of 40 bytes.
    fn file(size: (i32, i32), bits: u16, compression: u32, between: &[u8], body: &[u8]) -> Vec<u8> {
        [&bmp_header(40, size, bits, compression, between), body].concat()
    }

    #[test]
    fn rows_are_padded_and_stored_from_the_bottom() {
        for width in 1..6 {
            let expected = picture(width, 3, true);
            assert_eq!(image(&bmp_24(&expected)), expected);
            // The padding of the last row may be missing.
            let padding = (width as usize * 3).next_multiple_of(4) - width as usize * 3;
            let bytes = bmp_24(&expected);
            assert_eq!(image(&bytes[..bytes.len() - padding]), expected);
        }
        let top_down = file((1, -2), 24, 0, &[], &[1, 2, 3, 0, 4, 5, 6, 0]);
        assert_eq!(image(&top_down).pixels(), [[3, 2, 1, 255], [6, 5, 4, 255]]);
    }

    #[test]
    fn palettes_are_read_at_every_depth() {
        let palette = |colors: u8| (0..colors).flat_map(|i| [i, 100, 200, 0]).collect::<Vec<u8>>();
        for (bits, colors, body, expected) in [
            (1, 2, &[0b0110_0000, 0, 0, 0][..], &[0, 1, 1][..]),
            (2, 4, &[0b0001_1011, 0, 0, 0], &[0, 1, 2, 3]),
            (4, 16, &[0x1f, 0x20, 0, 0], &[1, 15, 2]),
            (8, 200, &[7, 199, 0, 0], &[7, 199]),
        ] {
            let width = i32::try_from(expected.len()).unwrap();
            let image = image(&file((width, 1), bits, 0, &palette(colors), body));
            let expected: Vec<[u8; 4]> = expected.iter().map(|&i| [200, 100, i, 255]).collect();
            assert_eq!(image.pixels(), expected, "{bits} bits");
        }
        let outside = file((2, 1), 8, 0, &palette(3), &[2, 3, 0, 0]);
        assert!(error(&outside).contains("index 3 is not in the palette of 3 colors"));
    }

    #[test]
    fn fields_of_any_width_are_widened() {
        let masks =
            |masks: [u32; 4], count| masks.iter().take(count).flat_map(|m| m.to_le_bytes()).collect::<Vec<u8>>();
        // 16 bits without masks are 5 bits a channel.
        let plain = file((2, 1), 16, 0, &[], &[0x00, 0x7c, 0xe1, 0x03]);
        assert_eq!(image(&plain).pixels(), [[255, 0, 0, 255], [0, 255, 8, 255]]);
        let rgb565 = file((1, 1), 16, 3, &masks([0xf800, 0x07e0, 0x001f, 0], 3), &[0xe0, 0x07, 0, 0]);
        assert_eq!(image(&rgb565).pixels(), [[0, 255, 0, 255]]);
        // The fourth byte is no alpha unless a mask says so.
        let body = 0x0180_40ff_u32.to_le_bytes();
        assert_eq!(image(&file((1, 1), 32, 0, &[], &body)).pixels(), [[0x80, 0x40, 0xff, 255]]);
        let with_alpha = masks([0xff, 0xff00, 0x00ff_0000, 0xff00_0000], 4);
        assert_eq!(image(&file((1, 1), 32, 6, &with_alpha, &body)).pixels(), [[0xff, 0x40, 0x80, 1]]);
        let ten_bits = masks([0x3ff0_0000, 0x000f_fc00, 0x0000_03ff, 0], 3);
        let body = (1023_u32 << 20 | 512 << 10 | 1).to_le_bytes();
        assert_eq!(image(&file((1, 1), 32, 3, &ten_bits, &body)).pixels(), [[255, 128, 0, 255]]);
        let scattered = masks([0x5, 0xff00, 0xff_0000, 0], 3);
        assert!(error(&file((1, 1), 32, 3, &scattered, &body)).contains("neighbours"));
    }

    #[test]
    fn run_length_packets_are_undone() {
        let index = |image: &Rgba8Image| image.pixels().iter().map(|pixel| pixel[2]).collect::<Vec<u8>>();
        assert_eq!(index(&image(&bmp_rle_8())), [0, 3, 3, 3, 3, 0, 0, 0, 0, 0, 1, 1, 3, 2, 1]);
        let palette: Vec<u8> = (0..16).flat_map(|i| [i, 0, 0, 0]).collect();
        // A run of five of 1 and 2 in turn; then three literals in two bytes.
        let packed = file((5, 2), 4, 2, &palette, &[5, 0x12, 0, 0, 0, 3, 0xab, 0xc0, 0, 1]);
        assert_eq!(index(&image(&packed)), [10, 11, 12, 0, 0, 1, 2, 1, 2, 1]);
        for body in [&[6, 0x12][..], &[0, 6, 1, 2, 3, 4], &[0, 0, 0, 0, 1, 1], &[0, 2, 9, 0], &[0, 2, 0, 9]] {
            let error = error(&file((5, 2), 4, 2, &palette, body));
            assert!(error.contains("stay inside the picture"), "{error}");
        }
    }

    #[test]
    fn other_header_versions_are_read() {
        // OS/2 1: sides of 16 bits and palette entries of 3 bytes.
        let mut core = b"BM\0\0\0\0\0\0\0\0\x20\0\0\0\x0c\0\0\0\x02\0\x01\0\x01\0\x01\0".to_vec();
        core.extend([1, 2, 3, 4, 5, 6, 0b0100_0000, 0, 0, 0]);
        assert_eq!(image(&core).pixels(), [[3, 2, 1, 255], [6, 5, 4, 255]]);
        // Version 5, whose masks lie in the header.
        let mut rest = [0xff_0000_u32, 0xff00, 0xff, 0xff00_0000].map(u32::to_le_bytes).concat();
        rest.resize(124 - 40, 0);
        let mut file = bmp_header(124, (1, 1), 32, 3, &rest);
        file.extend([1, 2, 3, 4]);
        assert_eq!(image(&file).pixels(), [[3, 2, 1, 4]]);
    }

    #[test]
    fn bad_headers_say_which_rule_they_break() {
        for (bytes, part) in [
            (file((0, 1), 24, 0, &[], &[]), "at least 1"),
            (file((-1, 1), 24, 0, &[], &[]), "the width is positive"),
            (file((1, 1), 7, 0, &[], &[]), "not 7"),
            (file((1, 1), 24, 1, &[], &[]), "24 bits a pixel do not go"),
            (file((1, 1), 8, 9, &[], &[]), "at byte 30: the compression is 0 to 6, not 9"),
            (file((1, 1), 24, 4, &[], &[]), "unsupported BMP: JPEG"),
            (file((1, -1), 8, 1, &[], &[]), "bottom row first"),
            (file((9, 9), 24, 0, &[], &[0; 8]), "too short for 9 rows of 28 bytes"),
            (file((2, 1), 24, 0, &[], &[0; 5]), "ends inside the pixels"),
            (bmp_header(41, (1, 1), 24, 0, &[]), "not 41"),
        ] {
            let error = error(&bytes);
            assert!(error.contains(part), "{error}");
        }
        assert!(error(&file((1, i32::MIN), 24, 0, &[], &[])).contains("max_height of 2147483648"));
    }
}
