//! Measured reflectance as a table of factors over fitted lobes.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::{FRAC_1_PI, PI};

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{
    Channels, Data, FactorError, FactorOptions, Factored, Format, Geometry, Measured, Noise, Quantity,
    Readings, Smoothed,
};

/// Directions without an order that one sees.
struct Random(Noise);

impl Random {
    fn new(seed: u64) -> Self {
        Self(Noise::new(seed))
    }

    fn next(&mut self) -> f64 {
        self.0.unit()
    }

    /// A direction within 80° of the normal.
    fn direction(&mut self) -> Vec3<f64> {
        Vec3::from_angles((80.0 * self.next().sqrt()).to_radians(), 2.0 * PI * self.next())
    }

    /// A pair of directions; half of them are near the mirror direction of each other.
    fn pair(&mut self) -> [Vec3<f64>; 2] {
        let wi = self.direction();
        loop {
            let wo = match self.next() < 0.5 {
                true => self.direction(),
                false => {
                    let off = Vec3::new(self.next() - 0.5, self.next() - 0.5, self.next() - 0.5) * 0.4;
                    (Vec3::new(-wi.x, -wi.y, wi.z) + off).normalized()
                }
            };
            if wo.z > 0.17 {
                return [wi, wo];
            }
        }
    }
}

fn measured(readings: Readings) -> Measured {
    Measured {
        format: Format::Csv,
        quantity: Quantity::Brdf,
        description: String::new(),
        data: Data::Readings(readings),
        notes: Vec::new(),
    }
}

/// Readings of a function with an error of this part of them.
fn readings(
    channels: Channels,
    count: usize,
    noise: f64,
    f: &dyn Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
) -> Measured {
    let mut random = Random::new(7);
    let mut readings = Readings::new(channels);
    for _ in 0..count {
        let [wi, wo] = random.pair();
        let error = 1.0 + noise * (random.next() + random.next() + random.next() - 1.5) * 2.0;
        let values: Vec<f32> = f(wi, wo).into_iter().map(|value| (value * error) as f32).collect();
        readings.push(wi, wo, &values);
    }
    measured(readings)
}

fn shape(name: &str, params: &[(&str, f64)]) -> impl Fn(Vec3<f64>, Vec3<f64>) -> f64 + use<> {
    let shape = Shape::named(name, params).unwrap();
    move |wi, wo| shape.f_cos(&DirectionPair::new(wo, wi)) / wi.z
}

/// Median and 95 of 100 of the relative differences of two functions, over pairs that no reading has.
fn errors(
    own: &dyn Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
    exact: &dyn Fn(Vec3<f64>, Vec3<f64>) -> Vec<f64>,
) -> [f64; 2] {
    let mut random = Random::new(99);
    let mut all: Vec<f64> = (0..2000)
        .flat_map(|_| {
            let [wi, wo] = random.pair();
            let (own, exact) = (own(wi, wo), exact(wi, wo));
            own.into_iter()
                .zip(exact)
                .map(|(own, exact)| (own - exact).abs() / exact.abs())
                .collect::<Vec<_>>()
        })
        .collect();
    all.sort_by(f64::total_cmp);
    [all[all.len() / 2], all[all.len() * 95 / 100]]
}

/// A red paint under a gloss that Fresnel's law makes stronger at grazing angles.
fn paint(wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
    let gloss = shape("ggx", &[("alpha", 0.2)]);
    let h = (wi + wo).normalized();
    let fresnel = 0.04 + 0.96 * (1.0 - h.dot(wo)).powi(5);
    [0.4, 0.1, 0.02].map(|red| red * FRAC_1_PI * (1.0 - fresnel) + gloss(wi, wo) * fresnel).to_vec()
}

#[test]
fn a_paint_is_drawn_as_it_was_measured() {
    let file = readings(Channels::Rgb, 8000, 0.0, &paint);
    let factored = Factored::of(&file, &FactorOptions::default()).unwrap();
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &paint);
    println!("{median} {most} {:?}", factored.facts);
    assert!(median < 0.005 && most < 0.05, "{median}, {most}");
    assert!(factored.facts.holes < 0.05, "{}", factored.facts.holes);
    // The sum of the lobes is the value.
    let [wi, wo] = Random::new(3).pair();
    let pair = DirectionPair::new(wo, wi);
    let mut sum = [0.0; 3];
    for (shape, layer, tint) in factored.lobes() {
        let value = shape.f_cos(&pair) / wi.z * layer.factor(&pair);
        sum.iter_mut().zip(tint).for_each(|(sum, tint)| *sum += value * tint);
    }
    for (sum, value) in sum.iter().zip(factored.value(wi, wo)) {
        assert!((sum - value).abs() < 1e-12, "{sum} and {value}");
    }
}

#[test]
fn noise_of_readings_is_smoothed() {
    let file = readings(Channels::Rgb, 8000, 0.05, &paint);
    let smoothed = Smoothed::of(&file, None).unwrap();
    let [median, most] = errors(&|wi, wo| smoothed.value(wi, wo).0, &paint);
    println!("{median} {most} {} {}", smoothed.neighbours(), smoothed.noise());
    // Readings are off by 0.034 in the median.
    assert!(median < 0.012 && most < 0.06, "{median}, {most}");
}

