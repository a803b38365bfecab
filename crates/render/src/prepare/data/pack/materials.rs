//! Materials, lobes and the tint table.

use glanz_bsdf::{FactorTable, LayerWeight};
use glanz_math::Chebyshev;
use glanz_scene::{AlphaMode, ChannelUse, Metalness, TextureUse};

use super::{NO_RECORD, Packer, Section};
use crate::prepare::data::{
    AreaIntegral, DirectLobe, LobeIntegrals, LobeLookups, LobeRoughness, Lookup, LtcComponent, LtcTable,
    MixTints, PreparedMask, PreparedMaterial, TintCoordinate,
};

/// The least cosine of a sheen's albedo, and the terms of its series: those of the model.
const LEAST_SHEEN_COSINE: f64 = 0.002;
const SHEEN_TERMS: usize = 13;

impl Packer {
    pub(super) fn material(&mut self, material: &PreparedMaterial) {
        let first_lobe = self.next(Section::Lobes);
        material.lobes.iter().for_each(|lobe| self.lobe(lobe));
        let spot_ambient = material.spot_ambient.as_flattened().as_flattened();
        let [mix_tints, mix_spot, mix] = material.mix.as_ref().map_or([NO_RECORD; 3], |mix| self.mix(mix));
        let transmittance = material.transmittance.as_slice();
        let (alpha_mode, _) = alpha_mode(material);
        let record = [
            first_lobe,
            material.lobes.len() as u32,
            self.floats(Section::Tints, material.tints.as_flattened()),
            or_none(&material.series, |series| self.series(series)),
            or_none(spot_ambient, |rows| self.floats(Section::SpotAmbient, rows)),
            or_none(&material.integrals, |integrals| self.integrals(integrals)),
            mix_tints,
            mix_spot,
            mix,
            or_none(transmittance, |series| self.series(series)),
            self.texture_use(material.base_color),
            self.texture_use(material.normal_map),
            self.texture_use(material.emission_map),
            self.texture_use(material.metal_rough_map),
            flags(material),
            alpha_mode,
            self.channels(&material.channels, &material.means.channels),
            material.channels.len() as u32,
            material.occlusion.map_or(NO_RECORD, |mask| self.mask(&mask)),
        ];
        self.words(Section::Materials, &record);
        self.material_values(material);
    }

    fn material_values(&mut self, material: &PreparedMaterial) {
        let aniso = material.aniso.map(|x| x as f32);
        let alpha = [material.alpha, alpha_mode(material).1];
        let (part, factor) = metalness(material.ambient_metalness);
        let more = [&material.means.metal_rough[..], &[part as f32, factor as f32]].concat();
        let values = [material.ambient.as_flattened(), &material.emission, &aniso, &alpha, &more].concat();
        self.floats(Section::MaterialValues, &values);
    }

    fn channels(&mut self, channels: &[ChannelUse], means: &[f32]) -> u32 {
        let uses: Vec<u32> = channels.iter().map(|own| self.texture_use(Some(own.map))).collect();
        let first = self.next(Section::Channels);
        for ((own, mean), used) in channels.iter().zip(means).zip(uses) {
            self.floats(Section::ChannelMeans, &[*mean]);
            self.words(Section::Channels, &[used, own.channel as u32]);
        }
        first
    }

    fn mask(&mut self, mask: &PreparedMask) -> u32 {
        self.floats(Section::MaskValues, &[mask.from as f32, mask.to as f32]);
        self.words(Section::Masks, &[mask.channel as u32])
    }

    fn lobe(&mut self, lobe: &DirectLobe) {
        let params: Vec<f32> = lobe.shape.params().iter().map(|value| *value as f32).collect();
        let first_param = self.floats(Section::Params, &params);
        let first_layer = self.next(Section::Layers);
        lobe.layers.iter().for_each(|layer| self.layer(layer));
        let first_mask = self.next(Section::Masks);
        lobe.masks.iter().for_each(|mask| {
            self.mask(mask);
        });
        let (coordinate, eta) = match lobe.coordinate {
            TintCoordinate::None => (0, 0.0),
            TintCoordinate::HalfAngle => (1, 0.0),
            TintCoordinate::CoatPath { eta } => (2, eta),
        };
        let (metalness, factor) = metalness(lobe.metalness);
        let record = [
            lobe.shape.id(),
            first_param,
            params.len() as u32,
            lobe.term as u32,
            u32::from(lobe.textured),
            coordinate,
            metalness,
            first_layer,
            lobe.layers.len() as u32,
            first_mask,
            lobe.masks.len() as u32,
            match lobe.roughness {
                LobeRoughness::Material => 0,
                LobeRoughness::Uniform => 1,
                LobeRoughness::Channel(number) => number as u32 + 2,
            },
        ];
        self.words(Section::Lobes, &record);
        self.floats(Section::LobeValues, &[eta as f32, factor as f32]);
    }

