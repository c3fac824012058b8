//! SIMD lanes: sixteen values at a time, with only those operations that give the same bits on every machine.
//!
//! In: scalars, slices and a level ([`SimdLevel`]). Out: [`F32`], [`I32`], [`U32`], [`Mask`] and small vectors of them.
//! The one idea: a kernel is a safe `#[inline(always)]` function, generic over [`Lanes`], and is compiled once per
//! level; `dispatch` picks the level once per tile or chunk. There are always [`LANES`] logical lanes (one AVX-512
//! register, two AVX2, four SSE/NEON/wasm ones), so that no value can depend on the width of the hardware.
//!
//! Absent on purpose: fused multiply-add, reciprocal estimates, horizontal float sums, platform transcendentals,
//! and float-to-integer conversions without a clamp. Plain closures must not appear in kernels: a closure is a
//! function of its own, compiled without the CPU features of its caller.

mod channels;
mod float;
mod gather;
mod int;
mod level;
mod mask;
mod noted;
mod plain;
mod records;
mod stream;
mod token;
mod vector;

pub use float::F32;
pub use gather::Zero;
pub use int::{I32, U32};
pub use level::{Kernel, SimdError, SimdLevel};
pub use mask::Mask;
pub use noted::Noted;
pub use token::{LANES, Lanes};
pub use vector::{Mat4, Rgba, Vec2, Vec3, Vec4};

pub(crate) use channels::{Channels, PixelColumns};
pub(crate) use gather::fetch;
pub(crate) use level::{dispatch, outline};
pub(crate) use records::{Quad, columns, store_records};
pub(crate) use stream::{Plain, finish_lines, store_lines};
