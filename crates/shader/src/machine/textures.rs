//! What shaders see of textures.

/// How fine a texture is looked at.
#[expect(
    clippy::large_enum_variant,
    reason = "it lives for one look, and the large variant is the usual one"
)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lod {
    /// By how far the coordinates move to the next pixel to the right and down, as `texture` does in a fragment shader
    /// and as `textureGrad` is told.
    Gradient {
        /// Change of the coordinates along x, one row per coordinate.
        dx: [[f32; 16]; 3],
        /// Change of the coordinates along y.
        dy: [[f32; 16]; 3],
        /// What is added to the level.
        bias: [f32; 16],
    },
    /// This level (`textureLod`); 0 in vertex shaders.
    Level([f32; 16]),
    /// This component of the 2×2 texels of the finest level that a linear filter would mix: those at the left and right
    /// with the greater v, then at the right and left with the lesser (`textureGather`).
    Gather(usize),
    /// No filter: the coordinates are the bits of whole numbers, the level too (`texelFetch`).
    Texel([i32; 16]),
}

/// One look into a texture for 16 fragments.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureQuery {
    /// Which texture: its index in [`Interface::textures`](crate::Interface::textures).
    pub texture: usize,
    /// Coordinates, one row each; three of 3D textures and of cube maps, which are looked into by a direction (see
    /// [`CubePlace`](crate::CubePlace)). For [`Lod::Texel`] they are whole numbers.
    pub coordinates: [[f32; 16]; 3],
    /// Layer of an array texture.
    pub layer: Option<[f32; 16]>,
    /// The level.
    pub lod: Lod,
    /// Whole texels that are added (`textureOffset`).
    pub offset: [i32; 3],
    /// What the texel is compared with (shadow samplers); the first component of the answer is then the share that
    /// passes.
    pub compare: Option<[f32; 16]>,
}

/// Textures that a shader looks into.
pub trait Textures: Sync {
    /// The texels: red, green, blue, alpha of 16 fragments. They arrive filled with opaque black.
    fn sample(&self, query: &TextureQuery, texels: &mut [[f32; 16]; 4]);

    /// Width, height and depth (or layers) of a level.
    fn size(&self, texture: usize, level: u32) -> [u32; 3] {
        let _ = (texture, level);
        [1; 3]
    }

    /// The number of levels.
    fn levels(&self, texture: usize) -> u32 {
        let _ = texture;
        1
    }
}

/// What a shadow sampler gives: the share of the four texels around a place that `depth` does not exceed, by their
/// weights in a linear filter.
///
/// `texels` are in the order of `textureGather`: upper left, upper right, lower right, lower left, where v goes up;
/// `part` is how far the place lies from the lower left one.
///
/// ```
/// assert_eq!(glanz_shader::compared([0.2, 0.9, 0.2, 0.9], [0.25, 0.0], 0.5), 0.75);
/// ```
pub fn compared(texels: [f32; 4], part: [f32; 2], depth: f32) -> f32 {
    let depth = depth.clamp(0.0, 1.0);
    let weights = [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)].map(|(x, y): (f32, f32)| {
        let along = |at: f32, part: f32| 1.0 - (at - part).abs();
        along(x, part[0]) * along(y, part[1])
    });
    texels.iter().zip(weights).map(|(texel, weight)| if depth <= *texel { weight } else { 0.0 }).sum()
}

/// No textures: every look gives opaque black.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTextures;

impl Textures for NoTextures {
    fn sample(&self, _: &TextureQuery, _: &mut [[f32; 16]; 4]) {}
}

/// The level of a look: registers of its numbers.
#[derive(Clone, Debug)]
pub(crate) enum LookLod<R> {
    Auto,
    Bias(R),
    Level(R),
    Gradient(Vec<R>, Vec<R>),
    /// This component of four texels.
    Gather(usize),
    Texel(Option<R>),
    /// Not a look at texels: the size of a level.
    Size(Option<R>),
    /// The number of levels.
    Levels,
}

/// An entry of a program's table of looks. `R` numbers registers.
#[derive(Clone, Debug)]
pub(crate) struct Look<R> {
    pub(crate) texture: usize,
    pub(crate) coordinates: Vec<R>,
    pub(crate) layer: Option<R>,
    pub(crate) offset: [i32; 3],
    pub(crate) compare: Option<R>,
    pub(crate) lod: LookLod<R>,
}

impl<R: Copy> Look<R> {
    /// The same with other numbers of registers.
    pub(crate) fn map<T>(&self, f: impl Fn(R) -> T) -> Look<T> {
        let all = |r: &[R]| r.iter().map(|r| f(*r)).collect::<Vec<T>>();
        Look {
            texture: self.texture,
            coordinates: all(&self.coordinates),
            layer: self.layer.map(&f),
            offset: self.offset,
            compare: self.compare.map(&f),
            lod: match &self.lod {
                LookLod::Auto => LookLod::Auto,
                LookLod::Bias(r) => LookLod::Bias(f(*r)),
                LookLod::Level(r) => LookLod::Level(f(*r)),
                LookLod::Gradient(x, y) => LookLod::Gradient(all(x), all(y)),
                LookLod::Gather(component) => LookLod::Gather(*component),
                LookLod::Texel(r) => LookLod::Texel(r.map(&f)),
                LookLod::Size(r) => LookLod::Size(r.map(&f)),
                LookLod::Levels => LookLod::Levels,
            },
        }
    }

    /// All registers that it reads.
    pub(crate) fn reads(&self) -> Vec<R> {
        let mut all = self.coordinates.clone();
        all.extend(self.layer.iter().chain(&self.compare).copied());
        match &self.lod {
            LookLod::Auto | LookLod::Levels | LookLod::Gather(_) => {}
            LookLod::Bias(r) | LookLod::Level(r) => all.push(*r),
            LookLod::Gradient(x, y) => all.extend(x.iter().chain(y).copied()),
            LookLod::Texel(r) | LookLod::Size(r) => all.extend(r.iter().copied()),
        }
        all
    }
}
