//! Threads: how the chunks and tiles of a frame are shared out.
//!
//! In: work items and one worker's memory per thread. Out: every item done once. Threads take the next item when they
//! are free; no result depends on who does what, or when.

pub use crate::clock::Deadline;

use core::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// The order in which tiles are drawn. It never changes a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum TileOrder {
    /// Tiles with most triangles first, to a factor of two, so that no thread is left with a large one at the end; those
    /// of a kind row by row, because neighbours share the memory pages of their pixels.
    #[default]
    MostWorkFirst,
    /// Row by row.
    Rows,
    /// Row by row, backwards.
    RowsReversed,
    /// Scattered over the picture.
    Scattered,
}

/// Hands every item of `items` to one of the workers. Each worker runs on a thread of its own; the first one runs on
/// the caller's.
pub fn share<W: Send, T: Send, F>(workers: &mut [W], items: impl Iterator<Item = T> + Send, work: F)
where
    F: Fn(&mut W, T) + Sync,
{
    let Some((first, others)) = workers.split_first_mut() else { return };
    // The standard library starts no threads in WebAssembly: asked to, it panics.
    if others.is_empty() || cfg!(target_family = "wasm") {
        items.for_each(|item| work(first, item));
        return;
    }
    let queue = Queue::new(items);
    let run = |worker: &mut W| {
        while let Some(item) = queue.next() {
            work(worker, item);
        }
    };
    std::thread::scope(|scope| {
        for worker in others {
            scope.spawn(|| run(worker));
        }
        run(first);
    });
}

/// Items and the number of the first one that nobody has taken. Threads meet at the counter only: one lock around all
/// items would make them sleep and wake each other for every empty tile.
struct Queue<T> {
    items: Vec<Mutex<Option<T>>>,
    next: AtomicUsize,
}

impl<T> Queue<T> {
    fn new(items: impl Iterator<Item = T>) -> Self {
        Self { items: items.map(|item| Mutex::new(Some(item))).collect(), next: AtomicUsize::new(0) }
    }

    fn next(&self) -> Option<T> {
        // Each number is handed out once, and what an item holds was written before the threads were started.
        let item = self.items.get(self.next.fetch_add(1, Ordering::Relaxed))?;
        item.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}

/// Tile numbers in the order in which they are to be drawn; `cost` is each tile's number of triangles.
pub(crate) fn tile_sequence(order: TileOrder, cost: &[u32]) -> Vec<u32> {
    let mut tiles: Vec<u32> = (0..cost.len() as u32).collect();
    match order {
        TileOrder::Rows => {}
        TileOrder::RowsReversed => tiles.reverse(),
        TileOrder::MostWorkFirst => tiles.sort_by_key(|&tile| cost[tile as usize].leading_zeros()),
        TileOrder::Scattered => tiles.sort_by_key(|&tile| tile.wrapping_mul(0x9E37_79B1).rotate_left(16)),
    }
    tiles
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_item_is_done_once() {
        for threads in [1, 2, 5] {
            let mut sums = vec![0u64; threads];
            share(&mut sums, 0..10_000u64, |sum, item| *sum += item);
            assert_eq!(sums.iter().sum::<u64>(), 9_999 * 5_000);
        }
    }

    #[test]
    fn sequences_are_permutations() {
        let cost = [3, 0, 9, 9, 1];
        for order in [TileOrder::MostWorkFirst, TileOrder::Rows, TileOrder::RowsReversed, TileOrder::Scattered] {
            let mut tiles = tile_sequence(order, &cost);
            tiles.sort_unstable();
            assert_eq!(tiles, [0, 1, 2, 3, 4]);
        }
        assert_eq!(tile_sequence(TileOrder::MostWorkFirst, &[5, 0, 9, 4, 0, 15]), [2, 5, 0, 3, 1, 4]);
    }
}
