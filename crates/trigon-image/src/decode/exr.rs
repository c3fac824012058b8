//! OpenEXR files to linear pixels: one part, scan lines or tiles, `f16`, `f32` and `u32` channels.
//!
//! The header tells the channels, the window and the blocks; the table behind it, where each block lies. Blocks are
//! undone by [`exr_block`](super::exr_block), and the samples of R, G, B, A (or of luminance, Y) put in their place. EXR
//! colour is linear and premultiplied, as is [`RgbaF32Image`].
//!
//! Source: "OpenEXR File Layout", openexr.com.

use super::DecodedImage;
use super::exr_block;
use super::exr_header::{Channel, Header, SampleType};
use super::reader::Reader;
use crate::half::f16_to_f32;
use crate::{DecodeError, Format, Limits, RgbaF32Image};

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut reader = Reader::new(Format::Exr, bytes);
    let header = Header::read(&mut reader)?;
    limits.check(header.width, header.height, 16)?;
    let roles = Roles::find(&header.channels)?;
    let (block_width, block_height) = header.block_size();
    let (blocks_across, blocks_down) = (header.width.div_ceil(block_width), header.height.div_ceil(block_height));
    let block_count = u64::from(blocks_across) * u64::from(blocks_down);
    if (reader.rest().len() as u64) < block_count * 8 {
        return Err(reader.malformed("the table of block offsets fits in the file"));
    }

    let mut image = RgbaF32Image::filled(header.width, header.height, [0.0, 0.0, 0.0, 1.0]);
    for row in 0..blocks_down {
        for column in 0..blocks_across {
            let offset = usize::try_from(reader.u64_le("table of block offsets")?).unwrap_or(usize::MAX);
            let mut block_reader = Reader::new(Format::Exr, bytes);
            block_reader.seek(offset, "blocks")?;
            let block = Block {
                x: column * block_width,
                y: row * block_height,
                width: block_width.min(header.width - column * block_width),
                height: block_height.min(header.height - row * block_height),
            };
            block.check_place(&header, &mut block_reader, column, row)?;
            let samples = block.read_samples(&header, &mut block_reader, limits)?;
            block.put(&header.channels, &roles, &samples, &mut image);
        }
    }
    Ok(DecodedImage::RgbaF32(image))
}

/// Which channel of the file feeds red, green, blue and alpha.
struct Roles([Option<usize>; 4]);

impl Roles {
    /// Takes `R G B A`, else `Y A`, of the picture itself if it has them, else of the first layer that has.
    fn find(channels: &[Channel]) -> Result<Self, DecodeError> {
        let with_name = |name: &str| channels.iter().position(|channel| channel.name == name);
        let layer_of = |letter: &str| {
            let ends_so =
                |channel: &&Channel| channel.name.strip_suffix(letter).is_some_and(|layer| layer.ends_with('.'));
            channels.iter().find(ends_so).map(|channel| &channel.name[..channel.name.len() - letter.len()])
        };
        let layers = [Some(""), layer_of("R"), layer_of("Y")];
        for layer in layers.into_iter().flatten() {
            let role = |letter: &str| with_name(&format!("{layer}{letter}"));
            if let (Some(r), Some(g), Some(b)) = (role("R"), role("G"), role("B")) {
                return Ok(Self([Some(r), Some(g), Some(b), role("A")]));
            }
            if let Some(y) = role("Y") {
                return Ok(Self([Some(y), Some(y), Some(y), role("A")]));
            }
        }
        let names: Vec<&str> = channels.iter().map(|channel| channel.name.as_str()).collect();
        let feature = format!("a picture without R, G, B or Y channels; it has {}", names.join(", "));
        Err(DecodeError::unsupported(Format::Exr, feature))
    }
}

/// The part of the picture that one block of the file holds.
struct Block {
    x: u32,
    y: u32,
    width: u32,
    height: u32,
}

