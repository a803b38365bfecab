//! A packed scene holds every value of the prepared one, where the table of the sections says.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod common;

use std::collections::HashSet;
use std::sync::Arc;

use common::everything::{GLASS, everything, punctual};
use glanz_bsdf::{FactorTable, LayerWeight, Shape};
use glanz_math::Chebyshev;
use glanz_render::prepare::{
    AreaIntegral, EnvironmentChain, EnvironmentMap, LightShape, LobeIntegrals, LobeLookups, LobeRoughness,
    Lookup, LtcComponent, NO_RECORD, Packed, Pool, PreparedLight, PreparedMask, PreparedMaterial,
    PreparedObject, Section, TintCoordinate, TintSeries, ViewNodes,
};
use glanz_render::{Observation, PrepareOptions, Prepared, prepare};
use glanz_scene::{AlphaMode, AreaShape, ColorMode, Metalness, Object, Scene, Shading, Space, TextureUse};

fn prepared(scene: &Scene, mode: ColorMode) -> Prepared {
    let observation = Observation::new(mode, None).unwrap();
    prepare(scene, &PrepareOptions { observation, ..PrepareOptions::default() }).unwrap()
}

/// The scene with everything, with layers of all kinds over one lobe, and a flat object with vertex colours.
fn scene() -> Scene {
    let mut scene = everything();
    scene.render.shadows = true;
    let angle = glanz_bsdf::Angle::HalfThrough;
    let lobe = &mut scene.materials[0].lobes[0];
    lobe.metalness = Metalness::Dielectric { factor: 0.25 };
    let values = (0..24).map(|i| 0.5 + 0.01 * i as f32).collect();
    let table = FactorTable::new([2, 3, 2, 1], 2, values).unwrap();
    lobe.layers = vec![
        LayerWeight::Constant(0.5),
        LayerWeight::Schlick { angle, at_zero: 0.9, at_grazing: 0.1 },
        LayerWeight::Series { angle: glanz_bsdf::Angle::View, factor: Chebyshev::interpolate(3, |x| x) },
        LayerWeight::Sheen { strength: 0.3, albedo: glanz_bsdf::models::charlie::Albedo::new(0.4) },
        LayerWeight::Table { table: Arc::new(table), rank: 1 },
    ];
    let colored =
        Object { shading: Some(Shading::Flat), interpolation: None, ..scene.objects[GLASS].clone() };
    scene.objects.push(colored);
    scene
}

/// Numbers of a section from its records.
struct Reader<'a> {
    packed: &'a Packed,
    /// All records that something was compared with.
    seen: HashSet<(Section, usize)>,
}

impl<'a> Reader<'a> {
    fn words(&mut self, section: Section, number: usize) -> &'a [u32] {
        self.seen.insert((section, number));
        let span = self.packed.sections[section as usize];
        assert!(number < span.len, "{section:?} {number}");
        &self.packed.words[span.offset + number * span.stride..][..span.stride]
    }

    fn floats(&mut self, section: Section, number: usize) -> &'a [f32] {
        self.seen.insert((section, number));
        let span = self.packed.sections[section as usize];
        assert!(number < span.len, "{section:?} {number}");
        &self.packed.floats[span.offset + number * span.stride..][..span.stride]
    }

    /// Compares records from `first` on.
    fn same<const N: usize>(&mut self, section: Section, first: u32, expected: &[[f32; N]]) {
        for (i, expected) in expected.iter().enumerate() {
            let number = first as usize + i;
            assert_eq!(self.floats(section, number), expected, "{section:?} {number}");
        }
    }

    /// The same for what may not be there.
    fn same_or_none<const N: usize>(&mut self, section: Section, first: u32, expected: &[[f32; N]]) {
        assert_eq!(first == NO_RECORD, expected.is_empty(), "{section:?}");
        self.same(section, first, expected);
    }

    fn scalar_series(&mut self, number: u32, expected: &Chebyshev) {
        let [first, terms] = *self.words(Section::ScalarSeries, number as usize) else { unreachable!() };
        assert_eq!(terms as usize, expected.terms.len());
        let terms: Vec<[f32; 1]> = expected.terms.iter().map(|[term]| [*term as f32]).collect();
        self.same(Section::ScalarTerms, first, &terms);
    }

    fn series(&mut self, number: u32, expected: &TintSeries) {
        let [first, terms] = *self.words(Section::Series, number as usize) else { unreachable!() };
        assert_eq!(terms as usize, expected.terms.len());
        self.same(Section::Terms, first, &expected.terms);
    }

    fn map(&mut self, number: u32, expected: &EnvironmentMap) {
        let [width, height, first] = *self.words(Section::Maps, number as usize) else { unreachable!() };
        assert_eq!([width as usize, height as usize], [expected.width, expected.height]);
        self.same(Section::Pixels, first, &expected.pixels);
    }
}

