//! Independent work items spread over threads, results in the order of the items.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Calls `work` with every item and its index, and returns the results in order. Items are taken in order by up to
/// `threads` threads, the calling one included; if the system refuses threads, fewer do the work.
pub(crate) fn parallel_map<T, R>(threads: usize, items: Vec<T>, work: impl Fn(usize, T) -> R + Sync) -> Vec<R>
where
    T: Send,
    R: Send,
{
    let threads = threads.min(items.len());
    if threads <= 1 || cfg!(target_family = "wasm") {
        return items.into_iter().enumerate().map(|(index, item)| work(index, item)).collect();
    }
    let mut results: Vec<Option<R>> = Vec::new();
    results.resize_with(items.len(), || None);
    // Each item travels with the slot for its result, so that only taking one needs the lock.
    let queue = Mutex::new(items.into_iter().zip(&mut results).enumerate());
    let run = || {
        loop {
            let Some((index, (item, slot))) = lock(&queue).next() else { return };
            *slot = Some(work(index, item));
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads {
            if std::thread::Builder::new().spawn_scoped(scope, run).is_err() {
                break;
            }
        }
        run();
    });
    drop(queue);
    results.into_iter().flatten().collect()
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_keep_the_order_of_the_items() {
        for threads in [0, 1, 2, 7, 100] {
            let items: Vec<usize> = (0..50).collect();
            let results = parallel_map(threads, items, |index, item| (index, item * item));
            assert!(results.iter().enumerate().all(|(i, &r)| r == (i, i * i)), "{threads} threads");
            assert_eq!(results.len(), 50);
        }
    }
}