impl Block {
    /// Reads where the block says it belongs, and compares.
    fn check_place(&self, header: &Header, reader: &mut Reader<'_>, column: u32, row: u32) -> Result<(), DecodeError> {
        let is_here = if header.tile_size.is_some() {
            let mut next = || reader.u32_le("blocks");
            // Column, row, and the level in each direction.
            [next()?, next()?, next()?, next()?] == [column, row, 0, 0]
        } else {
            i64::from(reader.u32_le("blocks")?.cast_signed()) == i64::from(header.y_min) + i64::from(self.y)
        };
        if is_here { Ok(()) } else { Err(reader.malformed("a block is where the table of offsets says")) }
    }

    /// The raw bytes of the block.
    fn read_samples(&self, header: &Header, reader: &mut Reader<'_>, limits: &Limits) -> Result<Vec<u8>, DecodeError> {
        let offset = reader.offset();
        let length = reader.u32_le("blocks")? as usize;
        let packed = reader.take(length, "blocks")?;
        let pixel_bytes: u64 = header.channels.iter().map(|channel| channel.sample_type.bytes() as u64).sum();
        let raw_length = u64::from(self.width) * u64::from(self.height) * pixel_bytes;
        if raw_length > limits.max_bytes {
            return Err(DecodeError::LimitExceeded {
                limit: "max_bytes",
                asked: raw_length,
                allowed: limits.max_bytes,
            });
        }
        let shape = exr_block::Shape {
            width: self.width as usize,
            height: self.height as usize,
            channels: &header.channels,
            raw_length: usize::try_from(raw_length).unwrap_or(usize::MAX),
        };
        exr_block::unpack(header.compression, packed, &shape)
            .map_err(|rule| DecodeError::malformed(Format::Exr, offset, rule))
    }

    /// Each line holds each channel's samples in turn.
    fn put(&self, channels: &[Channel], roles: &Roles, samples: &[u8], image: &mut RgbaF32Image) {
        let width = self.width as usize;
        let mut rest = samples;
        for y in self.y..self.y + self.height {
            let row = &mut image.row_mut(y)[self.x as usize..][..width];
            for (index, channel) in channels.iter().enumerate() {
                let (line, after) = rest.split_at(width * channel.sample_type.bytes());
                rest = after;
                for (slot, _) in roles.0.iter().enumerate().filter(|(_, role)| **role == Some(index)) {
                    channel.sample_type.read_line(line, |x, value| row[x][slot] = value);
                }
            }
        }
    }
}

impl SampleType {
    /// Calls `put` with the place and value of each sample of a line.
    fn read_line(self, line: &[u8], mut put: impl FnMut(usize, f32)) {
        match self {
            Self::F16 => {
                line.as_chunks().0.iter().enumerate().for_each(|(x, &b)| put(x, f16_to_f32(u16::from_le_bytes(b))));
            }
            Self::F32 => line.as_chunks().0.iter().enumerate().for_each(|(x, &b)| put(x, f32::from_le_bytes(b))),
            // The nearest float: there is no larger unit for integers.
            Self::U32 => line.as_chunks().0.iter().enumerate().for_each(|(x, &b)| put(x, u32::from_le_bytes(b) as f32)),
        }
    }
}

