//! Threads and instruction set, from options and environment.

use crate::failure::Failure;
use crate::options::MachineOptions;
use crate::values::closest;
use std::num::NonZeroUsize;
use std::thread::available_parallelism;
use trigon::lanes::{SimdError, SimdLevel};
use trigon::pipeline::RendererOptions;
use trigon::schedule::TileOrder;

/// The renderer's options: all cores and the best level of the CPU unless the user chose.
pub(crate) fn renderer_options(options: &MachineOptions) -> Result<RendererOptions, Failure> {
    let simd = match &options.simd {
        Some(name) => {
            name.to_ascii_lowercase().parse().and_then(SimdLevel::require).map_err(|error| wrong("--simd", &error))
        }
        None => SimdLevel::from_env().map_err(|error| wrong("TRIGON_SIMD", &error)),
    }?;
    let threads = options.threads.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    Ok(RendererOptions { threads, simd, tile_order: TileOrder::default() })
}

/// A usage error that says what this CPU has.
fn wrong(origin: &str, error: &SimdError) -> Failure {
    let available: Vec<_> =
        SimdLevel::ALL.into_iter().filter(|level| level.is_available()).map(SimdLevel::name).collect();
    let has = available.join(", ");
    Failure::usage(match error {
        SimdError::UnknownName(name) => match closest(name, SimdLevel::ALL.map(SimdLevel::name)) {
            Some(close) => {
                format!("{origin}: there is no SIMD level \"{name}\", did you mean {close}? This CPU has {has}")
            }
            None => format!("{origin}: there is no SIMD level \"{name}\"; this CPU has {has}"),
        },
        SimdError::Unavailable(level) => format!("{origin}: this CPU lacks {level}; it has {has}"),
        error => format!("{origin}: {error}"),
    })
}
