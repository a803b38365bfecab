//! Frames in the channels of other observers.

use glanz_color::{Channel, Observer, Rgb, Spectrum, observer, reflectance};
use glanz_render::{Observation, ObservationError};
use glanz_scene::{ColorMode, White};

use super::{ROUNDING, assert_near, faced, matte, observed, patch, unit};

fn spectral(observer: Observer) -> Observation {
    Observation::new(ColorMode::Spectral, Some(observer)).unwrap()
}

fn bell(center: f64) -> Spectrum {
    Spectrum::from_fn(|nm| libm::exp(-(nm - center) * (nm - center) / 2000.0))
}

fn camera(centers: &[f64]) -> Observer {
    let channels = centers.iter().map(|c| Channel { name: format!("c{c}"), sensitivity: bell(*c) });
    Observer::from_channels("camera", channels.collect())
}

#[test]
fn each_observer_gets_its_own_channels() {
    for name in ["cie1931", "cie1964", "cie2015-2", "cie2015-10", "lms2", "lms10", "photopic", "scotopic"] {
        let seen_by = observer(name).unwrap();
        let scene = faced(matte(patch("orange")), &unit("A"));
        let frame = observed(&scene, spectral(seen_by.clone()), 4);
        let daylight = unit("D65");
        let light = unit("A") * reflectance("orange").unwrap();
        let scale = |c: usize| {
            let channel = if name.starts_with("cie") { 1 } else { c };
            1.0 / seen_by.channels[channel].sensitivity.dot(&daylight)
        };
        let expected = core::array::from_fn(|c| {
            seen_by.channels.get(c).map_or(0.0, |channel| channel.sensitivity.dot(&light) * scale(c))
        });
        assert_near(frame.pixel(1, 1), expected, ROUNDING, name);
    }
}

#[test]
fn white_under_daylight_is_white_for_every_observer() {
    let names = ["cie1964", "cie2015-2", "cie2015-10", "lms2", "lms10", "photopic", "scotopic"];
    let observers = names.map(|name| observer(name).unwrap()).into_iter().chain([
        camera(&[450.0, 540.0, 610.0]),
        camera(&[500.0, 600.0]),
        camera(&[420.0, 480.0, 530.0, 590.0, 640.0]),
    ]);
    for seen_by in observers {
        let name = seen_by.name.clone();
        let scene = faced(matte(Rgb::WHITE.into()), &unit("D65"));
        let observation = spectral(seen_by);
        let to_screen = observation.to_screen(&scene, White::D65).unwrap().unwrap();
        let frame = observed(&scene, observation, 4).on_screen(&to_screen).unwrap();
        assert_near(frame.pixel(2, 1), [1.0; 3], 1e-5, &name);
    }
}

#[test]
fn a_camera_of_five_channels_has_five_planes() {
    let centers = [420.0, 480.0, 530.0, 590.0, 640.0];
    let scene = faced(matte(patch("red")), &unit("D65"));
    let frame = observed(&scene, spectral(camera(&centers)), 4);
    assert_eq!((frame.rgb.len(), frame.more.len()), (3, 2));
    let planes: Vec<&Vec<f32>> = frame.rgb.iter().chain(&frame.more).collect();
    for (plane, center) in planes.iter().zip(centers) {
        let light = unit("D65");
        let expected = bell(center).dot(&(light * reflectance("red").unwrap())) / bell(center).dot(&light);
        assert!((f64::from(plane[5]) - expected).abs() < ROUNDING, "{center}: {} for {expected}", plane[5]);
    }
}

#[test]
fn a_sensor_that_mixes_the_standard_curves_shows_the_same_picture() {
    let standard = Observer::default();
    let [x, y, z] = [0, 1, 2].map(|c| standard.channels[c].sensitivity);
    let mixed = [x * 0.5 + y * 0.3, y * 0.9 + z * 0.1, z * 0.7 + x * 0.1];
    let channels = mixed.iter().zip(["a", "b", "c"]);
    let channels = channels.map(|(s, name)| Channel { name: name.into(), sensitivity: *s }).collect();
    let scene = faced(matte(patch("orange")), &unit("A"));
    let shown = |observation: Observation| {
        let to_screen = observation.to_screen(&scene, White::Scene).unwrap().unwrap();
        observed(&scene, observation, 4).on_screen(&to_screen).unwrap().pixel(1, 1)
    };
    let [r, g, b, _] = shown(spectral(standard)).map(f64::from);
    assert_near(shown(spectral(Observer::from_channels("mixed", channels))), [r, g, b], 1e-5, "mixed");
}

#[test]
fn the_97_samples_of_a_pixel_are_its_spectrum() {
    let scene = faced(matte(patch("blue")), &unit("FL11"));
    let frame = observed(&scene, Observation::spectrum(), 4);
    assert_eq!(3 + frame.more.len(), 97);
    let expected = unit("FL11") * reflectance("blue").unwrap();
    for (i, plane) in frame.rgb.iter().chain(&frame.more).enumerate() {
        let error = (f64::from(plane[0]) - expected[i]).abs();
        assert!(error <= 1e-6 * expected.max(), "sample {i}: {} for {}", plane[0], expected[i]);
    }
}

#[test]
fn what_cannot_be_seen_is_an_error_that_says_what_can() {
    let other = || Some(observer("cie1964").unwrap());
    assert!(matches!(
        Observation::new(ColorMode::Rgb, other()),
        Err(ObservationError::RgbHasNoObserver { .. })
    ));
    let meyer = Observation::new(ColorMode::Meyer, other()).unwrap_err();
    assert!(meyer.to_string().contains("cie1931") && meyer.to_string().contains("cie1964"), "{meyer}");
    let mut dark = faced(matte(patch("red")), &unit("D65"));
    dark.lights.clear();
    let white = Observation::new(ColorMode::Spectral, None).unwrap().to_screen(&dark, White::Scene);
    assert!(matches!(white, Err(ObservationError::NoWhite { .. })));
    let invisible = faced(matte(patch("red")), &glanz_color::light("line(310)").unwrap());
    let white = Observation::new(ColorMode::Spectral, None).unwrap().to_screen(&invisible, White::Scene);
    assert!(matches!(white, Err(ObservationError::NotWhite { .. })), "{white:?}");
}
