//! A clear or coloured layer over any material: varnish, car paint, glaze.

use std::sync::Arc;

use glanz_bsdf::{CoatSurface, LayerWeight, LightTerm, ParamError, Shape, Side, layered_albedo};
use glanz_color::{Ior, Rgb, Spectrum};
use serde::{Deserialize, Serialize};

use crate::material::coated_boundary::MIDDLE_NM;
use crate::{Absorption, Boundary, CoatedBoundary, Lobe, Material, Tint};

/// The cosine to the viewer at which the reflectance of a measured base is looked at.
const MEAN_COSINE: f64 = 0.7;

/// What reflects less than this is as black as this under a coat.
const LEAST_REFLECTANCE: f64 = 1e-6;

/// A layer over a material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coat {
    /// Its index of refraction.
    pub ior: Ior,
    /// The width of its highlight, as of the shape `ggx`.
    pub alpha: f64,
    /// How much of the surface it covers, 0 to 1.
    pub weight: f64,
    /// Its thickness in mm; 0 is no coat at all.
    pub thickness_mm: f64,
    /// How it absorbs, per mm; `None` if it is clear.
    pub absorption_per_mm: Option<Spectrum>,
}

impl Default for Coat {
    fn default() -> Self {
        Self {
            ior: Ior::constant(1.5),
            alpha: 0.03,
            weight: 1.0,
            thickness_mm: 0.05,
            absorption_per_mm: None,
        }
    }
}

impl Coat {
    /// The index at the middle of the visible range, by which the geometry of the layer goes.
    fn eta(&self) -> f64 {
        self.ior.eta.at(MIDDLE_NM)
    }

    fn absorption(&self) -> Option<Arc<Absorption>> {
        let depth = self.absorption_per_mm? * self.thickness_mm;
        Some(Arc::new(Absorption { depth, eta: self.eta() }))
    }

    /// The boundary whose highlight a lobe is, if it is known.
    fn boundary(&self, lobe: &Lobe) -> Option<CoatedBoundary> {
        let info = lobe.shape.info();
        let reflects = info.term == LightTerm::Specular && info.side == Side::Reflection;
        let below = Boundary::of(&lobe.tint).filter(|_| reflects)?;
        Some(CoatedBoundary { below, coat: self.ior.clone(), alpha: self.alpha })
    }

    /// What becomes of a lobe below it.
    fn over(
        &self,
        surface: &CoatSurface,
        lobe: Lobe,
        measured: &Spectrum,
        absorption: &Option<Arc<Absorption>>,
    ) -> Lobe {
        let is_matte = is_matte(&lobe);
        // What comes back to the base from below the coat depends on its colour: where a texture darkens it further,
        // this is a little too bright.
        let boundary = self.boundary(&lobe);
        let layer = match &boundary {
            _ if is_matte => LayerWeight::over_matte(surface),
            Some(_) => LayerWeight::over_boundary(surface),
            None => LayerWeight::over_glossy(surface),
        };
        let tint = match boundary {
            _ if is_matte && is_measured(&lobe) => darker_by(&lobe.tint, measured, surface),
            _ if is_matte => darker(&lobe.tint, surface),
            Some(boundary) => Tint::Coated(Arc::new(boundary)),
            None => lobe.tint.clone(),
        };
        Lobe { tint, absorption: absorption.clone(), ..lobe }.under(layer)
    }
}

/// A matte tint as it looks under a coat; re-radiation, which moves light about, is left as it is.
fn darker(tint: &Tint, coat: &CoatSurface) -> Tint {
    match tint {
        Tint::Rgb(rgb) => Rgb(rgb.0.map(|c| coat.reflectance_of_coated(f64::from(c)) as f32)).into(),
        Tint::Spectrum(spectrum) => Tint::Spectrum(Arc::new(spectrum.map(|c| coat.reflectance_of_coated(c)))),
        other => other.clone(),
    }
}

fn is_matte(lobe: &Lobe) -> bool {
    lobe.shape.info().term == LightTerm::Diffuse && lobe.shape.info().side == Side::Reflection
}

fn is_measured(lobe: &Lobe) -> bool {
    lobe.layers.iter().any(|layer| matches!(layer, LayerWeight::Table { .. }))
}

