//! TIFF files to pixels: the first picture; grey, RGB, palette and CMYK, 1 to 16 bits or floating point, strips or tiles.
//!
//! The `tiff` crate undoes compression and prediction; here samples become RGBA. Integers are taken as sRGB-encoded,
//! floating point as linear, as in other formats. The crate knows no palettes, so indices are read as if they were grey
//! and looked up here. JPEG inside TIFF is not read, nor channels in separate planes.

use std::borrow::Cow;
use std::io::Cursor;

use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

use super::DecodedImage;
use crate::color::{premultiply, unpremultiply_u8, unpremultiply_u16};
use crate::{DecodeError, Format, Limits, Rgba8Image, Rgba16Image, RgbaF32Image, SizeMismatch};

type TiffDecoder<'a> = Decoder<Cursor<&'a [u8]>>;

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let without_palette = indices_as_gray(bytes);
    let has_palette = matches!(without_palette, Cow::Owned(_));
    let decoder = Decoder::new(Cursor::new(&*without_palette)).map_err(convert_error)?;
    let mut decoder = decoder.with_limits(library_limits(limits));
    let (width, height) = decoder.dimensions().map_err(convert_error)?;
    let color = decoder.colortype().map_err(convert_error)?;
    let pixel_bytes = match color.bit_depth() {
        0..=8 => 4,
        9..=16 => 8,
        _ => 16,
    };
    limits.check(width, height, pixel_bytes)?;
    let is_premultiplied = is_premultiplied(&mut decoder);
    let mut samples = DecodingResult::U8(Vec::new());
    let layout = decoder.read_image_to_buffer(&mut samples).map_err(convert_error)?;
    if layout.planes > 1 {
        return Err(DecodeError::unsupported(Format::Tiff, "channels in separate planes"));
    }

    let model = if has_palette { Model::Palette } else { Model::of(color)? };
    let wrong_size = |error: SizeMismatch| DecodeError::malformed_somewhere(Format::Tiff, error.to_string());
    match samples {
        DecodingResult::U8(samples) => {
            let samples = unpack_bits(samples, color.bit_depth(), width as usize * model.channels(), model.is_color());
            let mut pixels = if model == Model::Palette {
                look_up(&mut decoder, samples.into_iter().map(usize::from))?
            } else {
                to_rgba(&samples, model)
            };
            if is_premultiplied {
                pixels.iter_mut().for_each(|pixel| *pixel = unpremultiply_u8(*pixel));
            }
            Rgba8Image::from_pixels(width, height, pixels).map(DecodedImage::Rgba8).map_err(wrong_size)
        }
        DecodingResult::U16(samples) if model == Model::Palette => {
            let pixels = look_up(&mut decoder, samples.into_iter().map(usize::from))?;
            Rgba8Image::from_pixels(width, height, pixels).map(DecodedImage::Rgba8).map_err(wrong_size)
        }
        DecodingResult::U16(samples) if color.bit_depth() == 16 => {
            let mut pixels = to_rgba(&samples, model);
            if is_premultiplied {
                pixels.iter_mut().for_each(|pixel| *pixel = unpremultiply_u16(*pixel));
            }
            Rgba16Image::from_pixels(width, height, pixels).map(DecodedImage::Rgba16).map_err(wrong_size)
        }
        DecodingResult::F32(samples) => {
            let mut pixels = to_rgba(&samples, model);
            if !is_premultiplied {
                pixels.iter_mut().for_each(|pixel| *pixel = premultiply(*pixel));
            }
            RgbaF32Image::from_pixels(width, height, pixels).map(DecodedImage::RgbaF32).map_err(wrong_size)
        }
        _ => Err(DecodeError::unsupported(Format::Tiff, format!("samples of type {:?}", layout.sample_format))),
    }
}

const GRAY: u16 = 1;
const PALETTE: u16 = 3;

