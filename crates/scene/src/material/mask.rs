//! Numbers that pictures say at each place of a surface: how much of a lobe there is, and how rough it is.

use serde::{Deserialize, Serialize};

use crate::TextureUse;
use crate::names::names;

names! {
    /// A channel of a picture.
    pub TextureChannel {
        /// Red.
        Red = "red",
        /// Green.
        Green = "green",
        /// Blue.
        Blue = "blue",
        /// Alpha.
        Alpha = "alpha",
    } default Red
}

/// One channel of a picture on a surface, a number from 0 to 1 at each place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ChannelUse {
    /// The picture and how it lies. Its `scale` has no meaning here.
    pub map: TextureUse,
    /// Which of its channels.
    pub channel: TextureChannel,
}

impl ChannelUse {
    /// The most different ones that all of a material may have.
    pub const MOST: usize = 16;
}

/// A factor that a picture says: from one value where its channel is 0 to another where it is 1. On surfaces that are
/// shaded at facets or vertices, and where there are no texture coordinates, the channel counts as 1.
///
/// ```
/// use glanz_bsdf::Shape;
/// use glanz_scene::{TextureChannel, ChannelUse, Lobe, Mask, TextureUse};
///
/// // Gloss where the first picture of the scene is red.
/// let red = ChannelUse { map: TextureUse::plain(0), channel: TextureChannel::Red };
/// let gloss = Lobe::new(Shape::named("ggx", &[("alpha", 0.1)])?, [0.04; 3]).masked(Mask::of(red));
/// assert_eq!(gloss.masks[0].at(0.25), 0.25);
/// assert_eq!(Mask { from: 1.0, to: 0.2, ..Mask::of(red) }.at(0.5), 0.6);
/// # Ok::<(), glanz_bsdf::ParamError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mask {
    /// What says it.
    pub of: ChannelUse,
    /// The factor where the channel is 0.
    pub from: f64,
    /// The factor where the channel is 1.
    pub to: f64,
}

impl Mask {
    /// The channel itself.
    pub const fn of(of: ChannelUse) -> Self {
        Self { of, from: 0.0, to: 1.0 }
    }

    /// The factor where the channel has this value.
    pub fn at(&self, channel: f64) -> f64 {
        self.from + (self.to - self.from) * channel
    }
}

/// What says how rough a lobe is, beside its own width.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum RoughnessMap {
    /// The material's, if it has one.
    #[default]
    Material,
    /// Nothing: it is as rough as it is everywhere.
    Uniform,
    /// A picture of its own. As the material's it scales the roughness, whose square is the width.
    Own(ChannelUse),
}
