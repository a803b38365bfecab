//! One picture of a scene: what it is made with, how it is drawn and developed, and its file.

mod draw;
mod error;
mod light_error;
mod memory;
mod mistaken;
mod of_picture;
mod options;
mod output;
mod probe;
mod program_remarks;
mod remarks;
mod sight;
mod spectrum;
mod unseen;
mod xray;

pub use draw::{Shot, Step};
pub use error::{SaveError, ShotError};
pub use light_error::LightError;
pub(crate) use mistaken::mistaken;
pub use of_picture::{PictureLight, SeenPicture, picture_frame, see_picture};
pub use options::ShotOptions;
pub use remarks::{Remark, RemarkKind};
pub(crate) use sight::{Sight, angles};
pub use xray::{NOT_REACHED, UniformFill, ValueFrame, Xray};
