//! Stores past the caches, for pixels that are final.
//!
//! In: a row of a finished tile. Out: the same row in the caller's image, whole cache lines at a time. A plain store to
//! memory that is in no cache first reads the line it will overwrite, and since x86 stores become visible in order, the
//! next ones wait for that. Non-temporal stores do not read. Measured on 1920x1080 pixels of four bytes, 510 tiles of
//! 16 KB with other work between them: 2.1 ms with plain stores, 0.45 ms with these.

/// Types all of whose bytes are value: no padding, so that they may be copied as bytes.
pub(crate) trait Plain: Copy {}

impl Plain for u8 {}
impl Plain for u32 {}
impl Plain for f32 {}
impl<T: Plain, const N: usize> Plain for [T; N] {}

/// Copies the first `to.len()` values of `from` to `to`; call [`finish_lines`] before another thread may look at them.
#[inline]
pub(crate) fn store_lines<T: Plain>(to: &mut [T], from: &[T]) {
    let from = &from[..to.len()];
    #[cfg(target_arch = "x86_64")]
    {
        let head = to.as_ptr().align_offset(x86::LINE).min(to.len());
        let (to_head, to_rest) = to.split_at_mut(head);
        let (head, rest) = from.split_at(head);
        to_head.copy_from_slice(head);
        let streamed = x86::stream(to_rest, rest);
        to_rest[streamed..].copy_from_slice(&rest[streamed..]);
    }
    #[cfg(not(target_arch = "x86_64"))]
    to.copy_from_slice(from);
}

/// Makes what [`store_lines`] has written visible before anything that this thread writes later.
#[inline]
pub(crate) fn finish_lines() {
    #[cfg(target_arch = "x86_64")]
    x86::fence();
}

#[cfg(target_arch = "x86_64")]
#[expect(unsafe_code, reason = "stores that only an intrinsic can ask for")]
mod x86 {
    use super::Plain;
    use core::arch::x86_64::{__m128i, _mm_loadu_si128, _mm_sfence, _mm_stream_si128};

    /// Bytes of a cache line.
    pub(super) const LINE: usize = 64;

    const PARTS: usize = LINE / size_of::<__m128i>();

    /// Copies whole lines from the start of `from` to the start of `to`; returns how many values that were. None where
    /// `to` does not start at a line.
    #[inline]
    pub(super) fn stream<T: Plain>(to: &mut [T], from: &[T]) -> usize {
        let bytes = size_of_val(to).min(size_of_val(from)) / LINE * LINE;
        // A whole number of values, or the rest of the row could not be copied as values.
        if !to.as_ptr().addr().is_multiple_of(LINE) || !bytes.is_multiple_of(size_of::<T>()) {
            return 0;
        }
        let (to, from) = (to.as_mut_ptr().cast::<__m128i>(), from.as_ptr().cast::<__m128i>());
        for part in 0..bytes / LINE * PARTS {
            // SAFETY: `part` is below the number of whole 16-byte parts of both slices; the load needs no alignment.
            let value = unsafe { _mm_loadu_si128(from.wrapping_add(part)) };
            // SAFETY: as above; `to` starts at a cache line, so each part is aligned to 16 bytes. `T` has no padding and
            // any copy of its bytes is a value. `store_lines` asks its callers to fence.
            unsafe { _mm_stream_si128(to.wrapping_add(part), value) };
        }
        bytes / size_of::<T>()
    }

    /// Orders the stores of [`stream`] before later ones.
    #[inline]
    pub(super) fn fence() {
        // SAFETY: needs SSE only, which every x86-64 CPU has.
        unsafe { _mm_sfence() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<T: Plain + PartialEq + core::fmt::Debug>(values: &[T], zero: T) {
        for start in 0..20 {
            for len in [0, 1, 3, 15, 16, 17, 31, 64] {
                let mut row = vec![zero; start + len + 20];
                store_lines(&mut row[start..start + len], values);
                finish_lines();
                assert_eq!(row[start..start + len], values[..len]);
                assert!(row[..start].iter().chain(&row[start + len..]).all(|value| *value == zero));
            }
        }
    }

    #[test]
    fn rows_are_copied_wherever_they_begin() {
        check(&core::array::from_fn::<_, 64, _>(|i| [i as u8, 1, 2, 3]), [0; 4]);
        check(&core::array::from_fn::<_, 64, _>(|i| i as f32 + 0.5), 0.0);
        check(&core::array::from_fn::<_, 64, _>(|i| [i as f32, 1.0, 2.0]), [0.0; 3]);
        check(&core::array::from_fn::<_, 64, _>(|i| [i as f32, 1.0, 2.0, 4.0]), [0.0; 4]);
    }
}
