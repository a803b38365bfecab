//! Options with a fixed set of values, each under the name that scene files use too.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use glanz_bsdf::{LightTerm, MODELS};
use glanz_render::{DebugView, ToneMap};
use glanz_scene::file::{ShowName, ToneMapName};
use glanz_scene::{Interpolation, Shading};

/// A name on the command line, what it stands for, and a line of help.
type Choice<T> = (&'static str, T, &'static str);

const SHADINGS: &[Choice<Shading>] = &[
    ("flat", Shading::Flat, "one value per facet"),
    ("gouraud", Shading::Gouraud, "values at the vertices, interpolated"),
    ("phong", Shading::Phong, "normals interpolated, a value per pixel"),
];

const INTERPOLATIONS: &[Choice<Interpolation>] = &[
    ("perspective", Interpolation::Perspective, "linear on the surface"),
    ("screen-linear", Interpolation::ScreenLinear, "linear on the screen"),
    ("scanline", Interpolation::Scanline, "along polygon edges, then along scanlines, as in 1971"),
];

const SHOWS: &[Choice<DebugView>] = &[
    ("shaded", DebugView::Shaded, "light on surfaces"),
    ("normals", DebugView::Normals, "shading normals in the world"),
    ("depth", DebugView::Depth, "distance, near is bright"),
    ("ids", DebugView::Ids, "a colour per object"),
    ("facets", DebugView::Facets, "a colour per facet"),
    ("wireframe", DebugView::Wireframe, "the edges over the shaded picture"),
    ("ambient", DebugView::Ambient, "the ambient and emitted terms alone"),
    ("diffuse", DebugView::Diffuse, "the diffuse terms alone"),
    ("specular", DebugView::Specular, "the specular terms alone"),
    ("uv", DebugView::Uv, "texture coordinates as red and green"),
    ("lit", DebugView::Lit, "white where any light reaches the surface"),
];

const TONE_MAPS: &[Choice<ToneMap>] = &[
    ("none", ToneMap::None, "clip what is above 1"),
    ("reinhard", ToneMap::Reinhard, "Reinhard et al. 2002"),
    ("aces", ToneMap::Aces, "Academy, fitted"),
    ("agx", ToneMap::Agx, "AgX"),
    ("khronos-neutral", ToneMap::KhronosNeutral, "Khronos PBR neutral"),
];

/// The view that a scene file asks for.
pub fn show_of_scene(name: ShowName) -> DebugView {
    match name {
        ShowName::Shaded => DebugView::Shaded,
        ShowName::Normals => DebugView::Normals,
        ShowName::Depth => DebugView::Depth,
        ShowName::Ids => DebugView::Ids,
        ShowName::Facets => DebugView::Facets,
        ShowName::Wireframe => DebugView::Wireframe,
        ShowName::Ambient => DebugView::Ambient,
        ShowName::Diffuse => DebugView::Diffuse,
        ShowName::Specular => DebugView::Specular,
        ShowName::Uv => DebugView::Uv,
        ShowName::Lit => DebugView::Lit,
    }
}

/// The tone map that a scene file asks for.
pub fn tone_map_of_scene(name: ToneMapName) -> ToneMap {
    match name {
        ToneMapName::None => ToneMap::None,
        ToneMapName::Reinhard => ToneMap::Reinhard,
        ToneMapName::Aces => ToneMap::Aces,
        ToneMapName::Agx => ToneMap::Agx,
        ToneMapName::KhronosNeutral => ToneMap::KhronosNeutral,
    }
}

/// A parser of the names in `choices`.
fn parser<T>(choices: &'static [Choice<T>]) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    PossibleValuesParser::new(choices.iter().map(|(name, _, help)| PossibleValue::new(*name).help(*help)))
        .map(move |name| {
            choices
                .iter()
                .find(|choice| choice.0 == name)
                .expect("the parser lets only known names through")
                .1
        })
}

/// Parses the name of a shading.
pub fn shading() -> impl TypedValueParser<Value = Shading> {
    parser(SHADINGS)
}

/// Parses the name of an interpolation.
pub fn interpolation() -> impl TypedValueParser<Value = Interpolation> {
    parser(INTERPOLATIONS)
}

/// Parses the name of a view.
pub fn show() -> impl TypedValueParser<Value = DebugView> {
    parser(SHOWS)
}

/// Parses the name of a tone map.
pub fn tone_map() -> impl TypedValueParser<Value = ToneMap> {
    parser(TONE_MAPS)
}

/// Parses the name of a model of highlights.
pub fn highlight_model() -> impl TypedValueParser<Value = String> {
    let models = MODELS.iter().filter(|info| info.term == LightTerm::Specular);
    PossibleValuesParser::new(models.map(|info| PossibleValue::new(info.name).help(info.title)))
}

/// Parses a number of samples.
pub fn samples() -> impl TypedValueParser<Value = u32> {
    PossibleValuesParser::new(["1", "2", "4", "8", "16"])
        .map(|text| text.parse().expect("the parser lets only numbers through"))
}
