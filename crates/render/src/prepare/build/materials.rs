//! Materials with their rows of the tint table.

use glanz_bsdf::{LayerWeight, LightTerm, Side};
use glanz_math::names;
use glanz_scene::{ChannelUse, Lobe, Mask, Material, Metalness, RoughnessMap, Tint};

use crate::prepare::PrepareError;
use crate::prepare::color::tint_coordinate::coordinate_of;
use crate::prepare::color::tint_table::{Entry, Table, term_of};
use crate::prepare::data::{
    DirectLobe, LobeRoughness, MixTints, PreparedMask, PreparedMaterial, TextureMeans, TintCoordinate,
};

/// Fills a material's rows of the tint table.
pub(crate) fn prepare(
    material: &Material,
    table: &Table,
    model: Option<&str>,
) -> Result<PreparedMaterial, PrepareError> {
    let finite_through = material.transmittance.as_ref().is_none_or(glanz_scene::Transmittance::is_finite);
    if material.lobes.iter().any(|lobe| !lobe.tint.is_finite()) || !finite_through {
        let what = format!("material '{}': tints must be finite numbers", names::shown(&material.name));
        return Err(PrepareError::Scene { what });
    }
    let direct = direct_lobes(material, model)?;
    let mut channels = Channels::default();
    let lobes =
        direct.iter().map(|lobe| direct_lobe(lobe, model, &mut channels)).collect::<Result<Vec<_>, _>>()?;
    let occlusion = material.occlusion.map(|mask| channels.mask(&mask));
    let ambient_metalness = ambient_metalness(material)?;
    let most = PreparedMaterial::MOST_CHANNELS;
    if channels.0.len() > most {
        let (name, count) = (names::shown(&material.name), channels.0.len());
        let what =
            format!("material '{name}': its masks name {count} channels of pictures, more than {most}");
        return Err(PrepareError::Scene { what });
    }
    let terms = Terms::new(material);
    let mut ambient = [true, false].map(|textured| table.ambient(terms.ambient(textured), None));
    // Light of its own that textures multiply rides along with the ambient light that they multiply.
    add(&mut ambient[0], table.emission(&terms.textured_emission, None));
    let spot_ambient = spot_ambient(table, &terms);
    let mix = || Box::new(mix_tints(table, &direct, &terms, !spot_ambient.is_empty()));
    Ok(PreparedMaterial {
        mix: table.mixes_spectra().then(mix),
        anisotropic: lobes.iter().any(DirectLobe::is_anisotropic),
        transmits: lobes.iter().any(|lobe| lobe.shape.info().side == Side::Transmission),
        lobes,
        tints: table.direct(&direct, None),
        integrals: Vec::new(),
        series: table.series(&direct),
        ambient,
        spot_ambient,
        emission: table.emission(&terms.emission, None),
        two_sided: material.two_sided,
        cull_back: material.cull_back,
        base_color: material.base_color,
        normal_map: material.normal_map,
        emission_map: material.emission_map,
        metal_rough_map: material.metal_rough_map,
        channels: channels.0,
        means: TextureMeans::default(),
        occlusion,
        ambient_metalness,
        aniso: [libm::sin(material.aniso), libm::cos(material.aniso)],
        transmittance: material
            .transmittance
            .as_ref()
            .map(|transmittance| table.transmittance(transmittance)),
        alpha: material.opacity,
        alpha_mode: material.alpha_mode,
    })
}

/// The part of the surface that all ambient terms belong to: they are one sum.
fn ambient_metalness(material: &Material) -> Result<Metalness, PrepareError> {
    let ambient = || material.lobes.iter().filter(|lobe| term_of(lobe) == LightTerm::Ambient);
    let own = ambient().next().map_or(Metalness::Any, |lobe| lobe.metalness);
    let glows = |lobe: &Lobe| term_of(lobe) == LightTerm::Emission && lobe.textured;
    let what = if ambient().any(|lobe| lobe.metalness != own) {
        "ambient terms of one 'metalness' alone"
    } else if own != Metalness::Any && material.lobes.iter().any(glows) {
        "no ambient term with a 'metalness' beside light of its own that is 'textured'"
    } else {
        return Ok(own);
    };
    let name = names::shown(&material.name);
    Err(PrepareError::Scene { what: format!("material '{name}': expected {what}") })
}

