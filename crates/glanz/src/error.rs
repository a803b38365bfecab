//! All that can go wrong, as one type.

use thiserror::Error;

#[cfg(feature = "plot")]
use crate::plot;
use crate::{bsdf, color, picture, render, scene};

/// Any error of the library, for programs that pass all of them on. Each converts into it.
///
/// ```
/// fn gold() -> Result<glanz::Scene, glanz::Error> {
///     let mut gold = glanz::scene::library::material("gold")?;
///     gold.lobe_mut(0)?.set("alpha", 0.2)?;
///     Ok(glanz::Scene::new().with_mesh(glanz::Mesh::builtin("sphere")?, gold))
/// }
/// assert_eq!(gold()?.materials.len(), 1);
/// # Ok::<(), glanz::Error>(())
/// ```
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// A scene file cannot be used.
    #[error(transparent)]
    SceneFile(Box<scene::file::FileError>),
    /// A model or a table cannot be read.
    #[error(transparent)]
    Read(#[from] color::read::ReadError),
    /// A part of a scene is not there.
    #[error(transparent)]
    Lookup(#[from] scene::LookupError),
    /// A parameter of a material cannot be set.
    #[error(transparent)]
    Parameter(#[from] scene::ParameterError),
    /// A light has no such place or direction.
    #[error(transparent)]
    Light(#[from] scene::LightError),
    /// A built-in mesh cannot be made.
    #[error(transparent)]
    Mesh(#[from] scene::BuiltinError),
    /// The library has no such material.
    #[error(transparent)]
    Material(#[from] scene::library::UnknownMaterial),
    /// A model does not exist, or not with these parameters.
    #[error(transparent)]
    Model(#[from] bsdf::ParamError),
    /// There is no such light, observer or surface.
    #[error(transparent)]
    Name(#[from] color::UnknownName),
    /// A picture cannot be drawn.
    #[error(transparent)]
    Shot(#[from] render::ShotError),
    /// A picture cannot be written.
    #[error(transparent)]
    Output(#[from] picture::output::OutputError),
    /// A scene cannot be saved.
    #[error(transparent)]
    Write(#[from] scene::file::WriteError),
    /// Pictures cannot be compared.
    #[error(transparent)]
    Compare(#[from] picture::compare::CompareError),
    /// A plot cannot be made.
    #[cfg(feature = "plot")]
    #[error(transparent)]
    Plot(#[from] plot::Error),
    /// A file or a stream.
    #[error(transparent)]
    Io(#[from] std::io::Error),
}

impl From<scene::file::FileError> for Error {
    fn from(error: scene::file::FileError) -> Self {
        Self::SceneFile(Box::new(error))
    }
}

impl From<scene::OpenError> for Error {
    fn from(error: scene::OpenError) -> Self {
        match error {
            scene::OpenError::Scene(error) => error.into(),
            scene::OpenError::Model(error) => error.into(),
        }
    }
}

impl From<render::SaveError> for Error {
    fn from(error: render::SaveError) -> Self {
        match error {
            render::SaveError::Shot(error) => error.into(),
            render::SaveError::Output(error) => error.into(),
        }
    }
}

impl From<render::PrepareError> for Error {
    fn from(error: render::PrepareError) -> Self {
        render::ShotError::from(error).into()
    }
}
