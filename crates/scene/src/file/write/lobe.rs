//! The lobes of general materials.

use glanz_bsdf::{Angle, Chebyshev, LayerWeight, LightTerm, ModelSource, Shape};

use super::color::{is_white, tint};
use super::material::texture_use;
use super::names::Names;
use super::side_files::SideFiles;
use super::text::{Table, inline, list, number, numbers, samples, string};
use crate::file::factors;
use crate::{ChannelUse, Lobe, Mask, Metalness, RoughnessMap, TextureChannel, Tint};

/// A lobe on one line.
pub(super) fn lobe(lobe: &Lobe, names: &Names, files: &mut SideFiles) -> String {
    let mut table = Table::default();
    let info = lobe.shape.info();
    match lobe.shape.source() {
        Some(source) => table.put("shape", brdf(source, &lobe.shape, files)),
        None => {
            table.put("shape", string(info.name));
            put_parameters(&lobe.shape, &mut table);
        }
    }
    match &lobe.tint {
        Tint::Schlick(at_normal) if matches!(**at_normal, Tint::Rgb(_) | Tint::Spectrum(_)) => {
            table.put("tint", tint(at_normal));
            table.put("fresnel", string("schlick"));
        }
        other => table.put_unless(is_white(other), "tint", tint(other)),
    }
    let textured = matches!(info.term, LightTerm::Ambient | LightTerm::Diffuse);
    table.put_unless(lobe.textured == textured, "textured", lobe.textured.to_string());
    let is_lit = matches!(info.term, LightTerm::Diffuse | LightTerm::Specular);
    match lobe.layers.as_slice() {
        [] => {}
        [LayerWeight::Constant(weight)] if is_lit && (0.0..1.0).contains(weight) => {
            table.put("weight", number(*weight));
        }
        layers => table.put("layers", list(layers.iter().map(|own| layer(own, files)))),
    }
    if let Some(absorption) = &lobe.absorption {
        let depth = samples(&absorption.depth);
        table.put("absorption", inline([("depth", depth), ("eta", number(absorption.eta))]));
    }
    match lobe.metalness {
        Metalness::Any => {}
        Metalness::Metal { factor } => table.put("metalness", inline([("metal", number(factor))])),
        Metalness::Dielectric { factor } => table.put("metalness", inline([("dielectric", number(factor))])),
    }
    table.put_unless(lobe.masks.is_empty(), "masks", list(lobe.masks.iter().map(|own| mask(own, names))));
    match lobe.roughness {
        RoughnessMap::Material => {}
        RoughnessMap::Uniform => table.put("rough_texture", "false"),
        RoughnessMap::Own(of) => table.put("rough_texture", channel(&of, names).inline()),
    }
    table.inline()
}

/// A factor that a picture says, on one line.
pub(super) fn mask(mask: &Mask, names: &Names) -> String {
    let mut table = channel(&mask.of, names);
    table.put_unless(mask.from == 0.0, "from", number(mask.from));
    table.put_unless(mask.to == 1.0, "to", number(mask.to));
    table.inline()
}

fn channel(of: &ChannelUse, names: &Names) -> Table {
    let mut table = Table::default();
    table.put("picture", texture_use(&of.map, names));
    table.put_unless(of.channel == TextureChannel::Red, "channel", string(of.channel.name()));
    table
}

fn put_parameters(shape: &Shape, table: &mut Table) {
    for (param, value) in shape.info().params.iter().zip(shape.params()) {
        table.put_unless(value == param.default, param.name, number(value));
    }
}

/// A user's BRDF, whose text goes into a file of its own.
fn brdf(source: &ModelSource, shape: &Shape, files: &mut SideFiles) -> String {
    let is_wgsl = source.file.ends_with(".wgsl");
    let ending = if is_wgsl { "wgsl" } else { "brdf" };
    let mut table = Table::default();
    table.put("file", string(&files.add("brdf", ending, source.text.clone().into_bytes())));
    table.put("name", string(&source.file));
    table.put_unless(!source.diffuse, "term", string("diffuse"));
    put_parameters(shape, &mut table);
    table.inline()
}

fn layer(layer: &LayerWeight, files: &mut SideFiles) -> String {
    let (kind, value) = match layer {
        LayerWeight::Constant(weight) => ("constant", number(*weight)),
        LayerWeight::Schlick { angle, at_zero, at_grazing } => (
            "schlick",
            inline([
                ("angle", angle_name(*angle)),
                ("at_zero", number(*at_zero)),
                ("at_grazing", number(*at_grazing)),
            ]),
        ),
        LayerWeight::Series { angle, factor } => {
            ("series", inline([("angle", angle_name(*angle)), ("terms", terms(factor))]))
        }
        LayerWeight::Coat { transmittance, gain } => {
            ("coat", inline([("terms", terms(transmittance)), ("gain", number(*gain))]))
        }
        LayerWeight::OverBoundary { transmittance } => {
            ("over_boundary", inline([("terms", terms(transmittance))]))
        }
        LayerWeight::Sheen { strength, albedo } => {
            ("sheen", inline([("strength", number(*strength)), ("terms", numbers(albedo.series()))]))
        }
        LayerWeight::Table { table, rank } => {
            let file = files.add("measured", "factors", factors::bytes(table));
            ("table", inline([("file", string(&file)), ("rank", rank.to_string())]))
        }
    };
    inline([(kind, value)])
}

fn angle_name(angle: Angle) -> String {
    string(match angle {
        Angle::Half => "half",
        Angle::HalfThrough => "half-through",
        Angle::View => "view",
    })
}

fn terms(series: &Chebyshev) -> String {
    list(series.terms.iter().map(|[term]| number(*term)))
}