/// The reflectance of all matte lobes together that are ranks of measured reflectance, of which each may be negative.
fn measured_matte(lobes: &[Lobe]) -> Spectrum {
    let mut whole = Spectrum::ZERO;
    for lobe in lobes.iter().filter(|lobe| is_matte(lobe) && is_measured(lobe)) {
        if let Tint::Spectrum(tint) = &lobe.tint {
            whole += **tint * layered_albedo(&lobe.shape, &lobe.layers, MEAN_COSINE);
        }
    }
    whole.map(|rho| rho.clamp(0.0, 1.0))
}

/// A rank's part of a matte tint, as the whole of all ranks gets darker under a coat.
fn darker_by(tint: &Tint, whole: &Spectrum, coat: &CoatSurface) -> Tint {
    let left = whole.map(|rho| {
        let rho = rho.max(LEAST_REFLECTANCE);
        coat.reflectance_of_coated(rho) / rho
    });
    match tint {
        Tint::Spectrum(spectrum) => Tint::Spectrum(Arc::new(**spectrum * left)),
        other => other.clone(),
    }
}

impl Material {
    /// The material under a coat. Ambient light and the surface's own pass it unchanged.
    ///
    /// # Errors
    /// If the coat's `alpha` is out of the range of the shape `ggx`.
    pub fn under_coat(mut self, coat: &Coat) -> Result<Self, ParamError> {
        if coat.weight <= 0.0 || coat.thickness_mm <= 0.0 {
            return Ok(self);
        }
        // What facets send to other facets is part of what the coat lets through.
        let shape = Shape::named("ggx", &[("alpha", coat.alpha), ("multiscatter", 0.0)])?;
        let surface = CoatSurface::new(coat.eta(), coat.alpha);
        let absorption = coat.absorption();
        let measured = measured_matte(&self.lobes);
        let mut lobes = Vec::new();
        for lobe in self.lobes {
            if !matches!(lobe.shape.info().term, LightTerm::Diffuse | LightTerm::Specular) {
                lobes.push(lobe);
                continue;
            }
            if coat.weight < 1.0 {
                lobes.push(lobe.clone().under(LayerWeight::Constant(1.0 - coat.weight)));
            }
            let covered = coat.over(&surface, lobe, &measured, &absorption);
            lobes.push(if coat.weight < 1.0 {
                covered.under(LayerWeight::Constant(coat.weight))
            } else {
                covered
            });
        }
        let gloss = Lobe::new(shape, Tint::Ior(Arc::new(coat.ior.clone())));
        lobes.push(if coat.weight < 1.0 { gloss.under(LayerWeight::Constant(coat.weight)) } else { gloss });
        self.lobes = lobes;
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn base() -> Material {
        let lambert = Shape::named("lambert", &[]).expect("lambert exists");
        Material::of_lobes("base", vec![Lobe::new(lambert, Rgb::gray(0.5))])
    }

    #[test]
    fn a_coat_of_thickness_0_or_weight_0_is_none() {
        for coat in [Coat { thickness_mm: 0.0, ..Coat::default() }, Coat { weight: 0.0, ..Coat::default() }] {
            assert_eq!(base().under_coat(&coat), Ok(base()));
        }
    }

    #[test]
    fn half_a_coat_leaves_half_of_the_base_bare() {
        let half = base().under_coat(&Coat { weight: 0.5, ..Coat::default() }).expect("the coat is fine");
        assert_eq!(half.lobes.len(), 3);
        assert_eq!(half.lobes[0].layers, [LayerWeight::Constant(0.5)]);
        assert_eq!(
            half.lobes[1].layers,
            [LayerWeight::over_matte(&CoatSurface::new(1.5, 0.03)), LayerWeight::Constant(0.5)]
        );
    }

    #[test]
    fn a_coloured_coat_absorbs_along_its_thickness() {
        let coat =
            Coat { absorption_per_mm: Some(Spectrum::constant(2.0)), thickness_mm: 0.5, ..Coat::default() };
        let coated = base().under_coat(&coat).expect("the coat is fine");
        let absorption = coated.lobes[0].absorption.as_ref().expect("it absorbs");
        assert_eq!(absorption.depth[10], 1.0);
        assert!(coated.lobes[1].absorption.is_none(), "the highlight lies on top");
    }
}
