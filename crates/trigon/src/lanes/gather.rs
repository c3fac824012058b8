//! Gathers: one element of a slice per lane, each at its own index.
//!
//! In: a slice and sixteen indices. Out: lanes. An index outside the slice reads zero: no panic, so that the compiler
//! can drop what a kernel does not use.
//!
//! AVX-512 has an instruction for it; elsewhere sixteen loads are as fast or faster. Both read the same elements.

use super::{F32, I32, LANES, Lanes, U32, Vec2, Vec3, Vec4};

/// What an index outside a slice reads.
pub trait Zero: Copy {
    /// The zero of the type.
    const ZERO: Self;
}

impl Zero for f32 {
    const ZERO: Self = 0.0;
}
impl Zero for i32 {
    const ZERO: Self = 0;
}
impl Zero for u8 {
    const ZERO: Self = 0;
}
impl Zero for u64 {
    const ZERO: Self = 0;
}
impl Zero for u32 {
    const ZERO: Self = 0;
}
impl<T: Zero, const N: usize> Zero for [T; N] {
    const ZERO: Self = [T::ZERO; N];
}

/// One element, or zero outside the slice.
#[inline(always)]
pub(crate) fn fetch<T: Zero>(slice: &[T], index: u32) -> T {
    match slice.get(index as usize) {
        Some(value) => *value,
        None => T::ZERO,
    }
}

/// One element per index. A function of its own: sixteen loads and checks, inlined at every gather of every kernel,
/// are most of what a compiler has to work through, and the call costs little beside them.
#[inline(never)]
fn fetch_all<T: Zero>(slice: &[T], indices: &[u32; LANES]) -> [T; LANES] {
    let mut out = [T::ZERO; LANES];
    for (out, index) in out.iter_mut().zip(indices) {
        *out = fetch(slice, *index);
    }
    out
}

/// One element per index, by component.
#[inline(never)]
fn fetch_components<const N: usize>(slice: &[[f32; N]], indices: &[u32; LANES]) -> [[f32; LANES]; N] {
    let mut out = [[0.0; LANES]; N];
    for (i, index) in indices.iter().enumerate() {
        let element = fetch(slice, *index);
        for c in 0..N {
            out[c][i] = element[c];
        }
    }
    out
}

macro_rules! gather {
    ($name:ident, $instruction:ident, $scalar:ident, $lanes:ident, $constructor:ident) => {
        /// One element of `slice` per lane.
        #[inline(always)]
        pub fn $name(self, slice: &[$scalar]) -> $lanes<L> {
            let l = self.token();
            let index = self.to_array();
            #[cfg(all(feature = "avx512", target_arch = "x86_64"))]
            if let (fearless_simd::Level::Avx512(avx512), true) = (l.level(), slice.len() <= instruction::MAX_LEN) {
                return l.$constructor(&instruction::$instruction(avx512, slice, &index));
            }
            l.$constructor(&fetch_all(slice, &index))
        }
    };
}

impl<L: Lanes> U32<L> {
    gather!(gather_f32, f32, f32, F32, f32_array);
    gather!(gather_u32, u32, u32, U32, u32_array);
    gather!(gather_i32, i32, i32, I32, i32_array);

    /// One pair of `slice` per lane.
    #[inline(always)]
    pub fn gather_vec2(self, slice: &[[f32; 2]]) -> Vec2<L> {
        let [x, y] = self.gather_components(slice);
        Vec2 { x, y }
    }

    /// One triple of `slice` per lane.
    #[inline(always)]
    pub fn gather_vec3(self, slice: &[[f32; 3]]) -> Vec3<L> {
        let [x, y, z] = self.gather_components(slice);
        Vec3 { x, y, z }
    }

    /// One quadruple of `slice` per lane.
    #[inline(always)]
    pub fn gather_vec4(self, slice: &[[f32; 4]]) -> Vec4<L> {
        let [x, y, z, w] = self.gather_components(slice);
        Vec4 { x, y, z, w }
    }

