//! Scenes with all that a scene can have, at random.

use std::sync::Arc;

use glam::{DMat3, DMat4, DVec3, Vec2, Vec3, Vec4};
use glanz_bsdf::models::charlie::Albedo;
use glanz_bsdf::{Angle, Chebyshev, FactorTable, LayerWeight, MODELS, Shape};
use glanz_color::{Channel, Ior, Observer, ObserverKind, Reradiation, Rgb, Spectrum};
use glanz_eye::{Cones, Eye, Lens, RodColor, Viewer, Viewing};
use glanz_scene::builtin::Builtin;
use glanz_scene::*;
use proptest::prelude::*;

fn amount() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0f32), Just(1.0f32), 0.0..10.0f32]
}

fn rgb() -> impl Strategy<Value = Rgb> {
    [amount(), amount(), amount()].prop_map(Rgb)
}

fn spectrum() -> impl Strategy<Value = Spectrum> {
    prop_oneof![
        (0.0..1.0f64).prop_map(Spectrum::constant),
        (0.0..1.0f64, 1.0..9.0f64).prop_map(|(a, b)| Spectrum::from_fn(move |nm| a / (b + nm))),
    ]
}

fn vector() -> impl Strategy<Value = DVec3> {
    [-9.0..9.0f64, -9.0..9.0f64, 0.5..9.0f64].prop_map(DVec3::from_array)
}

fn name() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), Just("sphere".to_owned()), "[a-z]{1,2}", any::<String>()]
}

fn medium() -> impl Strategy<Value = Ior> {
    prop_oneof![
        Just(glanz_color::ior("Au").expect("gold")),
        Just(glanz_color::ior("water").expect("water")),
        (1.0..3.0f64).prop_map(Ior::constant),
        (name(), spectrum(), spectrum()).prop_map(|(name, eta, k)| Ior {
            name: name.clone(),
            eta: eta + Spectrum::ONE,
            k,
            source: name
        }),
    ]
}

fn clear() -> impl Strategy<Value = Ior> {
    medium().prop_map(|ior| Ior { k: Spectrum::ZERO, ..ior })
}

fn pane() -> impl Strategy<Value = Arc<Pane>> {
    (clear(), 0.0..0.1f64, spectrum())
        .prop_map(|(ior, thickness, absorption)| Arc::new(Pane { ior, thickness, absorption }))
}

fn film() -> impl Strategy<Value = Arc<Film>> {
    (0.0..2000.0f64, clear(), clear())
        .prop_map(|(thickness_nm, film, base)| Arc::new(Film { thickness_nm, film, base }))
}

fn coated() -> impl Strategy<Value = Arc<CoatedBoundary>> {
    let below = prop_oneof![
        medium().prop_map(|ior| Boundary::Medium(Arc::new(ior))),
        medium().prop_map(|ior| Boundary::Polarized(Arc::new(ior), Polarization::P)),
        film().prop_map(Boundary::Film),
    ];
    (below, clear(), 0.001..1.0f64)
        .prop_map(|(below, coat, alpha)| Arc::new(CoatedBoundary { below, coat, alpha }))
}

fn tint() -> impl Strategy<Value = Tint> {
    let reflectance = prop_oneof![
        rgb().prop_map(Tint::Rgb),
        spectrum().prop_map(|spectrum| Tint::Spectrum(Arc::new(spectrum)))
    ];
    prop_oneof![
        reflectance.clone(),
        reflectance.prop_map(|tint| Tint::Schlick(Box::new(tint))),
        spectrum().prop_map(|diagonal| Tint::Reradiation(Arc::new(Reradiation::diagonal(&diagonal)))),
        medium().prop_map(|ior| Tint::Ior(Arc::new(ior))),
        medium().prop_map(|ior| Tint::Polarized(Arc::new(ior), Polarization::P)),
        medium().prop_map(|ior| Tint::Schlick(Box::new(Tint::Ior(Arc::new(ior))))),
        film().prop_map(Tint::Film),
        pane().prop_map(Tint::Pane),
        coated().prop_map(Tint::Coated),
    ]
}

fn shape() -> impl Strategy<Value = Shape> {
    (0..MODELS.len(), proptest::collection::vec(0.0..1.0f64, 8)).prop_map(|(model, places)| {
        let info = &MODELS[model];
        let between = |(param, t): (&glanz_bsdf::ParamInfo, &f64)| {
            (param.name, param.min + (param.max - param.min) * *t)
        };
        let set: Vec<(&str, f64)> = info.params.iter().zip(&places).map(between).collect();
        Shape::named(info.name, &set)
            .or_else(|_| Shape::named(info.name, &[]))
            .expect("the defaults are valid")
    })
}