impl Header {
    /// Width and height of a full block.
    fn block_size(&self) -> (u32, u32) {
        self.tile_size.unwrap_or((self.width, self.compression.lines_per_block()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file with one `f32` channel Y and uncompressed blocks.
    struct Exr {
        flags: u32,
        window: [i32; 4],
        tile_size: Option<(u32, u32)>,
        /// What each block says of its place, and its samples.
        blocks: Vec<(Vec<i32>, Vec<f32>)>,
    }

    impl Exr {
        fn bytes(&self) -> Vec<u8> {
            let mut file = vec![0x76, 0x2f, 0x31, 0x01];
            file.extend(self.flags.to_le_bytes());
            let mut attribute = |name: &str, value: &[u8]| {
                file.extend(name.bytes().chain(*b"\0any\0"));
                file.extend(u32::try_from(value.len()).unwrap().to_le_bytes());
                file.extend(value);
            };
            attribute("compression", &[0]);
            attribute("channels", b"Y\0\x02\0\0\0\0\0\0\0\x01\0\0\0\x01\0\0\0\0");
            attribute("comment", b"passed over");
            attribute("dataWindow", &self.window.map(i32::to_le_bytes).concat());
            if let Some((width, height)) = self.tile_size {
                attribute("tiles", &[&width.to_le_bytes()[..], &height.to_le_bytes(), &[0]].concat());
            }
            file.push(0);
            let table = file.len();
            file.resize(table + self.blocks.len() * 8, 0);
            for (i, (place, samples)) in self.blocks.iter().enumerate() {
                let offset = file.len() as u64;
                file[table + i * 8..][..8].copy_from_slice(&offset.to_le_bytes());
                file.extend(place.iter().flat_map(|number| number.to_le_bytes()));
                file.extend(u32::try_from(samples.len() * 4).unwrap().to_le_bytes());
                file.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
            }
            file
        }

        fn numbers(&self) -> Vec<f32> {
            let image = decode(&self.bytes(), &Limits::default()).unwrap().into_linear();
            image.pixels().iter().map(|&[r, g, b, a]| if r == g && g == b && a == 1.0 { r } else { f32::NAN }).collect()
        }

        fn error(&self) -> String {
            decode(&self.bytes(), &Limits::default()).unwrap_err().to_string()
        }
    }

    /// Three columns and two lines from line -5 on.
    fn scan_lines() -> Exr {
        let blocks = vec![(vec![-5], vec![1.0, 2.0, 3.0]), (vec![-4], vec![4.0, 5.0, 6.0])];
        Exr { flags: 2, window: [10, -5, 12, -4], tile_size: None, blocks }
    }

    /// The same picture in tiles of two by one.
    fn tiles() -> Exr {
        let places = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| vec![x, y, 0, 0]);
        let samples = [vec![1.0, 2.0], vec![3.0], vec![4.0, 5.0], vec![6.0]];
        Exr {
            flags: 2 | 0x200,
            tile_size: Some((2, 1)),
            blocks: places.into_iter().zip(samples).collect(),
            ..scan_lines()
        }
    }

    #[test]
    fn scan_lines_and_tiles_give_the_same_picture() {
        assert_eq!(scan_lines().numbers(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(tiles().numbers(), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    }

    #[test]
    fn bad_headers_and_blocks_say_which_rule_they_break() {
        let wrong_place = |mut exr: Exr| {
            exr.blocks[1].0[0] += 7;
            exr
        };
        let short = |mut exr: Exr| {
            exr.blocks[1].1.pop();
            exr
        };
        for (exr, part) in [
            (Exr { flags: 1, ..scan_lines() }, "unsupported EXR: a version other than 2"),
            (Exr { flags: 2 | 0x1000, ..scan_lines() }, "several parts"),
            (Exr { window: [1, 0, 0, 5], ..scan_lines() }, "at least one pixel"),
            (Exr { window: [i32::MIN, 0, i32::MAX, 0], ..scan_lines() }, "at least one pixel"),
            (Exr { window: [0, 0, 40000, 0], ..scan_lines() }, "max_width of 40001"),
            (Exr { window: [0, 0, 2, 9000], ..scan_lines() }, "table of block offsets"),
            (Exr { tile_size: None, ..tiles() }, "attribute tiles"),
            (Exr { tile_size: Some((0, 1)), ..tiles() }, "at least one pixel wide"),
            (wrong_place(scan_lines()), "where the table of offsets says"),
            (wrong_place(tiles()), "where the table of offsets says"),
            (short(scan_lines()), "a block has the length of its lines"),
        ] {
            let error = exr.error();
            assert!(error.contains(part), "{error}");
        }
    }
}