/// The lobes for lights with a direction. A model without a highlight takes the highlights away rather
/// than making matte lobes of them.
fn direct_lobes<'a>(material: &'a Material, model: Option<&str>) -> Result<Vec<&'a Lobe>, PrepareError> {
    let target = model.map(glanz_bsdf::models::info_named).transpose()?;
    let matte = target.is_some_and(|info| info.term != LightTerm::Specular);
    let kept = |lobe: &&Lobe| match term_of(lobe) {
        LightTerm::Diffuse => true,
        LightTerm::Specular => !matte,
        LightTerm::Ambient | LightTerm::Emission => false,
    };
    Ok(material.lobes.iter().filter(kept).collect())
}

fn direct_lobe(
    lobe: &Lobe,
    model: Option<&str>,
    channels: &mut Channels,
) -> Result<DirectLobe, PrepareError> {
    let term = term_of(lobe);
    let (shape, mut layers) = match model {
        Some(name) if term == LightTerm::Specular => (lobe.shape.as_model(name)?, lobe.layers.clone()),
        _ => (lobe.shape.clone(), lobe.layers.clone()),
    };
    // What data are over one model they are not over another: the fitted lobes remain.
    if model.is_some() {
        layers.retain(|layer| !matches!(layer, LayerWeight::Table { .. }));
    }
    // A texel has no say in a tint that is a curve.
    let coordinate = coordinate_of(lobe);
    let textured = lobe.textured && coordinate == TintCoordinate::None;
    let masks = lobe.masks.iter().map(|mask| channels.mask(mask)).collect();
    let roughness = match lobe.roughness {
        RoughnessMap::Material => LobeRoughness::Material,
        RoughnessMap::Uniform => LobeRoughness::Uniform,
        RoughnessMap::Own(channel) => LobeRoughness::Channel(channels.number(channel)),
    };
    Ok(DirectLobe { shape, term, textured, coordinate, layers, metalness: lobe.metalness, masks, roughness })
}

/// The channels of pictures that a material asks for, each once.
#[derive(Default)]
struct Channels(Vec<ChannelUse>);

impl Channels {
    fn number(&mut self, channel: ChannelUse) -> usize {
        self.0.iter().position(|known| *known == channel).unwrap_or_else(|| {
            self.0.push(channel);
            self.0.len() - 1
        })
    }

    fn mask(&mut self, mask: &Mask) -> PreparedMask {
        PreparedMask { channel: self.number(mask.of), from: mask.from, to: mask.to }
    }
}

/// The tints of a material's lobes that no light with a direction touches.
struct Terms<'a> {
    textured_ambient: Vec<&'a Tint>,
    plain_ambient: Vec<&'a Tint>,
    textured_emission: Vec<&'a Tint>,
    emission: Vec<&'a Tint>,
}

impl<'a> Terms<'a> {
    fn new(material: &'a Material) -> Self {
        let of = |term: LightTerm, textured: bool| {
            let lobes = material.lobes.iter();
            lobes.filter(|l| term_of(l) == term && l.textured == textured).map(|l| &l.tint).collect()
        };
        Self {
            textured_ambient: of(LightTerm::Ambient, true),
            plain_ambient: of(LightTerm::Ambient, false),
            textured_emission: of(LightTerm::Emission, true),
            emission: of(LightTerm::Emission, false),
        }
    }

    fn ambient(&self, textured: bool) -> &[&'a Tint] {
        if textured { &self.textured_ambient } else { &self.plain_ambient }
    }
}

fn spot_ambient(table: &Table, terms: &Terms) -> Vec<[Entry; 2]> {
    let textured = table.spot_ambient(terms.ambient(true), None);
    let plain = table.spot_ambient(terms.ambient(false), None);
    let rows: Vec<_> = textured.into_iter().zip(plain).map(|(t, p)| [t, p]).collect();
    if rows.iter().any(|row| *row != [[0.0; 3]; 2]) { rows } else { Vec::new() }
}

fn mix_tints(table: &Table, direct: &[&Lobe], terms: &Terms, has_cones: bool) -> MixTints {
    const BASIS: [Option<usize>; 3] = [Some(0), Some(1), Some(2)];
    let by_entry = |columns: [Vec<Entry>; 3]| {
        let [a, b, c] = columns;
        a.into_iter().zip(b).zip(c).map(|((a, b), c)| [a, b, c]).collect()
    };
    MixTints {
        tints: by_entry(BASIS.map(|b| table.direct(direct, b))),
        ambient: BASIS.map(|b| {
            let mut sum = table.ambient(terms.ambient(true), b);
            add(&mut sum, table.emission(&terms.textured_emission, b));
            sum
        }),
        spot_ambient: match has_cones {
            true => by_entry(BASIS.map(|b| table.spot_ambient(terms.ambient(true), b))),
            false => Vec::new(),
        },
        emission: BASIS.map(|b| table.emission(&terms.emission, b)),
    }
}

fn add(sum: &mut Entry, value: Entry) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
}