/// A place to 48 bits.
fn is_at(pairs: &[f32], point: [f64; 3]) {
    for axis in 0..3 {
        let sum = f64::from(pairs[axis]) + f64::from(pairs[axis + 3]);
        assert!((sum - point[axis]).abs() <= point[axis].abs() * 2f64.powi(-47), "{sum}, {point:?}");
        assert_eq!(pairs[axis], point[axis] as f32);
    }
}

fn short<const N: usize>(vector: [f64; N]) -> [f32; N] {
    vector.map(|x| x as f32)
}

fn check_geometry(reader: &mut Reader, prepared: &Prepared) {
    let geometry = &prepared.geometry;
    for (i, c) in geometry.clusters.iter().enumerate() {
        let words = [c.object, c.first_vertex, c.vertices, c.first_triangle, c.triangles];
        assert_eq!(reader.words(Section::Clusters, i), words);
        let bounds = reader.floats(Section::ClusterBounds, i);
        assert_eq!((&bounds[..3], bounds[3]), (&c.center[..], c.radius));
        assert_eq!((&bounds[4..7], bounds[7]), (&c.cone_axis[..], c.cone_sin));
    }
    for i in 0..geometry.vertex_count() {
        let position = [0, 1, 2].map(|axis: usize| geometry.position[axis][i]);
        assert_eq!(reader.floats(Section::Positions, i), position);
        assert_eq!(reader.words(Section::Sources, i), [geometry.sources[i]]);
    }
    reader.same(Section::Normals, 0, &geometry.normals);
    reader.same(Section::Uvs, 0, &geometry.uvs);
    reader.same(Section::Uvs2, 0, &geometry.uvs2);
    reader.same(Section::Colors, 0, &geometry.colors);
    reader.same(Section::Tangents, 0, &geometry.tangents);
    for i in 0..geometry.triangle_count() {
        let [corners, facet] = *reader.words(Section::Triangles, i) else { unreachable!() };
        let corner = |number: u32| (corners >> (8 * number) & 255) as u8;
        assert_eq!([0, 1, 2].map(corner), geometry.triangles[i]);
        assert_eq!((facet, (corners >> 24) as u8), geometry.facets[i]);
    }
}

fn check_object(reader: &mut Reader, number: usize, object: &PreparedObject) {
    let record = reader.words(Section::Objects, number);
    assert_eq!(record[0] as usize, object.material);
    assert_eq!(record[1] as usize..(record[1] + record[2]) as usize, object.clusters);
    assert_eq!(record[3], object.first_facet);
    let flags = record[4];
    assert_eq!([flags & 3, flags >> 2 & 3], [object.shading as u32, object.interpolation as u32]);
    let attributes = object.attributes;
    let bits = [4, 5, 6, 7, 8].map(|bit| flags >> bit & 1 == 1);
    let expected = [object.closed, attributes.uv, attributes.color, attributes.tangent, attributes.uv2];
    assert_eq!(bits, expected);
    let places = reader.floats(Section::ObjectPlaces, number);
    is_at(&places[..6], object.anchor);
    assert_eq!(&places[6..], object.bounds.map(short).as_flattened());
    assert_eq!(record[5] == NO_RECORD, object.facets.is_none());
    if let Some(facets) = &object.facets {
        assert_eq!(record[6] as usize, facets.centroids.len());
        for (i, (centroid, normal)) in facets.centroids.iter().zip(&facets.normals).enumerate() {
            let own = reader.floats(Section::Facets, record[5] as usize + i);
            assert_eq!((&own[..3], &own[3..]), (&centroid[..], &normal[..]));
        }
        reader.same_or_none(Section::FacetColors, record[7], &facets.colors);
    }
    assert_eq!(record[8] == NO_RECORD, object.polygons.is_none());
    if let Some(polygons) = &object.polygons {
        for (i, start) in polygons.starts.iter().enumerate() {
            assert_eq!(reader.words(Section::PolygonStarts, record[8] as usize + i), [*start]);
        }
        for (i, (position, normal)) in polygons.positions.iter().zip(&polygons.normals).enumerate() {
            let own = reader.floats(Section::PolygonCorners, record[9] as usize + i);
            assert_eq!((&own[..3], &own[3..]), (&position[..], &normal[..]));
        }
        reader.same_or_none(Section::PolygonUvs, record[10], &polygons.uvs);
        reader.same_or_none(Section::PolygonColors, record[11], &polygons.colors);
    }
}