fn layer() -> impl Strategy<Value = LayerWeight> {
    let angle = prop_oneof![Just(Angle::Half), Just(Angle::HalfThrough), Just(Angle::View)];
    let series = proptest::collection::vec(-1.0..1.0f64, 0..5);
    let series = series.prop_map(|terms| Chebyshev { terms: terms.into_iter().map(|term| [term]).collect() });
    prop_oneof![
        (0.0..1.5f64).prop_map(LayerWeight::Constant),
        (angle.clone(), 0.0..1.0f64, 0.0..1.0f64)
            .prop_map(|(angle, at_zero, at_grazing)| LayerWeight::Schlick { angle, at_zero, at_grazing }),
        (angle, series.clone()).prop_map(|(angle, factor)| LayerWeight::Series { angle, factor }),
        series.clone().prop_map(|transmittance| LayerWeight::OverBoundary { transmittance }),
        (series, 1.0..3.0f64).prop_map(|(transmittance, gain)| LayerWeight::Coat { transmittance, gain }),
        (0.0..1.0f64, 0.01..1.0f64)
            .prop_map(|(strength, alpha)| LayerWeight::Sheen { strength, albedo: Albedo::new(alpha) }),
        proptest::collection::vec(0.1..2.0f32, 24).prop_map(|values| {
            let table = FactorTable::new([2, 3, 2, 1], 2, values).expect("twelve nodes of two ranks");
            LayerWeight::Table { table: Arc::new(table), rank: 1 }
        }),
    ]
}

fn lobe() -> impl Strategy<Value = Lobe> {
    let metalness = prop_oneof![
        Just(Metalness::Any),
        (0.0..1.0f64).prop_map(|factor| Metalness::Metal { factor }),
        (0.0..1.0f64).prop_map(|factor| Metalness::Dielectric { factor }),
    ];
    let absorption = proptest::option::of((spectrum(), 1.0..2.0f64));
    let layers = proptest::collection::vec(layer(), 0..3);
    let masks = proptest::collection::vec(mask(), 0..3);
    let roughness = prop_oneof![
        Just(RoughnessMap::Material),
        Just(RoughnessMap::Uniform),
        channel_use().prop_map(RoughnessMap::Own),
    ];
    (shape(), tint(), any::<bool>(), layers, absorption, metalness, masks, roughness).prop_map(
        |(shape, tint, textured, layers, absorption, metalness, masks, roughness)| {
            let info = shape.info();
            let glows = info.term == glanz_bsdf::LightTerm::Emission;
            let passes = info.side == glanz_bsdf::Side::Transmission;
            // Combinations that scene files refuse because they mean nothing.
            let tint = match tint {
                tint @ (Tint::Rgb(_) | Tint::Spectrum(_)) => tint,
                _ if glows => Tint::Rgb(Rgb::WHITE),
                Tint::Ior(ior) if passes => Tint::Ior(Arc::new(Ior { k: Spectrum::ZERO, ..(*ior).clone() })),
                tint => tint,
            };
            let specular = info.term == glanz_bsdf::LightTerm::Specular;
            let textured = textured && !(specular && tint.depends_on_angle());
            let absorption = absorption.map(|(depth, eta)| Arc::new(Absorption { depth, eta }));
            let is_lit =
                matches!(info.term, glanz_bsdf::LightTerm::Diffuse | glanz_bsdf::LightTerm::Specular);
            let masks = if is_lit { masks } else { Vec::new() };
            let roughness = if info.takes_roughness_map() { roughness } else { RoughnessMap::Material };
            Lobe { shape, tint, textured, layers, absorption, metalness, masks, roughness }
        },
    )
}

fn transmittance() -> impl Strategy<Value = Transmittance> {
    prop_oneof![
        (0.0..1.0f32).prop_map(|value| Transmittance::Constant(Tint::Rgb(Rgb::gray(value)))),
        spectrum().prop_map(|value| Transmittance::Constant(Tint::Spectrum(Arc::new(value)))),
        clear().prop_map(|ior| Transmittance::Boundary(Arc::new(ior))),
        pane().prop_map(Transmittance::Pane),
        film().prop_map(Transmittance::Film),
    ]
}

