//! OpenEXR files: one part, scan lines, ZIP compression, any number of named channels of `f16`, `f32` or `u32`.
//!
//! Sixteen lines make a block. In a block each line holds each channel's samples in turn, channels sorted by name. Before
//! compression the bytes are split into low and high halves and replaced by their differences.
//!
//! Source: "OpenEXR File Layout" and "Technical Introduction to OpenEXR", openexr.com.

use std::borrow::Cow;
use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::{Effort, EncodeOptions, ExrSample, ImageRef};
use crate::half::f32_to_f16;
use crate::{EncodeError, Format, RgbaF32Image};

/// One channel of an EXR file.
///
/// The usual names are `R`, `G`, `B`, `A` (linear, premultiplied) and `Z` (depth); a layer's name comes before, with a
/// dot: `normal.X`.
#[derive(Debug, Clone, PartialEq)]
pub struct ExrChannel<'a> {
    /// The name with its layer, 1 to 31 bytes of UTF-8 without NUL.
    pub name: String,
    /// One sample a pixel, in row order, row 0 at the top.
    pub samples: ExrSamples<'a>,
}

/// The samples of a channel and the type they are stored in.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum ExrSamples<'a> {
    /// Rounded to half precision.
    F16(Cow<'a, [f32]>),
    /// Exact.
    F32(Cow<'a, [f32]>),
    /// Integers: ids.
    U32(Cow<'a, [u32]>),
}

impl ExrSamples<'_> {
    fn len(&self) -> usize {
        match self {
            Self::F16(samples) | Self::F32(samples) => samples.len(),
            Self::U32(samples) => samples.len(),
        }
    }

    /// The number of the type in the file.
    fn type_code(&self) -> u32 {
        match self {
            Self::U32(_) => 0,
            Self::F16(_) => 1,
            Self::F32(_) => 2,
        }
    }

    fn append_line(&self, range: std::ops::Range<usize>, bytes: &mut Vec<u8>) {
        match self {
            Self::F16(samples) => bytes.extend(samples[range].iter().flat_map(|&x| f32_to_f16(x).to_le_bytes())),
            Self::F32(samples) => bytes.extend(samples[range].iter().flat_map(|x| x.to_le_bytes())),
            Self::U32(samples) => bytes.extend(samples[range].iter().flat_map(|x| x.to_le_bytes())),
        }
    }
}

impl ExrChannel<'static> {
    /// The four channels of an image, named `R`, `G`, `B`, `A`, or `layer.R` and so on if `layer` is not empty.
    #[must_use]
    pub fn rgba(layer: &str, image: &RgbaF32Image, sample: ExrSample) -> Vec<Self> {
        let channel = |(i, letter): (usize, &str)| {
            let name = if layer.is_empty() { letter.to_owned() } else { format!("{layer}.{letter}") };
            let samples = image.pixels().iter().map(|pixel| pixel[i]).collect();
            let samples = match sample {
                ExrSample::F16 => ExrSamples::F16(samples),
                ExrSample::F32 => ExrSamples::F32(samples),
            };
            Self { name, samples }
        };
        ["R", "G", "B", "A"].into_iter().enumerate().map(channel).collect()
    }
}

