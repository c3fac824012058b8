//! TIFF files to pixels: the first picture; grey, RGB, palette and CMYK, 1 to 16 bits or floating point, strips or tiles.
//!
//! The `tiff` crate undoes compression and prediction; here samples become RGBA. Integers are taken as sRGB-encoded,
//! floating point as linear, as in other formats. JPEG inside TIFF is not read, nor channels in separate planes.

use std::io::Cursor;

use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

use super::DecodedImage;
use crate::color::{premultiply, unpremultiply_u8, unpremultiply_u16};
use crate::{DecodeError, Format, Limits, Rgba8Image, Rgba16Image, RgbaF32Image, SizeMismatch};

type TiffDecoder<'a> = Decoder<Cursor<&'a [u8]>>;

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let decoder = Decoder::new(Cursor::new(bytes)).map_err(convert_error)?;
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

    let model = Model::of(color)?;
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
            ColorType::Palette(_) => Ok(Self::Palette),
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

    #[expect(clippy::cast_possible_truncation, reason = "a product of two numbers in 0..=255 over 255")]
    fn without_inks(ink: Self, black: Self) -> Self {
        ((u32::from(!ink) * u32::from(!black) + 127) / 255) as Self
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
