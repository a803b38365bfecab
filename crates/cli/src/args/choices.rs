//! Options with a fixed set of values, each under the name that scene files use too.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use glanz_bsdf::{LightTerm, MODELS};
use glanz_render::{DebugView, Encoding, ToneMap};
use glanz_scene::{Interpolation, Lighting, Mistake, Shading};

/// What a name on the command line stands for, the name, and a line of help.
type Choice<T> = (T, &'static str, &'static str);

const TONE_MAPS: &[Choice<ToneMap>] = &[
    (ToneMap::None, "none", "clip what is above 1"),
    (ToneMap::Reinhard, "reinhard", "Reinhard et al. 2002"),
    (ToneMap::Aces, "aces", "Academy, fitted"),
    (ToneMap::Agx, "agx", "AgX"),
    (ToneMap::KhronosNeutral, "khronos-neutral", "Khronos PBR neutral"),
];

const ENCODINGS: &[Choice<Encoding>] = &[
    (Encoding::Srgb, "srgb", "by the transfer function of sRGB"),
    (Encoding::Raw, "raw", "the linear value, clipped, times 255"),
];

/// A parser of the names in `choices`.
fn parser<T>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    PossibleValuesParser::new(choices.iter().map(|(_, name, help)| PossibleValue::new(*name).help(*help)))
        .map(move |name| {
            choices
                .iter()
                .find(|choice| choice.1 == name)
                .expect("the parser lets only known names through")
                .0
        })
}

/// Parses the name of a shading.
pub(crate) fn shading() -> impl TypedValueParser<Value = Shading> {
    parser(Shading::ALL)
}

/// Parses the name of an interpolation.
pub(crate) fn interpolation() -> impl TypedValueParser<Value = Interpolation> {
    parser(Interpolation::ALL)
}

/// Parses the name of a view.
pub(crate) fn show() -> impl TypedValueParser<Value = DebugView> {
    parser(DebugView::ALL)
}

/// Parses the name of a way to find light.
pub(crate) fn lighting() -> impl TypedValueParser<Value = Lighting> {
    parser(Lighting::ALL)
}

/// Parses the name of a tone map.
pub(crate) fn tone_map() -> impl TypedValueParser<Value = ToneMap> {
    parser(TONE_MAPS)
}

/// Parses the name of an encoding.
pub(crate) fn encoding() -> impl TypedValueParser<Value = Encoding> {
    parser(ENCODINGS)
}

/// Parses the name of a mistake.
pub(crate) fn mistake() -> impl TypedValueParser<Value = Mistake> {
    parser(Mistake::ALL)
}

/// Parses the name of a model of highlights.
pub(crate) fn highlight_model() -> impl TypedValueParser<Value = String> {
    let models = MODELS.iter().filter(|info| info.term == LightTerm::Specular);
    PossibleValuesParser::new(models.map(|info| PossibleValue::new(info.name).help(info.title)))
}

/// Parses a number of samples.
pub(crate) fn samples() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["1", "2", "4", "8", "16"])
        .map(|text| text.parse().expect("the parser lets only numbers through"))
}
