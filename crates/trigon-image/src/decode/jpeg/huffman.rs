//! Huffman codes: the entropy-coded bytes of a scan in, symbols and runs of bits out.
//!
//! A code of up to nine bits is looked up at once; the few longer ones are found by comparing with the last code of
//! each length (T.81, annexes C and F).

use crate::{DecodeError, Format};

/// Codes of at most this length are looked up.
const LOOKUP_BITS: u32 = 9;
const LONGEST_CODE: usize = 16;
const LONGEST_BITS: u32 = 16;

/// One table of codes.
pub(super) struct HuffmanTable {
    /// For each value of the next [`LOOKUP_BITS`] bits: length of the code and symbol, or length 0 for a longer code.
    lookup: Vec<(u8, u8)>,
    /// For each length: one more than its last code, as the first bits of 16; and the place in `symbols` of code 0.
    lengths: [(u32, i32); LONGEST_CODE + 1],
    symbols: Vec<u8>,
}

impl HuffmanTable {
    /// The table with `counts[n - 1]` codes of length n; `None` if the codes do not fit into their lengths.
    pub(super) fn new(counts: &[u8; LONGEST_CODE], symbols: &[u8]) -> Option<Self> {
        let mut lookup = vec![(0, 0); 1 << LOOKUP_BITS];
        let mut lengths = [(0, 0); LONGEST_CODE + 1];
        let (mut code, mut place) = (0_u32, 0_usize);
        for length in 1..=LONGEST_CODE {
            lengths[length].1 = i32::try_from(place).ok()? - i32::try_from(code).ok()?;
            for _ in 0..counts[length - 1] {
                if code >= 1 << length {
                    return None;
                }
                let symbol = *symbols.get(place)?;
                if let Some(free) = LOOKUP_BITS.checked_sub(u32::try_from(length).ok()?) {
                    let first = (code << free) as usize;
                    lookup[first..first + (1 << free)].fill((u8::try_from(length).ok()?, symbol));
                }
                code += 1;
                place += 1;
            }
            lengths[length].0 = code << (LONGEST_CODE - length);
            code <<= 1;
        }
        Some(Self { lookup, lengths, symbols: symbols.to_vec() })
    }

    /// Length and symbol of the code that the 16 bits `next` begin with.
    #[inline]
    fn find(&self, next: u32) -> Option<(u32, u8)> {
        let (length, symbol) = self.lookup[(next >> (LONGEST_BITS - LOOKUP_BITS)) as usize];
        if length != 0 {
            return Some((u32::from(length), symbol));
        }
        let length = (LOOKUP_BITS as usize + 1..=LONGEST_CODE).find(|&length| next < self.lengths[length].0)?;
        let code = i32::try_from(next >> (LONGEST_CODE - length)).ok()?;
        let place = usize::try_from(code + self.lengths[length].1).ok()?;
        Some((u32::try_from(length).ok()?, *self.symbols.get(place)?))
    }
}

/// Reads the bits of a scan from the first of each byte, up to the next marker.
pub(super) struct BitReader<'a> {
    file: &'a [u8],
    /// Of the next byte that is not in `bits`.
    offset: usize,
    /// What comes next, from the highest bit; behind `count` bits zeros, or the ones after.
    bits: u64,
    count: u32,
}

impl<'a> BitReader<'a> {
    pub(super) fn new(file: &'a [u8], offset: usize) -> Self {
        Self { file, offset, bits: 0, count: 0 }
    }

    /// From the start of the file to what has been read, or a few bytes further.
    pub(super) fn offset(&self) -> usize {
        self.offset
    }

    /// The next symbol.
    #[inline]
    pub(super) fn symbol(&mut self, table: &HuffmanTable) -> Result<u8, DecodeError> {
        if self.count < LONGEST_BITS {
            self.refill();
        }
        let [high, low, ..] = self.bits.to_be_bytes();
        match table.find(u32::from(u16::from_be_bytes([high, low]))) {
            Some((length, symbol)) if length <= self.count => {
                self.skip(length);
                Ok(symbol)
            }
            Some(_) => Err(self.too_short()),
            None => Err(self.malformed("these bits are no code of the Huffman table")),
        }
    }

    /// The next `count` bits, at most 16, as a number.
    #[inline]
    pub(super) fn take(&mut self, count: u32) -> Result<u16, DecodeError> {
        if self.count < count {
            self.refill();
            if self.count < count {
                return Err(self.too_short());
            }
        }
        // In two steps: none of 64 bits may be left.
        let value = (self.bits >> 1) >> (u64::BITS - 1 - count);
        self.skip(count);
        Ok((value & 0xffff) as u16)
    }

