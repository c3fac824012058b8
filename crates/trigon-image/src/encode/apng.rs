//! Animated PNG files of 8 bits and four channels.
//!
//! Each frame's changed rectangle is compressed as a PNG file of its own, whose data chunks are then moved into the
//! animation. The number of frames stands at the front and is filled in at the end.
//!
//! Source: Portable Network Graphics (PNG) Specification, third edition (W3C, 2025), section 11.3.6, animation chunks.

use std::time::Duration;

use flate2::Crc;

use super::EncodeOptions;
use super::animation::{FrameClock, Rectangle};
use crate::{EncodeError, Format, Rgba8Image};

/// Writes frames to an APNG file in memory.
#[derive(Debug)]
pub(super) struct ApngWriter {
    width: u32,
    height: u32,
    options: EncodeOptions,
    clock: FrameClock,
    file: Vec<u8>,
    frame_count: u32,
    /// Frame control and frame data chunks share one count.
    sequence_number: u32,
    shown: Option<Rgba8Image>,
}

const SIGNATURE: &[u8; 8] = b"\x89PNG\r\n\x1a\n";

/// Where the animation control chunk begins: behind the signature and the header chunk.
const CONTROL_OFFSET: usize = 8 + 25;

impl ApngWriter {
    pub(super) fn new(width: u32, height: u32, options: &EncodeOptions) -> Result<Self, EncodeError> {
        if width.max(height) > i32::MAX.unsigned_abs() {
            return Err(EncodeError::unsupported(Format::Png, "pictures are at most 2147483647 pixels wide and high"));
        }
        let mut writer = Self {
            width,
            height,
            options: options.clone(),
            clock: FrameClock::new(Duration::from_millis(1)),
            file: SIGNATURE.to_vec(),
            frame_count: 0,
            sequence_number: 0,
            shown: None,
        };
        // 8 bits, RGBA, and the only methods there are.
        writer.chunk(*b"IHDR", &[&width.to_be_bytes()[..], &height.to_be_bytes(), &[8, 6, 0, 0, 0]]);
        writer.control_chunk();
        // Perceptual intent.
        writer.chunk(*b"sRGB", &[&[0]]);
        Ok(writer)
    }

    pub(super) fn push_frame(&mut self, frame: &Rgba8Image, delay: Duration) -> Result<(), EncodeError> {
        let part = match &self.shown {
            Some(before) => Rectangle::of_changes(before, frame),
            None => Rectangle::all_of(frame),
        };
        let pixels = part.rows(frame).flat_map(|(_, row)| row).copied().collect();
        let part_image = Rgba8Image::from_pixels(part.width, part.height, pixels)
            .map_err(|error| EncodeError::invalid(Format::Png, error.to_string()))?;
        let png = super::png::encode_rgba8(&part_image, self.options.effort)?;
        let delay = self.clock.units(delay);
        self.frame_control_chunk(part, delay);
        for data in data_chunks(&png) {
            // The first frame is the picture that programs without animation show.
            if self.frame_count == 0 {
                self.chunk(*b"IDAT", &[data]);
            } else {
                let number = self.next_sequence_number();
                self.chunk(*b"fdAT", &[&number, data]);
            }
        }
        self.frame_count += 1;
        match &mut self.shown {
            Some(shown) => shown.pixels_mut().copy_from_slice(frame.pixels()),
            None => self.shown = Some(frame.clone()),
        }
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<Vec<u8>, EncodeError> {
        self.chunk(*b"IEND", &[]);
        let mut file = std::mem::take(&mut self.file);
        // Writes the control chunk again, now that the number of frames is known.
        self.control_chunk();
        file[CONTROL_OFFSET..CONTROL_OFFSET + self.file.len()].copy_from_slice(&self.file);
        debug_assert!(self.width > 0 && self.height > 0, "the caller admits no empty pictures");
        Ok(file)
    }

    fn control_chunk(&mut self) {
        let plays = u32::from(self.options.plays);
        self.chunk(*b"acTL", &[&self.frame_count.to_be_bytes(), &plays.to_be_bytes()]);
    }

    /// Where the frame goes and how long it stays; it replaces what was there, alpha included.
    fn frame_control_chunk(&mut self, part: Rectangle, delay_ms: u16) {
        let number = self.next_sequence_number();
        let [width, height, x, y] = [part.width, part.height, part.x, part.y].map(u32::to_be_bytes);
        let (numerator, denominator) = (delay_ms.to_be_bytes(), 1000_u16.to_be_bytes());
        let operations = [0, 0];
        self.chunk(*b"fcTL", &[&number, &width, &height, &x, &y, &numerator, &denominator, &operations]);
    }

    fn next_sequence_number(&mut self) -> [u8; 4] {
        let number = self.sequence_number.to_be_bytes();
        self.sequence_number += 1;
        number
    }

    /// Length, name, content, and the checksum of name and content.
    fn chunk(&mut self, name: [u8; 4], parts: &[&[u8]]) {
        let length = parts.iter().map(|part| part.len()).sum::<usize>();
        self.file.extend(u32::try_from(length).expect("chunks are at most 2 GiB").to_be_bytes());
        let mut crc = Crc::new();
        for part in std::iter::once(&name[..]).chain(parts.iter().copied()) {
            crc.update(part);
            self.file.extend_from_slice(part);
        }
        self.file.extend(crc.sum().to_be_bytes());
    }
}

/// The contents of the IDAT chunks of a PNG file of our own making.
fn data_chunks(png: &[u8]) -> impl Iterator<Item = &[u8]> {
    let mut rest = &png[SIGNATURE.len()..];
    std::iter::from_fn(move || {
        let (length, after) = rest.split_first_chunk::<4>()?;
        let (name, after) = after.split_first_chunk::<4>()?;
        let (content, after) = after.split_at_checked(u32::from_be_bytes(*length) as usize)?;
        rest = after.get(4..)?;
        Some((name, content))
    })
    .filter(|(name, _)| *name == b"IDAT")
    .map(|(_, content)| content)
}