/// The file, changed to say that its pixels are grey if it says that they are palette indices.
fn indices_as_gray(bytes: &[u8]) -> Cow<'_, [u8]> {
    let is_little_endian = bytes.starts_with(b"II");
    let u16_at = |offset: usize| -> Option<u16> {
        let value = *bytes.get(offset..)?.first_chunk()?;
        Some(if is_little_endian { u16::from_le_bytes(value) } else { u16::from_be_bytes(value) })
    };
    let find = || -> Option<usize> {
        let value = *bytes.get(4..)?.first_chunk()?;
        let directory = if is_little_endian { u32::from_le_bytes(value) } else { u32::from_be_bytes(value) } as usize;
        // Entries of 12 bytes: tag, type, number of values, and the value itself.
        let entries = (0..usize::from(u16_at(directory)?)).map(|i| directory.saturating_add(2 + i * 12));
        let photometric = Tag::PhotometricInterpretation.to_u16();
        let value = entries.into_iter().find(|&entry| u16_at(entry) == Some(photometric))? + 8;
        (u16_at(value) == Some(PALETTE)).then_some(value)
    };
    let Some(value) = find() else { return Cow::Borrowed(bytes) };
    let mut changed = bytes.to_vec();
    changed[value..value + 2].copy_from_slice(&if is_little_endian { GRAY.to_le_bytes() } else { GRAY.to_be_bytes() });
    Cow::Owned(changed)
}

/// What the samples of a pixel are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Model {
    Gray,
    GrayAlpha,
    Rgb,
    Rgba,
    /// Inks: 0 is none.
    Cmyk,
    Palette,
}

impl Model {
    fn of(color: ColorType) -> Result<Self, DecodeError> {
        match color {
            ColorType::Gray(_) => Ok(Self::Gray),
            ColorType::GrayA(_) | ColorType::Multiband { num_samples: 2, .. } => Ok(Self::GrayAlpha),
            ColorType::RGB(_) => Ok(Self::Rgb),
            ColorType::RGBA(_) => Ok(Self::Rgba),
            ColorType::CMYK(_) => Ok(Self::Cmyk),
            other => Err(DecodeError::unsupported(Format::Tiff, format!("pixels of type {other:?}"))),
        }
    }

    fn channels(self) -> usize {
        match self {
            Self::Gray | Self::Palette => 1,
            Self::GrayAlpha => 2,
            Self::Rgb => 3,
            Self::Rgba | Self::Cmyk => 4,
        }
    }

    /// Whether a sample is an amount, not an index.
    fn is_color(self) -> bool {
        self != Self::Palette
    }
}

/// A number of a channel: an integer code, or linear light.
trait Sample: Copy {
    const OPAQUE: Self;

    /// The light that `ink` and `black` leave: (1 - ink) (1 - black).
    fn without_inks(ink: Self, black: Self) -> Self;
}

impl Sample for u8 {
    const OPAQUE: Self = Self::MAX;

    fn without_inks(ink: Self, black: Self) -> Self {
        crate::color::without_inks(ink, black)
    }
}

impl Sample for u16 {
    const OPAQUE: Self = Self::MAX;

    #[expect(clippy::cast_possible_truncation, reason = "a product of two numbers in 0..=65535 over 65535")]
    fn without_inks(ink: Self, black: Self) -> Self {
        ((u64::from(!ink) * u64::from(!black) + 32767) / 65535) as Self
    }
}

impl Sample for f32 {
    const OPAQUE: Self = 1.0;

    fn without_inks(ink: Self, black: Self) -> Self {
        (1.0 - ink) * (1.0 - black)
    }
}

/// Interleaved samples to RGBA, for the models without a palette.
fn to_rgba<T: Sample>(samples: &[T], model: Model) -> Vec<[T; 4]> {
    match model {
        Model::Gray | Model::Palette => samples.iter().map(|&v| [v, v, v, T::OPAQUE]).collect(),
        Model::GrayAlpha => samples.as_chunks().0.iter().map(|&[v, a]| [v, v, v, a]).collect(),
        Model::Rgb => samples.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, T::OPAQUE]).collect(),
        Model::Rgba => samples.as_chunks().0.to_vec(),
        Model::Cmyk => {
            let pixel = |&[c, m, y, k]: &[T; 4]| [c, m, y].map(|ink| T::without_inks(ink, k));
            samples.as_chunks().0.iter().map(pixel).map(|[r, g, b]| [r, g, b, T::OPAQUE]).collect()
        }
    }
}

