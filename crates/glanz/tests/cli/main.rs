//! The command as a user types it: what it prints, what it writes, and how it fails.

mod errors;
mod help;
mod house;
mod models;
mod pictures;
