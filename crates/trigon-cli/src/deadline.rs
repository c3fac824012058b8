//! `--time-limit`: a thread that ends the command when its time is over, but never while the output is being written.

use crate::failure::Failure;
use crate::terminal::Terminal;
use crate::values::Positive;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Held while output is written. Who finds the time over keeps it until the end of the process: nothing is begun after.
static OUTPUT: Mutex<()> = Mutex::new(());

/// Starts to count.
pub(crate) fn start(limit: Option<Positive>) -> Result<(), Failure> {
    let Some(Positive(seconds)) = limit else { return Ok(()) };
    let limit = Duration::try_from_secs_f64(seconds)
        .map_err(|_| Failure::usage("--time-limit is too large; leave it out to wait forever"))?;
    let watch = move || {
        thread::sleep(limit);
        let _held = writing();
        let failure = Failure::work(format!(
            "not done after {seconds} s, the --time-limit; no unfinished file is left; allow more, or draw something smaller"
        ));
        Terminal::detect(false).failure(&failure);
        // The other threads are in the middle of things that cannot be called off.
        std::process::exit(1);
    };
    let started = thread::Builder::new().name("trigon-deadline".to_owned()).spawn(watch);
    started.map(drop).map_err(|error| Failure::work(format!("a thread cannot be started: {error}")))
}

/// Keeps the end away as long as the guard lives; does not come back if the time is over.
pub(crate) fn writing() -> MutexGuard<'static, ()> {
    OUTPUT.lock().unwrap_or_else(PoisonError::into_inner)
}
