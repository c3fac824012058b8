//! Gathers: one element of a slice per lane, each at its own index.
//!
//! In: a slice and sixteen indices. Out: lanes. An index outside the slice reads zero: no panic, so that the compiler
//! can drop what a kernel does not use.

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

impl<L: Lanes> U32<L> {
    /// One float of `slice` per lane.
    #[inline(always)]
    pub fn gather_f32(self, slice: &[f32]) -> F32<L> {
        self.token().f32_array(&fetch_all(slice, &self.to_array()))
    }

    /// One integer of `slice` per lane.
    #[inline(always)]
    pub fn gather_u32(self, slice: &[u32]) -> U32<L> {
        self.token().u32_array(&fetch_all(slice, &self.to_array()))
    }

    /// One integer of `slice` per lane.
    #[inline(always)]
    pub fn gather_i32(self, slice: &[i32]) -> I32<L> {
        self.token().i32_array(&fetch_all(slice, &self.to_array()))
    }

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