    #[inline(always)]
    fn gather_components<const N: usize>(self, slice: &[[f32; N]]) -> [F32<L>; N] {
        let components = fetch_components(slice, &self.to_array());
        let mut lanes = [self.token().f32(0.0); N];
        for c in 0..N {
            lanes[c] = self.token().f32_array(&components[c]);
        }
        lanes
    }
}

/// The gather instructions of AVX-512. Their indices are signed and are not checked: lanes whose index is not below the
/// slice's length are switched off.
#[cfg(all(feature = "avx512", target_arch = "x86_64"))]
#[expect(unsafe_code, reason = "an instruction that reads memory by address")]
mod instruction {
    use super::LANES;
    use core::arch::x86_64::{
        _mm512_cmplt_epu32_mask, _mm512_mask_i32gather_epi32, _mm512_mask_i32gather_ps, _mm512_set1_epi32,
        _mm512_setzero_ps, _mm512_setzero_si512,
    };
    use fearless_simd::{SimdBase, SimdFrom, f32x16, i32x16, kernel, u32x16};

    /// Longer slices have elements that no index of the instruction names.
    pub(super) const MAX_LEN: usize = i32::MAX as usize;

    macro_rules! gather {
        ($scalar:ident, $vector:ident, $zero:ident, $instruction:ident) => {
            kernel!(
                /// One element of `slice` per index, or zero. Elements beyond [`MAX_LEN`] read as zero, too.
                #[inline]
                pub(super) fn $scalar(l: Avx512, slice: &[$scalar], index: &[u32; LANES]) -> [$scalar; LANES] {
                    let len = i32::try_from(slice.len()).unwrap_or(i32::MAX);
                    let index = u32x16::load_array_ref(l, index).into();
                    let inside = _mm512_cmplt_epu32_mask(index, _mm512_set1_epi32(len));
                    // SAFETY: a lane reads only if its index is in 0..len, and `slice` has at least `len` elements
                    // of the four bytes that the scale says.
                    let values = unsafe { $instruction::<4>($zero(), inside, index, slice.as_ptr().cast()) };
                    $vector::simd_from(l, values).to_array()
                }
            );
        };
    }

    gather!(f32, f32x16, _mm512_setzero_ps, _mm512_mask_i32gather_ps);
    gather!(i32, i32x16, _mm512_setzero_si512, _mm512_mask_i32gather_epi32);
    gather!(u32, u32x16, _mm512_setzero_si512, _mm512_mask_i32gather_epi32);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{SimdLevel, dispatch};

    #[test]
    fn elements_are_gathered_and_zero_outside() {
        let values: Vec<u32> = (0..100).map(|i| i * 7 + 1).collect();
        let floats: Vec<f32> = values.iter().map(|v| *v as f32 + 0.5).collect();
        let integers: Vec<i32> = values.iter().map(|v| -v.cast_signed()).collect();
        let index = [0, 99, 100, 101, u32::MAX, 1 << 31, (1 << 31) - 1, 50, 3, 3, 98, 200, 1 << 30, 7, 64, 16];
        for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            let token = level.to_level().expect("the level is available");
            for len in [0, 1, 64, 100] {
                let (u, f, i) = dispatch!(token, l => {
                    let index = l.u32_array(&index);
                    (
                        index.gather_u32(&values[..len]).to_array(),
                        index.gather_f32(&floats[..len]).to_array(),
                        index.gather_i32(&integers[..len]).to_array(),
                    )
                });
                for (lane, at) in index.iter().enumerate() {
                    let at = usize::try_from(*at).expect("an index fits").min(len);
                    assert_eq!(u[lane], values[..len].get(at).copied().unwrap_or(0), "at {level}");
                    assert_eq!(f[lane], floats[..len].get(at).copied().unwrap_or(0.0), "at {level}");
                    assert_eq!(i[lane], integers[..len].get(at).copied().unwrap_or(0), "at {level}");
                }
            }
        }
    }
}
