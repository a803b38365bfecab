//! Materials.

use glanz_bsdf::{LightTerm, Shape};

use super::WriteError;
use super::color::{tint, transmittance};
use super::lobe::{lobe, mask};
use super::names::Names;
use super::side_files::SideFiles;
use super::text::{Document, Table, degrees, key, list, number, single, singles, string, tall_list};
use crate::{AlphaMode, ClassicMaterial, Material, TextureUse, Tint};

/// Adds `[materials.NAME]`.
pub(super) fn write(
    material: &Material,
    name: &str,
    names: &Names,
    document: &mut Document,
    files: &mut SideFiles,
) -> Result<(), WriteError> {
    let wrong = |what| WriteError::NoKey { place: format!("material '{name}'"), what };
    let mut table = Table::default();
    table.put_unless(material.name == name, "name", string(&material.name));
    let only_here = |shape: &Shape| matches!(shape, Shape::Custom(_)) && shape.source().is_none();
    if material.lobes.iter().any(|lobe| only_here(&lobe.shape)) {
        return Err(wrong("a lobe of a model that only the program knows"));
    }
    let glows = material.lobes.iter().filter(|lobe| lobe.shape.info().term == LightTerm::Emission);
    if glows.into_iter().any(|lobe| !matches!(lobe.tint, Tint::Rgb(_) | Tint::Spectrum(_))) {
        return Err(wrong("an emission lobe whose tint is not a colour or a spectrum"));
    }
    match classic(material) {
        Some(block) => put_classic(&block, &mut table),
        None => table.put("lobes", tall_list(material.lobes.iter().map(|own| lobe(own, names, files)))),
    }
    if let Some(value) = &material.transmittance {
        let value = transmittance(value).ok_or_else(|| wrong("a transmittance that depends on the angle"))?;
        table.put("transmittance", value);
    }
    put_surface(material, &mut table);
    let maps = [
        ("base_color_texture", material.base_color),
        ("normal_texture", material.normal_map),
        ("emission_texture", material.emission_map),
        ("metal_rough_texture", material.metal_rough_map),
    ];
    for (map, value) in maps.into_iter().filter_map(|(map, value)| Some((map, value?))) {
        table.put(map, texture_use(&value, names));
    }
    if let Some(occlusion) = &material.occlusion {
        table.put("occlusion_texture", mask(occlusion, names));
    }
    document.section(&format!("[materials.{}]", key(name)), &table, false);
    Ok(())
}

fn put_surface(material: &Material, table: &mut Table) {
    if material.aniso != 0.0 {
        match degrees(material.aniso) {
            Some(degrees) => table.put("aniso_deg", degrees),
            None => table.put("aniso_rad", number(material.aniso)),
        }
    }
    table.put_unless(material.two_sided, "two_sided", "false");
    table.put_unless(!material.cull_back, "cull_back", "true");
    table.put_unless(material.opacity == 1.0, "opacity", single(material.opacity));
    let translucent = material.opacity < 1.0;
    match material.alpha_mode {
        AlphaMode::Opaque => table.put_unless(!translucent, "alpha_mode", string("opaque")),
        AlphaMode::Blend => table.put_unless(translucent, "alpha_mode", string("blend")),
        AlphaMode::Mask { cutoff } => {
            table.put("alpha_mode", string("mask"));
            table.put_unless(cutoff == 0.5, "alpha_cutoff", single(cutoff));
        }
    }
}

pub(super) fn texture_use(map: &TextureUse, names: &Names) -> String {
    let mut table = Table::default();
    table.put("texture", string(&names.textures[map.texture]));
    let plain = TextureUse::plain(map.texture);
    let rows = list(map.transform.iter().map(|row| singles(row)));
    table.put_unless(map.transform == plain.transform, "transform", rows);
    table.put_unless(map.scale == plain.scale, "scale", single(map.scale));
    table.put_unless(!map.second_uvs, "uv_set", "1");
    table.inline()
}

/// The classic block of which the lobes are, if they are of one.
fn classic(material: &Material) -> Option<ClassicMaterial> {
    let mut block = ClassicMaterial::default();
    for lobe in &material.lobes {
        let info = lobe.shape.info();
        let color = match (info.name, info.term) {
            ("ambient", _) => &mut block.ambient,
            ("lambert", _) => &mut block.diffuse,
            ("emission", _) => &mut block.emission,
            (model, LightTerm::Specular) => {
                block.model = model.to_owned();
                let exponent = info.params.iter().position(|param| param.name == "shininess");
                block.shininess = exponent.map_or(block.shininess, |i| lobe.shape.params()[i]);
                block.parameters = parameters(&lobe.shape);
                &mut block.specular
            }
            _ => return None,
        };
        *color = lobe.tint.clone();
    }
    let built = block.build("").ok()?;
    (!material.lobes.is_empty() && built.lobes == material.lobes).then_some(block)
}

/// The parameters of a highlight that are not the exponent and not as the model has them by default.
fn parameters(shape: &Shape) -> Vec<(String, f64)> {
    let values = shape.info().params.iter().zip(shape.params());
    let own = values.filter(|(param, value)| param.name != "shininess" && *value != param.default);
    own.map(|(param, value)| (param.name.to_owned(), value)).collect()
}

fn put_classic(block: &ClassicMaterial, table: &mut Table) {
    let default = ClassicMaterial::default();
    table.put_unless(block.model == default.model, "model", string(&block.model));
    let colors = [
        ("ambient", &block.ambient),
        ("diffuse", &block.diffuse),
        ("specular", &block.specular),
        ("emission", &block.emission),
    ];
    for (name, color) in colors {
        table.put_unless(color.is_black(), name, tint(color));
    }
    table.put_unless(block.shininess == default.shininess, "shininess", number(block.shininess));
    for (name, value) in &block.parameters {
        table.put(name, number(*value));
    }
}
