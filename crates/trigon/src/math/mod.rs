//! Elementary functions on lanes, by our own polynomials: the platform's differ from machine to machine.
//!
//! Only `+ - * /`, square roots, comparisons and bit operations, each exact or correctly rounded on every target; so a
//! function gives the same bits at every SIMD level. Each states its largest error, which its test measures against
//! `libm` in double precision. [`host`] has the same kind of functions for single numbers outside kernels.

pub mod host;

#[cfg(test)]
mod check;
mod log_exp;
mod power;
mod srgb;
mod trigonometry;

pub use log_exp::{exp, exp2, log2};
pub use power::{pow, powi, rsqrt};
pub use srgb::{linear_to_srgb8, srgb8_to_linear};
pub use trigonometry::{acos, atan2, cos, sin};
