//! The compressions of OpenEXR blocks: none, RLE, ZIPS, ZIP and PXR24 are undone; PIZ, B44 and DWA are not read.
//!
//! RLE and ZIP pack bytes that were split into even and odd ones and replaced by differences. PXR24 packs the
//! differences of neighbouring numbers, byte by byte from the highest, with `f32` rounded to 24 bits. A block that would
//! not shrink is stored raw.
//!
//! Source: "OpenEXR File Layout", section "Data Compression", and `ImfRle.cpp`, `ImfZip.cpp`, `ImfPxr24Compressor.cpp`
//! of the OpenEXR library for the order of bytes.

use std::io::Read;

use flate2::read::ZlibDecoder;

use super::exr_header::{Channel, SampleType};
use crate::{DecodeError, Format};

/// How blocks are packed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Compression {
    None,
    Rle,
    /// One line a block.
    Zips,
    /// Sixteen lines a block.
    Zip,
    Pxr24,
}

impl Compression {
    /// By the number in the header.
    pub(super) fn of(code: u8) -> Result<Self, DecodeError> {
        let name = match code {
            0 => return Ok(Self::None),
            1 => return Ok(Self::Rle),
            2 => return Ok(Self::Zips),
            3 => return Ok(Self::Zip),
            5 => return Ok(Self::Pxr24),
            4 => "PIZ",
            6 => "B44",
            7 => "B44A",
            8 => "DWAA",
            9 => "DWAB",
            _ => {
                return Err(DecodeError::malformed_somewhere(
                    Format::Exr,
                    format!("the compression is 0 to 9, not {code}"),
                ));
            }
        };
        Err(DecodeError::unsupported(Format::Exr, format!("{name} compression; save the file with ZIP compression")))
    }

    pub(super) fn lines_per_block(self) -> u32 {
        match self {
            Self::None | Self::Rle | Self::Zips => 1,
            Self::Zip | Self::Pxr24 => 16,
        }
    }
}

/// What a block holds.
pub(super) struct Shape<'a> {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) channels: &'a [Channel],
    pub(super) raw_length: usize,
}

/// The raw bytes of a block, exactly `raw_length`; else the rule that the block breaks.
pub(super) fn unpack(compression: Compression, packed: &[u8], shape: &Shape<'_>) -> Result<Vec<u8>, &'static str> {
    if compression == Compression::None || packed.len() == shape.raw_length {
        return if packed.len() == shape.raw_length {
            Ok(packed.to_vec())
        } else {
            Err("a block has the length of its lines")
        };
    }
    match compression {
        Compression::None => Err("a block has the length of its lines"),
        Compression::Rle => undo_runs(packed, shape.raw_length).map(undo_difference_and_split),
        Compression::Zips | Compression::Zip => inflate(packed, shape.raw_length).map(undo_difference_and_split),
        Compression::Pxr24 => undo_pxr24(packed, shape),
    }
}

fn inflate(packed: &[u8], length: usize) -> Result<Vec<u8>, &'static str> {
    // Grows as bytes come, so that memory follows the file and not its claims.
    let mut bytes = Vec::new();
    let most = length as u64 + 1;
    ZlibDecoder::new(packed).take(most).read_to_end(&mut bytes).map_err(|_| "a block is a valid zlib stream")?;
    if bytes.len() == length { Ok(bytes) } else { Err("a block unpacks to the length of its lines") }
}

/// A count below 0 and as many literal bytes, or a count from 0 and a byte to repeat once more than that.
fn undo_runs(packed: &[u8], length: usize) -> Result<Vec<u8>, &'static str> {
    let mut bytes = Vec::new();
    let mut rest = packed;
    while let Some((&count, after)) = rest.split_first() {
        let count = count.cast_signed();
        if count < 0 {
            let literals = usize::from(count.unsigned_abs());
            let (taken, after) = after.split_at_checked(literals).ok_or("a run-length packet is whole")?;
            bytes.extend_from_slice(taken);
            rest = after;
        } else {
            let (&value, after) = after.split_first().ok_or("a run-length packet is whole")?;
            bytes.resize(bytes.len() + usize::from(count.unsigned_abs()) + 1, value);
            rest = after;
        }
        if bytes.len() > length {
            break;
        }
    }
    if bytes.len() == length { Ok(bytes) } else { Err("a block unpacks to the length of its lines") }
}

/// Sums up the differences (less 128), then interleaves the first half of the bytes with the second.
fn undo_difference_and_split(mut bytes: Vec<u8>) -> Vec<u8> {
    for i in 1..bytes.len() {
        bytes[i] = bytes[i].wrapping_add(bytes[i - 1]).wrapping_sub(128);
    }
    let (even, odd) = bytes.split_at(bytes.len().div_ceil(2));
    let mut raw = Vec::with_capacity(bytes.len());
    for (i, &byte) in even.iter().enumerate() {
        raw.push(byte);
        raw.extend(odd.get(i));
    }
    raw
}