fn check_texture_use(reader: &mut Reader, number: u32, expected: Option<TextureUse>) {
    assert_eq!(number == NO_RECORD, expected.is_none());
    let Some(expected) = expected else { return };
    let words = [expected.texture as u32, u32::from(expected.second_uvs)];
    assert_eq!(reader.words(Section::TextureUses, number as usize), words);
    let values = reader.floats(Section::TextureUseValues, number as usize);
    assert_eq!((&values[..6], values[6]), (expected.transform.as_flattened(), expected.scale));
}

fn check_material(reader: &mut Reader, number: usize, material: &PreparedMaterial) {
    let record = reader.words(Section::Materials, number);
    assert_eq!(record[1] as usize, material.lobes.len());
    for lobe in 0..material.lobes.len() {
        check_lobe(reader, record[0] as usize + lobe, material, lobe);
    }
    reader.same(Section::Tints, record[2], &material.tints);
    assert_eq!(record[3] == NO_RECORD, material.series.is_empty());
    for (i, series) in material.series.iter().enumerate() {
        reader.series(record[3] + i as u32, series);
    }
    let spots: Vec<[f32; 6]> =
        material.spot_ambient.iter().map(|row| *row.as_flattened().first_chunk().unwrap()).collect();
    reader.same_or_none(Section::SpotAmbient, record[4], &spots);
    assert_eq!(record[5] == NO_RECORD, material.integrals.is_empty());
    for (i, integrals) in material.integrals.iter().enumerate() {
        check_integrals(reader, record[5] as usize + i, integrals);
    }
    check_mix(reader, &record[6..9], material);
    assert_eq!(record[9] == NO_RECORD, material.transmittance.is_none());
    if let Some(series) = &material.transmittance {
        reader.series(record[9], series);
    }
    let uses = [material.base_color, material.normal_map, material.emission_map, material.metal_rough_map];
    for (own, expected) in record[10..14].iter().zip(uses) {
        check_texture_use(reader, *own, expected);
    }
    assert_eq!(record[17] as usize, material.channels.len());
    for (i, channel) in material.channels.iter().enumerate() {
        let [map, number] = *reader.words(Section::Channels, record[16] as usize + i) else { unreachable!() };
        assert_eq!(number, channel.channel as u32);
        let mean = reader.floats(Section::ChannelMeans, record[16] as usize + i);
        assert_eq!(mean, [material.means.channels[i]]);
        check_texture_use(reader, map, Some(channel.map));
    }
    assert_eq!(record[18] == NO_RECORD, material.occlusion.is_none());
    if let Some(mask) = &material.occlusion {
        check_mask(reader, record[18] as usize, mask);
    }
    let flags = [0, 1, 2, 3].map(|bit| record[14] >> bit & 1 == 1);
    let expected = [material.two_sided, material.cull_back, material.anisotropic, material.transmits];
    assert_eq!(flags, expected);
    let (mode, cutoff) = match material.alpha_mode {
        AlphaMode::Opaque => (0, 0.0),
        AlphaMode::Mask { cutoff } => (1, cutoff),
        AlphaMode::Blend => (2, 0.0),
    };
    let values = reader.floats(Section::MaterialValues, number);
    assert_eq!((record[15], values[12]), (mode, cutoff));
    assert_eq!((&values[..6], &values[6..9]), (material.ambient.as_flattened(), &material.emission[..]));
    assert_eq!((&values[9..11], values[11]), (&short(material.aniso)[..], material.alpha));
    let (part, factor) = metalness(material.ambient_metalness);
    assert_eq!(
        (&values[13..15], &values[15..17]),
        (&material.means.metal_rough[..], &[part as f32, factor][..])
    );
}

