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
    /// |wo + wi|², of the half vector before it is normalised: 2 + 2 wo·wi, but exact to rounding where light and viewer
    /// oppose each other, too.
    pub half2: R,
    /// The tangential coordinates of `wo`; zero from [`DirectionPair::isotropic`].
    pub tangent_o: (R, R),
    /// The tangential coordinates of `wi`; zero from [`DirectionPair::isotropic`].
    pub tangent_i: (R, R),
    /// Multiplies the width of a microfacet distribution, 0 … 1: what a roughness texture says. Models that
    /// textures cannot widen do not read it.
    pub alpha_scale: R,
}

/// Below this |wo + wi|² is taken from the vectors. The sum of 2 and 2 wo·wi is exact to 1e-6 above it in single
/// precision, and has no digit left where the directions are within a few thousandths of opposite.
pub(crate) const FROM_VECTORS: f64 = 0.25;

impl<R: Real> DirectionPair<R> {
    /// The pair of two unit vectors in the local frame.
    #[inline(always)]
    pub fn new(wo: Vec3<R>, wi: Vec3<R>) -> Self {
        Self { tangent_o: (wo.x, wo.y), tangent_i: (wi.x, wi.y), ..Self::between((wo.z, wo), (wi.z, wi)) }
    }

    /// The pair for models that do not read the tangent: the cosine to the normal of each of two unit vectors, and the
    /// vectors in any frame.
    ///
    /// ```
    /// use glanz_bsdf::DirectionPair;
    /// use glanz_math::Vec3;
    ///
    /// // Among the world's axes, on a slope: viewer and light low on both sides of it.
    /// let normal = Vec3::new(0.6_f32, 0.8, 0.0);
    /// let (wo, wi) = (Vec3::new(0.8016_f32, -0.5979, 0.0), Vec3::new(-0.799, 0.6013, 0.0));
    /// let pair = DirectionPair::between((normal.dot(wo), wo), (normal.dot(wi), wi));
    /// // wo + wi is (0.0026, 0.0034, 0), which is the normal times 0.00428.
    /// assert!((pair.half2.sqrt() - 0.00428).abs() < 1e-6);
    /// assert!((pair.cos_half() - 1.0).abs() < 1e-3);
    /// ```
    #[inline(always)]
    pub fn between((cos_o, wo): (R, Vec3<R>), (cos_i, wi): (R, Vec3<R>)) -> Self {
        let mut pair = Self::isotropic(cos_o, cos_i, wo.dot(wi));
        pair.half2 = refined(
            pair.half2,
            #[inline(always)]
            || (wo + wi).dot(wo + wi),
        );
        pair
    }

    /// The pair for models that do not read the tangent, from cosines alone. Where light and viewer oppose each other the
    /// cosine between them does not tell the half vector; [`DirectionPair::between`] does.
    #[inline(always)]
    pub fn isotropic(cos_o: R, cos_i: R, cos_io: R) -> Self {
        let (zero, one) = (cos_o.zero(), cos_o.one());
        let half2 = (cos_io + one) * cos_io.lit(2.0);
        Self {
            cos_o,
            cos_i,
            cos_io,
            half2,
            tangent_o: (zero, zero),
            tangent_i: (zero, zero),
            alpha_scale: one,
        }
    }

    /// The pair with the light mirrored at the surface, to the other side of it.
    #[inline(always)]
    pub(crate) fn mirrored(&self) -> Self {
        let height = self.cos_o * self.cos_i;
        let cos_io = self.cos_io - height - height;
        let half2 = refined(
            (cos_io + cos_io.one()) * cos_io.lit(2.0),
            #[inline(always)]
            || (self.half2 - height * height.lit(4.0)).max(height.zero()),
        );
        Self { cos_i: -self.cos_i, cos_io, half2, ..*self }
    }

    /// R·wo, where R is `wi` mirrored about the normal: 2 (n·wi)(n·wo) − wi·wo.
    ///
    /// ```
    /// use glanz_bsdf::DirectionPair;
    ///
    /// // Viewer along the normal, light 60° off it: the mirrored light is 60° off the viewer.
    /// let pair = DirectionPair::isotropic(1.0_f64, 0.5, 0.5);
    /// assert_eq!(pair.cos_mirror(), 0.5);
    /// // The half vector is 30° off both.
    /// assert!((pair.cos_half() - 0.75_f64.sqrt()).abs() < 1e-15);
    /// ```
    #[inline(always)]
    pub fn cos_mirror(&self) -> R {
        let half = self.cos_i * self.cos_o;
        half + half - self.cos_io
    }

    /// wo·h, where h is the half vector: the cosine of the angle of reflection at a facet that mirrors
    /// the light to the viewer. √((1 + wo·wi) / 2), which is |wo + wi| / 2.
    #[inline(always)]
    pub fn cos_view_half(&self) -> R {
        (self.half2 * self.half2.lit(0.25)).clamp(0.0, 1.0).sqrt()
    }

    /// n·h, where h is the half vector: (n·wi + n·wo) / |wi + wo|.
    #[inline(always)]
    pub fn cos_half(&self) -> R {
        // Opposite directions have no half vector; the floor keeps the quotient finite there.
        (self.cos_i + self.cos_o) * self.half2.max(self.half2.lit(1e-12)).rsqrt()
    }
}

/// |wo + wi|² from the cosine between both, or from the vectors where that has lost its digits.
#[inline(always)]
fn refined<R: Real>(from_cosine: R, from_vectors: impl FnOnce() -> R) -> R {
    let opposite = from_cosine.lt(from_cosine.lit(FROM_VECTORS));
    if R::any(opposite) { from_vectors().select(opposite, from_cosine) } else { from_cosine }
}
