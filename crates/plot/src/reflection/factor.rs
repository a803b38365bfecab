//! What a lobe is multiplied with: Fresnel reflectance of a medium, or a reflectance at one wavelength.

use glanz_bsdf::{DirectionPair, Shape, Side};

use super::medium::Medium;

/// What a lobe is multiplied with: its tint at one wavelength.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Factor {
    /// Nothing.
    #[default]
    One,
    /// A reflectance that does not depend on angles, with its name.
    Reflectance(String, f64),
    /// Fresnel reflectance; for lobes of transmission what is not reflected.
    Fresnel(Medium),
}

impl Factor {
    /// BSDF times incident cosine times factor.
    pub fn f_cos(&self, shape: &Shape, pair: &DirectionPair<f64>) -> f64 {
        shape.f_cos(pair) * self.value(shape, pair)
    }

    /// The factor itself, as pictures have it: Fresnel's law at the facet that sends the light on
    /// ([`Shape::fresnel_cosine`]), which for matte lobes is normal incidence.
    pub fn value(&self, shape: &Shape, pair: &DirectionPair<f64>) -> f64 {
        match self {
            Self::One => 1.0,
            Self::Reflectance(_, reflectance) => *reflectance,
            Self::Fresnel(medium) => {
                let reflected = medium.reflectance(shape.fresnel_cosine(pair));
                let transmits = shape.info().side == Side::Transmission;
                if transmits { 1.0 - reflected } else { reflected }
            }
        }
    }

    /// Its name; empty for none.
    pub fn name(&self) -> &str {
        match self {
            Self::One => "",
            Self::Reflectance(name, _) => name,
            Self::Fresnel(medium) => &medium.name,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_highlight_has_the_reflectance_at_the_half_vector_and_a_matte_lobe_that_along_the_normal() {
        let pair = DirectionPair::isotropic(0.5, 0.5, -0.5);
        let glass = Factor::Fresnel(Medium::named("1.5", 550.0).unwrap());
        // wo·wi = −1/2 is 120° between both, 60° to the half vector.
        for (model, reflectance) in
            [("phong", 0.089_187), ("ggx", 0.089_187), ("lambert", 0.04), ("eon", 0.04)]
        {
            let shape = Shape::named(model, &[]).unwrap();
            let expected = shape.f_cos(&pair) * reflectance;
            let error = glass.f_cos(&shape, &pair) / expected - 1.0;
            assert!(error.abs() < 1e-5, "{model}: {error}");
        }
    }
}
