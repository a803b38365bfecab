//! Areas, environments and luminaires in scene files.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::PI;
use std::path::PathBuf;

use glam::{DMat3, DVec3};
use glanz_color::Rgb;

use super::*;
use super::{parse, scene};
use crate::{
    AreaShape, Attenuation, Background, EnvironmentMap, Light, LightColor, LightColors, LightKind, Lighting,
};

/// Rounding of a few products, and of the sines of a turn.
const ROUNDING: f64 = 1e-12;
/// Rounding of colours, which are `f32`.
const COLOR_ROUNDING: f64 = 1e-6;

/// A folder of its own for one test, removed at its end, with a profile and a picture.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glanz-lights-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        let ies = "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 20\n0 90\n0\n500 100\n";
        std::fs::write(path.join("lamp.ies"), ies).unwrap();
        std::fs::write(path.join("dark.ies"), ies.replace("500 100", "0 0")).unwrap();
        let mut hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".to_vec();
        hdr.extend([128, 64, 32, 129, 0, 0, 0, 0]);
        std::fs::write(path.join("sky.hdr"), hdr).unwrap();
        Self(path)
    }

    fn parse(&self, text: &str) -> Result<Loaded, FileError> {
        parse_str(text, &self.0, &LoadOptions::default())
    }

    fn light(&self, keys: &str) -> (Light, Loaded) {
        let loaded =
            self.parse(&format!("[[lights]]\n{keys}\n")).unwrap_or_else(|error| panic!("{error}\n{keys}"));
        (loaded.scene.lights[0].clone(), loaded)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn light(keys: &str) -> Light {
    scene(&format!("[[lights]]\n{keys}\n")).lights[0].clone()
}

/// The value of a grey light.
fn value(light: &Light) -> f64 {
    match light.colors.diffuse {
        LightColor::Rgb(Rgb([r, g, b])) if r == g && g == b => f64::from(r),
        ref other => panic!("{other:?}"),
    }
}

#[test]
fn surfaces_have_a_form_a_place_and_a_side() {
    let rectangle = light("kind = 'rectangle'\nposition = [0, 3, 0]\ntarget = [0, 1, 0]\nsize = [2, 1]\n");
    let kind = LightKind::Area {
        shape: AreaShape::Rectangle { width: 2.0, height: 1.0 },
        position: DVec3::new(0.0, 3.0, 0.0),
        direction: DVec3::new(0.0, -2.0, 0.0),
        // +Y would be parallel.
        up: DVec3::NEG_Z,
        two_sided: false,
    };
    assert_eq!(rectangle.kind, kind);
    let same = "kind = 'rectangle'\nposition = [0, 3, 0]\ndirection = [0, -2, 0]\nwidth = 2\nheight = 1\n";
    assert_eq!(light(same).kind, kind);
    let disk =
        light("kind = 'disk'\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nradius = 0.5\ntwo_sided = true");
    let LightKind::Area { shape, up, two_sided, .. } = disk.kind else { panic!("{disk:?}") };
    assert_eq!((shape, up, two_sided), (AreaShape::Disk { radius: 0.5 }, DVec3::Y, true));
    let sphere = light("kind = 'sphere'\nposition = [1, 0, 0]\nradius = 2");
    assert!(matches!(sphere.kind, LightKind::Area { shape: AreaShape::Sphere { radius: 2.0 }, .. }));
}

#[test]
fn surfaces_and_surroundings_send_nothing_ambient_unless_it_is_said() {
    for keys in ["kind = 'sphere'\nposition = [1, 0, 0]\nradius = 2", "kind = 'environment'"] {
        assert_eq!(light(keys).colors, LightColors::direct(Rgb::WHITE));
        let more = light(&format!("{keys}\nambient = 0.5\nintensity = 2"));
        let expected = LightColors { ambient: Rgb::gray(1.0).into(), ..LightColors::all(Rgb::gray(2.0)) };
        assert_eq!(more.colors, expected);
    }
}

#[test]
fn the_flux_of_a_surface_is_pi_times_its_luminance_and_area() {
    let cases = [
        ("kind = 'rectangle'\nsize = [2, 3]\ndirection = [0, 0, 1]", 6.0),
        ("kind = 'rectangle'\nsize = [2, 3]\ndirection = [0, 0, 1]\ntwo_sided = true", 12.0),
        ("kind = 'disk'\nradius = 2\ndirection = [0, 0, 1]", 4.0 * PI),
        ("kind = 'sphere'\nradius = 2", 16.0 * PI),
    ];
    for (keys, area) in cases {
        let by = |strength: &str| {
            let text = format!("[[lights]]\nposition = [0, 0, 0]\n{keys}\n{strength}\n");
            let scene = scene(&text);
            assert!(scene.photometric);
            value(&scene.lights[0])
        };
        // 1 in the frame is 1 cd/m², which is what the surface is seen as.
        assert!((by("luminance_cd_m2 = 500") / 500.0 - 1.0).abs() < COLOR_ROUNDING, "{keys}");
        let flux = format!("luminous_flux_lm = {}", 100.0 * PI * area);
        assert!((by(&flux) / 100.0 - 1.0).abs() < COLOR_ROUNDING, "{keys}");
    }
}

#[test]
fn surroundings_are_a_picture_or_the_same_all_around_and_can_be_turned() {
    let scratch = Scratch::new("sky");
    let (sky, loaded) = scratch.light("kind = 'environment'\nfile = 'sky.hdr'\nrotate_deg = 90");
    let LightKind::Environment { map: Some(map), rotation } = sky.kind else { panic!("{sky:?}") };
    let pixels = vec![[1.0, 0.5, 0.25], [0.0; 3]];
    assert_eq!((*map).clone(), EnvironmentMap { width: 2, height: 1, pixels });
    assert!(loaded.notes.is_empty(), "{:?}", loaded.notes);
    // From the middle of the picture to the left, as +Y turns it.
    assert!((rotation * DVec3::NEG_Z - DVec3::NEG_X).length() < ROUNDING, "{rotation}");
    let uniform = light("kind = 'environment'\nrotate_deg = 450");
    let LightKind::Environment { map: None, rotation: again } = uniform.kind else { panic!("{uniform:?}") };
    assert_eq!(again, rotation);
    let tilted = "kind = 'environment'\nrotate_deg = [{ axis = [0, 1, 0], angle = 90 }, { axis = [0, 0, 1], angle = 90 }]";
    let LightKind::Environment { rotation, .. } = light(tilted).kind else { panic!("an environment") };
    assert!((rotation * DVec3::NEG_Z - DVec3::NEG_Y).length() < ROUNDING, "{rotation}");
    assert_eq!(
        light("kind = 'environment'").kind,
        LightKind::Environment { map: None, rotation: DMat3::IDENTITY }
    );
}

#[test]
fn a_file_that_several_lights_name_is_read_once() {
    let scratch = Scratch::new("once");
    let sky = "[[lights]]\nkind = 'environment'\nfile = 'sky.hdr'\n";
    let lamp = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nprofile = 'lamp.ies'\nintensity = 1\n";
    let lights = scratch.parse(&format!("{sky}{sky}{lamp}{lamp}")).unwrap().scene.lights;
    let map = |light: &Light| match &light.kind {
        LightKind::Environment { map: Some(map), .. } => std::sync::Arc::as_ptr(map),
        other => panic!("{other:?}"),
    };
    let profile = |light: &Light| std::sync::Arc::as_ptr(&light.luminaire.as_ref().unwrap().profile);
    assert_eq!((map(&lights[0]), profile(&lights[2])), (map(&lights[1]), profile(&lights[3])));
}

#[test]
fn the_background_may_be_the_surroundings_if_there_are_any() {
    let text = "[image]\nbackground = 'environment'\n";
    let with = scene(&format!("{text}[[lights]]\nkind = 'environment'\n"));
    assert_eq!(with.image.background, Background::Environment);
    let error = parse(text).unwrap_err();
    assert_eq!(error.message, "the background is to be the environment, but there is none");
    assert_eq!(&error.text[error.span.unwrap()], "'environment'");
    assert!(scene("[render]\nshadows = true").render.shadows && !scene("").render.shadows);
}

#[test]
fn exact_light_is_read_and_written() {
    let own = scene("[render]\nlighting = 'exact'\nlight_samples = 4096");
    assert_eq!((own.render.lighting, own.render.light_samples), (Lighting::Exact, Some(4096)));
    let written = write(&own, "").unwrap().text;
    let again = scene(&written);
    assert_eq!(again.render, own.render, "{written}");
    assert_eq!(scene("").render.lighting, Lighting::Fast);
    let error = parse("[render]\nlight_samples = 1").unwrap_err();
    assert!(error.message.contains("between 2 and 1048576 points, found 1"), "{}", error.message);
}

#[test]
fn a_luminaire_has_its_own_candela_unless_it_is_given_a_strength() {
    let scratch = Scratch::new("candela");
    let of = |keys: &str| {
        scratch.light(&format!("kind = 'point'\nposition = [0, 2, 0]\nprofile = 'lamp.ies'\n{keys}"))
    };
    let cases =
        [("", 500.0, true), ("dimming = 0.5", 250.0, true), ("luminous_intensity_cd = 80", 80.0, true)];
    for (keys, candela, photometric) in cases {
        let (lamp, loaded) = of(keys);
        assert!((value(&lamp) * PI / candela - 1.0).abs() < COLOR_ROUNDING, "{keys}: {}", value(&lamp));
        assert_eq!(loaded.scene.photometric, photometric);
        assert!(matches!(lamp.kind, LightKind::Point { attenuation: Attenuation::PHYSICAL, .. }));
    }
    let (classic, loaded) = of("intensity = 2");
    assert_eq!((value(&classic), loaded.scene.photometric), (2.0, false));
    assert!(matches!(classic.kind, LightKind::Point { attenuation: Attenuation::NONE, .. }));
}

#[test]
fn a_luminaire_points_down_or_where_its_light_does() {
    let scratch = Scratch::new("axis");
    let of = |keys: &str| {
        let (light, _) = scratch.light(&format!("position = [0, 2, 0]\nprofile = 'lamp.ies'\n{keys}"));
        let luminaire = light.luminaire.unwrap();
        (luminaire.axis, luminaire.c0)
    };
    assert_eq!(of("kind = 'point'"), (DVec3::NEG_Y, DVec3::X));
    assert_eq!(of("kind = 'point'\ntarget = [3, 2, 0]"), (3.0 * DVec3::X, DVec3::Y));
    let spot = of("kind = 'spot'\ndirection = [0, 0, -1]\nprofile_c0 = [0, 1, 1]");
    assert_eq!(spot, (DVec3::NEG_Z, DVec3::new(0.0, 1.0, 1.0)));
}

#[test]
fn what_does_not_fit_is_refused_where_it_stands() {
    let scratch = Scratch::new("errors");
    let at = "position = [0, 2, 0]\n";
    let cases = [
        (
            format!("kind = 'rectangle'\n{at}direction = [0, 0, 1]\nwidth = 1"),
            "a rectangle light needs 'height', which is missing",
            "[[lights]]",
        ),
        (
            format!("kind = 'rectangle'\n{at}size = [1, 1]"),
            "a rectangle light needs 'direction', which is missing",
            "[[lights]]",
        ),
        (
            format!("kind = 'rectangle'\n{at}size = [1, 1]\nwidth = 1"),
            "'size' beside 'width' and 'height'",
            "[1, 1]",
        ),
        (
            format!("kind = 'rectangle'\n{at}size = [1, 1]\ndirection = [0, 1, 0]\nup = [0, -2, 0]"),
            "'up' is parallel to the direction of the light",
            "[0, -2, 0]",
        ),
        (format!("kind = 'disk'\n{at}radius = 0"), "expected a length between 1e-12 and 1e12, found 0", "0"),
        (
            format!("kind = 'disk'\n{at}radius = 1\ndirection = [0, 0, 1]\ntarget = [1, 0, 0]"),
            "'target' beside 'direction': one says where a light points",
            "[1, 0, 0]",
        ),
        (
            format!("kind = 'spot'\n{at}target = [0, 2, 0]"),
            "'position' and 'target' are the same point; they must differ",
            "[0, 2, 0]",
        ),
        (
            format!("kind = 'sphere'\n{at}radius = 1\ndirection = [0, 0, 1]"),
            "a sphere light has no 'direction'",
            "[0, 0, 1]",
        ),
        (
            format!("kind = 'sphere'\n{at}radius = 1\nattenuation = 'physical'"),
            "a sphere light has no 'attenuation'",
            "'physical'",
        ),
        (
            format!("kind = 'sphere'\n{at}radius = 1\nluminous_flux_lm = 1\nluminance_cd_m2 = 2"),
            "'luminous_flux_lm' beside 'luminance_cd_m2': one says how strong a light is",
            "1",
        ),
        (
            "kind = 'environment'\nattached_to = 'camera'".to_owned(),
            "an environment light has no 'attached_to'",
            "'camera'",
        ),
        (
            "kind = 'environment'\nluminous_flux_lm = 7".to_owned(),
            "an environment light has no 'luminous_flux_lm'",
            "7",
        ),
        ("kind = 'environment'\nfile = 'none.hdr'".to_owned(), "there is no file 'none.hdr'", "'none.hdr'"),
        (
            "kind = 'environment'\nfile = '../sky.hdr'".to_owned(),
            "'../sky.hdr' leaves the folder of the scene file",
            "'../sky.hdr'",
        ),
        (
            "kind = 'environment'\nfile = 'lamp.ies'".to_owned(),
            "lamp.ies: the file: expected a Radiance HDR or OpenEXR picture, found 'IESNA:LM', which is not supported",
            "'lamp.ies'",
        ),
        (
            "kind = 'environment'\nrotate_deg = 'up'".to_owned(),
            "expected degrees about +Y, a rotation such as { axis = [1, 0, 0], angle = 20 }, or a list of those, found string \"up\"",
            "'up'",
        ),
        (
            format!("kind = 'point'\n{at}direction = [0, 0, 1]"),
            "a point light without 'profile' has no 'direction'",
            "[0, 0, 1]",
        ),
        (
            format!("kind = 'spot'\n{at}direction = [0, 0, 1]\ndimming = 0.5"),
            "a spot light without 'profile' has no 'dimming'",
            "0.5",
        ),
        (
            format!("kind = 'point'\n{at}profile = 'lamp.ies'\nintensity = 2\ndimming = 0.5"),
            "'dimming' beside 'intensity': one says how strong a light is",
            "0.5",
        ),
        (
            format!("kind = 'point'\n{at}profile = 'lamp.ies'\nattenuation = 'none'"),
            "'profile' fades by the inverse square law",
            "'none'",
        ),
        (
            format!("kind = 'point'\n{at}profile = 'lamp.ies'\nprofile_c0 = [0, 1, 0]"),
            "'profile_c0' is parallel to the axis of the light",
            "[0, 1, 0]",
        ),
        (
            format!("kind = 'point'\n{at}profile = 'dark.ies'"),
            "there is no light in 'dark.ies'",
            "'dark.ies'",
        ),
        (
            format!("kind = 'point'\n{at}profile = 'sky.hdr'"),
            "sky.hdr: line 3: expected the symmetry, 0 to 4, a number of at most 1e12, found ''",
            "'sky.hdr'",
        ),
    ];
    for (keys, message, place) in cases {
        let error = scratch.parse(&format!("[[lights]]\n{keys}\n")).expect_err(&keys);
        let span = error.span.clone().expect("a place");
        assert_eq!((error.message.as_str(), &error.text[span]), (message, place), "{keys}");
    }
}

#[test]
fn light_in_candela_beside_classic_light_is_refused() {
    let scratch = Scratch::new("mixed");
    let text = "[[lights]]\nkind = 'point'\nposition = [0, 1, 0]\nprofile = 'lamp.ies'\n[[lights]]\nkind = 'environment'\n";
    let error = scratch.parse(text).unwrap_err();
    assert_eq!(error.message, "light in classic units beside light in lx, cd, W/sr or cd/m²");
}