/// Encodes channels of `width * height` samples each as an EXR file.
///
/// # Errors
/// [`EncodeError::Invalid`] if there is no channel or no pixel, a channel has another number of samples, or a name is
/// empty, too long, holds NUL or is given twice.
pub fn encode_exr(
    width: u32,
    height: u32,
    channels: &[ExrChannel<'_>],
    effort: Effort,
) -> Result<Vec<u8>, EncodeError> {
    let (Ok(signed_width), Ok(signed_height)) = (i32::try_from(width), i32::try_from(height)) else {
        return Err(EncodeError::unsupported(Format::Exr, "pictures are at most 2147483647 pixels wide and high"));
    };
    let mut channels: Vec<&ExrChannel<'_>> = channels.iter().collect();
    channels.sort_by(|a, b| a.name.as_bytes().cmp(b.name.as_bytes()));
    check(width, height, &channels)?;

    let mut file = header(signed_width, signed_height, &channels);
    // The table of block offsets is filled in as blocks are written.
    let block_count = height.div_ceil(LINES_PER_BLOCK);
    let mut table_entry = file.len();
    file.resize(file.len() + block_count as usize * 8, 0);
    let mut raw = Vec::new();
    for first_line in (0..height).step_by(LINES_PER_BLOCK as usize) {
        raw.clear();
        for y in first_line..height.min(first_line + LINES_PER_BLOCK) {
            let start = y as usize * width as usize;
            channels.iter().for_each(|channel| channel.samples.append_line(start..start + width as usize, &mut raw));
        }
        let offset = file.len() as u64;
        file[table_entry..table_entry + 8].copy_from_slice(&offset.to_le_bytes());
        table_entry += 8;
        append_block(first_line, &raw, effort, &mut file)?;
    }
    Ok(file)
}

pub(super) fn encode(image: ImageRef<'_>, options: &EncodeOptions) -> Result<Vec<u8>, EncodeError> {
    let channels = match image {
        ImageRef::Rgba8(image) => ExrChannel::rgba("", &image.to_linear(), options.exr_sample),
        ImageRef::Rgba16(image) => ExrChannel::rgba("", &image.to_linear(), options.exr_sample),
        ImageRef::RgbaF32(image) => ExrChannel::rgba("", image, options.exr_sample),
        // Depth needs all its bits.
        ImageRef::GrayF32(image) => {
            vec![ExrChannel { name: "Y".into(), samples: ExrSamples::F32(image.pixels().into()) }]
        }
    };
    encode_exr(image.width(), image.height(), &channels, options.effort)
}

/// What ZIP compression packs together.
const LINES_PER_BLOCK: u32 = 16;
const ZIP_COMPRESSION: u8 = 3;

fn check(width: u32, height: u32, channels: &[&ExrChannel<'_>]) -> Result<(), EncodeError> {
    let invalid = |rule: String| Err(EncodeError::invalid(Format::Exr, rule));
    let pixels = u64::from(width) * u64::from(height);
    if pixels == 0 || channels.is_empty() {
        return invalid("there is at least one pixel and one channel".into());
    }
    for channel in channels {
        let (name, samples) = (&channel.name, channel.samples.len());
        if samples as u64 != pixels {
            return invalid(format!("channel {name} has {samples} samples for {width}x{height} pixels"));
        }
        if name.is_empty() || name.len() > 31 || name.contains('\0') {
            return invalid(format!("a channel name has 1 to 31 bytes and no NUL: \"{}\"", name.escape_debug()));
        }
    }
    match channels.windows(2).find(|pair| pair[0].name == pair[1].name) {
        Some(pair) => invalid(format!("channel {} is given twice", pair[0].name)),
        None => Ok(()),
    }
}

/// Magic number, version and attributes.
fn header(width: i32, height: i32, channels: &[&ExrChannel<'_>]) -> Vec<u8> {
    let mut channel_list = Vec::new();
    for channel in channels {
        channel_list.extend(channel.name.as_bytes());
        channel_list.push(0);
        channel_list.extend(channel.samples.type_code().to_le_bytes());
        // Four bytes of no effect here (perceptual linearity, reserved), then a sample for every pixel.
        channel_list.extend([0; 4]);
        channel_list.extend([1, 0, 0, 0, 1, 0, 0, 0]);
    }
    channel_list.push(0);
    let window: Vec<u8> = [0, 0, width - 1, height - 1].iter().flat_map(|side: &i32| side.to_le_bytes()).collect();

    let mut file = vec![0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        file.extend(name.bytes().chain([0]).chain(kind.bytes()).chain([0]));
        let length = u32::try_from(value.len()).expect("attributes are short");
        file.extend(length.to_le_bytes());
        file.extend(value);
    };
    attribute("channels", "chlist", &channel_list);
    attribute("compression", "compression", &[ZIP_COMPRESSION]);
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1.0_f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1.0_f32.to_le_bytes());
    file.push(0);
    file
}

/// First line, length, and the compressed bytes, or the raw ones if those are fewer.
fn append_block(first_line: u32, raw: &[u8], effort: Effort, file: &mut Vec<u8>) -> Result<(), EncodeError> {
    let level = match effort {
        Effort::Fast => Compression::new(1),
        Effort::Balanced => Compression::new(4),
        Effort::Best => Compression::new(9),
    };
    let mut encoder = ZlibEncoder::new(Vec::new(), level);
    encoder.write_all(&split_and_difference(raw))?;
    let compressed = encoder.finish()?;
    let stored = if compressed.len() < raw.len() { &compressed } else { raw };
    let Ok(length) = i32::try_from(stored.len()) else {
        return Err(EncodeError::unsupported(Format::Exr, "blocks of 16 lines are at most 2 GiB"));
    };
    file.extend(first_line.to_le_bytes());
    file.extend(length.to_le_bytes());
    file.extend(stored);
    Ok(())
}

/// All even bytes, then all odd ones; then each byte as its difference to the one before, plus 128.
fn split_and_difference(raw: &[u8]) -> Vec<u8> {
    let mut bytes: Vec<u8> = raw.iter().step_by(2).chain(raw.iter().skip(1).step_by(2)).copied().collect();
    for i in (1..bytes.len()).rev() {
        bytes[i] = bytes[i].wrapping_sub(bytes[i - 1]).wrapping_add(128);
    }
    bytes
}
