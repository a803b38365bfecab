//! Ctrl-C, and whatever else asks the program to end: nothing half-written is left behind.

use std::process::{Child, ExitStatus, exit};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::sleep;
use std::time::Duration;

use glanz_picture::output::remove_temporaries;

/// The exit code of a program that a signal ended, as shells tell it: 128 + SIGINT.
const INTERRUPTED: i32 = 130;
/// How often it is asked whether a child has ended.
const INTERVAL: Duration = Duration::from_millis(20);

/// Whether being interrupted is the way to end.
static IS_THE_END: AtomicBool = AtomicBool::new(false);
/// The program that this one has started, as long as it runs.
static CHILD: Mutex<Option<Child>> = Mutex::new(None);

/// From now on an interruption removes what is half-written before the program ends.
pub(crate) fn prepare() {
    // Where the system allows no handler, an interruption ends the program as it always did.
    let _ = ctrlc::set_handler(|| {
        end_child();
        remove_temporaries();
        exit(if IS_THE_END.load(Ordering::Relaxed) { 0 } else { INTERRUPTED });
    });
}

/// From now on being interrupted is the way to end, and no failure.
pub(crate) fn is_the_end() {
    IS_THE_END.store(true, Ordering::Relaxed);
}

fn child() -> MutexGuard<'static, Option<Child>> {
    CHILD.lock().unwrap_or_else(PoisonError::into_inner)
}

fn end_child() {
    if let Some(mut child) = child().take() {
        let _ = child.kill();
        let _ = child.wait();
    }
}

/// A started program that is ended with this one, and when this is dropped.
pub(crate) struct Ended(());

impl Ended {
    /// Takes charge of the program; there is one at a time.
    pub(crate) fn of(started: Child) -> Self {
        *child() = Some(started);
        Self(())
    }

    /// Waits until it has ended by itself.
    pub(crate) fn wait(self) -> std::io::Result<ExitStatus> {
        loop {
            // Not locked while waiting, so that an interruption gets through.
            let ended = match child().as_mut() {
                Some(child) => child.try_wait()?,
                None => return Err(std::io::Error::other("it was ended")),
            };
            match ended {
                Some(status) => return Ok(status),
                None => sleep(INTERVAL),
            }
        }
    }
}

impl Drop for Ended {
    fn drop(&mut self) {
        end_child();
    }
}