#[test]
fn far_from_readings_the_fitted_lobes_remain() {
    let f = |_: Vec3<f64>, _: Vec3<f64>| vec![0.25];
    // Only light near the normal, and only near its mirror direction.
    let mut random = Random::new(5);
    let mut list = Readings::new(Channels::Luminance);
    for _ in 0..500 {
        let wi = Vec3::from_angles(0.3 * random.next(), 2.0 * PI * random.next());
        let wo = Vec3::from_angles(0.3 * random.next(), 2.0 * PI * random.next());
        list.push(wi, wo, &[0.25]);
    }
    let factored = Factored::of(&measured(list), &FactorOptions::default()).unwrap();
    assert!(factored.facts.holes > 0.3, "{}", factored.facts.holes);
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &f);
    assert!(median < 0.01 && most < 0.05, "{median}, {most}");
}

/// Pairs of directions off the plane of incidence: the light, and detectors to all sides.
fn beside_the_plane() -> Vec<(Vec3<f64>, Vec<Vec3<f64>>)> {
    let at =
        |theta: i32, phi: i32| Vec3::from_angles(f64::from(theta).to_radians(), f64::from(phi).to_radians());
    let lights = [10, 30, 50, 70].into_iter().flat_map(|theta| [0, 20, 45, 70, 90].map(|phi| (theta, phi)));
    let detectors = |phi: i32| {
        let around = (20..341).step_by(20).filter(|turn| *turn != 180);
        around.flat_map(move |turn| (5..76).step_by(10).map(move |theta| at(theta, phi + turn))).collect()
    };
    lights.map(|(theta, phi)| (at(theta, phi), detectors(phi))).collect()
}

/// Readings with 3 % of noise where a goniometer goes that stays in the plane of incidence, of a brushed surface whose matte
/// part has this albedo, smoothed; and what it is.
fn read_in_plane(
    geometry: Geometry,
    widths: [f64; 2],
    albedo: f64,
) -> (Smoothed, impl Fn(Vec3<f64>, Vec3<f64>) -> f64) {
    let brushed = shape("ward", &[("alpha", widths[0]), ("alpha_y", widths[1])]);
    let f = move |wi, wo| 0.3 * brushed(wi, wo) + albedo * FRAC_1_PI;
    let (mut noise, mut list) = (Noise::new(3), Readings::new(Channels::Luminance));
    for [wi, wo] in geometry.pairs(true) {
        list.push(wi, wo, &[(f(wi, wo) * (1.0 + 0.03 * noise.normal())) as f32]);
    }
    let smoothed = Smoothed::of(&measured(list), None).unwrap();
    assert!(smoothed.is_anisotropic());
    (smoothed, f)
}

#[test]
fn readings_in_the_plane_of_incidence_tell_what_lies_beside_it() {
    // Most readings are of the highlight, and their median is 60 times the matte part.
    let (smoothed, f) = read_in_plane(Geometry::Scatterometer, [0.09, 0.32], 0.02);
    for (wi, detectors) in beside_the_plane() {
        for wo in detectors {
            let (value, exact) = (smoothed.value(wi, wo).0[0], f(wi, wo));
            assert!((value / exact - 1.0).abs() < 0.05, "{value} for {exact} at {wi:?}, {wo:?}");
        }
    }
}

#[test]
fn slopes_in_the_plane_of_incidence_do_not_lead_on_beside_it() {
    // Without a matte part the logarithms of the readings fall without end.
    let (smoothed, f) = read_in_plane(Geometry::InPlane, [0.02, 0.6], 0.0);
    for (wi, detectors) in beside_the_plane() {
        let most = detectors.iter().map(|wo| f(wi, *wo)).fold(0.0, f64::max);
        for wo in detectors {
            let value = smoothed.value(wi, wo).0[0];
            assert!(value < 1.1 * most, "{value} where {most} is the most, at {wi:?}, {wo:?}");
        }
    }
}