    fn layer(&mut self, layer: &LayerWeight) {
        let (kind, angle, series, values) = match layer {
            LayerWeight::Constant(value) => (0, 0, NO_RECORD, [*value, 0.0]),
            LayerWeight::Schlick { angle, at_zero, at_grazing } => {
                (1, *angle as u32, NO_RECORD, [*at_zero, *at_grazing])
            }
            LayerWeight::Series { angle, factor } => (2, *angle as u32, self.scalar_series(factor), [0.0; 2]),
            LayerWeight::Coat { transmittance, gain } => {
                (3, 0, self.scalar_series(transmittance), [*gain, 0.0])
            }
            LayerWeight::OverBoundary { transmittance } => {
                (5, 0, self.scalar_series(transmittance), [0.0; 2])
            }
            LayerWeight::Sheen { strength, albedo } => {
                let flattest = libm::sqrt(LEAST_SHEEN_COSINE);
                let at = |x: f64| {
                    let root = flattest + (1.0 - flattest) * x;
                    albedo.at(root * root)
                };
                let series = self.scalar_series(&Chebyshev::interpolate(SHEEN_TERMS, at));
                (4, 0, series, [*strength, 0.0])
            }
            LayerWeight::Table { table, rank } => {
                (6, *rank as u32, self.once(table, Self::factor_table), [0.0; 2])
            }
        };
        self.words(Section::Layers, &[kind, angle, series]);
        self.floats(Section::LayerValues, &values.map(|value| value as f32));
    }

    fn factor_table(&mut self, table: &FactorTable) -> u32 {
        let first = self.floats(Section::Factors, &table.values());
        let [x, y, z, w] = table.sizes().map(|size| size as u32);
        self.words(Section::FactorTables, &[x, y, z, w, table.ranks() as u32, first])
    }

    /// The numbers of the first entry, of the first light and of the values that no light has a part in.
    fn mix(&mut self, mix: &MixTints) -> [u32; 3] {
        let spots = mix.spot_ambient.as_flattened().as_flattened();
        [
            self.floats(Section::MixTints, mix.tints.as_flattened().as_flattened()),
            or_none(spots, |rows| self.floats(Section::MixSpotAmbient, rows)),
            self.floats(Section::MixValues, [mix.ambient, mix.emission].as_flattened().as_flattened()),
        ]
    }

    fn integrals(&mut self, integrals: &[LobeIntegrals]) -> u32 {
        let first = self.next(Section::Integrals);
        for lobe in integrals {
            let albedo = self.scalar_series(&lobe.albedo.mean);
            for wave in &lobe.albedo.waves {
                self.scalar_series(wave);
            }
            let waves = lobe.albedo.waves.len() as u32;
            let (area, ltc) = match &lobe.area {
                AreaIntegral::Cosine => (0, NO_RECORD),
                AreaIntegral::Ltc(table) => (1, self.once(table, Self::ltc)),
                AreaIntegral::Points => (2, NO_RECORD),
                AreaIntegral::Mirror => (3, NO_RECORD),
            };
            let lookups =
                lobe.lookups.as_ref().map_or(NO_RECORD, |lookups| self.once(lookups, Self::lookups));
            self.words(Section::Integrals, &[albedo, waves, area, ltc, lookups]);
        }
        first
    }

    fn lookups(&mut self, table: &LobeLookups) -> u32 {
        let values: Vec<_> = table.lookups.iter().map(Lookup::values).collect();
        let first = self.floats(Section::Lookups, values.as_flattened());
        let cosines = or_none(&table.cosine, |cosines| self.floats(Section::LookupCosines, cosines));
        let sizes = [table.count, table.nodes.azimuths, table.nodes.quarters, usize::from(table.wide)];
        let [count, azimuths, quarters, wide] = sizes.map(|size| size as u32);
        self.words(Section::LookupTables, &[count, azimuths, quarters, wide, first, cosines])
    }

    fn ltc(&mut self, table: &LtcTable) -> u32 {
        let values: Vec<_> = table.components.iter().map(LtcComponent::values).collect();
        let first = self.floats(Section::LtcComponents, values.as_flattened());
        let sizes = [table.count, table.nodes.azimuths, table.nodes.quarters];
        let [count, azimuths, quarters] = sizes.map(|size| size as u32);
        self.words(Section::LtcTables, &[count, azimuths, quarters, first])
    }

    fn texture_use(&mut self, used: Option<TextureUse>) -> u32 {
        let Some(TextureUse { texture, transform, scale, second_uvs }) = used else { return NO_RECORD };
        self.floats(Section::TextureUseValues, &[transform.as_flattened(), &[scale]].concat());
        self.words(Section::TextureUses, &[texture as u32, u32::from(second_uvs)])
    }
}

/// The number of the first record of what is not empty.
fn or_none<T>(values: &[T], pack: impl FnOnce(&[T]) -> u32) -> u32 {
    if values.is_empty() { NO_RECORD } else { pack(values) }
}

fn flags(material: &PreparedMaterial) -> u32 {
    u32::from(material.two_sided)
        | u32::from(material.cull_back) << 1
        | u32::from(material.anisotropic) << 2
        | u32::from(material.transmits) << 3
}

/// The number of a part of the surface, and its factor.
fn metalness(part: Metalness) -> (u32, f64) {
    match part {
        Metalness::Any => (0, 0.0),
        Metalness::Metal { factor } => (1, factor),
        Metalness::Dielectric { factor } => (2, factor),
    }
}

/// What alpha means, and the cutoff of masks.
fn alpha_mode(material: &PreparedMaterial) -> (u32, f32) {
    match material.alpha_mode {
        AlphaMode::Opaque => (0, 0.0),
        AlphaMode::Mask { cutoff } => (1, cutoff),
        AlphaMode::Blend => (2, 0.0),
    }
}
