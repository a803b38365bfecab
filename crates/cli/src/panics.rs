//! Faults of the program itself, told as one error.

use std::any::Any;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::{Mutex, PoisonError};

use crate::print::failure::{Failure, Report};

/// What the first panic said, and where.
static FIRST: Mutex<Option<String>> = Mutex::new(None);

/// From now on a panic is kept, to be told by [`caught`]. With `RUST_BACKTRACE=full` it is told with its way, too.
pub(crate) fn prepare() {
    let usual = take_hook();
    let whole = std::env::var_os("RUST_BACKTRACE").is_some_and(|value| value == "full");
    set_hook(Box::new(move |info| {
        let mut first = FIRST.lock().unwrap_or_else(PoisonError::into_inner);
        if first.is_none() {
            *first = Some(words(info));
        }
        drop(first);
        if whole {
            usual(info);
        }
    }));
}

/// Does some work; a panic in it, on any of its threads, becomes a failure.
pub(crate) fn caught(work: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|payload| {
        let told = FIRST.lock().unwrap_or_else(PoisonError::into_inner).take();
        let what = told.unwrap_or_else(|| message(payload.as_ref()));
        let report = Report::new(format_args!("a fault of Glanz or of a library that it uses: {what}"));
        let help = "nothing was written of what failed; please report the command line with its files, and what RUST_BACKTRACE=full says";
        Err(report.help(help).into())
    })
}

/// What a panic says, in one line, and where it happened.
fn words(info: &PanicHookInfo<'_>) -> String {
    let place = info.location().map_or(String::new(), |place| {
        // Of the way to a library's file, what follows its sources' folder.
        let file = place.file().replace('\\', "/");
        let short = file.split("/src/").collect::<Vec<_>>();
        let short = match short[..] {
            [.., package, inside] => format!("{}/{inside}", package.rsplit('/').next().unwrap_or(package)),
            _ => file.clone(),
        };
        format!(" ({short}:{})", place.line())
    });
    format!("{}{place}", message(info.payload()))
}

fn message(payload: &dyn Any) -> String {
    let text = payload.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or("no message");
    text.lines().next().unwrap_or_default().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_one_error_with_its_place() {
        prepare();
        let failure = caught(|| panic!("index {} of {}", 3, 2)).unwrap_err();
        assert_eq!(failure.code(), 3);
        let Failure::CouldNot(report) = failure else { panic!("it could not be done") };
        let text = report.to_string();
        assert!(text.contains("index 3 of 2 (") && text.contains("panics.rs:"), "{text}");
        assert!(caught(|| Ok(())).is_ok());
    }
}
