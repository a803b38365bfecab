//! Frames as eyes see them.

use std::sync::Arc;

use glanz_color::{Rgb, Spectrum, observer};
use glanz_eye::{Eye, Viewer, Viewing};
use glanz_render::{Session, Shot};
use glanz_scene::{ColorMode, Scene, Tint, White};

use super::{assert_near, faced, matte, patch, unit};

fn spectral(mut scene: Scene) -> Scene {
    scene.render.mode = ColorMode::Spectral;
    scene.image = glanz_scene::Image { width: 4, height: 4, ..scene.image };
    scene
}

fn viewer(name: &str, viewing: Viewing) -> Viewer {
    Viewer { eye: name.parse().unwrap(), viewing }
}

/// The linear sRGB of a pixel that an eye sees.
fn shown(scene: &Scene, viewer: Viewer) -> [f32; 4] {
    let mut shot = Shot::new(&spectral(scene.clone()).with_eye(viewer)).unwrap();
    let frame = shot.frame().unwrap();
    shot.on_screen(frame).unwrap().pixel(1, 1)
}

/// What is left of a spectrum without all that these curves respond to (Gram and Schmidt).
fn unseen_by(curves: &[Spectrum], spectrum: Spectrum) -> Spectrum {
    let mut basis: Vec<Spectrum> = Vec::new();
    let without = |basis: &[Spectrum], mut rest: Spectrum| {
        // Twice, for what rounding leaves.
        for axis in basis.iter().chain(basis) {
            let part = rest.dot(axis) / axis.dot(axis);
            rest = Spectrum::from_fn(|nm| rest.at(nm) - part * axis.at(nm));
        }
        rest
    };
    for curve in curves {
        basis.push(without(&basis, *curve));
    }
    without(&basis, spectrum)
}

fn day() -> Viewing {
    Viewing::default()
}

/// The published fundamentals have six digits.
const DIGITS: f64 = 1e-5;

#[test]
fn the_standard_eye_by_day_sees_what_the_cone_fundamentals_see() {
    for source in ["D65", "A", "FL11"] {
        for white in [White::D65, White::Scene, White::None] {
            let mut scene = faced(matte(patch("orange")), &unit(source));
            scene.render.white = white;
            let mut by_name =
                Shot::new(&spectral(scene.clone()).with_observer(observer("lms2").unwrap())).unwrap();
            let frame = by_name.frame().unwrap();
            let [r, g, b, _] = by_name.on_screen(frame).unwrap().pixel(1, 1).map(f64::from);
            assert_near(shown(&scene, viewer("standard", day())), [r, g, b], DIGITS, source);
        }
    }
}

#[test]
fn an_old_eye_sees_yellow_until_it_is_adapted() {
    let scene = faced(matte(Rgb::WHITE.into()), &unit("D65"));
    let [r, _, b, _] = shown(&scene, viewer("age:75", Viewing { adapted: 0.0, ..day() }));
    assert!(b < 0.6 * r, "{r} {b}");
    assert_near(shown(&scene, viewer("age:75", day())), [1.0; 3], DIGITS, "adapted");
    // Half of the way is between.
    let [r, _, half, _] = shown(&scene, viewer("age:75", Viewing { adapted: 0.5, ..day() }));
    assert!(half > b && half < r);
}

#[test]
fn white_is_white_to_every_eye_that_is_adapted() {
    for source in ["D65", "A"] {
        let mut scene = faced(matte(Rgb::WHITE.into()), &unit(source));
        scene.render.white = White::Scene;
        for name in [
            "protan",
            "deutan",
            "tritan",
            "deutan:10",
            "protan:15",
            "age:80+deutan:6",
            "aphakic",
            "shift:3,-2,1",
        ] {
            assert_near(
                shown(&scene, viewer(name, day())),
                [f64::from(shown(&scene, viewer("standard", day()))[1]); 3],
                2e-5,
                name,
            );
        }
    }
}

