//! Kinds of materials.

/// What kind of thing a material is, or which table it is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Category {
    /// Bare metals by spectral η and k.
    Metal,
    /// Films as thin as a wavelength.
    Film,
    /// Paints and lacquers, those of cars among them.
    Paint,
    /// Plastics and rubber.
    Plastic,
    /// Woven and felted things.
    Cloth,
    /// Paper, card and lampshades.
    Paper,
    /// Leaves.
    Plant,
    /// Timber.
    Wood,
    /// Stone, plaster, ceramics.
    Mineral,
    /// Glass, water and other clear media.
    Glass,
    /// Table 1 of Ward 1992.
    Ward1992,
    /// Fits of Ngan, Durand and Matusik 2005.
    Ngan2005,
    /// The classic table of OpenGL.
    OpenGl,
}

impl Category {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Metal,
        Self::Film,
        Self::Paint,
        Self::Plastic,
        Self::Cloth,
        Self::Paper,
        Self::Plant,
        Self::Wood,
        Self::Mineral,
        Self::Glass,
        Self::Ward1992,
        Self::Ngan2005,
        Self::OpenGl,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Metal => "metal",
            Self::Film => "film",
            Self::Paint => "paint",
            Self::Plastic => "plastic",
            Self::Cloth => "cloth",
            Self::Paper => "paper",
            Self::Plant => "plant",
            Self::Wood => "wood",
            Self::Mineral => "mineral",
            Self::Glass => "glass",
            Self::Ward1992 => "ward1992",
            Self::Ngan2005 => "ngan2005",
            Self::OpenGl => "opengl",
        }
    }

    /// The category of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|category| category.name() == name)
    }
}
