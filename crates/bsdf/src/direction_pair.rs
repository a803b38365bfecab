//! The two directions that a lobe is evaluated for.

use glanz_math::{Real, Vec3};

/// View and light direction in the local frame, as the numbers that lobes use, with the factor of a roughness texture.
///
/// Isotropic models read the three cosines only, which the pixel loop has without building a frame.
///
/// ```
/// use glanz_bsdf::DirectionPair;
/// use glanz_math::Vec3;
///
/// let pair = DirectionPair::new(Vec3::from_angles(0.3, 0.0), Vec3::from_angles(0.3, std::f64::consts::PI));
/// // The light comes from the mirror direction of the viewer.
/// assert!((pair.cos_mirror() - 1.0).abs() < 1e-12 && (pair.cos_half() - 1.0).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct DirectionPair<R> {
    /// n·wo, cosine of the view angle.
    pub cos_o: R,
    /// n·wi, cosine of the angle of incidence.
    pub cos_i: R,
    /// wo·wi.
    pub cos_io: R,
    /// The tangential coordinates of `wo`; zero from [`DirectionPair::isotropic`].
    pub tangent_o: (R, R),
    /// The tangential coordinates of `wi`; zero from [`DirectionPair::isotropic`].
    pub tangent_i: (R, R),
    /// Multiplies the width of a microfacet distribution, 0 … 1: what a roughness texture says. Models that
    /// textures cannot widen do not read it.
    pub alpha_scale: R,
}

impl<R: Real> DirectionPair<R> {
    /// The pair of two unit vectors in the local frame.
    #[inline(always)]
    pub fn new(wo: Vec3<R>, wi: Vec3<R>) -> Self {
        Self {
            cos_o: wo.z,
            cos_i: wi.z,
            cos_io: wo.dot(wi),
            tangent_o: (wo.x, wo.y),
            tangent_i: (wi.x, wi.y),
            alpha_scale: wo.z.one(),
        }
    }

    /// The pair for models that do not read the tangent.
    #[inline(always)]
    pub fn isotropic(cos_o: R, cos_i: R, cos_io: R) -> Self {
        let zero = cos_o.zero();
        let alpha_scale = cos_o.one();
        Self { cos_o, cos_i, cos_io, tangent_o: (zero, zero), tangent_i: (zero, zero), alpha_scale }
    }

    /// R·wo, where R is `wi` mirrored about the normal: 2 (n·wi)(n·wo) − wi·wo.
    #[inline(always)]
    pub fn cos_mirror(&self) -> R {
        let half = self.cos_i * self.cos_o;
        half + half - self.cos_io
    }

    /// wo·h, where h is the half vector: the cosine of the angle of reflection at a facet that mirrors
    /// the light to the viewer. √((1 + wo·wi) / 2).
    #[inline(always)]
    pub fn cos_view_half(&self) -> R {
        ((self.cos_io.one() + self.cos_io) * self.cos_io.lit(0.5)).clamp(0.0, 1.0).sqrt()
    }

    /// n·h, where h is the half vector: (n·wi + n·wo) / |wi + wo|.
    #[inline(always)]
    pub fn cos_half(&self) -> R {
        let length_squared = (self.cos_io + self.cos_io.one()) * self.cos_io.lit(2.0);
        // Opposite directions have no half vector; the floor keeps the quotient finite there.
        (self.cos_i + self.cos_o) * length_squared.max(self.cos_io.lit(1e-12)).rsqrt()
    }
}
