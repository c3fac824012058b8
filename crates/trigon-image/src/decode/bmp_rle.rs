//! The run-length coding of BMP files: packets to palette indices.
//!
//! A packet is two bytes. A count and a value make a run; with a count of 0 the value is a command: end of line, end of
//! picture, a move right and up, or so many literal indices. Indices that no packet reaches are 0.
//!
//! Source: Microsoft, "Bitmap Compression", Windows GDI reference.

use super::reader::Reader;
use crate::DecodeError;

/// Indices in file order, bottom row first. `bits` is 4 or 8; `count` is `width * height`.
pub(super) fn read_indices(
    reader: &mut Reader<'_>,
    bits: u8,
    width: u32,
    height: u32,
    count: usize,
) -> Result<Vec<u8>, DecodeError> {
    let mut canvas = Canvas { indices: vec![0; count], width: width as usize, height: height as usize, x: 0, y: 0 };
    loop {
        let offset = reader.offset();
        let [first, second] = reader.array("run-length packets")?;
        let is_inside = match (first, second) {
            (0, 0) => {
                (canvas.x, canvas.y) = (0, canvas.y + 1);
                true
            }
            (0, 1) => return Ok(canvas.indices),
            (0, 2) => {
                let [right, up] = reader.array("run-length packets")?;
                canvas.x += usize::from(right);
                canvas.y += usize::from(up);
                canvas.x <= canvas.width && canvas.y <= canvas.height
            }
            (0, length) => {
                // Literal indices are padded to a multiple of two bytes.
                let byte_count = (usize::from(length) * usize::from(bits)).div_ceil(8);
                let bytes = reader.take(byte_count.next_multiple_of(2), "run-length packets")?;
                canvas.put((0..usize::from(length)).map(|i| match bits {
                    8 => bytes[i],
                    _ if i % 2 == 0 => bytes[i / 2] >> 4,
                    _ => bytes[i / 2] & 0xf,
                }))
            }
            (length, value) => canvas.put((0..usize::from(length)).map(|i| match bits {
                8 => value,
                // Two indices take turns.
                _ if i % 2 == 0 => value >> 4,
                _ => value & 0xf,
            })),
        };
        if !is_inside {
            return Err(DecodeError::malformed(
                crate::Format::Bmp,
                offset,
                "run-length packets stay inside the picture",
            ));
        }
    }
}

/// The indices, and where the next one goes.
struct Canvas {
    indices: Vec<u8>,
    width: usize,
    height: usize,
    x: usize,
    y: usize,
}

impl Canvas {
    /// Puts indices from the current place to the right; `false` if they do not fit in the row.
    fn put(&mut self, indices: impl ExactSizeIterator<Item = u8>) -> bool {
        let length = indices.len();
        if self.y >= self.height || length > self.width - self.x.min(self.width) {
            return false;
        }
        let start = self.y * self.width + self.x;
        self.indices[start..start + length].iter_mut().zip(indices).for_each(|(place, index)| *place = index);
        self.x += length;
        true
    }
}