fn metalness(part: Metalness) -> (u32, f32) {
    match part {
        Metalness::Any => (0, 0.0),
        Metalness::Metal { factor } => (1, factor as f32),
        Metalness::Dielectric { factor } => (2, factor as f32),
    }
}

fn check_mask(reader: &mut Reader, number: usize, mask: &PreparedMask) {
    assert_eq!(reader.words(Section::Masks, number), [mask.channel as u32]);
    assert_eq!(reader.floats(Section::MaskValues, number), [mask.from as f32, mask.to as f32]);
}

fn check_mix(reader: &mut Reader, record: &[u32], material: &PreparedMaterial) {
    assert_eq!(record[2] == NO_RECORD, material.mix.is_none());
    let Some(mix) = &material.mix else { return };
    let flat = |rows: &[[[f32; 3]; 3]]| -> Vec<[f32; 9]> {
        rows.iter().map(|row| *row.as_flattened().first_chunk().unwrap()).collect()
    };
    reader.same(Section::MixTints, record[0], &flat(&mix.tints));
    reader.same_or_none(Section::MixSpotAmbient, record[1], &flat(&mix.spot_ambient));
    let values = reader.floats(Section::MixValues, record[2] as usize);
    assert_eq!(&values[..9], mix.ambient.as_flattened());
    assert_eq!(&values[9..], mix.emission.as_flattened());
}

fn check_lobe(reader: &mut Reader, number: usize, material: &PreparedMaterial, lobe: usize) {
    let lobe = &material.lobes[lobe];
    let record = reader.words(Section::Lobes, number);
    let params: Vec<[f32; 1]> = lobe.shape.params().iter().map(|value| [*value as f32]).collect();
    assert_eq!([record[0], record[2]], [lobe.shape.id(), params.len() as u32]);
    reader.same(Section::Params, record[1], &params);
    assert_eq!([record[3], record[4]], [lobe.term as u32, u32::from(lobe.textured)]);
    let values = reader.floats(Section::LobeValues, number);
    let (coordinate, eta) = match lobe.coordinate {
        TintCoordinate::None => (0, 0.0),
        TintCoordinate::HalfAngle => (1, 0.0),
        TintCoordinate::CoatPath { eta } => (2, eta as f32),
    };
    assert_eq!((record[5], values[0]), (coordinate, eta));
    let (metalness, factor) = metalness(lobe.metalness);
    assert_eq!((record[6], values[1]), (metalness, factor));
    assert_eq!(record[10] as usize, lobe.masks.len());
    for (i, mask) in lobe.masks.iter().enumerate() {
        check_mask(reader, record[9] as usize + i, mask);
    }
    let roughness = match lobe.roughness {
        LobeRoughness::Material => 0,
        LobeRoughness::Uniform => 1,
        LobeRoughness::Channel(number) => number as u32 + 2,
    };
    assert_eq!(record[11], roughness);
    assert_eq!(record[8] as usize, lobe.layers.len());
    for (i, layer) in lobe.layers.iter().enumerate() {
        check_layer(reader, record[7] as usize + i, layer);
    }
}

fn check_layer(reader: &mut Reader, number: usize, layer: &LayerWeight) {
    let [kind, angle, series] = *reader.words(Section::Layers, number) else { unreachable!() };
    let values = reader.floats(Section::LayerValues, number);
    match layer {
        LayerWeight::Constant(value) => assert_eq!((kind, values[0]), (0, *value as f32)),
        LayerWeight::Schlick { angle: own, at_zero, at_grazing } => {
            assert_eq!((kind, angle), (1, *own as u32));
            assert_eq!(values, short([*at_zero, *at_grazing]));
        }
        LayerWeight::Series { angle: own, factor } => {
            assert_eq!((kind, angle), (2, *own as u32));
            reader.scalar_series(series, factor);
        }
        LayerWeight::Coat { transmittance, gain } => {
            assert_eq!((kind, values[0]), (3, *gain as f32));
            reader.scalar_series(series, transmittance);
        }
        LayerWeight::OverBoundary { transmittance } => {
            assert_eq!(kind, 5);
            reader.scalar_series(series, transmittance);
        }
        LayerWeight::Sheen { strength, albedo } => {
            assert_eq!((kind, values[0]), (4, *strength as f32));
            check_sheen(reader, series, albedo);
        }
        LayerWeight::Table { table, rank } => {
            assert_eq!((kind, angle as usize), (6, *rank));
            let [x, y, z, w, ranks, first] = *reader.words(Section::FactorTables, series as usize) else {
                unreachable!()
            };
            assert_eq!([x, y, z, w].map(|size| size as usize), table.sizes());
            assert_eq!(ranks as usize, table.ranks());
            let values: Vec<[f32; 1]> = table.values().into_iter().map(|value| [value]).collect();
            reader.same(Section::Factors, first, &values);
        }
    }
}

