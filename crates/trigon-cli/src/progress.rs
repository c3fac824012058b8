//! The progress bar: frames done in, a line for the terminal out.

use crate::terminal::Terminal;
use std::time::{Duration, Instant};

/// A bar on standard error that is cleared when it goes out of scope; nothing where that is no terminal.
pub(crate) struct Progress {
    terminal: Terminal,
    total: u32,
    started: Instant,
}

impl Progress {
    pub(crate) fn new(terminal: Terminal, total: u32) -> Self {
        let progress = Self { terminal, total, started: Instant::now() };
        progress.show(0);
        progress
    }

    /// Shows that `done` frames are finished.
    pub(crate) fn show(&self, done: u32) {
        if self.terminal.shows_progress() {
            self.terminal.status(&line(done, self.total, self.started.elapsed()));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.terminal.status("");
    }
}

const BAR_WIDTH: u32 = 30;

/// `frame 12/72 [=====>    ] 17 %, 3 s left`
fn line(done: u32, total: u32, elapsed: Duration) -> String {
    let share = |of: u32| u64::from(done) * u64::from(of) / u64::from(total.max(1));
    let filled = usize::try_from(share(BAR_WIDTH)).unwrap_or(0);
    let bar: String = "=".repeat(filled) + if done < total { ">" } else { "" };
    let width = BAR_WIDTH as usize + 1;
    let left = if done > 0 && done < total {
        let seconds = elapsed.as_secs_f64() / f64::from(done) * f64::from(total - done);
        format!(", {seconds:.0} s left")
    } else {
        String::new()
    };
    format!("frame {done}/{total} [{bar:width$}] {} %{left}", share(100))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_fills() {
        let second = Duration::from_secs(1);
        assert_eq!(line(0, 4, second), format!("frame 0/4 [>{}] 0 %", " ".repeat(30)));
        assert_eq!(line(1, 4, second), format!("frame 1/4 [=======>{}] 25 %, 3 s left", " ".repeat(23)));
        assert_eq!(line(4, 4, second), format!("frame 4/4 [{} ] 100 %", "=".repeat(30)));
        for done in 0..=100_000 {
            assert!(line(done, 100_000, Duration::from_secs(7)).len() < 79);
        }
    }
}