#[test]
fn spectra_need_as_many_ranks_as_they_have_parts() {
    let nm: Vec<f64> = (0..31).map(|i| 400.0 + 10.0 * f64::from(i)).collect();
    let pigment: Vec<f64> = nm.iter().map(|nm| 0.05 + 0.5 / (1.0 + (-(nm - 580.0) / 15.0).exp())).collect();
    let gloss = shape("ggx", &[("alpha", 0.15)]);
    let f = move |wi: Vec3<f64>, wo: Vec3<f64>| {
        let h = (wi + wo).normalized();
        let fresnel = 0.04 + 0.96 * (1.0 - h.dot(wo)).powi(5);
        // A pearl turns bluish away from the mirror direction.
        let turn = (h.z * h.z).powi(8);
        let at = |(i, rho): (usize, &f64)| {
            let pearl = 0.1 * (1.0 - turn) * (1.0 - i as f64 / 30.0);
            (rho + pearl) * FRAC_1_PI + gloss(wi, wo) * fresnel
        };
        pigment.iter().enumerate().map(at).collect::<Vec<_>>()
    };
    let file = readings(Channels::Wavelengths(nm), 3000, 0.0, &f);
    let factored = Factored::of(&file, &FactorOptions::default()).unwrap();
    println!("{:?}", factored.facts);
    let ranks = factored.table().ranks();
    assert!((2..=4).contains(&ranks), "{:?}", factored.facts);
    assert!(factored.facts.delta_e[ranks - 1] <= 0.3 && factored.facts.delta_e[ranks - 2] > 0.3);
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &f);
    println!("{median} {most}");
    assert!(median < 0.01 && most < 0.08, "{median}, {most}");
    let one = Factored::of(&file, &FactorOptions { ranks: Some(1), ..FactorOptions::default() }).unwrap();
    assert_eq!((one.table().ranks(), one.facts.bytes), (1, factored.facts.bytes));
    let asked = FactorOptions { ranks: Some(9), ..FactorOptions::default() };
    assert_eq!(Factored::of(&file, &asked), Err(FactorError::Ranks { asked: 9, channels: 31 }));
}

#[test]
fn an_oblique_grain_is_followed() {
    const ANISO_DEG: f64 = 117.0;
    let brushed = shape("ggx", &[("alpha", 0.08), ("alpha_y", 0.35)]);
    let (sin, cos) = ANISO_DEG.to_radians().sin_cos();
    let turned = |w: Vec3<f64>| Vec3::new(cos * w.x + sin * w.y, cos * w.y - sin * w.x, w.z);
    let f = |wi, wo| vec![0.05 * FRAC_1_PI + 0.5 * brushed(turned(wi), turned(wo))];
    let file = readings(Channels::Luminance, 3000, 0.05, &f);
    let factored = Factored::of(&file, &FactorOptions::default()).unwrap();
    assert!(factored.table().is_anisotropic());
    // x lies along either width.
    let off = (factored.aniso_deg() - ANISO_DEG).rem_euclid(90.0);
    assert!(off.min(90.0 - off) < 0.5, "{}", factored.aniso_deg());
    // A fifth of the readings' noise in the median: the carrier is their model, so its fit and the regression average them all.
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &f);
    println!("{median} {most} {:?}", factored.facts);
    assert!(median < 0.01 && most < 0.05, "{median}, {most}");
    // Smoothed values are in the frame of the data, too.
    let smoothed = Smoothed::of(&file, None).unwrap();
    assert!(smoothed.is_anisotropic());
    let [median, most] = errors(&|wi, wo| smoothed.value(wi, wo).0, &f);
    assert!(median < 0.01 && most < 0.05, "{median}, {most}");
}

#[test]
fn a_grain_is_seen_where_there_is_one() {
    // No model that the table is a factor of.
    let brushed = shape("ashikhmin-shirley", &[("nu", 150.0), ("nv", 10.0)]);
    let f = move |wi: Vec3<f64>, wo: Vec3<f64>| vec![0.05 * FRAC_1_PI + 0.5 * brushed(wi, wo)];
    let file = readings(Channels::Luminance, 20_000, 0.0, &f);
    let factored = Factored::of(&file, &FactorOptions::default()).unwrap();
    assert!(factored.table().is_anisotropic());
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &f);
    println!("{median} {most} {:?}", factored.facts);
    assert!(median < 0.04 && most < 0.4, "{median}, {most}");
    let isotropic = Factored::of(&readings(Channels::Rgb, 8000, 0.02, &paint), &FactorOptions::default());
    assert!(!isotropic.unwrap().table().is_anisotropic());
}

#[test]
fn colours_outside_of_srgb_are_kept() {
    // A yellow whose blue is below 0.
    let f = |wi: Vec3<f64>, wo: Vec3<f64>| {
        paint(wi, wo).iter().zip([1.0, 1.0, -0.2]).map(|(x, c)| x * c).collect()
    };
    let yellow = |wi: Vec3<f64>, wo: Vec3<f64>| {
        let values: Vec<f64> = f(wi, wo);
        vec![values[0], values[0] * 0.8, values[0] * -0.04]
    };
    let file = readings(Channels::Rgb, 4000, 0.0, &yellow);
    let factored = Factored::of(&file, &FactorOptions::default()).unwrap();
    let [median, most] = errors(&|wi, wo| factored.value(wi, wo), &yellow);
    println!("{median} {most}");
    assert!(median < 0.02 && most < 0.2, "{median}, {most}");
    let [wi, wo] = Random::new(11).pair();
    assert!(factored.value(wi, wo)[2] < 0.0);
}

#[test]
fn readings_of_nothing_are_refused_in_words() {
    let file = readings(Channels::Rgb, 600, 0.0, &|_, _| vec![0.0; 3]);
    let error = Factored::of(&file, &FactorOptions::default()).unwrap_err();
    assert!(error.to_string().ends_with("all values are 0 or below"), "{error}");
}
