//! The format of the output and how it is encoded: options and a name in, bytes of a picture out.

use super::Destination;
use crate::failure::Failure;
use crate::options::{BitDepth, Compression, OutputOptions};
use crate::values::closest;
use std::path::Path;
use trigon::pipeline::{Outputs, Picture};
use trigon::target::Plane;
use trigon_image::encode::{Effort, ExrSample};
use trigon_image::{EncodeOptions, Format, ImageRef, Rgba8Image, RgbaF32Image, encode};

/// A format and its choices.
#[derive(Clone, Debug)]
pub(crate) struct Encoding {
    pub(crate) format: Format,
    pub(crate) options: EncodeOptions,
    is_float: bool,
}

impl Encoding {
    /// The format that the options ask for, or else the name tells; PNG to standard output and devices.
    pub(crate) fn choose(options: &OutputOptions, destination: &Destination) -> Result<Self, Failure> {
        let format = match (&options.format, destination) {
            (Some(name), _) => writable(Format::from_name(name), name)?,
            (None, Destination::File(path)) if !destination.is_device() => by_extension(path)?,
            (None, _) => Format::Png,
        };
        let is_float = match (format, options.bit_depth) {
            (Format::Exr, None | Some(BitDepth::Sixteen | BitDepth::ThirtyTwo)) => true,
            (Format::Png, Some(BitDepth::Sixteen)) => true,
            (Format::Exr, Some(BitDepth::Eight)) => {
                return Err(Failure::usage("EXR has no 8-bit channels; leave out --bit-depth, or write 16 or 32"));
            }
            (_, None | Some(BitDepth::Eight)) => false,
            (_, Some(BitDepth::Sixteen)) => {
                return Err(Failure::usage(format!("{format} has 8 bits per channel; only PNG and EXR have 16")));
            }
            (_, Some(BitDepth::ThirtyTwo)) => {
                return Err(Failure::usage(format!("{format} has no 32-bit channels; only EXR has")));
            }
        };
        Ok(Self { format, options: encode_options(options, is_float), is_float })
    }

    /// For a picture that is not written: linear floats, or bytes.
    pub(crate) fn in_memory(is_float: bool) -> Self {
        let format = if is_float { Format::Exr } else { Format::Png };
        Self { format, options: EncodeOptions::default(), is_float }
    }

    /// Whether the file holds linear floats or 16-bit numbers made of them.
    pub(crate) fn is_float(&self) -> bool {
        self.is_float
    }

    /// The images that a frame must make: bytes for the file, floats for the file, bytes for the hash of a report.
    pub(crate) fn outputs(&self, has_report: bool) -> Outputs {
        Outputs { color: !self.is_float || has_report, color_f32: self.is_float, ..Outputs::NONE }
    }

    /// The file of a picture made with [`outputs`](Self::outputs).
    pub(crate) fn encode(&self, picture: &Images) -> Result<Vec<u8>, Failure> {
        let image: ImageRef<'_> = match (&picture.floats, &picture.bytes) {
            (Some(floats), _) if self.is_float => floats.into(),
            (_, Some(bytes)) => bytes.into(),
            _ => return Err(Failure::work("the picture was not drawn")),
        };
        encode(image, self.format, &self.options).map_err(|error| Failure::work(error.to_string()))
    }
}

/// The colour images of a frame.
#[derive(Debug, Default)]
pub(crate) struct Images {
    /// 8-bit sRGB, straight alpha.
    pub(crate) bytes: Option<Rgba8Image>,
    /// Linear, premultiplied.
    pub(crate) floats: Option<RgbaF32Image>,
}

impl Images {
    /// Takes the colour images out of a picture.
    pub(crate) fn take(picture: &mut Picture) -> Self {
        fn parts<T: Copy>(plane: Plane<T>) -> (u32, u32, Vec<T>) {
            (plane.width(), plane.height(), plane.into_values())
        }
        let bytes = picture.color.take().map(parts);
        let floats = picture.color_f32.take().map(parts);
        Self {
            bytes: bytes.and_then(|(width, height, pixels)| Rgba8Image::from_pixels(width, height, pixels).ok()),
            floats: floats.and_then(|(width, height, pixels)| RgbaF32Image::from_pixels(width, height, pixels).ok()),
        }
    }
}

fn encode_options(options: &OutputOptions, is_float: bool) -> EncodeOptions {
    let mut encode_options = EncodeOptions::default();
    encode_options.jpeg_quality = options.quality;
    encode_options.effort = match options.compression {
        Compression::Fast => Effort::Fast,
        Compression::Balanced => Effort::Balanced,
        Compression::Best => Effort::Best,
    };
    if is_float {
        encode_options.depth = trigon_image::encode::BitDepth::Sixteen;
    }
    if options.bit_depth == Some(BitDepth::ThirtyTwo) {
        encode_options.exr_sample = ExrSample::F32;
    }
    encode_options
}

fn by_extension(path: &Path) -> Result<Format, Failure> {
    match path.extension() {
        Some(extension) => writable(Format::from_path(path), &extension.to_string_lossy()),
        None => Err(Failure::usage(format!(
            "the name {} does not tell the format; end it in .png, or use --format",
            path.display()
        ))),
    }
}

fn writable(format: Option<Format>, name: &str) -> Result<Format, Failure> {
    let names = Format::all().filter(|format| format.is_writable()).map(Format::extension).collect::<Vec<_>>();
    match format {
        Some(format) if format.is_writable() => Ok(format),
        Some(format) => Err(Failure::usage(format!("{format} is only read; write {}", names.join(", ")))),
        None => Err(Failure::usage(match closest(name, names.iter().copied()) {
            Some(close) => format!("\"{name}\" is no picture format; did you mean {close}?"),
            None => format!("\"{name}\" is no picture format; write {}", names.join(", ")),
        })),
    }
}