#[test]
fn spectra_that_all_cones_see_alike_look_alike_through_all_stages() {
    let eye: Eye = "age:60+deutan:10".parse().unwrap();
    let curves: Vec<Spectrum> =
        eye.observer_with_rods().channels.iter().map(|c| c.sensitivity * unit("D65")).collect();
    // A grey, and the same with a wiggle that no kind of receptors notices.
    let grey = Spectrum::constant(0.4);
    let wiggle = Spectrum::from_fn(|nm| if nm > 400.0 && nm < 690.0 { libm::sin(nm / 9.0) } else { 0.0 });
    let wiggle = unseen_by(&curves, wiggle);
    let other = Spectrum::from_fn(|nm| grey.at(nm) + 0.15 * wiggle.at(nm));
    assert!(other.0.iter().all(|v| (0.0..=1.0).contains(v)));
    let night = Viewing { level_cd_m2: Some(1.0), glare: true, acuity: true, ..day() };
    let seen = |spectrum: Spectrum| {
        let scene = faced(matte(Tint::Spectrum(Arc::new(spectrum))), &unit("D65"));
        shown(&scene, Viewer { eye: eye.clone(), viewing: night.clone() })
    };
    let [r, g, b, _] = seen(grey).map(f64::from);
    assert_near(seen(other), [r, g, b], 1e-4, "the wiggle");
}

#[test]
fn uniform_light_stays_uniform_through_every_stage() {
    let scene = faced(matte(patch("orange")), &unit("D65"));
    let all = Viewing {
        level_cd_m2: Some(0.5),
        glare: true,
        chromatic: true,
        acuity: true,
        gaze: Some([0.0, 0.0]),
        ..day()
    };
    for name in ["age:70+protan", "deutan:12", "tritan+iris:1.2", "rods"] {
        let mut shot = Shot::new(&spectral(scene.clone()).with_eye(viewer(name, all.clone()))).unwrap();
        let frame = shot.frame().unwrap();
        for plane in &frame.rgb {
            assert!(plane.iter().all(|v| (v - plane[0]).abs() <= 1e-6 * plane[0].abs()), "{name}: {plane:?}");
        }
    }
}

#[test]
fn in_bright_light_rods_change_nothing() {
    let scene = faced(matte(patch("blue")), &unit("D65"));
    let [r, g, b, _] = shown(&scene, viewer("age:50", day())).map(f64::from);
    let bright = Viewing { level_cd_m2: Some(1e4), night: true, ..day() };
    assert_near(shown(&scene, viewer("age:50", bright)), [r, g, b], 1e-6, "by day");
}

#[test]
fn photons_are_few_by_night_and_keep_the_mean() {
    let mut scene = spectral(faced(matte(patch("white-9.5")), &unit("D65")));
    (scene.image.width, scene.image.height) = (200, 200);
    // The mean of the cones' mixture with the rods, and its relative standard deviation.
    let spread = |level: f64, noise: Option<u32>| {
        let viewing = Viewing { level_cd_m2: Some(level), noise, px_per_deg: Some(40.0), ..day() };
        let frame = Shot::new(&scene.clone().with_eye(viewer("standard", viewing))).unwrap().frame().unwrap();
        let values: Vec<f64> = frame.rgb[1].iter().map(|v| f64::from(*v)).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let variance = values.iter().map(|v| (v - mean) * (v - mean)).sum::<f64>() / values.len() as f64;
        (mean, libm::sqrt(variance) / mean)
    };
    let (still, none) = spread(0.01, None);
    assert!(none < 1e-6);
    let (mean, moon) = spread(0.01, Some(1));
    assert!((mean / still - 1.0).abs() < 4.0 * moon / 200.0, "{mean} for {still}");
    // By moonlight some photons of a pixel in a tenth of a second, by starlight a hundredth of them.
    let (_, stars) = spread(1e-4, Some(1));
    assert!((0.2..0.9).contains(&moon) && stars > 5.0 * moon, "{moon} {stars}");
    let (_, bright) = spread(1e3, Some(1));
    assert!(bright < 0.02, "{bright}");
}

