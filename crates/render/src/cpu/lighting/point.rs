//! A point that is lit, and the sums of light that it sends.

use glanz_math::inline::{inlined, three};
use glanz_math::{Real, Vec3};

use crate::prepare::{MixTints, PreparedMaterial};

/// A surface point as seen: relative to the eye, along world axes.
#[derive(Clone, Copy)]
pub(crate) struct ShadingPoint<'a, R> {
    pub position: Vec3<R>,
    /// Unit normal; null where the surface shall not be lit.
    pub normal: Vec3<R>,
    /// Unit vector to the viewer.
    pub wo: Vec3<R>,
    /// The surface's tangent, of any length; none where it has none.
    pub tangent: Option<Vec3<R>>,
    /// Multiplies the width of lobes that textures can widen.
    pub alpha_scale: R,
    /// What a texture says of metal.
    pub metal: R,
    /// What pictures say, by channels of the material; empty of vertices and facets, for which their means count.
    pub channels: &'a [R],
    /// Of a pixel, its width; see [`crate::view::lights::ViewLights::pixel`]. None of vertices and facets.
    pub pixel: Option<[f32; 2]>,
}

impl<R: Real> ShadingPoint<'_, R> {
    /// A point of a surface without tangents and textures.
    #[inline(always)]
    pub(crate) fn plain(position: Vec3<R>, normal: Vec3<R>, wo: Vec3<R>) -> Self {
        let one = normal.x.one();
        Self { position, normal, wo, tangent: None, alpha_scale: one, metal: one, channels: &[], pixel: None }
    }

    /// The same with what the material's texture of metal and roughness says on the whole: of vertices and facets.
    #[inline(always)]
    pub(crate) fn at_means(mut self, material: &PreparedMaterial) -> Self {
        if material.metal_rough_map.is_some() {
            let [rough, metal] = material.means.metal_rough.map(f64::from);
            (self.alpha_scale, self.metal) = (self.metal.lit(rough * rough), self.metal.lit(metal));
        }
        self
    }
}

/// Light that textures multiply, and light that they do not.
#[derive(Clone, Copy)]
pub(crate) struct Reflected<R> {
    pub textured: [R; 3],
    pub plain: [R; 3],
}

impl<R: Real> Reflected<R> {
    /// Ambient light times the ambient tints, the textured one mixed by the texel where that mixes spectra.
    #[inline(always)]
    pub(crate) fn ambient(like: R, material: &PreparedMaterial, mix: &Option<(&MixTints, [R; 3])>) -> Self {
        Self {
            textured: match mix {
                Some((mix, texel)) => mixed(&mix.ambient, texel),
                None => literal(like, &material.ambient[0]),
            },
            plain: literal(like, &material.ambient[1]),
        }
    }
}

/// The unit normal, or null where there is none.
#[inline(always)]
pub(crate) fn unit<R: Real>(n: Vec3<R>) -> Vec3<R> {
    n * n.dot(n).max(n.x.lit(1e-30)).rsqrt()
}

/// What a texel makes of three spectra.
#[inline(always)]
pub(crate) fn mixed<R: Real>(basis: &[[f32; 3]; 3], texel: &[R; 3]) -> [R; 3] {
    let [r, g, b] = *texel;
    three(
        [0, 1, 2],
        #[inline(always)]
        |c: usize| {
            let lit = inlined(
                #[inline(always)]
                |spectrum: usize| r.lit(f64::from(basis[spectrum][c])),
            );
            r * lit(0) + g * lit(1) + b * lit(2)
        },
    )
}

#[inline(always)]
pub(crate) fn literal<R: Real>(like: R, tint: &[f32; 3]) -> [R; 3] {
    three(
        *tint,
        #[inline(always)]
        |c| like.lit(f64::from(c)),
    )
}

#[inline(always)]
pub(crate) fn add<R: Real>(sum: &mut [R; 3], value: R, tint: [R; 3]) {
    for c in 0..3 {
        sum[c] = sum[c] + value * tint[c];
    }
}
