//! The threads that draw: those of the caller's rayon pool where the feature `rayon` is on, else the caller's own.
//!
//! Without optimisation every intermediate value of the pixel loop has a place on the stack, and a single tile takes up
//! to 12 MiB of it, where threads commonly have 2. A build like that draws on threads of its own: as many as the
//! caller's pool has, each with [`deep::STACK`].

#[cfg(feature = "rayon")]
use std::sync::{Mutex, PoisonError};

/// How many threads draw.
#[cfg(feature = "rayon")]
pub(super) fn count() -> usize {
    rayon::current_num_threads()
}

/// How many threads draw.
#[cfg(not(feature = "rayon"))]
pub(super) fn count() -> usize {
    1
}

/// The number of this thread in its pool; one past the last for a thread outside.
#[cfg(feature = "rayon")]
pub(super) fn number() -> usize {
    rayon::current_thread_index().unwrap_or_else(count)
}

/// The number of this thread.
#[cfg(not(feature = "rayon"))]
pub(super) fn number() -> usize {
    0
}

/// Runs `work` on a thread that draws.
#[cfg(all(feature = "rayon", not(unoptimized)))]
pub(super) fn enter(work: impl FnOnce() + Send) {
    rayon::scope(|_| work());
}

/// Runs `work` on a thread that draws.
#[cfg(all(not(feature = "rayon"), not(unoptimized)))]
pub(super) fn enter(work: impl FnOnce() + Send) {
    work();
}

#[cfg(unoptimized)]
pub(super) use deep::enter;

/// Runs `work` on every task, begun in their order. Each thread takes the next one whenever it is done, so that none
/// waits for long at the end.
#[cfg(feature = "rayon")]
pub(super) fn for_each<T: Send>(tasks: Vec<T>, work: impl Fn(T) + Sync + Send) {
    let workers = count().min(tasks.len());
    if workers < 2 {
        return tasks.into_iter().for_each(work);
    }
    let queue = Mutex::new(tasks.into_iter());
    let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
    rayon::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|_| {
                while let Some(task) = next() {
                    work(task);
                }
            });
        }
    });
}

/// Runs `work` on every task, one after the other.
#[cfg(not(feature = "rayon"))]
pub(super) fn for_each<T>(tasks: Vec<T>, work: impl Fn(T)) {
    tasks.into_iter().for_each(work);
}

/// Threads with stacks for code that is not optimised.
#[cfg(unoptimized)]
mod deep {
    /// Bytes of stack: nearly three times what the deepest path takes, SSE2's. Only what is used becomes memory.
    const STACK: usize = 32 << 20;

    /// Runs `work` in a pool of as many threads as the caller's has; in the caller's own where the system has no
    /// threads to give.
    #[cfg(feature = "rayon")]
    pub(in crate::cpu) fn enter(work: impl FnOnce() + Send) {
        match pool(rayon::current_num_threads()) {
            Some(pool) => pool.install(work),
            None => rayon::scope(|_| work()),
        }
    }

    /// Pools by their number of threads, made when first needed and kept for good.
    #[cfg(feature = "rayon")]
    fn pool(threads: usize) -> Option<std::sync::Arc<rayon::ThreadPool>> {
        use std::collections::BTreeMap;
        use std::sync::{Arc, Mutex, PoisonError};

        static POOLS: Mutex<BTreeMap<usize, Arc<rayon::ThreadPool>>> = Mutex::new(BTreeMap::new());
        let mut pools = POOLS.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(pool) = pools.get(&threads) {
            return Some(pool.clone());
        }
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build().ok()?;
        Some(pools.entry(threads).or_insert(Arc::new(pool)).clone())
    }

    /// Runs `work` on a thread made for it; on the caller's where the target has no threads.
    #[cfg(not(feature = "rayon"))]
    pub(in crate::cpu) fn enter(work: impl FnOnce() + Send) {
        if cfg!(target_family = "wasm") {
            return work();
        }
        std::thread::scope(|scope| {
            let drawing = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work);
            let ended = drawing.expect("the system has a thread more").join();
            ended.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        });
    }
}

#[cfg(all(test, feature = "rayon"))]
mod tests {
    use super::*;

    #[test]
    fn as_many_threads_draw_as_the_callers_pool_has() {
        let drawing = || {
            let mut found = 0;
            enter(|| found = count());
            found
        };
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            assert_eq!(pool.install(drawing), threads);
        }
        assert_eq!(drawing(), rayon::current_num_threads());
    }
}
