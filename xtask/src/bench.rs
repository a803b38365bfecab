//! How fast it draws, and how fast others do.

use crate::house::{House, run};
use crate::{Result, peers};

/// What is measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Fewer frames.
    pub quick: bool,
    /// The peers, too.
    pub peers: bool,
    /// The peers alone.
    pub only_peers: bool,
}

/// Measures and prints one JSON line per measurement.
pub fn run_all(house: &House, options: &Options) -> Result<()> {
    if !options.only_peers {
        let quick = if options.quick { " -- --quick" } else { "" };
        run(&mut house.cargo(&format!("run --release --package glanz-render --example bench{quick}")))?;
    }
    if options.peers || options.only_peers {
        peers::run_all(house, options.quick)?;
    }
    Ok(())
}
