//! Tints that depend on an angle, as a Chebyshev series over its coordinate.

use glanz_math::chebyshev_nodes;

/// Places at which a tint is taken, and the most terms that are kept. A test holds that they keep 1e-4 for
/// every medium that ships and for indices from 1.05 to 20.
const NODES: usize = 32;

/// The coordinates at which a tint must be known for [`Chebyshev::fit`](glanz_math::Chebyshev).
pub(crate) fn nodes() -> impl Iterator<Item = f64> {
    chebyshev_nodes(NODES)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use std::sync::Arc;

    use glanz_color::{Ior, ior, iors, light};
    use glanz_scene::{Boundary, CoatedBoundary, ColorMode, Tint};

    use super::*;
    use crate::prepare::Observation;
    use crate::prepare::color::quadrature::Sampling;
    use crate::prepare::data::TintSeries;

    /// What the table promises: relative to the reflection itself.
    const RELATIVE: f64 = 1e-4;

    #[test]
    fn every_metal_and_glass_keeps_its_reflection_at_every_angle() {
        let sampling = Sampling::new(&Observation::new(ColorMode::Spectral, None).unwrap(), 0);
        let lights = ["D65", "A", "FL11"].map(|name| light(name).unwrap().0.to_vec());
        let mut worst: (f64, String) = (0.0, String::new());
        let numbers = [1.05, 1.5, 20.0].map(Ior::constant);
        for ior in iors().iter().map(|info| ior(info.name).unwrap()).chain(numbers) {
            let name = ior.name.clone();
            let tint = Tint::Ior(Arc::new(ior));
            let at = |cosine: f64| sampling.response(&sampling.surface(&tint, cosine), None);
            for light in &lights {
                let values: Vec<_> = nodes().map(|cosine| at(cosine).under(light)).collect();
                let series = TintSeries::fit(&values);
                for step in 0..=300 {
                    let cosine = f64::from(step) / 300.0;
                    let exact = at(cosine).under(light);
                    for (got, exact) in series.at(cosine as f32).iter().zip(exact) {
                        let error = (f64::from(*got) / exact - 1.0).abs();
                        if error > worst.0 {
                            worst = (error, format!("{name} at cosθ = {cosine}"));
                        }
                    }
                }
            }
        }
        assert!(worst.0 < RELATIVE, "{worst:?}");
        assert!(worst.0 > 1e-8, "{worst:?}: f32 is not as good as that");
    }

    /// What a series may be off by where a metal lies under a coat, in parts of all light: most at grazing angles, below
    /// coats as dense as diamond, where the coat lets next to nothing pass.
    const COATED: f64 = 4e-4;

    #[test]
    fn every_metal_under_a_coat_keeps_its_reflection_at_every_angle() {
        let sampling = Sampling::new(&Observation::new(ColorMode::Spectral, None).unwrap(), 0);
        let white = light("E").unwrap().0.to_vec();
        let all = sampling
            .response(&sampling.surface(&Tint::Spectrum(Arc::new(glanz_color::Spectrum::ONE)), 1.0), None);
        let scale = all.under(&white)[1];
        let mut worst: (f64, String) = (0.0, String::new());
        for (info, coat) in iors().iter().flat_map(|info| [1.05, 1.5, 2.4].map(|coat| (info, coat))) {
            let below = Boundary::Medium(Arc::new(ior(info.name).unwrap()));
            let boundary = CoatedBoundary { below, coat: Ior::constant(coat), alpha: 0.03 };
            let tint = Tint::Coated(Arc::new(boundary));
            let at = |cosine: f64| sampling.response(&sampling.surface(&tint, cosine), None).under(&white);
            let series = TintSeries::fit(&nodes().map(at).collect::<Vec<_>>());
            for step in 0..=60 {
                let cosine = f64::from(step) / 60.0;
                let error = (f64::from(series.at(cosine as f32)[1]) - at(cosine)[1]).abs() / scale;
                if error > worst.0 {
                    worst = (error, format!("{} under {coat} at cosθ = {cosine}", info.name));
                }
            }
        }
        assert!(worst.0 < COATED, "{worst:?}");
    }

    #[test]
    fn nothing_is_zero() {
        let zeros: Vec<_> = nodes().map(|_| [0.0; 3]).collect();
        assert!(TintSeries::fit(&zeros).is_empty());
        assert_eq!(TintSeries::default().at(0.3), [0.0; 3]);
    }
}
