//! The token that stands for a SIMD level inside a kernel, and the constructors of lane values.
//!
//! In: scalars, arrays, slices. Out: lane values. A token can only be had from [`dispatch`](super::level), which
//! checked that the CPU has the level; so every operation on it is safe.

use super::plain::lane_op;
use super::{F32, I32, Mask, Noted, U32, Vec2, Vec3, Vec4};
use crate::explain;
use fearless_simd::{Simd, SimdBase, SimdMask, f32x16, i32x16, mask32x16, u32x16};

/// Logical lanes of every lane value, at every level.
pub const LANES: usize = 16;

/// A SIMD level at which a kernel is compiled; the value is the proof that the CPU has it.
///
/// Kernels take it as their first argument, `l`, and make constants with it: `l.f32(0.5)`.
pub trait Lanes: Simd {
    /// The same float in every lane.
    #[inline(always)]
    fn f32(self, value: f32) -> F32<Self> {
        let l = self;
        lane_op!(l, (l: L, value: f32) -> F32<L> = F32(f32x16::splat(l, value)))
    }

    /// The same signed integer in every lane.
    #[inline(always)]
    fn i32(self, value: i32) -> I32<Self> {
        let l = self;
        lane_op!(l, (l: L, value: i32) -> I32<L> = I32(i32x16::splat(l, value)))
    }

    /// The same unsigned integer in every lane.
    #[inline(always)]
    fn u32(self, value: u32) -> U32<Self> {
        let l = self;
        lane_op!(l, (l: L, value: u32) -> U32<L> = U32(u32x16::splat(l, value)))
    }

    /// The same truth value in every lane.
    #[inline(always)]
    fn mask(self, value: bool) -> Mask<Self> {
        let l = self;
        lane_op!(l, (l: L, value: bool) -> Mask<L> = Mask(mask32x16::splat(l, value)))
    }

    /// Lane `i` is bit `i`.
    #[inline(always)]
    fn mask_from_bits(self, bits: u16) -> Mask<Self> {
        let l = self;
        lane_op!(l, (l: L, bits: u16) -> Mask<L> = Mask(mask32x16::from_bitmask(l, u64::from(bits))))
    }

    /// One float per lane.
    #[inline(always)]
    fn f32_array(self, values: &[f32; LANES]) -> F32<Self> {
        let l = self;
        lane_op!(l, (l: L, values: &[f32; LANES]) -> F32<L> = F32(f32x16::load_array_ref(l, values)))
    }

    /// One signed integer per lane.
    #[inline(always)]
    fn i32_array(self, values: &[i32; LANES]) -> I32<Self> {
        let l = self;
        lane_op!(l, (l: L, values: &[i32; LANES]) -> I32<L> = I32(i32x16::load_array_ref(l, values)))
    }

    /// One unsigned integer per lane.
    #[inline(always)]
    fn u32_array(self, values: &[u32; LANES]) -> U32<Self> {
        let l = self;
        lane_op!(l, (l: L, values: &[u32; LANES]) -> U32<L> = U32(u32x16::load_array_ref(l, values)))
    }

    /// The lane numbers 0, 1, 2, .. as floats.
    #[inline(always)]
    fn lane_numbers(self) -> F32<Self> {
        self.f32_array(&[0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.])
    }

    /// The same pair in every lane.
    #[inline(always)]
    fn vec2(self, v: [f32; 2]) -> Vec2<Self> {
        Vec2 { x: self.f32(v[0]), y: self.f32(v[1]) }
    }

    /// The same triple in every lane.
    #[inline(always)]
    fn vec3(self, v: [f32; 3]) -> Vec3<Self> {
        Vec3 { x: self.f32(v[0]), y: self.f32(v[1]), z: self.f32(v[2]) }
    }

    /// The same quadruple in every lane.
    #[inline(always)]
    fn vec4(self, v: [f32; 4]) -> Vec4<Self> {
        Vec4 { x: self.f32(v[0]), y: self.f32(v[1]), z: self.f32(v[2]), w: self.f32(v[3]) }
    }

    /// Tells a value by its name where a pixel is being explained (see [`crate::explain`]).
    ///
    /// Shaders name the terms of their result with it. It costs nothing: at SIMD levels it compiles to nothing.
    #[inline(always)]
    fn note(self, name: &'static str, value: impl Noted<Self>) {
        if self.is_explaining() {
            value.note(name);
        }
    }

    /// Tells what the notes that follow belong to: "light", number 2.
    #[inline(always)]
    fn note_topic(self, name: &'static str, number: Option<u32>) {
        if self.is_explaining() {
            explain::note_topic(name, number);
        }
    }

    /// True while lanes are watched, which is so at the plain level alone; constant at all others.
    #[doc(hidden)]
    #[inline(always)]
    fn is_explaining(self) -> bool {
        is_plain(self) && explain::is_watching()
    }

    /// True at the plain level, the one that can explain pixels; constant at every level.
    #[doc(hidden)]
    #[inline(always)]
    fn can_explain(self) -> bool {
        is_plain(self)
    }
}

impl<S: Simd> Lanes for S {}

/// True at the plain level, where sixteen lanes are sixteen scalars.
#[inline(always)]
pub(super) fn is_plain<L: Lanes>(l: L) -> bool {
    l.level().is_fallback()
}