fn texture_use() -> impl Strategy<Value = TextureUse> {
    let plain = Just([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
    let transform = prop_oneof![
        plain,
        [[-2.0..2.0f32, -2.0..2.0f32, -2.0..2.0f32], [-2.0..2.0f32, 0.0..1.0f32, 0.0..1.0f32]]
    ];
    (0..2usize, transform, amount(), any::<bool>()).prop_map(|(texture, transform, scale, second_uvs)| {
        TextureUse { texture, transform, scale, second_uvs }
    })
}

fn channel_use() -> impl Strategy<Value = ChannelUse> {
    (texture_use(), 0..4usize)
        .prop_map(|(map, channel)| ChannelUse { map, channel: TextureChannel::ALL[channel].0 })
}

fn mask() -> impl Strategy<Value = Mask> {
    let number = || prop_oneof![Just(0.0), Just(1.0), 0.0..1.0f64];
    (channel_use(), number(), number()).prop_map(|(of, from, to)| Mask { of, from, to })
}

fn material() -> impl Strategy<Value = Material> {
    let classic = (rgb(), rgb(), rgb(), 0.0..200.0f64).prop_map(|(ambient, diffuse, specular, shininess)| {
        let block = ClassicMaterial {
            ambient: ambient.into(),
            diffuse: diffuse.into(),
            specular: specular.into(),
            shininess,
            ..ClassicMaterial::default()
        };
        block.build("").expect("phong exists").lobes
    });
    let lobes = prop_oneof![classic, proptest::collection::vec(lobe(), 0..4)];
    let maps = [(); 4].map(|()| proptest::option::of(texture_use()));
    let alpha = prop_oneof![
        Just(AlphaMode::Opaque),
        Just(AlphaMode::Blend),
        (0.0..1.0f32).prop_map(|cutoff| AlphaMode::Mask { cutoff })
    ];
    let occlusion = proptest::option::of(mask());
    let surface = (any::<bool>(), any::<bool>(), -4.0..4.0f64, 0.0..1.0f32, alpha, occlusion);
    (name(), lobes, maps, proptest::option::of(transmittance()), surface).prop_map(
        |(name, lobes, [base_color, normal_map, emission_map, metal_rough_map], transmittance, surface)| {
            let (two_sided, cull_back, aniso, opacity, alpha_mode, occlusion) = surface;
            let glows =
                |lobe: &Lobe| lobe.textured && lobe.shape.info().term == glanz_bsdf::LightTerm::Emission;
            let occlusion = occlusion.filter(|_| !lobes.iter().any(glows));
            Material {
                name,
                lobes,
                two_sided,
                base_color,
                normal_map,
                emission_map,
                metal_rough_map,
                occlusion,
                aniso,
                transmittance,
                opacity,
                alpha_mode,
                cull_back,
            }
        },
    )
}

fn light_color() -> impl Strategy<Value = LightColor> {
    prop_oneof![
        rgb().prop_map(LightColor::Rgb),
        spectrum().prop_map(|spectrum| LightColor::Spectrum(Arc::new(spectrum)))
    ]
}

fn attenuation() -> impl Strategy<Value = Attenuation> {
    prop_oneof![
        Just(Attenuation::NONE),
        Just(Attenuation::PHYSICAL),
        [0.1..2.0f64, 0.0..2.0f64, 0.0..2.0f64].prop_map(|[constant, linear, quadratic]| Attenuation {
            constant,
            linear,
            quadratic
        }),
    ]
}

fn environment() -> impl Strategy<Value = LightKind> {
    let pixels = proptest::collection::vec([amount(), amount(), amount()], 8);
    let map = pixels.prop_map(|pixels| Arc::new(EnvironmentMap { width: 4, height: 2, pixels }));
    let turn = prop_oneof![
        Just(DMat3::IDENTITY),
        (-180.0..180.0f64).prop_map(|degrees| DMat3::from_axis_angle(DVec3::Y, degrees.to_radians())),
        (vector(), 0.0..3.0f64).prop_map(|(axis, angle)| DMat3::from_axis_angle(axis.normalize(), angle)),
    ];
    (proptest::option::of(map), turn).prop_map(|(map, rotation)| LightKind::Environment { map, rotation })
}

fn light_kind() -> impl Strategy<Value = LightKind> {
    let edge = proptest::option::of((0.5..1.0f64, 0.0..0.5f64));
    prop_oneof![
        Just(LightKind::Ambient),
        vector().prop_map(|direction| LightKind::Directional { direction }),
        (vector(), attenuation())
            .prop_map(|(position, attenuation)| LightKind::Point { position, attenuation }),
        (vector(), vector(), 0.0..3.1f64, 0.0..50.0f64, edge, attenuation()).prop_map(
            |(position, direction, cutoff, exponent, smooth_edge, attenuation)| LightKind::Spot {
                position,
                direction,
                cutoff,
                exponent,
                smooth_edge,
                attenuation
            }
        ),
        (vector(), vector(), 0.1..3.0f64, 0.1..3.0f64, any::<bool>()).prop_map(
            |(position, direction, width, height, two_sided)| LightKind::Area {
                shape: AreaShape::Rectangle { width, height },
                position,
                direction,
                up: direction.any_orthogonal_vector(),
                two_sided
            }
        ),
        (vector(), 0.1..3.0f64).prop_map(|(position, radius)| LightKind::Area {
            shape: AreaShape::Sphere { radius },
            position,
            direction: DVec3::NEG_Y,
            up: DVec3::NEG_Z,
            two_sided: false
        }),
        environment(),
    ]
}

fn light() -> impl Strategy<Value = Light> {
    let candela = proptest::collection::vec(0.1..100.0f64, 6);
    let profile = candela.prop_map(|candela| {
        Arc::new(Profile { c_deg: vec![0.0, 120.5, 360.0], gamma_deg: vec![0.0, 90.0], candela })
    });
    let colors = (light_color(), light_color(), light_color(), any::<bool>());
    (name(), light_kind(), colors, any::<bool>(), proptest::option::of((profile, vector()))).prop_map(
        |(name, kind, (ambient, diffuse, specular, same), with_camera, profile)| {
            let colors = match (&kind, same) {
                (LightKind::Ambient, _) => LightColors::ambient(ambient),
                (_, true) => LightColors::all(diffuse),
                (_, false) => LightColors { ambient, diffuse, specular },
            };
            let still = matches!(kind, LightKind::Ambient | LightKind::Environment { .. });
            let space = if with_camera && !still { Space::Camera } else { Space::World };
            let axis = match &kind {
                LightKind::Point { .. } => Some(Luminaire::AXIS),
                LightKind::Spot { direction, .. } => Some(*direction),
                _ => None,
            };
            let luminaire = axis.zip(profile).map(|(axis, (profile, c0))| {
                let parallel = axis.normalize().cross(c0.normalize()).length() < 1e-3;
                Luminaire { profile, axis, c0: if parallel { Luminaire::c0_for(axis) } else { c0 } }
            });
            Light { name, kind, colors, space, luminaire }
        },
    )
}

fn mesh() -> impl Strategy<Value = Mesh> {
    let coordinate = || prop_oneof![Just(0.0f32), -1e6..1e6f32, Just(1e-40f32), Just(0.1f32)];
    let soup = (3..90usize, name(), any::<[bool; 6]>(), coordinate(), coordinate()).prop_map(
        |(vertices, name, has, a, b)| {
            let value = |i: usize| a + b * i as f32;
            let list = |has: bool| if has { vertices } else { 0 };
            let corners: Vec<u32> = (0..vertices as u32 / 3 * 3).collect();
            let end = corners.len() as u32;
            Mesh {
                name,
                positions: (0..vertices).map(|i| Vec3::new(value(i), a, b)).collect(),
                normals: (0..list(has[0])).map(|i| Vec3::new(a, value(i), b)).collect(),
                uvs: (0..list(has[1])).map(|i| Vec2::new(value(i), b)).collect(),
                uvs2: (0..list(has[5])).map(|i| Vec2::new(b, value(i))).collect(),
                tangents: (0..list(has[2])).map(|i| Vec4::new(value(i), a, b, -1.0)).collect(),
                colors: (0..list(has[3])).map(|i| Vec4::new(value(i), a, b, 0.5)).collect(),
                face_starts: if has[4] { vec![0, 2, end] } else { Vec::new() },
                corners,
            }
        },
    );
    let builtin = (0..Builtin::NAMES.len())
        .prop_map(|i| Builtin::named(Builtin::NAMES[i]).expect("a name").mesh().expect("it has defaults"));
    prop_oneof![soup, builtin]
}

fn texture() -> impl Strategy<Value = Texture> {
    let wrap = || prop_oneof![Just(Wrap::Repeat), Just(Wrap::Mirror), Just(Wrap::Clamp)];
    let filter = prop_oneof![Just(TextureFilter::Nearest), Just(TextureFilter::Trilinear)];
    let rgba = proptest::collection::vec(any::<u8>(), 24);
    (name(), rgba, any::<bool>(), [wrap(), wrap()], filter).prop_map(|(name, rgba, srgb, wrap, filter)| {
        Texture { name, width: 3, height: 2, rgba, srgb, wrap, filter }
    })
}

fn object() -> impl Strategy<Value = Object> {
    let transform = prop_oneof![
        Just(DMat4::IDENTITY),
        vector().prop_map(DMat4::from_translation),
        (0.1..3.0f64, vector())
            .prop_map(|(scale, to)| DMat4::from_translation(to) * DMat4::from_scale(DVec3::splat(scale))),
        (vector(), 0.0..3.0f64).prop_map(|(axis, angle)| DMat4::from_axis_angle(axis.normalize(), angle)),
    ];
    let shading = proptest::option::of(Just(Shading::Gouraud));
    (name(), 0..2usize, 0..2usize, transform, shading).prop_map(
        |(name, mesh, material, transform, shading)| Object {
            name,
            mesh,
            material,
            transform,
            shading,
            interpolation: None,
            program: None,
        },
    )
}

/// An eye with all its numbers, and how it looks.
fn viewer() -> impl Strategy<Value = Viewer> {
    let numbers = proptest::array::uniform12(0.1..1.0f64);
    (numbers, any::<bool>(), 0..5_usize).prop_map(|(n, flag, kind)| Viewer {
        eye: Eye {
            age: 5.0 + 90.0 * n[0],
            field_deg: 1.0 + 9.0 * n[1],
            lens: [Lens::Cie170, Lens::Cie203, Lens::None, Lens::Cie170, Lens::Cie203][kind],
            lens_density: n[2],
            macula_density: n[3],
            pigment_density: [n[4], 1.0, n[5]],
            shift_nm: if flag { [0.0; 3] } else { [n[6], -n[7], 0.0] },
            cones: [Cones::All, Cones::NoL, Cones::NoM, Cones::NoS, Cones::None][kind],
            iris: n[8],
        },
        viewing: Viewing {
            level_cd_m2: flag.then_some(n[9]),
            adapted: n[10],
            adaptation_cd_m2: (!flag).then_some(n[11]),
            rods: if flag { RodColor::Blue } else { RodColor::White },
            glare: flag,
            chromatic: kind == 1,
            noise: (kind > 2).then_some(kind as u32),
            acuity: !flag,
            gaze: flag.then_some([100.0 * n[1], 50.0]),
            px_per_deg: flag.then_some(60.0 * n[2]),
            night: kind == 2,
        },
    })
}

pub(crate) fn scene() -> impl Strategy<Value = Scene> {
    let pair = || proptest::collection::vec(material(), 2..4);
    let parts = (
        proptest::collection::vec(mesh(), 2..4),
        proptest::collection::vec(texture(), 2..4),
        pair(),
        proptest::collection::vec(light(), 0..4),
        proptest::collection::vec(object(), 0..4),
    );
    let camera = proptest::option::of((vector(), 0.1..3.0f64)).prop_map(|camera| {
        camera.map(|(eye, fov_y)| Camera {
            eye,
            target: DVec3::ZERO,
            up: DVec3::Y,
            projection: Projection::Perspective { fov_y },
        })
    });
    let observer = proptest::option::of(spectrum().prop_map(|sensitivity| Observer {
        name: "eye".to_owned(),
        title: String::new(),
        channels: vec![Channel { name: "V".to_owned(), sensitivity }],
        kind: ObserverKind::Other,
        reference: None,
    }));
    (parts, camera, (observer, viewer()), any::<bool>(), rgb(), -3.0..3.0f64).prop_map(
        |(
            (meshes, textures, materials, lights, objects),
            camera,
            (observer, viewer),
            photometric,
            color,
            ev,
        )| Scene {
            meshes,
            textures,
            materials,
            lights,
            objects,
            camera,
            image: Image {
                background: Background::Color(color),
                supersample: photometric,
                ..Image::default()
            },
            render: RenderSettings {
                ev,
                show: DebugView::Lit,
                tone_map: ToneMap::KhronosNeutral,
                mode: ColorMode::Sampled(7),
                white: White::None,
                ..RenderSettings::default()
            },
            programs: Vec::new(),
            program: None,
            eye: observer.is_none().then_some(viewer),
            observer,
            photometric,
        },
    )
}
