//! The generalised cosine lobe: Phong's highlight about any direction that depends on the light's linearly.
//!
//! Formula, parameters, source and cost: [`Lafortune::INFO`](crate::Model::INFO), and docs/MODELS.md.
//!
//! **Laws** reciprocal; conserves energy: the albedo is 1 at most, where the lobe stands on the normal.
//!
//! **Limits** Cx = Cy = −Cz is Phong's lobe, normalised after Lewis 1994; Cx = Cy = Cz sends light back; Cx = Cy =
//! 0 is diffuse and darker at the limb; n = 0 is Lambert's law. All of C 0 is black. Lobes that lean to the horizon
//! are cut by it and darken, as Phong's do.
//!
//! **Notes** Only the ratios of C count. The paper puts reflectance and normalisation into C; published fits are of
//! that raw kind. Here a lobe is normalised as the paper's classic one, where (n+2)/(2π) goes with max|C| = 1, so
//! that a tint is its greatest albedo: [`Lafortune::raw_tint`] gives the tint of a raw lobe.

use glanz_math::{Exponent, PI, Real};

use crate::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side};

/// The generalised cosine lobe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lafortune {
    cx: f64,
    cy: f64,
    cz: f64,
    n: Exponent,
    /// C / max|C|.
    direction: [f64; 3],
    /// (n+2)/(2π), or 0 for a lobe without direction.
    height: f64,
}

/// One of the three coefficients.
const fn coefficient(name: &'static str, symbol: &'static str, doc: &'static str, default: f64) -> ParamInfo {
    ParamInfo { name, symbol, doc, min: -2.0, max: 2.0, default }
}

impl Model for Lafortune {
    const INFO: ModelInfo = ModelInfo {
        name: "lafortune",
        title: "Lafortune 1997",
        formula: "cosθi · (n+2)/(2π) · (max(Cx wox wix + Cy woy wiy + Cz cosθo cosθi, 0) / max|C|)ⁿ",
        source: "E. P. F. Lafortune et al., Non-Linear Approximation of Reflectance Functions, SIGGRAPH 1997",
        params: &[
            coefficient("cx", "Cx", "weight along the tangent: negative mirrors, positive sends back", -1.0),
            coefficient("cy", "Cy", "weight across the tangent: negative mirrors, positive sends back", -1.0),
            coefficient(
                "cz",
                "Cz",
                "weight along the normal: less than |Cx| leans the lobe to the horizon",
                1.0,
            ),
            ParamInfo {
                name: "n",
                symbol: "n",
                doc: "exponent: the greater, the narrower the lobe",
                min: 0.0,
                max: 1000.0,
                default: 32.0,
            },
        ],
        term: LightTerm::Specular,
        side: Side::Reflection,
        anisotropic: true,
        delta: false,
        operations: 17,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        let (cx, cy, cz, n) = (values[0], values[1], values[2], values[3]);
        let greatest = cx.abs().max(cy.abs()).max(cz.abs());
        let (direction, height) = if greatest > 0.0 {
            ([cx, cy, cz].map(|c| c / greatest), (n + 2.0) / (2.0 * PI))
        } else {
            ([0.0; 3], 0.0)
        };
        Self { cx, cy, cz, n: Exponent::new(n), direction, height }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.cx, self.cy, self.cz, self.n.n()]
    }

    #[inline(always)]
    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let zero = pair.cos_i.zero();
        let [x, y, z] = self.direction.map(|c| zero.lit(c));
        let cosine = pair.tangent_o.0 * pair.tangent_i.0 * x
            + pair.tangent_o.1 * pair.tangent_i.1 * y
            + pair.cos_o * pair.cos_i * z;
        let power = cosine.power(&self.n);
        pair.cos_i.max(zero) * power * zero.lit(self.height)
    }
}

impl Lafortune {
    /// The tint that makes this lobe the raw one of a published fit, whose f is (Cx wox wix + …)ⁿ: 2π/(n+2)
    /// max|C|ⁿ.
    ///
    /// ```
    /// use glanz_bsdf::{DirectionPair, Model, models::lafortune::Lafortune};
    ///
    /// let raw = [("cx", -0.9), ("cy", -0.9), ("cz", 0.8), ("n", 10.0)];
    /// let lobe = Lafortune::with_params(&raw)?;
    /// // Along the normal f is Czⁿ as published.
    /// let f: f64 = lobe.f_cos(&DirectionPair::isotropic(1.0, 1.0, 1.0)) * lobe.raw_tint();
    /// assert!((f - 0.8_f64.powi(10)).abs() < 1e-12);
    /// # Ok::<(), glanz_bsdf::ParamError>(())
    /// ```
    pub fn raw_tint(&self) -> f64 {
        let greatest = self.cx.abs().max(self.cy.abs()).max(self.cz.abs());
        2.0 * PI / (self.n.n() + 2.0) * libm::pow(greatest, self.n.n())
    }
}

#[cfg(test)]
mod tests;
