//! Independent parts of the work on as many processors as there are. What they give does not depend on how many that is.

use std::panic::resume_unwind;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{Builder, Scope, ScopedJoinHandle, available_parallelism, scope};

/// As much as a main thread has: expressions are lowered by recursion.
const STACK: usize = 8 << 20;

/// The results of both, which know nothing of each other.
pub(crate) fn side_by_side<A: Send, B>(first: impl Fn() -> A + Sync, second: impl FnOnce() -> B) -> (A, B) {
    scope(|scope| {
        let thread = (processors() > 1).then(|| started(scope, &first)).flatten();
        let second = second();
        (thread.map_or_else(&first, joined), second)
    })
}

/// `f` of each item, in their order.
pub(crate) fn map<T: Sync, U: Send>(items: &[T], f: impl Fn(&T) -> U + Sync) -> Vec<U> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mine = std::iter::from_fn(|| {
            let at = next.fetch_add(1, Ordering::Relaxed);
            Some((at, f(items.get(at)?)))
        });
        mine.collect::<Vec<(usize, U)>>()
    };
    let mut done = scope(|scope| {
        let others = processors().min(items.len()).saturating_sub(1);
        let threads: Vec<_> = (0..others).filter_map(|_| started(scope, work)).collect();
        let own = work();
        threads.into_iter().flat_map(joined).chain(own).collect::<Vec<_>>()
    });
    done.sort_unstable_by_key(|(at, _)| *at);
    done.into_iter().map(|(_, result)| result).collect()
}

fn processors() -> usize {
    static PROCESSORS: OnceLock<usize> = OnceLock::new();
    *PROCESSORS.get_or_init(|| available_parallelism().map_or(1, usize::from))
}

/// A thread, if there can be one more.
fn started<'s, T: Send + 's>(
    scope: &'s Scope<'s, '_>,
    work: impl FnOnce() -> T + Send + 's,
) -> Option<ScopedJoinHandle<'s, T>> {
    Builder::new().stack_size(STACK).spawn_scoped(scope, work).ok()
}

fn joined<T>(thread: ScopedJoinHandle<T>) -> T {
    thread.join().unwrap_or_else(|panic| resume_unwind(panic))
}

#[cfg(test)]
mod tests {
    use super::{map, side_by_side};

    #[test]
    fn results_stand_in_the_order_of_their_items() {
        // Later items take less time, so that threads end out of order.
        let items: Vec<u64> = (0..200).collect();
        let work = |item: &u64| (0..(200 - item) * 1000).fold(*item, |sum, k| std::hint::black_box(sum ^ k) ^ k);
        assert_eq!(map(&items, work), items.iter().map(work).collect::<Vec<_>>());
        assert_eq!(map(&[] as &[u64], work), []);
        assert_eq!(side_by_side(|| 1, || "b"), (1, "b"));
    }

    #[test]
    #[should_panic(expected = "the seventh")]
    fn panics_in_threads_are_those_of_the_caller() {
        map(&[1, 7, 3], |item| assert!(*item != 7, "the seventh"));
    }
}
