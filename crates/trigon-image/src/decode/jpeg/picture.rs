//! The way through a JPEG file: its segments in order, scan by scan, and at the end the pixels.
//!
//! A file that breaks off is an error: nothing is made up for what it lacks.

use super::color::Color;
use super::header::{Component, Frame, Tables};
use super::huffman::{BitReader, find_marker};
use super::scan::{draw_coefficients, read_scan};
use super::upsample::Upsampling;
use crate::decode::DecodedImage;
use crate::decode::reader::Reader;
use crate::{DecodeError, Format, Limits, Rgba8Image};

/// More scans than programs write, which is about ten. Each costs time for every block, however short it is.
const MOST_SCANS: usize = 100;

pub(in crate::decode) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    if !bytes.starts_with(&[0xff, 0xd8]) {
        return Err(DecodeError::malformed(Format::Jpeg, 0, "the file begins with a start-of-image marker"));
    }
    let mut file = File { bytes, offset: 2, ..File::default() };
    loop {
        let (offset, marker) = find_marker(bytes, file.offset).ok_or_else(|| cut_off(bytes))?;
        file.offset = offset + 2;
        match marker {
            // Markers without content: restarts that are left over, and the start of the image.
            0x01 | 0xd0..=0xd8 => {}
            0xd9 => return file.finish(),
            _ => file.read_segment(marker, limits)?,
        }
    }
}

/// What has been read so far.
#[derive(Default)]
struct File<'a> {
    bytes: &'a [u8],
    /// Of what comes next.
    offset: usize,
    tables: Tables,
    frame: Option<Frame>,
    scans: usize,
    has_jfif: bool,
    /// The transform that an Adobe marker names.
    adobe: Option<u8>,
}

impl File<'_> {
    /// Reads a segment whose content has a length in front; after a scan's header also its data.
    fn read_segment(&mut self, marker: u8, limits: &Limits) -> Result<(), DecodeError> {
        let length = match self.bytes.get(self.offset..) {
            Some([high, low, ..]) => usize::from(u16::from_be_bytes([*high, *low])).max(2),
            _ => return Err(cut_off(self.bytes)),
        };
        let end = self.offset + length;
        // Offsets in messages count from the start of the file.
        let mut segment = Reader::new(Format::Jpeg, self.bytes.get(..end).ok_or_else(|| cut_off(self.bytes))?);
        segment.seek(self.offset + 2, "segment")?;
        self.offset = end;
        match marker {
            0xc0..=0xc2 => {
                if self.frame.is_some() {
                    return Err(segment.malformed("there is one frame header"));
                }
                self.frame = Some(Frame::read(&mut segment, marker == 0xc2, limits)?);
            }
            0xc3 | 0xc5..=0xc7 | 0xc9..=0xcb | 0xcd..=0xcf => {
                let feature = "lossless, hierarchical or arithmetic coding; write it as baseline or progressive";
                return Err(DecodeError::unsupported(Format::Jpeg, feature));
            }
            0xc4 => self.tables.read_codes(&mut segment)?,
            0xda => self.read_scan(&mut segment)?,
            0xdb => self.tables.read_quantizers(&mut segment)?,
            0xdd => {
                let interval = u16::from_be_bytes(segment.array("restart interval")?);
                self.tables.restart_interval = usize::from(interval);
            }
            0xe0 => self.has_jfif |= segment.rest().starts_with(b"JFIF\0"),
            0xee => {
                if let Some([transform, ..]) = segment.rest().strip_prefix(b"Adobe").and_then(|rest| rest.get(6..)) {
                    self.adobe = Some(*transform);
                }
            }
            // Metadata, comments and what is not known.
            _ => {}
        }
        Ok(())
    }

    fn read_scan(&mut self, segment: &mut Reader<'_>) -> Result<(), DecodeError> {
        self.scans += 1;
        let Some(frame) = self.frame.as_mut() else {
            return Err(segment.malformed("a scan comes after the frame header"));
        };
        if self.scans > MOST_SCANS {
            return Err(DecodeError::unsupported(Format::Jpeg, format!("more than {MOST_SCANS} scans")));
        }
        let scan = self.tables.read_scan(segment, frame)?;
        let mut bits = BitReader::new(self.bytes, self.offset);
        read_scan(&mut bits, &scan, frame, self.tables.restart_interval)?;
        // What is read ahead are no markers.
        self.offset = bits.offset();
        Ok(())
    }

    /// The pixels, once all scans are read.
    fn finish(mut self) -> Result<DecodedImage, DecodeError> {
        let malformed = |rule| DecodeError::malformed(Format::Jpeg, self.offset, rule);
        let frame = self.frame.as_mut().ok_or_else(|| malformed("there is no frame header"))?;
        if frame.components.iter().any(|component| component.quantizers.is_none()) {
            return Err(malformed("a component has no scan"));
        }
        frame.components.iter_mut().for_each(draw_coefficients);
        let ids: Vec<u8> = frame.components.iter().map(|component| component.id).collect();
        let pixels = pixels(frame, Color::new(&ids, self.has_jfif, self.adobe));
        let (width, height) = (u32::try_from(frame.width), u32::try_from(frame.height));
        Rgba8Image::from_pixels(width.unwrap_or(0), height.unwrap_or(0), pixels)
            .map(DecodedImage::Rgba8)
            .map_err(|error| DecodeError::malformed_somewhere(Format::Jpeg, error.to_string()))
    }
}

fn pixels(frame: &Frame, color: Color) -> Vec<[u8; 4]> {
    let mut pixels = Vec::with_capacity(frame.width * frame.height);
    let upsampling =
        |component: &Component| Upsampling::new(component.plane.width, component.expansion.0, component.expansion.1);
    let upsamplings: Vec<Upsampling> = frame.components.iter().map(upsampling).collect();
    let mut rows = vec![Vec::new(); frame.components.len()];
    for y in 0..frame.height {
        for ((upsampling, component), row) in upsamplings.iter().zip(&frame.components).zip(&mut rows) {
            upsampling.write_row(&component.plane, y, row);
        }
        color.append(&rows, frame.width, &mut pixels);
    }
    pixels
}

fn cut_off(bytes: &[u8]) -> DecodeError {
    DecodeError::malformed(Format::Jpeg, bytes.len(), "the file ends before the end-of-image marker")
}