/// The terms are made anew of the albedo's values, and rounded to `f32`.
const SHEEN_TOLERANCE: f64 = 1e-6;

fn check_sheen(reader: &mut Reader, series: u32, albedo: &glanz_bsdf::models::charlie::Albedo) {
    let [first, count] = *reader.words(Section::ScalarSeries, series as usize) else { unreachable!() };
    let term = |i: u32| [f64::from(reader.floats(Section::ScalarTerms, (first + i) as usize)[0])];
    let packed = Chebyshev { terms: (0..count).map(term).collect::<Vec<[f64; 1]>>() };
    for i in 0..=100 {
        let cosine = 0.002 + 0.998 * f64::from(i) / 100.0;
        let x = (cosine.sqrt() - 0.002f64.sqrt()) / (1.0 - 0.002f64.sqrt());
        let (own, expected): (f64, f64) = (packed.at(x), albedo.at(cosine));
        assert!((own - expected).abs() < SHEEN_TOLERANCE, "{cosine}: {own} for {expected}");
    }
}

fn check_integrals(reader: &mut Reader, number: usize, integrals: &LobeIntegrals) {
    let record = reader.words(Section::Integrals, number);
    let [albedo, waves, area, ltc, lookups] = *record else { unreachable!() };
    reader.scalar_series(albedo, &integrals.albedo.mean);
    assert_eq!(waves as usize, integrals.albedo.waves.len());
    for (i, wave) in integrals.albedo.waves.iter().enumerate() {
        reader.scalar_series(albedo + 1 + i as u32, wave);
    }
    let expected = match &integrals.area {
        AreaIntegral::Cosine => 0,
        AreaIntegral::Ltc(table) => {
            let record = reader.words(Section::LtcTables, ltc as usize);
            let [count, azimuths, quarters, first] = *record else { unreachable!() };
            let nodes = ViewNodes { azimuths: azimuths as usize, quarters: quarters as usize };
            assert_eq!((count as usize, nodes), (table.count, table.nodes));
            let values: Vec<[f32; 10]> = table.components.iter().map(LtcComponent::values).collect();
            reader.same(Section::LtcComponents, first, &values);
            1
        }
        AreaIntegral::Points => 2,
        AreaIntegral::Mirror => 3,
    };
    assert_eq!((area, ltc == NO_RECORD), (expected, expected != 1));
    assert_eq!(lookups == NO_RECORD, integrals.lookups.is_none());
    if let Some(table) = &integrals.lookups {
        check_lookups(reader, lookups, table);
    }
}

fn check_lookups(reader: &mut Reader, number: u32, table: &LobeLookups) {
    let record = reader.words(Section::LookupTables, number as usize);
    let [count, azimuths, quarters, wide, first, cosines] = *record else { unreachable!() };
    let nodes = ViewNodes { azimuths: azimuths as usize, quarters: quarters as usize };
    assert_eq!((count as usize, nodes, wide == 1), (table.count, table.nodes, table.wide));
    let values: Vec<[f32; 5]> = table.lookups.iter().map(Lookup::values).collect();
    reader.same(Section::Lookups, first, &values);
    let expected: Vec<[f32; 1]> = table.cosine.iter().map(|value| [*value]).collect();
    reader.same_or_none(Section::LookupCosines, cosines, &expected);
}

fn check_chain(reader: &mut Reader, first: u32, chain: &EnvironmentChain) {
    let begin = reader.words(Section::ChainLevels, first as usize)[2];
    for (i, level) in chain.levels.iter().enumerate() {
        let record = reader.words(Section::ChainLevels, first as usize + i);
        assert_eq!(record, [level.width as u32, level.height as u32, begin + level.first as u32]);
    }
    reader.same(Section::ChainPixels, begin, &chain.pixels);
}

