//! Materials with their rows of the tint table.

use glanz_bsdf::{LayerWeight, LightTerm, Shape, Side};
use glanz_scene::{AlphaMode, Lobe, Material, Metalness, TextureUse, Tint};

use super::lobe_integrals::LobeIntegrals;
use super::tint_coordinate::TintCoordinate;
use super::tint_series::TintSeries;
use super::tint_table::{Entry, Table, term_of};
use super::{PrepareError, with_model};
use crate::cpu::is_evaluated_in_place;

/// A lobe that answers to lights with a direction.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectLobe {
    /// Its shape.
    pub shape: Shape,
    /// Diffuse or specular.
    pub term: LightTerm,
    /// Whether base colour texture and vertex colours multiply it.
    pub textured: bool,
    /// On what its tint depends.
    pub coordinate: TintCoordinate,
    /// What lies over it.
    pub layers: Vec<LayerWeight>,
    /// Which part of the surface it belongs to.
    pub metalness: Metalness,
    /// Whether its shape is that of the lobe before.
    pub repeats: bool,
}

/// A material with its rows of the tint table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PreparedMaterial {
    /// Lobes for lights with a direction.
    pub lobes: Vec<DirectLobe>,
    /// The tint table: entry `light · lobes.len() + lobe`, one value per channel.
    pub tints: Vec<[f32; 3]>,
    /// What the lobes make of areas and surroundings; empty where the scene has none.
    pub integrals: Vec<LobeIntegrals>,
    /// The entries of curved lobes, with the same numbers; empty if there are none.
    pub series: Vec<TintSeries>,
    /// Ambient light from everywhere times the ambient tints, and light of its own: what textures
    /// multiply, then the ambient light that they do not.
    pub ambient: [[f32; 3]; 2],
    /// Ambient light that a spot sends into its cone, per light, textured and not. Empty where no
    /// spot sends any.
    pub spot_ambient: Vec<[[f32; 3]; 2]>,
    /// Light of its own.
    pub emission: [f32; 3],
    /// How textures and vertex colours mix the table, where they do more than multiply channels.
    pub mix: Option<Box<MixTints>>,
    /// Whether the normal is turned to the viewer.
    pub two_sided: bool,
    /// Whether back faces are not drawn.
    pub cull_back: bool,
    /// Multiplies textured lobes.
    pub base_color: Option<TextureUse>,
    /// Bends the normal.
    pub normal_map: Option<TextureUse>,
    /// Multiplies the emission.
    pub emission_map: Option<TextureUse>,
    /// Green widens lobes, blue says where metal is.
    pub metal_rough_map: Option<TextureUse>,
    /// Sine and cosine of the angle from the tangent to the x axis of lobes that know one.
    pub aniso: [f64; 2],
    /// Whether any lobe asks where the tangent is.
    pub anisotropic: bool,
    /// Whether any lobe answers to light on the other side.
    pub transmits: bool,
    /// What is seen through it, per channel over the cosine of the line of sight.
    pub transmittance: Option<TintSeries>,
    /// Whether it has nothing that the pixel loop of the classic models does not know.
    pub classic: bool,
    /// Opacity.
    pub alpha: f32,
    /// What alpha means.
    pub alpha_mode: AlphaMode,
}

/// The table for texels that mix three spectra: for each entry that textures multiply, what its lobe
/// gives through each of them. Their sum is the entry itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MixTints {
    /// As [`PreparedMaterial::tints`].
    pub tints: Vec<[[f32; 3]; 3]>,
    /// As the first of [`PreparedMaterial::ambient`].
    pub ambient: [[f32; 3]; 3],
    /// As the first of each of [`PreparedMaterial::spot_ambient`].
    pub spot_ambient: Vec<[[f32; 3]; 3]>,
    /// As [`PreparedMaterial::emission`].
    pub emission: [[f32; 3]; 3],
}

