//! What of a file is not drawn, or not as it says.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Something in a file that is not drawn, or not as it says. Never fatal: the rest of the picture is right.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Warning {
    /// What, in words.
    pub message: String,
    /// How many times.
    pub count: usize,
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.count {
            1 => f.write_str(&self.message),
            count => write!(f, "{} ({count} times)", self.message),
        }
    }
}

/// Warnings being gathered; each message once.
#[derive(Debug, Clone, Default)]
pub(super) struct Warnings {
    counts: BTreeMap<String, usize>,
}

impl Warnings {
    pub(super) fn add(&mut self, message: impl Into<String>) {
        *self.counts.entry(message.into()).or_default() += 1;
    }

    pub(super) fn extend(&mut self, other: &Self) {
        for (message, count) in &other.counts {
            *self.counts.entry(message.clone()).or_default() += count;
        }
    }

    pub(super) fn into_list(self) -> Vec<Warning> {
        self.counts.into_iter().map(|(message, count)| Warning { message, count }).collect()
    }
}

/// Warnings that functions add to which the reader of files calls.
#[derive(Default)]
pub(super) struct SharedWarnings(Mutex<Warnings>);

impl SharedWarnings {
    pub(super) fn add(&self, message: impl Into<String>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).add(message);
    }

    pub(super) fn into_inner(self) -> Warnings {
        self.0.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}
