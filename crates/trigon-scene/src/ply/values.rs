//! The values behind the header, one after the other, in each of the three encodings.

use super::header::{Encoding, Scalar};
use crate::text::Cursor;

/// A position among the values. Values are widened to `f64`, which is exact for all types.
pub(super) enum Values<'a> {
    Text(Cursor<'a>),
    Binary { bytes: &'a [u8], at: usize, is_big_endian: bool },
}

impl<'a> Values<'a> {
    pub(super) fn new(body: &'a [u8], encoding: Encoding) -> Self {
        match encoding {
            Encoding::Ascii => Self::Text(Cursor::new(body)),
            Encoding::BinaryLittleEndian => Self::Binary { bytes: body, at: 0, is_big_endian: false },
            Encoding::BinaryBigEndian => Self::Binary { bytes: body, at: 0, is_big_endian: true },
        }
    }

    /// The next value; `None` at the end of the file or, in text, at a word that is not a number.
    #[inline(always)]
    pub(super) fn next(&mut self, scalar: Scalar) -> Option<f64> {
        match self {
            Self::Text(cursor) => next_number(cursor),
            Self::Binary { bytes, at, is_big_endian } => {
                let value = read_binary(bytes.get(*at..)?, scalar, *is_big_endian)?;
                *at += scalar.bytes();
                Some(value)
            }
        }
    }

    /// Steps over `count` values of a type; `None` if the file ends.
    pub(super) fn skip(&mut self, scalar: Scalar, count: u64) -> Option<()> {
        match self {
            Self::Text(_) => (0..count).try_for_each(|_| self.next(scalar).map(|_| ())),
            Self::Binary { bytes, at, .. } => {
                let width = usize::try_from(count).ok()?.checked_mul(scalar.bytes())?;
                *at = at.checked_add(width).filter(|end| *end <= bytes.len())?;
                Some(())
            }
        }
    }

    /// Binary values that are left, if at least `count` bytes are.
    #[inline(always)]
    pub(super) fn take_binary(&mut self, count: usize) -> Option<&'a [u8]> {
        match self {
            Self::Text(_) => None,
            Self::Binary { bytes, at, .. } => {
                let taken = bytes.get(*at..at.checked_add(count)?)?;
                *at += count;
                Some(taken)
            }
        }
    }

    /// Ends a record. In text a record is a line; what is left of it is dropped, since some writers put more values on
    /// the line than the header declares.
    #[inline]
    pub(super) fn end_record(&mut self) {
        if let Self::Text(cursor) = self {
            cursor.finish_line();
        }
    }

    /// The most values that can be left, for judging announced counts.
    pub(super) fn most_left(&self) -> u64 {
        let bytes = match self {
            Self::Text(cursor) => cursor.rest().len() / 2 + 1,
            Self::Binary { bytes, at, .. } => bytes.len() - at,
        };
        u64::try_from(bytes).unwrap_or(u64::MAX)
    }

    /// Where the next value is: line ends passed in text, bytes in binary.
    pub(super) fn place(&self) -> (Option<u32>, usize) {
        match self {
            Self::Text(cursor) => (Some(cursor.lines()), cursor.offset()),
            Self::Binary { at, .. } => (None, *at),
        }
    }
}

/// The next number on this or a following line. Numbers of a record may be spread over lines.
#[inline]
fn next_number(cursor: &mut Cursor<'_>) -> Option<f64> {
    loop {
        match cursor.float() {
            Ok(Some(value)) => return Some(whole(value, cursor)),
            Ok(None) if cursor.is_at_end() => return None,
            Ok(None) => cursor.finish_line(),
            Err(_) => return None,
        }
    }
}

/// Wide enough for indices: `f32` holds them exactly up to 2^24, larger ones are read again as integers.
#[inline(always)]
fn whole(value: f32, cursor: &Cursor<'_>) -> f64 {
    if value.abs() < 16_777_216.0 { f64::from(value) } else { reread(value, cursor) }
}

#[cold]
fn reread(value: f32, cursor: &Cursor<'_>) -> f64 {
    let token = cursor.last_word();
    std::str::from_utf8(token).ok().and_then(|text| text.parse().ok()).unwrap_or(f64::from(value))
}

/// The first value of `bytes`.
#[inline(always)]
pub(super) fn read_binary(bytes: &[u8], scalar: Scalar, is_big_endian: bool) -> Option<f64> {
    /// The first `N` bytes, least significant first.
    #[inline(always)]
    fn ordered<const N: usize>(bytes: &[u8], is_big_endian: bool) -> Option<[u8; N]> {
        let mut first = *bytes.first_chunk::<N>()?;
        if is_big_endian {
            first.reverse();
        }
        Some(first)
    }
    Some(match scalar {
        Scalar::I8 => f64::from(i8::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::U8 => f64::from(u8::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::I16 => f64::from(i16::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::U16 => f64::from(u16::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::I32 => f64::from(i32::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::U32 => f64::from(u32::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::F32 => f64::from(f32::from_le_bytes(ordered(bytes, is_big_endian)?)),
        Scalar::F64 => f64::from_le_bytes(ordered(bytes, is_big_endian)?),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_byte_orders_and_text_give_the_same_values() {
        let scalars = [Scalar::I8, Scalar::U16, Scalar::I32, Scalar::F32, Scalar::F64, Scalar::U32];
        let little = [
            &(-3_i8).to_le_bytes()[..],
            &700_u16.to_le_bytes(),
            &(-70_000_i32).to_le_bytes(),
            &0.5_f32.to_le_bytes(),
            &0.25_f64.to_le_bytes(),
            &4_294_967_295_u32.to_le_bytes(),
        ];
        let big: Vec<u8> = little.iter().flat_map(|bytes| bytes.iter().rev().copied()).collect();
        let little = little.concat();
        let text = b"-3 700\n-70000 .5 2.5e-1\r\n4294967295";
        for (body, encoding) in [
            (&little[..], Encoding::BinaryLittleEndian),
            (&big[..], Encoding::BinaryBigEndian),
            (&text[..], Encoding::Ascii),
        ] {
            let mut values = Values::new(body, encoding);
            let read: Vec<f64> = scalars.iter().map(|&scalar| values.next(scalar).unwrap()).collect();
            assert_eq!(read, [-3.0, 700.0, -70_000.0, 0.5, 0.25, 4_294_967_295.0], "{encoding:?}");
            assert_eq!(values.next(Scalar::U8), None);
        }
    }
}