/// Fills a material's rows of the tint table.
pub(super) fn prepare(
    material: &Material,
    table: &Table,
    model: Option<&str>,
) -> Result<PreparedMaterial, PrepareError> {
    let finite_through = material.transmittance.as_ref().is_none_or(glanz_scene::Transmittance::is_finite);
    if material.lobes.iter().any(|lobe| !lobe.tint.is_finite()) || !finite_through {
        let what = format!("material '{}': tints must be finite numbers", material.name);
        return Err(PrepareError::Scene { what });
    }
    let direct = direct_lobes(material, model)?;
    let mut lobes = direct.iter().map(|lobe| direct_lobe(lobe, model)).collect::<Result<Vec<_>, _>>()?;
    for i in 1..lobes.len() {
        lobes[i].repeats = lobes[i].shape == lobes[i - 1].shape;
    }
    let terms = Terms::new(material);
    let mut ambient = [true, false].map(|textured| table.ambient(terms.ambient(textured), None));
    // Light of its own that textures multiply rides along with the ambient light that they multiply.
    add(&mut ambient[0], table.emission(&terms.textured_emission, None));
    Ok(PreparedMaterial {
        anisotropic: lobes.iter().any(|lobe| lobe.shape.is_anisotropic()),
        transmits: lobes.iter().any(|lobe| lobe.shape.info().side == Side::Transmission),
        classic: lobes.iter().all(DirectLobe::is_classic) && material.metal_rough_map.is_none(),
        lobes,
        tints: table.direct(&direct, None),
        integrals: Vec::new(),
        series: table.series(&direct),
        ambient,
        spot_ambient: spot_ambient(table, &terms),
        emission: table.emission(&terms.emission, None),
        mix: table.mixes_spectra().then(|| Box::new(mix_tints(table, &direct, &terms))),
        two_sided: material.two_sided,
        cull_back: material.cull_back,
        base_color: material.base_color,
        normal_map: material.normal_map,
        emission_map: material.emission_map,
        metal_rough_map: material.metal_rough_map,
        aniso: [libm::sin(material.aniso), libm::cos(material.aniso)],
        transmittance: material
            .transmittance
            .as_ref()
            .map(|transmittance| table.transmittance(transmittance)),
        alpha: material.alpha,
        alpha_mode: material.alpha_mode,
    })
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

fn direct_lobe(lobe: &Lobe, model: Option<&str>) -> Result<DirectLobe, PrepareError> {
    let term = term_of(lobe);
    let shape = match model {
        Some(name) if term == LightTerm::Specular => with_model(&lobe.shape, name)?,
        _ => lobe.shape.clone(),
    };
    // A texel has no say in a tint that is a curve.
    let coordinate = TintCoordinate::of(lobe);
    let textured = lobe.textured && coordinate == TintCoordinate::None;
    Ok(DirectLobe {
        shape,
        term,
        textured,
        coordinate,
        layers: lobe.layers.clone(),
        metalness: lobe.metalness,
        repeats: false,
    })
}

impl DirectLobe {
    /// A bare lobe.
    pub fn new(shape: Shape) -> Self {
        let (term, coordinate) = (shape.info().term, TintCoordinate::None);
        Self {
            shape,
            term,
            textured: false,
            coordinate,
            layers: Vec::new(),
            metalness: Metalness::Any,
            repeats: false,
        }
    }

    fn is_classic(&self) -> bool {
        let bare = self.layers.is_empty() && self.metalness == Metalness::Any;
        bare && is_evaluated_in_place(self.shape.info()) && !matches!(self.coordinate, TintCoordinate::CoatPath { .. })
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

fn mix_tints(table: &Table, direct: &[&Lobe], terms: &Terms) -> MixTints {
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
        spot_ambient: by_entry(BASIS.map(|b| table.spot_ambient(terms.ambient(true), b))),
        emission: BASIS.map(|b| table.emission(&terms.emission, b)),
    }
}

fn add(sum: &mut Entry, value: Entry) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
}
