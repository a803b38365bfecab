//! The lobes against the formulas of the specification, written out here once more by vectors: with the half
//! vector, the distribution and the visibility of the Khronos documents.

use glanz_bsdf::terms::{fresnel_dielectric, fresnel_film, fresnel_slab};
use glanz_bsdf::{DirectionPair, LayerWeight, LightTerm, Side};
use glanz_math::{PI, Vec3};
use serde_json::{Value, json};

use super::super::tests::{material, read};
use super::{Albedo, FILM_TERMS, greatest_of_film};
use crate::read::Model;
use crate::{Material, Metalness, RoughnessMap, Tint, Transmittance};

mod texels;

/// Tints are `f32`, which rounds to 6e-8; a few of them are multiplied.
const RELATIVE: f64 = 1e-6;

/// What the series of the greatest channel is off by near its kinks.
const KINKS: f64 = 0.01;

const BASE: [f64; 3] = [0.75, 0.5, 0.125];

type Color = [f64; 3];
type Direction = Vec3<f64>;

fn model(metallic: f64, roughness: f64, extensions: Value) -> Model {
    let [r, g, b] = BASE;
    read(&material(json!({ "doubleSided": true, "extensions": extensions, "pbrMetallicRoughness": {
        "baseColorFactor": [r, g, b, 1], "metallicFactor": metallic, "roughnessFactor": roughness } })))
}

fn pbr(metallic: f64, roughness: f64, extensions: Value) -> Material {
    model(metallic, roughness, extensions).materials.remove(0)
}

/// The BSDF times |n·l| of all lobes that lights touch, where the metal texture is 1.
fn value(material: &Material, v: Direction, l: Direction) -> Color {
    let pair = DirectionPair::new(v, l);
    let mut sum = [0.0; 3];
    for lobe in &material.lobes {
        if !matches!(lobe.shape.info().term, LightTerm::Diffuse | LightTerm::Specular) {
            continue;
        }
        let fraction = match lobe.metalness {
            Metalness::Any => 1.0,
            Metalness::Metal { factor } => factor,
            Metalness::Dielectric { factor } => 1.0 - factor,
        };
        assert!(lobe.masks.is_empty() && !matches!(lobe.roughness, RoughnessMap::Own(_)));
        let layers: f64 = lobe.layers.iter().map(|layer| layer.factor(&pair)).product();
        let tint = match &lobe.tint {
            Tint::Rgb(rgb) => rgb.0.map(f64::from),
            Tint::Film(film) => {
                let base = (film.base.eta[50], 0.0);
                let cosine = lobe.shape.tint_cosine(&pair);
                [fresnel_film(cosine, 550.0, film.film.eta[50], film.thickness_nm, base); 3]
            }
            other => panic!("{other:?}"),
        };
        let scale = lobe.shape.f_cos(&pair) * layers * fraction;
        (0..3).for_each(|c| sum[c] += scale * tint[c]);
    }
    sum
}

/// Compares a material with a BSDF, for light from above and from below.
fn compare(material: &Material, expected: impl Fn(Direction, Direction) -> Color) {
    let mut lit = 0;
    for (theta_v, theta_l, phi) in
        [(0.0, 0.3, 1.0), (0.5, 0.5, 3.1), (0.9, 0.2, 2.5), (1.3, 1.1, 2.9), (0.4, 1.4, 0.3), (1.2, 1.2, 0.1)]
    {
        for below in [false, true] {
            let v = Vec3::from_angles(theta_v, 0.4);
            let l = Vec3::from_angles(if below { PI - theta_l } else { theta_l }, 0.4 + phi);
            let (got, expected) = (value(material, v, l), expected(v, l).map(|f| f * l.z.abs()));
            for c in 0..3 {
                let off = (got[c] - expected[c]).abs();
                assert!(
                    off <= RELATIVE * expected[c].abs(),
                    "{theta_v} {theta_l} {phi} {below}: {got:?} for {expected:?}"
                );
                lit += usize::from(expected[c] > 0.0);
            }
        }
    }
    assert!(lit >= 18, "most directions must say something");
}

fn half(v: Direction, l: Direction) -> Direction {
    (v + l).normalized()
}

/// The specular BRDF without Fresnel, as KHR_materials_anisotropy writes it: alpha along and across the tangent.
fn specular([at, ab]: [f64; 2], v: Direction, l: Direction) -> f64 {
    if l.z <= 0.0 {
        return 0.0;
    }
    let h = half(v, l);
    let a2 = at * ab;
    let f = Vec3::new(ab * h.x, at * h.y, a2 * h.z);
    let w2 = a2 / f.dot(f);
    let length = |w: Direction| libm::sqrt((at * w.x).powi(2) + (ab * w.y).powi(2) + w.z.powi(2));
    let visibility = 0.5 / (l.z * length(v) + v.z * length(l));
    a2 * w2 * w2 / PI * visibility
}

