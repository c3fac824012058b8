//! Processor time of this process: all threads, user and system. It stays meaningful on a busy machine, where wall time
//! does not.

use std::time::Duration;

/// Processor time used so far; `None` where the system does not tell.
#[must_use]
pub fn process_cpu_time() -> Option<Duration> {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        let seconds = Duration::from_secs(u64::try_from(time.tv_sec).ok()?);
        Some(seconds + Duration::from_nanos(u64::try_from(time.tv_nsec).ok()?))
    }
    #[cfg(not(unix))]
    None
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    #[test]
    fn work_takes_time() {
        let before = process_cpu_time().unwrap();
        let mut x = 1u32;
        while process_cpu_time().unwrap() == before {
            x = std::hint::black_box(x.wrapping_mul(3));
        }
        assert!(process_cpu_time().unwrap() > before);
    }
}
