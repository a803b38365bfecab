//! Which models the fast path holds inside its loop, rather than calling them.

use glanz_bsdf::{DirectionPair, LightTerm, Model, ModelInfo, ShapeVisitor, Side};
use glanz_math::Real;

/// The most operations of a model inside the loop, with an exponent that makes its power a product. The classic
/// highlights take up to 15.
const MOST_OPERATIONS: u32 = 20;

/// Whether the loop holds a model: one of the classic block of coefficients, which has no parameter or an exponent
/// alone; cheap, isotropic, and dark where the light is below the surface, since the loop leaves such light out.
pub(crate) const fn is_inlined(info: &ModelInfo) -> bool {
    let classic = match info.params {
        [] => !info.delta,
        [only] => is_same(only.name.as_bytes(), b"shininess"),
        _ => false,
    };
    let reflects = matches!(info.side, Side::Reflection) && !info.anisotropic;
    classic && reflects && info.operations <= MOST_OPERATIONS
}

/// Whether a model is a highlight that the loop holds.
pub(crate) const fn is_highlight(info: &ModelInfo) -> bool {
    matches!(info.term, LightTerm::Specular) && is_inlined(info)
}

/// Whether a model is the matte lobe beside such a highlight.
pub(crate) const fn is_matte(info: &ModelInfo) -> bool {
    matches!(info.term, LightTerm::Diffuse) && info.params.is_empty() && is_inlined(info)
}

/// Comparison of strings where constants are evaluated.
const fn is_same(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

/// Evaluates the models for which [`is_inlined`] holds, and gives 0 for the others.
pub(crate) struct Inline<'a, R>(pub &'a DirectionPair<R>);

impl<R: Real> ShapeVisitor for Inline<'_, R> {
    type Output = R;

    #[inline(always)]
    fn visit<M: Model>(self, model: &M) -> R {
        if const { is_inlined(&M::INFO) } { model.f_cos(self.0) } else { self.0.cos_o.zero() }
    }
}

#[cfg(test)]
mod tests {
    use glanz_bsdf::{MODELS, Shape};

    use super::*;

    #[test]
    fn inlined_models_have_their_values_and_are_dark_from_behind() {
        let mut inlined = 0;
        for info in MODELS.iter().filter(|info| is_inlined(info)) {
            inlined += 1;
            let shape = Shape::named(info.name, &[]).expect("a name from the list");
            let front = DirectionPair::isotropic(0.8_f64, 0.7, 0.2);
            assert_eq!(shape.visit(Inline(&front)), shape.f_cos(&front), "{}", info.name);
            let behind = DirectionPair::isotropic(0.8_f64, -0.7, -0.2);
            let needs_light = matches!(info.term, LightTerm::Diffuse | LightTerm::Specular);
            assert!(!needs_light || shape.f_cos(&behind) == 0.0, "{} is lit from behind", info.name);
        }
        assert!(MODELS.iter().any(is_matte) && MODELS.iter().any(is_highlight));
        assert!(inlined < MODELS.len() / 2, "the loop is short");
    }

    #[test]
    fn other_models_are_none_of_the_loop() {
        for info in MODELS.iter().filter(|info| !is_inlined(info)) {
            let shape = Shape::named(info.name, &[]).expect("a name from the list");
            assert_eq!(
                shape.visit(Inline(&DirectionPair::isotropic(0.8_f64, 0.7, 0.2))),
                0.0,
                "{}",
                info.name
            );
        }
    }
}