fn isotropic(roughness: f64) -> [f64; 2] {
    [roughness * roughness; 2]
}

fn schlick(f0: f64, f90: f64, cosine: f64) -> f64 {
    f0 + (f90 - f0) * (1.0 - cosine.abs()).powi(5)
}

fn diffuse(color: f64, l: Direction) -> f64 {
    if l.z > 0.0 { color / PI } else { 0.0 }
}

fn mix(a: Color, b: Color, t: f64) -> Color {
    core::array::from_fn(|c| a[c] * (1.0 - t) + b[c] * t)
}

/// The dielectric of KHR_materials_specular and KHR_materials_ior, with the widths of its highlight.
fn dielectric(alpha: [f64; 2], f0: Color, weight: f64, v: Direction, l: Direction) -> Color {
    let cosine = v.dot(half(v, l));
    let fr = f0.map(|f0| schlick(f0, 1.0, cosine));
    let greatest = fr[0].max(fr[1]).max(fr[2]);
    core::array::from_fn(|c| {
        (1.0 - weight * greatest) * diffuse(BASE[c], l) + weight * fr[c] * specular(alpha, v, l)
    })
}

fn metal(alpha: [f64; 2], v: Direction, l: Direction) -> Color {
    let cosine = v.dot(half(v, l));
    BASE.map(|base| specular(alpha, v, l) * (base + (1.0 - base) * (1.0 - cosine.abs()).powi(5)))
}

fn base(roughness: f64, v: Direction, l: Direction) -> Color {
    dielectric(isotropic(roughness), [0.04; 3], 1.0, v, l)
}

#[test]
fn dielectrics_metals_and_what_is_half_each_are_those_of_appendix_b() {
    for roughness in [0.25, 0.5, 1.0] {
        compare(&pbr(0.0, roughness, json!({})), |v, l| base(roughness, v, l));
        compare(&pbr(1.0, roughness, json!({})), |v, l| metal(isotropic(roughness), v, l));
        compare(&pbr(0.5, roughness, json!({})), |v, l| {
            mix(base(roughness, v, l), metal(isotropic(roughness), v, l), 0.5)
        });
    }
}

#[test]
fn the_index_of_refraction_sets_the_reflectance() {
    // Diamond's index 2.42: (1.42 / 3.42)².
    for (ior, f0) in [(1.5, 0.04), (1.0, 0.0), (2.42, 0.172_394_924_934_167_75), (0.0, 1.0)] {
        let extensions = json!({ "KHR_materials_ior": { "ior": ior } });
        compare(&pbr(0.0, 0.5, extensions), |v, l| dielectric(isotropic(0.5), [f0; 3], 1.0, v, l));
    }
}

#[test]
fn specular_colour_and_strength_change_the_dielectric_alone() {
    let extensions = json!({ "KHR_materials_specular": {
        "specularFactor": 0.5, "specularColorFactor": [2, 1, 0.25] } });
    let mirror = |v, l| dielectric(isotropic(0.5), [0.08, 0.04, 0.01], 0.5, v, l);
    compare(&pbr(0.0, 0.5, extensions.clone()), mirror);
    compare(&pbr(0.5, 0.5, extensions), |v, l| mix(mirror(v, l), metal(isotropic(0.5), v, l), 0.5));
    let bright = json!({ "KHR_materials_specular": { "specularColorFactor": [50, 5, 0] } });
    compare(&pbr(0.0, 0.5, bright), |v, l| dielectric(isotropic(0.5), [1.0, 0.2, 0.0], 1.0, v, l));
}

#[test]
fn a_clear_coat_reflects_and_takes_by_the_angle_of_view() {
    let extensions =
        json!({ "KHR_materials_clearcoat": { "clearcoatFactor": 0.75, "clearcoatRoughnessFactor": 0.25 } });
    compare(&pbr(0.5, 0.5, extensions), |v, l| {
        let below = mix(base(0.5, v, l), metal(isotropic(0.5), v, l), 0.5);
        mix(below, [specular(isotropic(0.25), v, l); 3], 0.75 * schlick(0.04, 1.0, v.z))
    });
}

