//! SIMD levels: which exist, which this CPU has, and how a kernel is entered at one of them.
//!
//! In: a name, the environment (`TRIGON_SIMD`) or the CPU. Out: a [`SimdLevel`] that is known to be available.
//! The level changes the speed of a picture, never a bit of it.

use core::fmt;
use core::str::FromStr;
use fearless_simd::Level;

/// An instruction set that the kernels are compiled for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
#[non_exhaustive]
pub enum SimdLevel {
    /// Plain code for the target's baseline.
    Scalar,
    /// x86-64-v2: 128-bit vectors.
    Sse42,
    /// x86-64-v3: 256-bit vectors.
    Avx2,
    /// AVX-512 with the Ice Lake extensions: 512-bit vectors.
    Avx512,
    /// 64-bit ARM: 128-bit vectors.
    Neon,
    /// WebAssembly `simd128`; only in modules compiled with that feature.
    WasmSimd128,
}

/// Why a level cannot be used.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum SimdError {
    /// No level has this name.
    UnknownName(String),
    /// This CPU, or this build, lacks the level.
    Unavailable(SimdLevel),
}

impl SimdLevel {
    /// Every level that trigon knows, slowest first.
    pub const ALL: [Self; 6] = [Self::Scalar, Self::Sse42, Self::Avx2, Self::Avx512, Self::Neon, Self::WasmSimd128];

    /// The best level of this CPU.
    #[must_use]
    pub fn detect() -> Self {
        Self::ALL.into_iter().rev().find(|level| level.is_available()).unwrap_or(Self::Scalar)
    }

    /// The level named by the environment variable `TRIGON_SIMD`, or the best one where it is unset or empty.
    ///
    /// # Errors
    /// An unknown name, or a level that this CPU lacks.
    pub fn from_env() -> Result<Self, SimdError> {
        match std::env::var("TRIGON_SIMD") {
            Ok(name) if !name.is_empty() => name.parse::<Self>()?.require(),
            _ => Ok(Self::detect()),
        }
    }

    /// This level, if the CPU has it.
    ///
    /// # Errors
    /// [`SimdError::Unavailable`] if not.
    pub fn require(self) -> Result<Self, SimdError> {
        if self.is_available() { Ok(self) } else { Err(SimdError::Unavailable(self)) }
    }

    /// True if this CPU (and build) has the level.
    #[must_use]
    pub fn is_available(self) -> bool {
        self.to_level().is_some()
    }

    /// The name that [`FromStr`] reads.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Sse42 => "sse4.2",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
            Self::Neon => "neon",
            Self::WasmSimd128 => "simd128",
        }
    }

    /// Runs a kernel compiled for this level; plain code where the CPU lacks it.
    ///
    /// This is how other crates enter lane code: once per tile or chunk, not per block.
    pub fn run<K: Kernel>(self, kernel: K) -> K::Output {
        dispatch!(self.to_level().unwrap_or_else(Level::fallback), l => kernel.run(l))
    }

    /// The proof that the CPU has this level; `None` if it has not.
    pub(crate) fn to_level(self) -> Option<Level> {
        match self {
            Self::Scalar => Some(Level::fallback()),
            #[cfg(all(feature = "sse42", any(target_arch = "x86", target_arch = "x86_64")))]
            Self::Sse42 => Level::new().as_sse4_2().map(Level::Sse4_2),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            Self::Avx2 => Level::new().as_avx2().map(Level::Avx2),
            #[cfg(all(feature = "avx512", any(target_arch = "x86", target_arch = "x86_64")))]
            Self::Avx512 => Level::new().as_avx512().map(Level::Avx512),
            #[cfg(target_arch = "aarch64")]
            Self::Neon => Level::new().as_neon().map(Level::Neon),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            Self::WasmSimd128 => Level::new().as_wasm_simd128().map(Level::WasmSimd128),
            _ => None,
        }
    }
}

/// A piece of lane code with its operands, for [`SimdLevel::run`].
pub trait Kernel {
    /// What it returns.
    type Output;

    /// The code; mark the implementation `#[inline(always)]`, so that it is compiled with the level's CPU features.
    fn run<L: super::Lanes>(self, l: L) -> Self::Output;
}

impl fmt::Display for SimdLevel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for SimdLevel {
    type Err = SimdError;

    fn from_str(name: &str) -> Result<Self, SimdError> {
        Self::ALL.into_iter().find(|level| level.name() == name).ok_or_else(|| SimdError::UnknownName(name.to_owned()))
    }
}

impl fmt::Display for SimdError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = |f: &mut fmt::Formatter<'_>, all: bool| {
            let known = SimdLevel::ALL.into_iter().filter(|level| all || level.is_available());
            known.enumerate().try_for_each(|(i, level)| write!(f, "{}{level}", if i == 0 { "" } else { ", " }))
        };
        match self {
            Self::UnknownName(name) => {
                write!(f, "unknown SIMD level '{name}'; the levels are ")?;
                names(f, true)
            }
            Self::Unavailable(level) => {
                write!(f, "SIMD level '{level}' is not available on this CPU; it has ")?;
                names(f, false)
            }
        }
    }
}

impl core::error::Error for SimdError {}

/// Runs a kernel at a level: `dispatch!(level, l => kernel(l, ..))`, where the kernel is `#[inline(always)]`.
///
/// The expression is compiled once per level, inside a function that has the level's CPU features.
macro_rules! dispatch {
    ($level:expr, $l:ident => $kernel:expr) => {
        match $level {
            #[cfg(all(feature = "avx512", any(target_arch = "x86", target_arch = "x86_64")))]
            fearless_simd::Level::Avx512($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
            fearless_simd::Level::Avx2($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            #[cfg(all(feature = "sse42", any(target_arch = "x86", target_arch = "x86_64")))]
            fearless_simd::Level::Sse4_2($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            #[cfg(target_arch = "aarch64")]
            fearless_simd::Level::Neon($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            fearless_simd::Level::WasmSimd128($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            fearless_simd::Level::Fallback($l) => $crate::lanes::dispatch!(@enter $l => $kernel),
            _ => unreachable!("SimdLevel::to_level makes no other level"),
        }
    };
    (@enter $l:ident => $kernel:expr) => {
        fearless_simd::Simd::vectorize($l, #[inline(always)] || $kernel)
    };
}

/// Enters the body of an `#[inline(never)]` function at its caller's level: `outline!(l => body)`.
///
/// Such a function is compiled once per level instead of into every caller. Without this its body would lack the
/// level's CPU features.
macro_rules! outline {
    ($l:ident => $body:expr) => {
        fearless_simd::Simd::vectorize(
            $l,
            #[inline(always)]
            || $body,
        )
    };
}

pub(crate) use {dispatch, outline};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for level in SimdLevel::ALL {
            assert_eq!(level.name().parse(), Ok(level));
        }
    }

    #[test]
    fn detected_level_is_available_and_scalar_always_is() {
        assert!(SimdLevel::detect().is_available());
        assert!(SimdLevel::Scalar.is_available());
    }

    #[test]
    fn errors_say_what_there_is() {
        let unknown = "mmx".parse::<SimdLevel>().unwrap_err().to_string();
        assert!(unknown.contains("mmx") && unknown.contains("avx512"), "{unknown}");
        let missing = SimdError::Unavailable(SimdLevel::Neon).to_string();
        assert!(missing.contains("scalar"), "{missing}");
    }
}