#[test]
fn at_dusk_red_darkens_and_blue_brightens() {
    let luminance = |name: &str, level: f64| {
        let scene = faced(matte(patch(name)), &unit("D65"));
        let viewing = Viewing { level_cd_m2: Some(level), adaptation_cd_m2: Some(level), ..day() };
        let [r, g, b, _] = shown(&scene, viewer("standard", viewing));
        0.2126 * r + 0.7152 * g + 0.0722 * b
    };
    assert!(luminance("red", 1e3) > luminance("blue", 1e3));
    assert!(luminance("red", 0.01) < 0.5 * luminance("blue", 0.01));
    // Night has no colours, and white stays white.
    let scene = faced(matte(Rgb::WHITE.into()), &unit("A"));
    for (name, adapted) in [("standard", 1.0), ("age:70", 1.0)] {
        let mut lit = scene.clone();
        lit.render.white = White::Scene;
        let viewing = Viewing { level_cd_m2: Some(1e-3), adapted, ..day() };
        let [r, g, b, _] = shown(&lit, viewer(name, viewing));
        assert!((r / g - 1.0).abs() < 1e-4 && (b / g - 1.0).abs() < 1e-4, "{name}: {r} {g} {b}");
    }
}

#[test]
fn dichromats_cannot_tell_what_differs_in_the_missing_cone_alone() {
    for (name, channel) in [("protan", 0), ("deutan", 1), ("tritan", 2)] {
        let eye: Eye = name.parse().unwrap();
        let curves: Vec<Spectrum> =
            eye.observer().channels.iter().map(|c| c.sensitivity * unit("D65")).collect();
        // What only the missing kind of cones sees: its curve without the two others.
        let others: Vec<Spectrum> = (0..3).filter(|c| *c != channel).map(|c| curves[c]).collect();
        let only = unseen_by(&others, curves[channel]);
        let most = only.0.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let other = Spectrum::from_fn(|nm| 0.4 + 0.3 * only.at(nm) / most);
        let seen = |eye: &str, spectrum: Spectrum| {
            shown(&faced(matte(Tint::Spectrum(Arc::new(spectrum))), &unit("D65")), viewer(eye, day()))
                .map(f64::from)
        };
        let (a, b) = (seen(name, Spectrum::constant(0.4)), seen(name, other));
        let (x, y) = (seen("standard", Spectrum::constant(0.4)), seen("standard", other));
        let distance = |a: [f64; 4], b: [f64; 4]| (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max);
        assert!(distance(a, b) < 2e-5, "{name}: {a:?} {b:?}");
        assert!(distance(x, y) > 1e-2, "{name}: others do: {x:?} {y:?}");
    }
}

#[test]
fn the_same_bits_for_every_number_of_threads() {
    let scene = spectral(faced(matte(patch("green")), &unit("D65")));
    let all = Viewing {
        level_cd_m2: Some(1.0),
        glare: true,
        chromatic: true,
        noise: Some(4),
        acuity: true,
        gaze: Some([20.0, 9.0]),
        ..day()
    };
    let mut scene = scene.with_eye(viewer("age:66+deutan:6", all));
    (scene.image.width, scene.image.height) = (233, 121);
    let drawn = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Shot::new(&scene).unwrap().frame().unwrap())
    };
    assert_eq!(drawn(1).rgb, drawn(3).rgb);
}

#[test]
fn a_session_changes_eyes_as_a_new_picture_has_them() {
    let scene = spectral(faced(matte(patch("red")), &unit("D65")));
    let mut session = Session::new(scene.clone()).unwrap();
    let pixels = |session: &mut Session| {
        let mut rgba = vec![0; 4 * 16];
        session.draw_into(&mut rgba).unwrap();
        rgba
    };
    let before = pixels(&mut session);
    for eye in [
        viewer("age:80", Viewing { adapted: 0.0, ..day() }),
        viewer("protan", day()),
        viewer("standard", Viewing { level_cd_m2: Some(0.01), ..day() }),
    ] {
        session.set_eye(Some(eye.clone()));
        let expected = Shot::new(&scene.clone().with_eye(eye)).unwrap().rgba8().unwrap();
        assert_eq!(pixels(&mut session), expected);
    }
    session.set_eye(None);
    assert_eq!(pixels(&mut session), before);
}

#[test]
fn an_eye_sees_no_rgb() {
    let mut scene = faced(matte(patch("red")), &unit("D65")).with_eye("age:70".parse::<Eye>().unwrap());
    scene.render.mode = ColorMode::Rgb;
    let error = Shot::new(&scene).err().unwrap().to_string();
    assert!(error.contains("choose mode 'spectral'"), "{error}");
}