/// The sheen's distribution times its visibility, for light from above.
fn sheen(alpha: f64, v: Direction, l: Direction) -> f64 {
    let blend = |at_1: f64, at_0: f64| at_1 + (at_0 - at_1) * (1.0 - alpha) * (1.0 - alpha);
    let l_of = |x: f64| {
        let (a, b, c) = (blend(21.5473, 25.3245), blend(3.82987, 3.32435), blend(0.19823, 0.16801));
        let (d, e) = (blend(-1.97760, -1.27393), blend(-4.32054, -4.85967));
        a / (1.0 + b * libm::pow(x, c)) + d * x + e
    };
    let lambda = |cosine: f64| match cosine < 0.5 {
        true => libm::exp(l_of(cosine)),
        false => libm::exp(2.0 * l_of(0.5) - l_of(1.0 - cosine)),
    };
    let sin2 = 1.0 - half(v, l).z.powi(2);
    let distribution = (2.0 + 1.0 / alpha) * libm::pow(sin2, 0.5 / alpha) / (2.0 * PI);
    distribution / ((1.0 + lambda(v.z) + lambda(l.z)) * 4.0 * v.z * l.z)
}

#[test]
fn a_sheen_lies_on_the_base_and_dims_it_by_its_albedo() {
    let color = [0.5, 0.25, 0.125];
    let extensions =
        json!({ "KHR_materials_sheen": { "sheenColorFactor": color, "sheenRoughnessFactor": 0.5 } });
    let albedo = Albedo::new(0.25);
    compare(&pbr(0.0, 0.5, extensions), |v, l| {
        if l.z <= 0.0 {
            return [0.0; 3];
        }
        let taken = 0.5 * albedo.at(v.z).max(albedo.at(l.z));
        let (below, sheen) = (base(0.5, v, l), sheen(0.25, v, l));
        core::array::from_fn(|c| color[c] * sheen + below[c] * (1.0 - taken))
    });
}

#[test]
fn transmission_gives_the_diffuse_part_to_the_other_side() {
    let extensions = json!({ "KHR_materials_transmission": { "transmissionFactor": 0.75 } });
    let open = |v: Direction, l: Direction| {
        let mirrored = Vec3::new(l.x, l.y, -l.z);
        let cosine = v.dot(half(v, if l.z > 0.0 { l } else { mirrored }));
        let f = schlick(0.04, 1.0, cosine);
        BASE.map(|base| {
            let body = diffuse(base, l) * 0.25 + specular(isotropic(0.5), v, mirrored) * base * 0.75;
            body * (1.0 - f) + f * specular(isotropic(0.5), v, l)
        })
    };
    compare(&pbr(0.0, 0.5, extensions.clone()), open);
    compare(&pbr(0.5, 0.5, extensions), |v, l| mix(open(v, l), metal(isotropic(0.5), v, l), 0.5));
}

#[test]
fn anisotropy_widens_the_highlight_along_its_direction() {
    let extensions =
        json!({ "KHR_materials_anisotropy": { "anisotropyStrength": 0.5, "anisotropyRotation": 1.25 } });
    let brushed = pbr(0.5, 0.5, extensions);
    // α = 0.25: along the tangent 0.25 · 0.75 + 1 · 0.25.
    let alpha = [0.4375, 0.25];
    compare(&brushed, |v, l| mix(dielectric(alpha, [0.04; 3], 1.0, v, l), metal(alpha, v, l), 0.5));
    assert_eq!(brushed.aniso, 1.25);
    assert_eq!(pbr(0.5, 0.0, json!({})).lobes[2].shape.params(), [0.001, 0.0, 0.0]);
}

#[test]
fn a_film_of_the_bases_own_index_is_an_ordinary_boundary() {
    let extensions =
        json!({ "KHR_materials_iridescence": { "iridescenceFactor": 0.5, "iridescenceIor": 1.5 } });
    let mut material = pbr(0.0, 0.5, extensions);
    // What is below is the matter of the next test.
    material.lobes.retain(|lobe| lobe.shape.info().term == LightTerm::Specular);
    compare(&material, |v, l| {
        let cosine = v.dot(half(v, l));
        let f = 0.5 * schlick(0.04, 1.0, cosine) + 0.5 * fresnel_dielectric(cosine, 1.5);
        [f * specular(isotropic(0.5), v, l); 3]
    });
}

#[test]
fn a_film_leaves_to_the_light_below_what_its_brightest_channel_does_not_take() {
    let extensions = json!({ "KHR_materials_iridescence": {
        "iridescenceFactor": 1, "iridescenceIor": 1.9, "iridescenceThicknessMinimum": 300,
        "iridescenceThicknessMaximum": 400 } });
    let soap = pbr(0.0, 0.5, extensions);
    let [lambert, gloss] = [1, 2].map(|i| &soap.lobes[i]);
    let (Tint::Film(film), [LayerWeight::Series { factor, .. }]) = (&gloss.tint, &lambert.layers[..]) else {
        panic!("{soap:?}")
    };
    assert_eq!(film.thickness_nm, 400.0);
    for step in 0..=20 {
        let cosine = f64::from(step) / 20.0;
        let off = factor.at(cosine) + greatest_of_film(film, cosine) - 1.0;
        assert!(off.abs() < KINKS, "{cosine}: {off} with {FILM_TERMS} terms");
    }
}

