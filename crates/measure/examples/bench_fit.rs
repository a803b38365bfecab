//! How long fits take: tables of MERL's cells, made of known lobes with 5 % of noise, one and two lobes, 3 and 31 channels.
//!
//! ```console
//! $ cargo run --release -p glanz-measure --example bench_fit [FOLDER]
//! ```
//!
//! Prints one JSON line per case: median, least and greatest time of nine fits in s, and what was found. With a folder it
//! writes the readings there, too, for `xtask/peers/fits.py`, which fits them with scipy.

use std::io::Write as _;
use std::time::Instant;
use std::{env, fs, io};

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::{SimdLevel, Vec3};
use glanz_measure::{Channels, Data, Fit, FitOptions, Measured, Merl, Noise, Readings, fit};

/// Fits of one case.
const TURNS: usize = 9;

/// A case: its name, the lobes that the readings are made of (model, m, tint at normal and grazing incidence), those that are
/// fitted, the channels, and every how many cells count.
struct Case {
    name: &'static str,
    truth: &'static [(&'static str, f64, [f64; 2])],
    models: &'static [&'static str],
    channels: usize,
    every: usize,
}

const GLOSS: (&str, f64, [f64; 2]) = ("cook-torrance", 0.15, [0.1, 0.1]);
const MATTE: (&str, f64, [f64; 2]) = ("lambert", 0.0, [0.3, 0.3]);

const CASES: [Case; 4] = [
    Case {
        name: "one lobe",
        truth: &[GLOSS, MATTE],
        models: &["cook-torrance", "lambert"],
        channels: 3,
        every: 55,
    },
    Case {
        name: "one lobe, all cells",
        truth: &[GLOSS, MATTE],
        models: &["cook-torrance", "lambert"],
        channels: 3,
        every: 1,
    },
    Case {
        name: "two lobes",
        truth: &[("cook-torrance", 0.06, [0.05, 0.05]), ("cook-torrance", 0.25, [0.1, 0.1]), MATTE],
        models: &["cook-torrance", "cook-torrance", "lambert"],
        channels: 3,
        every: 55,
    },
    Case {
        name: "two lobes, Fresnel tints, 31 channels",
        truth: &[("cook-torrance", 0.06, [0.05, 0.3]), ("cook-torrance", 0.25, [0.1, 0.2]), MATTE],
        models: &["cook-torrance:schlick", "cook-torrance:schlick", "lambert"],
        channels: 31,
        every: 187,
    },
];

/// The middles of MERL's cells above the horizon, every n-th.
fn cells(every: usize) -> Result<Vec<[Vec3<f64>; 2]>, Box<dyn std::error::Error>> {
    let table = Merl::of(&mut |_, _| [0.1; 3]);
    let measured = Measured {
        format: glanz_measure::Format::Merl,
        quantity: Default::default(),
        description: String::new(),
        data: Data::Merl(table),
        notes: Vec::new(),
    };
    let all = measured.readings();
    Ok((0..all.len()).step_by(every).map(|i| all.pair(i)).collect())
}

/// The readings of a case, with 5 % of noise and 2e-4 everywhere.
fn readings(case: &Case) -> Result<Readings, Box<dyn std::error::Error>> {
    let channels = match case.channels {
        3 => Channels::Rgb,
        n => Channels::Wavelengths((0..n).map(|i| 400.0 + 10.0 * i as f64).collect()),
    };
    let mut shapes = Vec::new();
    for (model, m, tints) in case.truth {
        let set = [("m", *m)];
        shapes.push((Shape::named(model, if *m > 0.0 { &set } else { &[] })?, tints));
    }
    let (mut readings, mut noise) = (Readings::new(channels), Noise::new(88_172_645));
    for [wi, wo] in cells(case.every)? {
        let pair = DirectionPair::new(wo, wi);
        let u5 = (1.0 - pair.cos_view_half()).powi(5);
        let lobe = |(shape, [f0, f90]): &(Shape, &[f64; 2])| {
            (f0 * (1.0 - u5) + f90 * u5) * shape.f_cos(&pair) / wi.z
        };
        let f: f64 = shapes.iter().map(lobe).sum();
        // Channels are 1 to 1.3 times the first.
        let mut value = |c: usize| {
            let f = f * (1.0 + 0.3 * c as f64 / case.channels as f64);
            (f * (1.0 + 0.05 * noise.normal()) + 2e-4 * noise.normal()).max(0.0) as f32
        };
        let values: Vec<f32> = (0..case.channels).map(&mut value).collect();
        readings.push(wi, wo, &values);
    }
    Ok(readings)
}

/// For each reading wi, wo and the values, as f64, least significant byte first.
fn write(readings: &Readings, path: &str) -> io::Result<()> {
    let mut bytes = Vec::new();
    for i in 0..readings.len() {
        let [wi, wo] = readings.pair(i);
        let values = readings.values(i).iter().map(|value| f64::from(*value));
        let row = [wi.x, wi.y, wi.z, wo.x, wo.y, wo.z].into_iter().chain(values);
        row.for_each(|number| bytes.extend(number.to_le_bytes()));
    }
    fs::write(path, bytes)
}

fn widths(fit: &Fit) -> Vec<f64> {
    fit.lobes.iter().flat_map(|lobe| lobe.parameters.iter().map(|parameter| parameter.value)).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = env::args().nth(1);
    let options = FitOptions { most_theta_deg: 89.9, most_readings: usize::MAX, ..FitOptions::default() };
    for (number, case) in CASES.iter().enumerate() {
        let readings = readings(case)?;
        if let Some(folder) = &folder {
            write(&readings, &format!("{folder}/{number}.bin"))?;
        }
        let mut found = fit(&readings, case.models, &options)?;
        let mut times = Vec::new();
        for _ in 0..TURNS {
            let start = Instant::now();
            found = fit(&readings, case.models, &options)?;
            times.push(start.elapsed().as_secs_f64());
        }
        times.sort_by(f64::total_cmp);
        writeln!(
            io::stdout(),
            r#"{{"case": "{}", "number": {number}, "channels": {}, "readings": {}, "level": "{}", "median": {:.5}, "least": {:.5}, "most": {:.5}, "evaluations": {}, "error": {:.10}, "widths": {:?}}}"#,
            case.name,
            case.channels,
            found.readings,
            SimdLevel::best().name(),
            times[TURNS / 2],
            times[0],
            times[TURNS - 1],
            found.evaluations,
            found.error,
            widths(&found),
        )?;
    }
    Ok(())
}