    /// The next `size` bits, at most 15, as a difference: those that begin with 0 are negative (T.81, F.2.2.1, EXTEND).
    #[inline]
    pub(super) fn difference(&mut self, size: u32) -> Result<i16, DecodeError> {
        let value = i32::from(self.take(size)?);
        let is_negative = size > 0 && value >> (size - 1) == 0;
        let difference = if is_negative { value + 1 - (1 << size) } else { value };
        Ok(i16::try_from(difference).unwrap_or(i16::MAX))
    }

    /// Goes past the restart marker that is due here, which is the `number`th of eight.
    pub(super) fn restart(&mut self, number: u8) -> Result<(), DecodeError> {
        (self.bits, self.count) = (0, 0);
        match find_marker(self.file, self.offset) {
            Some((offset, marker)) if marker == 0xd0 + number % 8 => {
                self.offset = offset + 2;
                Ok(())
            }
            _ => Err(self.malformed("a restart marker is missing")),
        }
    }

    pub(super) fn malformed(&self, rule: &'static str) -> DecodeError {
        DecodeError::malformed(Format::Jpeg, self.offset, rule)
    }

    fn too_short(&self) -> DecodeError {
        self.malformed("the data of a scan end before the picture does")
    }

    #[inline]
    fn skip(&mut self, count: u32) {
        self.bits <<= count;
        self.count -= count;
    }

    /// Fills `bits` with at least 56 bits, or with all up to the next marker.
    #[inline]
    fn refill(&mut self) {
        if let Some(next) = self.file.get(self.offset..).and_then(|rest| rest.first_chunk()) {
            let next = u64::from_be_bytes(*next);
            // Without 0xff no byte is special.
            if (!next).wrapping_sub(0x0101_0101_0101_0101) & next & 0x8080_8080_8080_8080 == 0 {
                self.bits |= next >> self.count;
                self.offset += ((u64::BITS - 1 - self.count) / 8) as usize;
                self.count |= 56;
                return;
            }
        }
        self.refill_by_bytes();
    }

    fn refill_by_bytes(&mut self) {
        while self.count <= 56 {
            let (byte, length) = match self.file.get(self.offset..) {
                // A zero is stuffed behind a byte that else would begin a marker.
                Some([0xff, 0, ..]) => (0xff, 2),
                Some([0xff, ..] | []) | None => return,
                Some([byte, ..]) => (*byte, 1),
            };
            self.bits |= u64::from(byte) << (56 - self.count);
            self.count += 8;
            self.offset += length;
        }
    }
}

/// Offset and second byte of the first marker at or after `offset`.
pub(super) fn find_marker(file: &[u8], offset: usize) -> Option<(usize, u8)> {
    let rest = file.get(offset..)?;
    let place = rest.windows(2).position(|pair| pair[0] == 0xff && !matches!(pair[1], 0 | 0xff))?;
    Some((offset + place, rest[place + 1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One code each of the lengths 1 to 11: 0, 10, 110 and so on.
    fn unary() -> HuffmanTable {
        let mut counts = [0; 16];
        counts[..11].fill(1);
        HuffmanTable::new(&counts, &(1..=11).collect::<Vec<u8>>()).unwrap()
    }

    #[test]
    fn short_and_long_codes_are_read_and_too_many_refused() {
        // 0, 10, ten ones and a zero, then ones: of these there is no code.
        let file = [0b0101_1111, 0b1111_1011, 0xff, 0, 0xff, 0];
        let mut reader = BitReader::new(&file, 0);
        let table = unary();
        assert_eq!([(); 3].map(|()| reader.symbol(&table).unwrap()), [1, 2, 11]);
        assert!(reader.symbol(&table).unwrap_err().to_string().contains("no code"));
        let mut counts = [0; 16];
        counts[0] = 3;
        assert!(HuffmanTable::new(&counts, &[0; 3]).is_none());
    }

    #[test]
    fn bits_end_at_a_marker_and_zeros_are_unstuffed() {
        let mut reader = BitReader::new(&[0xff, 0x00, 0x80, 0xff, 0xd1, 0x40, 1, 2, 3, 4, 5, 6, 7, 8], 0);
        assert_eq!((reader.take(9).unwrap(), reader.take(7).unwrap()), (0x1ff, 0));
        assert!(reader.take(1).is_err());
        reader.restart(9).unwrap();
        assert_eq!(reader.take(16).unwrap(), 0x4001);
        assert_eq!(reader.take(0).unwrap(), 0);
        assert_eq!([(); 7].map(|()| reader.take(8).unwrap()), [2, 3, 4, 5, 6, 7, 8]);
        assert!(reader.restart(0).is_err());
    }

    #[test]
    fn differences_are_symmetric() {
        let mut reader = BitReader::new(&[0b0011_1011, 0b1000_0000], 0);
        let differences = [2, 2, 1, 3].map(|size| reader.difference(size).unwrap());
        assert_eq!(differences, [-3, 3, 1, -4]);
    }
}
