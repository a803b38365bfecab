//! A scene that changes while it is drawn again and again.

mod before;
mod live;

pub use live::Session;
