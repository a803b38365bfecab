//! The parts of a scene by their names or numbers.

mod error;
mod key;
mod lookup;

pub use error::LookupError;
pub(crate) use error::known_names;
pub use key::Key;
pub(crate) use lookup::number_of;
