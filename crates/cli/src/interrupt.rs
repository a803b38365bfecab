//! Ctrl-C, and whatever else asks the program to end: nothing half-written is left behind.

use std::process::{Child, ChildStderr, ChildStdin, Command, ExitStatus, exit};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread::sleep;
use std::time::Duration;

use glanz_picture::output::remove_temporaries;

/// The exit code of a program that a signal ended is this and the signal's number, as shells tell it.
const SIGNALLED: i32 = 128;
/// How often it is asked whether a child has ended.
const INTERVAL: Duration = Duration::from_millis(20);

/// Whether being interrupted is the way to end.
static IS_THE_END: AtomicBool = AtomicBool::new(false);
/// The program that this one has started, as long as it runs.
static CHILD: Mutex<Option<Child>> = Mutex::new(None);

/// Held for good by whoever ends the program: the handler of signals, or the way from `main`.
static ENDING: Mutex<()> = Mutex::new(());

/// From now on an interruption removes what is half-written before the program ends.
pub(crate) fn prepare() {
    // Where the system allows no handler, an interruption ends the program as it always did.
    let _ = watch();
}

/// Ends the program at the first signal that asks for it.
#[cfg(unix)]
fn watch() -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU};
    let mut signals = signal_hook::iterator::Signals::new([SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU])?;
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            end(signal);
        }
    };
    std::thread::Builder::new().name("signals".to_owned()).spawn(wait).map(drop)
}

/// Ends the program at the first signal that asks for it.
#[cfg(not(unix))]
fn watch() -> Result<(), ctrlc::Error> {
    /// The number of SIGINT.
    const INTERRUPT: i32 = 2;
    ctrlc::set_handler(|| end(INTERRUPT))
}

/// Ends the program as a signal of this number does.
fn end(signal: i32) {
    settle();
    let mut child = child();
    end_child(&mut child);
    // No other is started: it would write to a temporary file that is removed now.
    core::mem::forget(child);
    remove_temporaries();
    exit(if IS_THE_END.load(Ordering::Relaxed) { 0 } else { SIGNALLED + signal });
}

/// Begins the end of the program. It has one exit code: if a signal ends it, this never returns.
pub(crate) fn settle() {
    core::mem::forget(ENDING.lock().unwrap_or_else(PoisonError::into_inner));
}

/// From now on being interrupted is the way to end, and no failure.
pub(crate) fn is_the_end() {
    IS_THE_END.store(true, Ordering::Relaxed);
}

fn child() -> MutexGuard<'static, Option<Child>> {
    CHILD.lock().unwrap_or_else(PoisonError::into_inner)
}

fn end_child(child: &mut Option<Child>) {
    if let Some(mut child) = child.take() {
        let _ = child.kill();
        let _ = child.wait();
    }
}

/// A started program that is ended with this one, and when this is dropped.
pub(crate) struct Ended(());

impl Ended {
    /// Starts a program, of which there is one at a time, and gives what it reads and what it says.
    pub(crate) fn start(
        command: &mut Command,
    ) -> std::io::Result<(Self, Option<ChildStdin>, Option<ChildStderr>)> {
        let mut child = child();
        let mut started = command.spawn()?;
        let (stdin, stderr) = (started.stdin.take(), started.stderr.take());
        *child = Some(started);
        Ok((Self(()), stdin, stderr))
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
        end_child(&mut child());
    }
}