/// Bytes that PXR24 keeps of a sample.
fn pxr24_bytes(sample_type: SampleType) -> usize {
    match sample_type {
        SampleType::U32 => 4,
        SampleType::F16 => 2,
        SampleType::F32 => 3,
    }
}

fn undo_pxr24(packed: &[u8], shape: &Shape<'_>) -> Result<Vec<u8>, &'static str> {
    let pixel_bytes: usize = shape.channels.iter().map(|channel| pxr24_bytes(channel.sample_type)).sum();
    let planes = inflate(packed, shape.width * shape.height * pixel_bytes)?;
    let mut rest = planes.as_slice();
    let mut raw = Vec::with_capacity(shape.raw_length);
    for _ in 0..shape.height {
        for channel in shape.channels {
            // The highest bytes of all samples of the line, then the next, to the lowest.
            let kept = pxr24_bytes(channel.sample_type);
            let (line, after) = rest.split_at(shape.width * kept);
            rest = after;
            let mut sample = 0_u32;
            for x in 0..shape.width {
                let difference = (0..kept).fold(0, |bits, plane| bits << 8 | u32::from(line[plane * shape.width + x]));
                match channel.sample_type {
                    SampleType::F32 => sample = sample.wrapping_add(difference << 8),
                    _ => sample = sample.wrapping_add(difference),
                }
                raw.extend_from_slice(&sample.to_le_bytes()[..channel.sample_type.bytes()]);
            }
        }
    }
    Ok(raw)
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use flate2::Compression as Level;
    use flate2::write::ZlibEncoder;

    use super::*;

    fn deflate(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = ZlibEncoder::new(Vec::new(), Level::best());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    fn channel(sample_type: SampleType) -> Channel {
        Channel { name: "Y".into(), sample_type }
    }

    #[test]
    fn differences_and_the_split_are_undone() {
        // Even bytes 10, 12, 14, then odd bytes 11, 13: each as the difference to the one before, plus 128.
        assert_eq!(undo_difference_and_split(vec![10, 130, 130, 125, 130]), [10, 11, 12, 13, 14]);
        assert_eq!(undo_difference_and_split(Vec::new()), []);
    }

    #[test]
    fn runs_are_undone() {
        let packed = [(-3_i8).cast_unsigned(), 1, 2, 3, 4, 9];
        assert_eq!(undo_runs(&packed, 8).unwrap(), [1, 2, 3, 9, 9, 9, 9, 9]);
        for (packed, length) in [(&packed[..5], 8), (&packed[..3], 8), (&packed[..], 7), (&packed[..], 9), (&[][..], 1)]
        {
            assert!(undo_runs(packed, length).is_err(), "{packed:?} to {length} bytes");
        }
    }

    #[test]
    fn blocks_of_the_wrong_length_are_refused() {
        let channels = [channel(SampleType::F16)];
        let shape = Shape { width: 50, height: 1, channels: &channels, raw_length: 100 };
        for compression in [Compression::Zip, Compression::Zips] {
            assert_eq!(unpack(compression, &deflate(&[0; 100]), &shape).unwrap().len(), 100);
            for length in [0, 99, 101, 100_000] {
                assert!(unpack(compression, &deflate(&vec![0; length]), &shape).is_err());
            }
            assert!(unpack(compression, &[1, 2, 3], &shape).is_err());
        }
        assert!(unpack(Compression::None, &[0; 99], &shape).is_err());
        // What would not shrink is stored raw, whatever the compression.
        for compression in [Compression::None, Compression::Rle, Compression::Zip, Compression::Pxr24] {
            assert_eq!(unpack(compression, &[7; 100], &shape).unwrap(), [7; 100]);
        }
    }

    #[test]
    fn pxr24_sums_up_differences_of_numbers() {
        for (sample_type, planes, expected) in [
            // 0x3c00, then 1 more, then 0x0101 less.
            (SampleType::F16, &[0x3c, 0x00, 0xfe, 0x00, 0x01, 0xff][..], vec![0x3c00_u32, 0x3c01, 0x3b00]),
            (SampleType::U32, &[0, 0, 0, 0, 1, 0, 0, 0, 0, 5, 1, 0], vec![5, 0x0001_0006, 0x0001_0006]),
            // The highest three bytes of each.
            (SampleType::F32, &[0x3f, 0, 0, 0x80, 0, 0, 0, 1, 0], vec![0x3f80_0000, 0x3f80_0100, 0x3f80_0100]),
        ] {
            let bytes = sample_type.bytes();
            let channels = [channel(sample_type)];
            let shape = Shape { width: 3, height: 1, channels: &channels, raw_length: 3 * bytes };
            let raw = undo_pxr24(&deflate(planes), &shape).unwrap();
            let expected: Vec<u8> = expected.iter().flat_map(|x| x.to_le_bytes()[..bytes].to_vec()).collect();
            assert_eq!(raw, expected, "{sample_type:?}");
        }
    }
}
