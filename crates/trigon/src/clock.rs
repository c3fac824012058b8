//! Wall time of the stages, for statistics: a time on targets that have a clock, zero on those without.
//!
//! WebAssembly has no clock of its own, and the standard library panics there when asked for one.

use std::time::{Duration, Instant};

/// A point in time to count from.
pub(crate) struct Stopwatch(Option<Instant>);

impl Stopwatch {
    /// Counts from now.
    pub(crate) fn start() -> Self {
        let has_clock = !cfg!(all(target_family = "wasm", target_os = "unknown"));
        Self(has_clock.then(Instant::now))
    }

    /// Time since the start.
    pub(crate) fn elapsed(&self) -> Duration {
        self.0.map_or(Duration::ZERO, |start| start.elapsed())
    }
}