/// Samples of 1, 2, 4 bits, in rows that begin at a byte, to one a byte; amounts are widened to 0..=255.
fn unpack_bits(bytes: Vec<u8>, bits: u8, row_samples: usize, is_color: bool) -> Vec<u8> {
    let (1 | 2 | 4) = bits else { return bytes };
    let per_byte = usize::from(8 / bits);
    let mask = u8::MAX >> (8 - bits);
    let factor = if is_color { u8::MAX / mask } else { 1 };
    let row_bytes = row_samples.div_ceil(per_byte).max(1);
    let mut samples = Vec::with_capacity(bytes.len() * per_byte);
    for row in bytes.chunks(row_bytes) {
        let unpacked =
            row.iter().flat_map(|byte| (1..=8 / bits).map(move |i| (byte >> (8 - i * bits) & mask) * factor));
        samples.extend(unpacked.take(row_samples));
    }
    samples
}

/// Palette indices to colors: the color map holds all reds, then all greens, then all blues, of 16 bits each.
fn look_up(decoder: &mut TiffDecoder<'_>, indices: impl Iterator<Item = usize>) -> Result<Vec<[u8; 4]>, DecodeError> {
    let map = decoder.get_tag_u16_vec(Tag::ColorMap).map_err(convert_error)?;
    let colors = map.len() / 3;
    let code = |channel: usize, index: usize| crate::color::u16_to_u8(map[channel * colors + index]);
    indices
        .map(|index| {
            if index < colors {
                return Ok([code(0, index), code(1, index), code(2, index), u8::MAX]);
            }
            let rule = format!("index {index} is not in the color map of {colors} colors");
            Err(DecodeError::malformed_somewhere(Format::Tiff, rule))
        })
        .collect()
}

/// Whether the first extra channel is an alpha that the colors are multiplied by (tag ExtraSamples, value 1).
fn is_premultiplied(decoder: &mut TiffDecoder<'_>) -> bool {
    let extra = decoder.find_tag_unsigned_vec::<u16>(Tag::ExtraSamples);
    matches!(extra.as_ref().map(|kinds| kinds.as_deref()), Ok(Some([1, ..])))
}

fn library_limits(limits: &Limits) -> tiff::decoder::Limits {
    let most = usize::try_from(limits.max_bytes).unwrap_or(usize::MAX);
    let mut library = tiff::decoder::Limits::default();
    library.decoding_buffer_size = most;
    library.intermediate_buffer_size = most;
    library
}

