//! Wall time: that of the stages, for statistics, and the moment at which a caller no longer wants to wait.
//!
//! WebAssembly has no clock of its own, and the standard library panics there when asked for one. There times are zero and
//! deadlines are never over.

use std::time::{Duration, Instant};

/// A point in time to count from.
pub(crate) struct Stopwatch(Option<Instant>);

impl Stopwatch {
    /// Counts from now.
    pub(crate) fn start() -> Self {
        Self(now())
    }

    /// Time since the start.
    pub(crate) fn elapsed(&self) -> Duration {
        self.0.map_or(Duration::ZERO, |start| start.elapsed())
    }
}

/// The moment at which work is given up, or none.
///
/// Work that is given one stops soon after the moment, between two small pieces, and then fails; it never returns half of a
/// result. A copy is the same moment, so one deadline can be given to all the steps of a job.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Deadline(Option<Instant>);

impl Deadline {
    /// Work takes as long as it takes.
    pub const NEVER: Self = Self(None);

    /// This long from now. [`NEVER`](Self::NEVER) if that is beyond what the clock counts to, and in WebAssembly without a
    /// clock.
    #[must_use]
    pub fn after(time: Duration) -> Self {
        Self(now().and_then(|now| now.checked_add(time)))
    }

    /// True from the moment on.
    #[inline]
    #[must_use]
    pub fn is_over(self) -> bool {
        self.0.is_some_and(|moment| Instant::now() >= moment)
    }
}

/// `None` where there is no clock.
fn now() -> Option<Instant> {
    let has_clock = !cfg!(all(target_family = "wasm", target_os = "unknown"));
    has_clock.then(Instant::now)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_deadline_is_over_once_its_time_has_passed() {
        assert!(Deadline::after(Duration::ZERO).is_over());
        assert!(!Deadline::after(Duration::from_secs(3600)).is_over());
        assert!(!Deadline::NEVER.is_over());
        assert_eq!(Deadline::after(Duration::MAX), Deadline::NEVER);
    }
}