fn check_light(reader: &mut Reader, number: usize, light: &PreparedLight) {
    let [kind, flags, form, _, luminaire, environment] = *reader.words(Section::Lights, number) else {
        unreachable!()
    };
    assert_eq!(flags & 1 == 1, light.space == Space::Camera);
    let values = reader.floats(Section::LightValues, number);
    match &light.shape {
        LightShape::Directional { towards } => {
            assert_eq!((kind, &values[6..9]), (0, &short(*towards)[..]));
        }
        LightShape::Point { position, attenuation } => {
            assert_eq!((kind, flags >> 1 & 1 == 1), (1, attenuation.is_some()));
            assert_eq!(values[18..21], short(attenuation.unwrap_or_default()));
            is_at(&values[..6], *position);
        }
        LightShape::Spot { position, axis, cos_cutoff, exponent, smooth_edge, attenuation } => {
            let (inner, outer) = smooth_edge.unwrap_or_default();
            assert_eq!([kind, flags >> 2 & 1], [2, u32::from(smooth_edge.is_some())]);
            assert_eq!(flags >> 1 & 1 == 1, attenuation.is_some());
            assert_eq!(values[18..21], short(attenuation.unwrap_or_default()));
            assert_eq!(values[6..9], short(*axis));
            assert_eq!(values[21..25], short([*cos_cutoff, *exponent, inner, outer]));
            is_at(&values[..6], *position);
        }
        LightShape::Area { form: own, position, axes, two_sided } => {
            let (expected, size) = match *own {
                AreaShape::Rectangle { width, height } => (0, [width, height]),
                AreaShape::Disk { radius } => (1, [radius, 0.0]),
                AreaShape::Sphere { radius } => (2, [radius, 0.0]),
            };
            assert_eq!((kind, flags >> 3 & 1 == 1, form), (3, *two_sided, expected));
            assert_eq!(&values[9..18], axes.map(short).as_flattened());
            assert_eq!(values[25..27], short(size));
            is_at(&values[..6], *position);
        }
        LightShape::Environment(own) => {
            assert_eq!(kind, 4);
            let values = reader.floats(Section::EnvironmentValues, environment as usize);
            assert_eq!(&values[..93], own.irradiance.terms.as_flattened());
            assert_eq!(&values[93..], own.rotation.map(short).as_flattened());
            let [map, chain] = *reader.words(Section::Environments, environment as usize) else {
                unreachable!()
            };
            assert_eq!(map == NO_RECORD, own.map.is_none());
            let own_chain = own.map.as_ref().and_then(|map| map.chain());
            assert_eq!(chain == NO_RECORD, own_chain.is_none());
            own_chain.iter().for_each(|own| check_chain(reader, chain, own));
            own.map.iter().for_each(|own| reader.map(map, own));
        }
    }
    assert_eq!(environment != NO_RECORD, kind == 4);
    assert_eq!(luminaire == NO_RECORD, light.luminaire.is_none());
    if let Some(own) = &light.luminaire {
        let frame = reader.floats(Section::LuminaireFrames, luminaire as usize);
        assert_eq!(frame, own.frame.map(short).as_flattened());
        let first = reader.words(Section::Luminaires, luminaire as usize)[0];
        let values: Vec<[f32; 1]> = own.intensities.values.iter().map(|value| [*value]).collect();
        reader.same(Section::Intensities, first, &values);
    }
}

fn check_textures(reader: &mut Reader, prepared: &Prepared) {
    for (i, texture) in prepared.textures.iter().enumerate() {
        let [first, levels, u, v, filter] = *reader.words(Section::Textures, i) else { unreachable!() };
        assert_eq!(levels as usize, texture.levels.len());
        assert_eq!([u, v, filter], [texture.wrap[0] as u32, texture.wrap[1] as u32, texture.filter as u32]);
        assert_eq!(reader.floats(Section::Decode, i), texture.decode);
        for (k, level) in texture.levels.iter().enumerate() {
            let [width, height, texels] = *reader.words(Section::Levels, first as usize + k) else {
                unreachable!()
            };
            assert_eq!([width as usize, height as usize], [level.width, level.height]);
            for (j, codes) in level.rgba.iter().enumerate() {
                let own = reader.words(Section::Texels, texels as usize + j)[0];
                assert_eq!([0, 8, 16, 24].map(|shift| (own >> shift & 255) as u8), *codes);
            }
        }
    }
}

