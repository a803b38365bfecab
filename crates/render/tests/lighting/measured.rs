//! Measured reflectance under lamps, areas and environments, against integrals of what was measured.

use glanz_measure::{Channels, Data, FactorOptions, Factored, Format, Measured, Quantity, Readings};
use glanz_scene::AreaShape;

use super::areas::{PLACES, VIEWS, area};
use super::environments::{environment, map, room};
use super::{areas, environments, *};

/// The albedo of both parts together.
const ALBEDO: f64 = 0.7;

/// What is measured: two models that the fitted lobes are not, and their albedos.
fn parts() -> [(Shape, f64); 2] {
    [(shape("ward", &[("alpha", 0.25)]), 0.3), (shape("oren-nayar", &[("sigma_deg", 30.0)]), 0.4)]
}

/// Its readings, as the red, green and blue of a surface that is yellower where it is matte.
fn measured() -> Material {
    let [(ward, gloss), (matte, rho)] = parts();
    let mut readings = Readings::new(Channels::Rgb);
    for theta_i in (0..85).step_by(4) {
        for theta_o in (0..85).step_by(3) {
            for phi in (0..360).step_by(12) {
                let at = |theta: i32, phi: i32| {
                    Vec3::from_angles(f64::from(theta).to_radians(), f64::from(phi).to_radians())
                };
                let (wi, wo) = (at(theta_i, 180), at(theta_o, phi));
                let pair = DirectionPair::new(wo, wi);
                let (gloss, matte) = (gloss * ward.f_cos(&pair) / wi.z, rho * matte.f_cos(&pair) / wi.z);
                let rgb = [1.0, 0.8, 0.3].map(|yellow| (gloss + yellow * matte) as f32);
                readings.push(wi, wo, &rgb);
            }
        }
    }
    let measured = Measured {
        format: Format::Csv,
        quantity: Quantity::Brdf,
        description: String::new(),
        data: Data::Readings(readings),
        notes: Vec::new(),
    };
    Material::measured("measured", &Factored::of(&measured, &FactorOptions::default()).unwrap())
}

/// Red of the surface, and what it should be: the sum of an integral over both parts. Errors are in parts of a scale.
fn compare(
    name: &str,
    (allowed, scale): (f64, f64),
    light: &dyn Fn() -> Light,
    integral: &dyn Fn(&Shape, f64) -> f64,
) {
    let material = measured();
    let mut worst = Worst::default();
    for degrees in VIEWS {
        let mut scene = surface(&shape("lambert", &[]), degrees);
        scene.materials = vec![material.clone()];
        scene.lights.push(light());
        let expected: f64 = parts().iter().map(|(shape, part)| part * integral(shape, degrees)).sum();
        let got = value(&scene);
        worst.note((got - expected) / scale, || format!("{degrees}°: {got:.5} for {expected:.5}"));
    }
    eprintln!("{name}: {:.4} at {}", worst.0, worst.1);
    assert!(worst.0 < allowed, "{name}: {} at {}", worst.0, worst.1);
}

#[test]
fn lamps_show_what_was_measured() {
    for towards in [DVec3::new(0.0, 0.0, 1.0), DVec3::new(-0.5, 0.3, 0.8), DVec3::new(0.8, 0.0, 0.6)] {
        let towards = towards.normalize();
        let light = || white(LightKind::Directional { direction: -towards });
        // A classic light of value 1 is π.
        compare("lamp", (0.01, ALBEDO), &light, &|shape, degrees| {
            std::f64::consts::PI * lobe_value(shape, degrees, towards)
        });
    }
}

#[test]
fn areas_show_what_was_measured() {
    let form = AreaShape::Rectangle { width: 1.0, height: 0.6 };
    for place in PLACES {
        let position = DVec3::from_array(place);
        compare("area", (0.03, ALBEDO), &|| white(area(form, position)), &|shape, degrees| {
            areas::by_sum(form, position, shape, degrees)
        });
    }
}

#[test]
fn environments_show_what_was_measured() {
    let map = map(room);
    // Measured, at 80°: lookups are fitted to the carrier, of which the table is a factor that its albedo alone has.
    compare("environment", (0.14, map.mean()[0]), &|| environment(Some(map.clone())), &|shape, degrees| {
        environments::by_sum(&map, shape, degrees)
    });
}
