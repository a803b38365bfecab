//! Materials and the tint table.
//!
//! A colour mode is a way to fill the numbers in this file and nothing else. In RGB:
//! T\[l, k, c\] = π · light_l,c · tint_k,c, where π turns a classic light of 1 into radiance units.

use glanz_bsdf::{Part, Shape};
use glanz_color::Rgb;
use glanz_math::PI;
use glanz_scene::{AlphaMode, Light, LightKind, Lobe, Material, Scene, TextureUse};

use super::{PrepareError, lights, with_model};

/// A lobe that answers to lights with a direction.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectLobe {
    /// Its shape.
    pub shape: Shape,
    /// Diffuse or specular.
    pub part: Part,
    /// Whether base colour texture and vertex colours multiply it.
    pub textured: bool,
}

/// A material with its rows of the tint table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PreparedMaterial {
    /// Lobes for lights with a direction.
    pub lobes: Vec<DirectLobe>,
    /// The tint table: entry `light · lobes.len() + lobe`, one value per channel.
    pub tints: Vec<[f32; 3]>,
    /// Ambient light from everywhere times the ambient tints, and light of its own: what textures
    /// multiply, then the ambient light that they do not.
    pub ambient: [[f32; 3]; 2],
    /// Ambient light that a spot sends into its cone, per light, textured and not. Empty where no
    /// spot sends any.
    pub spot_ambient: Vec<[[f32; 3]; 2]>,
    /// Light of its own.
    pub emission: [f32; 3],
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
    /// Opacity.
    pub alpha: f32,
    /// What alpha means.
    pub alpha_mode: AlphaMode,
}

/// Fills a material's rows of the tint table in RGB.
pub(super) fn prepare(
    material: &Material,
    scene: &Scene,
    model: Option<&str>,
) -> Result<PreparedMaterial, PrepareError> {
    if let Some(lobe) = material.lobes.iter().find(|lobe| !lobe.tint.is_finite()) {
        let what = format!("material '{}': the tint {:?} must be finite numbers", material.name, lobe.tint.0);
        return Err(PrepareError::Scene { what });
    }
    // A model without a highlight takes the highlights away rather than making matte lobes of them.
    let target = model.map(glanz_bsdf::models::info_named).transpose()?;
    let matte = target.is_some_and(|info| info.part != Part::Specular);
    let direct: Vec<&Lobe> = material
        .lobes
        .iter()
        .filter(|lobe| is_direct(part_of(lobe)) && !(matte && part_of(lobe) == Part::Specular))
        .collect();
    let lobes = direct.iter().map(|lobe| direct_lobe(lobe, model)).collect::<Result<Vec<_>, _>>()?;
    let mut ambient = ambient_of(material, scene.lights.iter().filter(|light| !is_spot(light)));
    // Light of its own that textures multiply rides along with the ambient light that they multiply.
    ambient[0] = (Rgb(ambient[0]) + emission_of(material, true)).0;
    let tints =
        lights::directed(scene).flat_map(|light| direct.iter().map(move |lobe| tint(light, lobe))).collect();
    Ok(PreparedMaterial {
        lobes,
        tints,
        ambient,
        spot_ambient: spot_ambient(material, scene),
        emission: emission_of(material, false).0,
        two_sided: material.two_sided,
        cull_back: material.cull_back,
        base_color: material.base_color,
        normal_map: material.normal_map,
        emission_map: material.emission_map,
        alpha: material.alpha,
        alpha_mode: material.alpha_mode,
    })
}

fn part_of(lobe: &Lobe) -> Part {
    lobe.shape.info().part
}

fn is_direct(part: Part) -> bool {
    matches!(part, Part::Diffuse | Part::Specular)
}

fn is_spot(light: &Light) -> bool {
    matches!(light.kind, LightKind::Spot { .. })
}

fn direct_lobe(lobe: &Lobe, model: Option<&str>) -> Result<DirectLobe, PrepareError> {
    let part = part_of(lobe);
    let shape = match model {
        Some(name) if part == Part::Specular => with_model(&lobe.shape, name)?,
        _ => lobe.shape.clone(),
    };
    Ok(DirectLobe { shape, part, textured: lobe.textured })
}

/// One entry of the tint table.
fn tint(light: &Light, lobe: &Lobe) -> [f32; 3] {
    let color = match part_of(lobe) {
        Part::Diffuse => light.colors.diffuse,
        _ => light.colors.specular,
    };
    core::array::from_fn(|c| (PI * f64::from(color.0[c]) * f64::from(lobe.tint.0[c])) as f32)
}

/// Σ ambient light × Σ ambient tints; textured lobes first, then the others.
fn ambient_of<'a>(material: &Material, lights: impl Iterator<Item = &'a Light>) -> [[f32; 3]; 2] {
    let light = lights.fold(Rgb::BLACK, |sum, light| sum + light.colors.ambient);
    [true, false].map(|textured| {
        let tint = material
            .lobes
            .iter()
            .filter(|lobe| part_of(lobe) == Part::Ambient && lobe.textured == textured)
            .fold(Rgb::BLACK, |sum, lobe| sum + lobe.tint);
        (light * tint).0
    })
}

/// Σ of the light of its own that textures multiply, or of that which they do not.
fn emission_of(material: &Material, textured: bool) -> Rgb {
    let own =
        material.lobes.iter().filter(|lobe| part_of(lobe) == Part::Emission && lobe.textured == textured);
    own.fold(Rgb::BLACK, |sum, lobe| sum + lobe.tint)
}

fn spot_ambient(material: &Material, scene: &Scene) -> Vec<[[f32; 3]; 2]> {
    let rows: Vec<_> = lights::directed(scene)
        .map(|light| ambient_of(material, is_spot(light).then_some(light).into_iter()))
        .collect();
    if rows.iter().any(|row| *row != [[0.0; 3]; 2]) { rows } else { Vec::new() }
}
