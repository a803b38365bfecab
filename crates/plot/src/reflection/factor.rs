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
        let value = shape.f_cos(pair);
        match self {
            Self::One => value,
            Self::Reflectance(_, reflectance) => value * reflectance,
            Self::Fresnel(medium) => {
                let reflected = medium.reflectance(shape.tint_cosine(pair));
                let transmits = shape.info().side == Side::Transmission;
                value * if transmits { 1.0 - reflected } else { reflected }
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
    fn a_lobe_is_multiplied_with_the_reflectance_at_the_half_vector() {
        let shape = Shape::named("lambert", &[]).unwrap();
        let pair = DirectionPair::isotropic(0.5, 0.5, -0.5);
        let glass = Factor::Fresnel(Medium::named("1.5", 550.0).unwrap());
        // wo·wi = −1/2 is 120° between both, 60° to the half vector.
        let expected = shape.f_cos(&pair) * 0.089_187;
        assert!((glass.f_cos(&shape, &pair) - expected).abs() < 1e-6);
    }
}
