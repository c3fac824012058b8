//! Sixteen records of four floats, turned into four columns of lanes, and back.
//!
//! In memory a triangle's numbers lie side by side, so that one load fetches four of them; in lanes each number of
//! sixteen triangles has a register of its own. Eight permutations turn the one into the other, where fetching lane by
//! lane takes sixty-four loads and as many stores.

use super::plain::lane_op;
use super::{F32, LANES, Lanes};
use fearless_simd::{SimdCombine, SimdFrom, SimdSplit, f32x4, f32x16};

/// Four numbers of one record.
pub(crate) type Quad = [f32; 4];

/// Column `c` holds number `c` of each record.
#[inline(always)]
pub(crate) fn columns<L: Lanes>(l: L, records: &[&Quad; LANES]) -> [F32<L>; 4] {
    lane_op!(l, (l: L, records: &[&Quad; LANES]) -> [F32<L>; 4] = {
        transposed(l, [four(l, records, 0), four(l, records, 4), four(l, records, 8), four(l, records, 12)])
    })
}

/// Column `c` holds number `c` of each of the sixteen quads in four registers.
#[inline(always)]
pub(super) fn transposed<L: Lanes>(l: L, quads: [f32x16<L>; 4]) -> [F32<L>; 4] {
    lane_op!(l, (l: L, quads: [f32x16<L>; 4]) -> [F32<L>; 4] = {
        let [a, b, c, d] = quads;
        let (even, odd) = (l.unzip_low_f32x16(a, b), l.unzip_high_f32x16(a, b));
        let (even_high, odd_high) = (l.unzip_low_f32x16(c, d), l.unzip_high_f32x16(c, d));
        [
            F32(l.unzip_low_f32x16(even, even_high)),
            F32(l.unzip_low_f32x16(odd, odd_high)),
            F32(l.unzip_high_f32x16(even, even_high)),
            F32(l.unzip_high_f32x16(odd, odd_high)),
        ]
    })
}

/// Records `first` to `first + 3`, one after the other.
#[inline(always)]
fn four<L: Lanes>(l: L, records: &[&Quad; LANES], first: usize) -> f32x16<L> {
    let [a, b] = [f32x4::simd_from(l, *records[first]), f32x4::simd_from(l, *records[first + 1])];
    let [c, d] = [f32x4::simd_from(l, *records[first + 2]), f32x4::simd_from(l, *records[first + 3])];
    a.combine(b).combine(c.combine(d))
}

/// Writes number `c` of record `i` from lane `i` of column `c`: the inverse of [`columns`]. Records are `stride` quads
/// apart in `out`; those that do not fit are left out.
#[inline(always)]
pub(crate) fn store_records<L: Lanes>(l: L, columns: [F32<L>; 4], out: &mut [Quad], stride: usize) {
    lane_op!(l, (l: L, columns: [F32<L>; 4], out: &mut [Quad], stride: usize) -> () = {
        let [c0, c1, c2, c3] = columns.map(
            #[inline(always)]
            |column| column.0,
        );
        let (even, odd) = (l.zip_low_f32x16(c0, c2), l.zip_low_f32x16(c1, c3));
        let (even_high, odd_high) = (l.zip_high_f32x16(c0, c2), l.zip_high_f32x16(c1, c3));
        let fours = [
            l.zip_low_f32x16(even, odd),
            l.zip_high_f32x16(even, odd),
            l.zip_low_f32x16(even_high, odd_high),
            l.zip_high_f32x16(even_high, odd_high),
        ];
        for (i, four) in fours.into_iter().enumerate() {
            let (low, high) = four.split();
            let ((a, b), (c, d)) = (low.split(), high.split());
            for (j, record) in [a, b, c, d].into_iter().enumerate() {
                if let Some(out) = out.get_mut((4 * i + j) * stride) {
                    *out = record.into();
                }
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{SimdLevel, dispatch};

    #[test]
    fn columns_and_records_are_inverse() {
        let records: [Quad; LANES] = core::array::from_fn(|i| core::array::from_fn(|c| (10 * i + c) as f32));
        for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            let token = level.to_level().expect("the level is available");
            let (columns, back) = dispatch!(token, l => {
                let columns = columns(l, &records.each_ref());
                let mut back = vec![[-1.0; 4]; 2 * LANES];
                store_records(l, columns, &mut back, 2);
                (columns.map(|column| column.to_array()), back)
            });
            for (i, record) in records.iter().enumerate() {
                assert_eq!(columns.map(|column| column[i]), *record, "at {level}");
                assert_eq!((back[2 * i], back[2 * i + 1]), (*record, [-1.0; 4]), "at {level}");
            }
        }
    }
}