#[test]
fn metals_under_films_have_a_base_of_their_reflectance() {
    let extensions = json!({ "KHR_materials_iridescence": { "iridescenceFactor": 1 } });
    let metal = pbr(1.0, 0.5, extensions);
    let Tint::Film(film) = &metal.lobes[0].tint else { panic!("{metal:?}") };
    let bare = film.base.eta.map(|eta| ((eta - 1.0) / (eta + 1.0)) * ((eta - 1.0) / (eta + 1.0)));
    for (got, expected) in glanz_color::rgb_spectra::rgb_of_reflectance(&bare).iter().zip(BASE) {
        assert!((got - expected).abs() < 1e-4, "{got} for {expected}");
    }
    assert_eq!(metal.lobes.len(), 1, "nothing is below a metal, and nothing of it is matte");
}

/// What is seen straight through a material in the middle of the spectrum.
fn seen(material: &Material) -> f64 {
    let Some(Transmittance::Pane(pane)) = &material.transmittance else {
        panic!("{:?}", material.transmittance)
    };
    let left = libm::exp(-pane.absorption[50] * pane.thickness);
    fresnel_slab(1.0, pane.ior.eta[50], left).1
}

#[test]
fn what_is_seen_through_is_what_one_boundary_a_volume_and_a_coat_leave() {
    let glass = |base: f64, more: Value| {
        let mut extensions = json!({ "KHR_materials_transmission": { "transmissionFactor": 1 } });
        extensions.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        let json = json!({ "pbrMetallicRoughness": { "baseColorFactor": [base, base, base, 1],
            "metallicFactor": 0, "roughnessFactor": 0 }, "extensions": extensions });
        read(&material(json)).materials.remove(0)
    };
    assert!((seen(&glass(1.0, json!({}))) - 0.96).abs() < 1e-6);
    // The two sides of the pane reflect to and fro what the one boundary does not know: 4e-4.
    assert!((seen(&glass(0.5, json!({}))) - 0.48).abs() < 4e-4);
    let volume = |thickness: f64| {
        json!({ "KHR_materials_volume": { "thicknessFactor": thickness, "attenuationDistance": 2,
            "attenuationColor": [0.25, 0.25, 0.25] } })
    };
    assert!((seen(&glass(1.0, volume(1.0))) - 0.96 * 0.5).abs() < 4e-4);
    assert!((seen(&glass(1.0, volume(0.0))) - 0.96).abs() < 1e-6);
    let coat = json!({ "KHR_materials_clearcoat": { "clearcoatFactor": 1 } });
    assert!((seen(&glass(1.0, coat)) - 0.96 * 0.96).abs() < 4e-4);
    assert_eq!(pbr(0.0, 0.5, json!({})).transmittance, None);
    let opaque = json!({ "KHR_materials_transmission": { "transmissionFactor": 1 } });
    assert_eq!(pbr(1.0, 0.5, opaque).transmittance, None, "metals are opaque");
}

#[test]
fn a_volume_of_two_faces_absorbs_half_at_each() {
    let volume = json!({ "KHR_materials_transmission": { "transmissionFactor": 1 }, "KHR_materials_volume": {
        "thicknessFactor": 2, "attenuationDistance": 1, "attenuationColor": [0.5, 1, 0] } });
    let material = pbr(0.0, 0.5, volume);
    let transmittance =
        material.lobes.iter().find(|lobe| lobe.shape.info().side == Side::Transmission).unwrap();
    assert_eq!(transmittance.tint.rgb().unwrap().0.map(f64::from), [BASE[0] * 0.5, BASE[1], 0.0]);
}

#[test]
fn ambient_light_sees_the_base_colour_but_for_what_passes() {
    let first = |metallic, extensions| pbr(metallic, 0.5, extensions).lobes.remove(0);
    let ambient = |metallic, extensions| {
        let lobe = first(metallic, extensions);
        assert_eq!((lobe.shape.info().name, lobe.textured), ("ambient", true));
        lobe.tint.rgb().unwrap().0.map(f64::from)
    };
    assert_eq!(ambient(0.0, json!({})), BASE);
    assert_eq!(ambient(0.5, json!({})), BASE.map(|channel| channel * 0.5));
    assert_ne!(first(1.0, json!({})).shape.info().name, "ambient", "metal has no matte part");
    let half = json!({ "KHR_materials_transmission": { "transmissionFactor": 0.5 } });
    assert_eq!(ambient(0.0, half), BASE.map(|channel| channel * 0.5));
}