fn check_bvh(reader: &mut Reader, prepared: &Prepared) {
    let Some(bvh) = &prepared.bvh else { return };
    let origin = reader.floats(Section::BvhPlace, 0);
    is_at(&origin[..6], bvh.center);
    assert_eq!(origin[6], bvh.size);
    for (i, node) in bvh.nodes.iter().enumerate() {
        assert_eq!(reader.words(Section::BvhNodes, i), [node.first, node.count]);
        let corners = reader.floats(Section::BvhBoxes, i);
        assert_eq!((&corners[..3], &corners[3..]), (&node.min[..], &node.max[..]));
    }
    for (i, triangle) in bvh.triangles.iter().enumerate() {
        assert_eq!(reader.floats(Section::BvhTriangles, i), triangle.as_flattened());
    }
}

/// Compares everything, and says which records nothing was compared with.
fn unseen(prepared: &Prepared, packed: &Packed) -> Vec<(Section, usize)> {
    let mut reader = Reader { packed, seen: HashSet::new() };
    check_geometry(&mut reader, prepared);
    prepared.objects.iter().enumerate().for_each(|(i, object)| check_object(&mut reader, i, object));
    prepared.materials.iter().enumerate().for_each(|(i, own)| check_material(&mut reader, i, own));
    let mut row = 0;
    for (i, light) in prepared.lights.iter().enumerate() {
        check_light(&mut reader, i, light);
        assert_eq!(reader.words(Section::Lights, i)[3], row);
        row += light.shape.rows() as u32;
    }
    if let Some(tint) = &prepared.environment_tint {
        assert_eq!(reader.floats(Section::EnvironmentTint, 0), tint.as_flattened());
    }
    check_textures(&mut reader, prepared);
    check_bvh(&mut reader, prepared);
    let all = Section::ALL.iter().flat_map(|section| (0..packed.span(*section).len).map(|i| (*section, i)));
    all.filter(|record| !reader.seen.contains(record)).collect()
}

#[test]
fn every_value_is_where_the_table_says_and_nothing_else_is_there() {
    for mode in [ColorMode::Rgb, ColorMode::Spectral] {
        for scene in [scene(), punctual(), Scene::default()] {
            let prepared = prepared(&scene, mode);
            assert_eq!(unseen(&prepared, &prepared.pack()), []);
        }
    }
}

#[test]
fn the_scene_has_records_of_every_section() {
    let packed = prepared(&scene(), ColorMode::Spectral).pack();
    let empty = |section: &&Section| packed.span(**section).len == 0;
    assert_eq!(Section::ALL.iter().filter(empty).collect::<Vec<_>>(), Vec::<&Section>::new());
}

#[test]
fn sections_fill_their_pools_without_gaps_or_overlaps() {
    let packed = prepared(&scene(), ColorMode::Spectral).pack();
    for (pool, numbers) in [(Pool::Words, packed.words.len()), (Pool::Floats, packed.floats.len())] {
        let mut end = 0;
        for section in Section::ALL.iter().filter(|section| section.pool() == pool) {
            let span = packed.span(*section);
            assert_eq!((span.offset, span.stride), (end, section.stride()), "{section:?}");
            end += span.len * span.stride;
        }
        assert_eq!(end, numbers, "{pool:?}");
    }
    assert_eq!(packed.sections.len(), Section::ALL.len());
}

#[test]
fn what_is_shared_is_packed_once() {
    let mut scene = scene();
    let before = prepared(&scene, ColorMode::Rgb).pack();
    scene.materials.push(scene.materials[1].clone());
    let after = prepared(&scene, ColorMode::Rgb).pack();
    assert!(after.span(Section::Lobes).len > before.span(Section::Lobes).len);
    for section in
        [Section::Maps, Section::Pixels, Section::LtcTables, Section::LookupTables, Section::ChainPixels]
    {
        assert_eq!(before.span(section).len, after.span(section).len, "{section:?}");
    }
}

#[test]
fn models_are_named_by_their_stable_numbers() {
    let packed = prepared(&punctual(), ColorMode::Rgb).pack();
    let ward = Shape::named("ward", &[]).unwrap().id();
    assert_eq!(packed.words(Section::Lobes, 0)[0], ward);
}
