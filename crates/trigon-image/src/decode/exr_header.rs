//! The header of an OpenEXR file: which channels, which window, which blocks.
//!
//! Source: "OpenEXR File Layout", section "Header", openexr.com.

use super::exr_block::Compression;
use super::reader::Reader;
use crate::{DecodeError, Format};

/// What a decoder needs of the header, checked.
pub(super) struct Header {
    /// In file order, sorted by name.
    pub(super) channels: Vec<Channel>,
    pub(super) compression: Compression,
    pub(super) width: u32,
    pub(super) height: u32,
    /// The number of the first line.
    pub(super) y_min: i32,
    /// `None` for scan lines.
    pub(super) tile_size: Option<(u32, u32)>,
}

/// A named channel with one sample a pixel.
pub(super) struct Channel {
    pub(super) name: String,
    pub(super) sample_type: SampleType,
}

/// How a sample is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SampleType {
    U32,
    F16,
    F32,
}

impl SampleType {
    pub(super) fn bytes(self) -> usize {
        match self {
            Self::F16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }
}

const VERSION_MASK: u32 = 0xff;
const TILED: u32 = 0x200;
const DEEP: u32 = 0x800;
const MULTI_PART: u32 = 0x1000;

impl Header {
    pub(super) fn read(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let unsupported = |feature: &'static str| Err(DecodeError::unsupported(Format::Exr, feature));
        if reader.array("header")? != [0x76, 0x2f, 0x31, 0x01] {
            return Err(DecodeError::malformed(Format::Exr, 0, "the file begins with its magic number"));
        }
        let flags = reader.u32_le("header")?;
        if flags & VERSION_MASK != 2 {
            return unsupported("a version other than 2");
        }
        if flags & (DEEP | MULTI_PART) != 0 {
            return unsupported("several parts or deep pixels");
        }
        let mut attributes = Attributes::default();
        attributes.read(reader)?;
        let missing = |name: &str| reader.malformed(format!("the header has the attribute {name}"));
        let [x_min, y_min, x_max, y_max] = attributes.data_window.ok_or_else(|| missing("dataWindow"))?;
        let side = |min: i32, max: i32| u32::try_from(i64::from(max) - i64::from(min) + 1).unwrap_or(0);
        let (width, height) = (side(x_min, x_max), side(y_min, y_max));
        if width == 0 || height == 0 {
            return Err(reader.malformed("the data window holds at least one pixel"));
        }
        let tile_size = match (flags & TILED != 0, attributes.tile_size) {
            (false, _) => None,
            (true, Some(size)) => Some(size),
            (true, None) => return Err(missing("tiles")),
        };
        Ok(Self {
            channels: attributes.channels.ok_or_else(|| missing("channels"))?,
            compression: attributes.compression.ok_or_else(|| missing("compression"))?,
            width,
            height,
            y_min,
            tile_size,
        })
    }
}

/// Attributes come in any order.
#[derive(Default)]
struct Attributes {
    channels: Option<Vec<Channel>>,
    compression: Option<Compression>,
    data_window: Option<[i32; 4]>,
    tile_size: Option<(u32, u32)>,
}

impl Attributes {
    /// Reads name, type, length and value of each, up to the empty name.
    fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), DecodeError> {
        loop {
            let name = reader.until_nul("header")?;
            if name.is_empty() {
                return Ok(());
            }
            reader.until_nul("header")?;
            let length = reader.u32_le("header")? as usize;
            let start = reader.offset();
            match name {
                b"channels" => self.channels = Some(read_channels(reader)?),
                b"compression" => self.compression = Some(Compression::of(reader.u8("header")?)?),
                b"dataWindow" => {
                    let mut next = || reader.u32_le("header").map(u32::cast_signed);
                    self.data_window = Some([next()?, next()?, next()?, next()?]);
                }
                b"tiles" => {
                    let size = (reader.u32_le("header")?, reader.u32_le("header")?);
                    if size.0 == 0 || size.1 == 0 {
                        return Err(reader.malformed("tiles are at least one pixel wide and high"));
                    }
                    self.tile_size = Some(size);
                }
                _ => {}
            }
            reader.seek(start.saturating_add(length), "header")?;
        }
    }
}

fn read_channels(reader: &mut Reader<'_>) -> Result<Vec<Channel>, DecodeError> {
    let mut channels = Vec::new();
    loop {
        let name = reader.until_nul("channel list")?;
        if name.is_empty() {
            return Ok(channels);
        }
        let name = String::from_utf8_lossy(name).into_owned();
        let sample_type = match reader.u32_le("channel list")? {
            0 => SampleType::U32,
            1 => SampleType::F16,
            2 => SampleType::F32,
            other => return Err(reader.malformed(format!("the type of a channel is 0, 1 or 2, not {other}"))),
        };
        reader.take(4, "channel list")?;
        let sampling = [reader.u32_le("channel list")?, reader.u32_le("channel list")?];
        if sampling != [1, 1] {
            return Err(DecodeError::unsupported(
                Format::Exr,
                format!("channel {name} without a sample at every pixel"),
            ));
        }
        channels.push(Channel { name, sample_type });
    }
}
