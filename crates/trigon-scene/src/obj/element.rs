//! Indices as OBJ files write them: the encoding that lets a block be parsed without knowing what comes before it.
//!
//! A positive index counts from the start of the file and is final; a negative one counts back from the statement and
//! needs the number of elements in all blocks before. Both fit one `u32`: absolute indices are below 2^31 (zero-based),
//! relative ones above, as block-local positions offset by [`RELATIVE_ZERO`].

use crate::geometry::ABSENT;

/// An index that no element has, for 0 and for numbers beyond range. Absolute, and above [`MAX_ELEMENTS`].
pub(super) const INVALID: u32 = (1 << 31) - 1;

/// The most elements of a kind that a file may have.
pub(super) const MAX_ELEMENTS: usize = 1 << 30;

/// The encoding of the block's first element.
const RELATIVE_ZERO: i64 = (1 << 31) + (1 << 30);

/// The code of an index as written, in a block that has `defined` elements of the kind so far.
#[inline(always)]
pub(super) fn encode((is_relative, value): (bool, u32), defined: usize) -> u32 {
    if is_relative { encode_relative(value, defined) } else { value.wrapping_sub(1).min(INVALID) }
}

#[cold]
fn encode_relative(back: u32, defined: usize) -> u32 {
    let defined = i64::try_from(defined).unwrap_or(i64::MAX / 2);
    match u32::try_from(RELATIVE_ZERO + defined - i64::from(back)) {
        Ok(code) if code > INVALID && code < ABSENT && back > 0 => code,
        _ => INVALID,
    }
}

/// The zero-based index in the file, given that blocks before this one defined `before` elements; [`INVALID`] if it
/// points before the start. [`ABSENT`] stays.
#[inline(always)]
pub(super) fn resolve(code: u32, before: usize) -> u32 {
    if code <= INVALID || code == ABSENT { code } else { resolve_relative(code, before) }
}

#[inline]
fn resolve_relative(code: u32, before: usize) -> u32 {
    let index = i64::try_from(before).unwrap_or(i64::MAX / 2) + (i64::from(code) - RELATIVE_ZERO);
    u32::try_from(index).map_or(INVALID, |index| index.min(INVALID))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn relative_indices_count_back_across_blocks() {
        assert_eq!(resolve(encode((false, 1), 0), 100), 0);
        assert_eq!(resolve(encode((true, 1), 3), 100), 102);
        assert_eq!(resolve(encode((true, 3), 3), 100), 100);
        assert_eq!(resolve(encode((true, 103), 3), 100), 0);
        assert_eq!(resolve(encode((true, 104), 3), 100), INVALID);
        assert_eq!(resolve(encode((false, 0), 3), 100), INVALID);
        assert_eq!(resolve(encode((true, 0), 3), 100), INVALID);
        assert_eq!(resolve(encode((true, u32::MAX), 3), 100), INVALID);
        assert_eq!(resolve(encode((false, u32::MAX), 3), 100), INVALID);
        assert_eq!(resolve(ABSENT, 100), ABSENT);
    }
}