fn convert_error(error: TiffError) -> DecodeError {
    match error {
        TiffError::UnsupportedError(feature) => DecodeError::unsupported(Format::Tiff, feature.to_string()),
        TiffError::LimitsExceeded | TiffError::IntSizeError => {
            DecodeError::unsupported(Format::Tiff, "parts that need more memory than Limits::max_bytes")
        }
        // The file is in memory, so the only failure of reading is its end.
        TiffError::IoError(error) => {
            DecodeError::malformed_somewhere(Format::Tiff, format!("the file ends too early ({error})"))
        }
        other => DecodeError::malformed_somewhere(Format::Tiff, other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An uncompressed little-endian file of one strip.
    struct Tiff {
        size: (u16, u16),
        bits: u16,
        channels: u16,
        photometric: u16,
        /// More entries: tag and values of 16 bits.
        extra: Vec<(u16, Vec<u16>)>,
        body: Vec<u8>,
    }

    impl Tiff {
        fn bytes(&self) -> Vec<u8> {
            let mut entries = vec![
                (256, vec![self.size.0]),
                (257, vec![self.size.1]),
                (258, vec![self.bits; usize::from(self.channels)]),
                (259, vec![1]),
                (262, vec![self.photometric]),
                (273, vec![8]),
                (277, vec![self.channels]),
                (278, vec![self.size.1]),
                (279, vec![u16::try_from(self.body.len()).unwrap()]),
            ];
            entries.extend(self.extra.clone());
            entries.sort();
            // Head, strip, directory, and values that are too long for it.
            let directory = 8 + self.body.len().next_multiple_of(2);
            let mut file = b"II\x2a\0".to_vec();
            file.extend(u32::try_from(directory).unwrap().to_le_bytes());
            file.extend(&self.body);
            file.resize(directory, 0);
            let mut long_values = Vec::new();
            let long_offset = directory + 2 + entries.len() * 12 + 4;
            file.extend(u16::try_from(entries.len()).unwrap().to_le_bytes());
            for (tag, values) in entries {
                file.extend([tag, 3].map(u16::to_le_bytes).concat());
                file.extend(u32::try_from(values.len()).unwrap().to_le_bytes());
                let mut bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
                if bytes.len() > 4 {
                    let offset = u32::try_from(long_offset + long_values.len()).unwrap();
                    long_values.extend(bytes);
                    bytes = offset.to_le_bytes().to_vec();
                }
                bytes.resize(4, 0);
                file.extend(bytes);
            }
            file.extend([0; 4]);
            file.extend(long_values);
            file
        }

        fn image(&self) -> DecodedImage {
            decode(&self.bytes(), &Limits::default()).unwrap()
        }

        fn pixels(&self) -> Vec<[u8; 4]> {
            self.image().into_rgba8().into_pixels()
        }
    }

    fn tiff(size: (u16, u16), bits: u16, channels: u16, photometric: u16, body: &[u8]) -> Tiff {
        Tiff { size, bits, channels, photometric, extra: Vec::new(), body: body.to_vec() }
    }

    #[test]
    fn low_depths_are_widened() {
        let gray = |pixels: Vec<[u8; 4]>| pixels.iter().map(|pixel| pixel[0]).collect::<Vec<_>>();
        let bilevel = tiff((10, 2), 1, 1, 1, &[0b1010_0000, 0b0100_0000, 0xff, 0]);
        assert_eq!(gray(bilevel.pixels())[..10], [255, 0, 255, 0, 0, 0, 0, 0, 0, 255]);
        assert_eq!(gray(bilevel.pixels())[10..], [255, 255, 255, 255, 255, 255, 255, 255, 0, 0]);
        let four_bits = tiff((3, 1), 4, 1, 1, &[0x0f, 0x80]);
        assert_eq!(gray(four_bits.pixels()), [0, 255, 136]);
        // White is zero.
        let inverted = tiff((3, 1), 8, 1, 0, &[0, 255, 100]);
        assert_eq!(gray(inverted.pixels()), [255, 0, 155]);
    }

    #[test]
    fn palettes_are_looked_up() {
        let mut file = tiff((2, 1), 8, 1, PALETTE, &[1, 255]);
        let map = (0..3 * 256).map(|i| if i % 256 == 1 { [10, 20, 30][i / 256] * 257 } else { 65535 }).collect();
        file.extra.push((320, map));
        assert_eq!(file.pixels(), [[10, 20, 30, 255], [255, 255, 255, 255]]);
        let packed = Tiff { body: vec![0x10, 0x10], extra: file.extra.clone(), ..tiff((3, 1), 4, 1, PALETTE, &[]) };
        assert_eq!(packed.pixels()[0], [10, 20, 30, 255]);
        assert_eq!(packed.pixels()[1], packed.pixels()[0].map(|_| 255));
        file.extra[0].1.truncate(3);
        let error = decode(&file.bytes(), &Limits::default()).unwrap_err().to_string();
        assert!(error.contains("not in the color map of 1 colors"), "{error}");
    }

    #[test]
    fn inks_are_taken_from_white() {
        let file = tiff((4, 1), 8, 4, 5, &[0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 255, 0, 128, 255, 128]);
        assert_eq!(file.pixels(), [[255, 255, 255, 255], [0, 255, 255, 255], [0, 0, 0, 255], [127, 63, 0, 255]]);
    }

    #[test]
    fn premultiplied_alpha_is_undone_and_straight_alpha_kept() {
        let mut file = tiff((1, 1), 8, 4, 2, &[64, 128, 0, 128]);
        for (kind, expected) in [(2, [64, 128, 0, 128]), (1, [128, 255, 0, 128])] {
            file.extra = vec![(338, vec![kind])];
            assert_eq!(file.pixels(), [expected]);
        }
    }

    #[test]
    fn sixteen_bits_and_floats_are_kept() {
        let wide = tiff((2, 1), 16, 1, 1, &[0x34, 0x12, 0xff, 0xff]);
        let DecodedImage::Rgba16(image) = wide.image() else { panic!("16 bits stay") };
        assert_eq!(image.pixels(), [[0x1234, 0x1234, 0x1234, 65535], [65535; 4]]);
        let mut float = tiff((1, 1), 32, 1, 1, &2.5_f32.to_le_bytes());
        float.extra.push((339, vec![3]));
        assert_eq!(float.image(), DecodedImage::RgbaF32(RgbaF32Image::filled(1, 1, [2.5, 2.5, 2.5, 1.0])));
    }
}
