//! How long the stages of an eye take on a frame of 1920×1080: `cargo run --release -p glanz-eye --example bench`,
//! those whose name has a word: `… --example bench -- glare`.

#![expect(clippy::print_stdout, reason = "a bench tells what it measured")]

use std::time::Instant;

use glanz_eye::{Angles, Eye, Seeing, Viewer, Viewing};
use glanz_picture::Frame;

/// Runs of each stage.
const RUNS: usize = 25;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (width, height) = (1920, 1080);
    let dawn = Viewing { level_cd_m2: Some(1.0), adaptation_cd_m2: Some(1.0), ..Viewing::default() };
    let cases = [
        ("nothing but what it is adapted to", "standard", Viewing::default()),
        ("deficiency", "deutan:10", Viewing::default()),
        ("dusk", "standard", dawn),
        ("glare", "age:70", Viewing { glare: true, ..Viewing::default() }),
        (
            "acuity by moonlight",
            "standard",
            Viewing { adaptation_cd_m2: Some(0.01), acuity: true, ..Viewing::default() },
        ),
        ("gaze", "standard", Viewing { gaze: Some([600.0, 400.0]), ..Viewing::default() }),
    ];
    for (name, eye, viewing, distance_px) in
        cases.map(|(name, eye, viewing)| (name, eye, viewing, None)).into_iter().chain([(
            "glare of a camera of 60°",
            "age:70",
            Viewing { glare: true, ..Viewing::default() },
            Some(0.5 * 1080.0 / libm::tan(30_f64.to_radians())),
        )])
    {
        if std::env::args().nth(1).is_some_and(|word| !name.contains(&word)) {
            continue;
        }
        let rods = viewing.level_cd_m2.is_some();
        let eye: Eye = eye.parse()?;
        let mut seeing = seeing(Viewer { eye, viewing }, width, height);
        if let Some(distance) = distance_px {
            seeing.angles = Angles { px_per_deg: distance.to_radians(), distance_px, ..seeing.angles };
        }
        let drawn = frame(width, height, rods);
        let mut frame = drawn.clone();
        let mut times: Vec<f64> = (0..RUNS)
            .map(|_| {
                for (channel, drawn) in
                    frame.rgb.iter_mut().chain(&mut frame.more).zip(drawn.rgb.iter().chain(&drawn.more))
                {
                    channel.copy_from_slice(drawn);
                }
                let start = Instant::now();
                let seen = seeing.see(&mut frame);
                let time = start.elapsed().as_secs_f64() * 1e3;
                std::hint::black_box((seen, &frame));
                time
            })
            .collect();
        times.sort_by(f64::total_cmp);
        println!(
            "{name:<36} {:6.1} ms  ({:.1} to {:.1}, {RUNS} runs)",
            times[RUNS / 2],
            times[0],
            times[RUNS - 1]
        );
    }
    Ok(())
}

/// An eye before a screen of 40 pixels per degree.
fn seeing(viewer: Viewer, width: usize, height: usize) -> Seeing {
    let middle = [0.5 * width as f64, 0.5 * height as f64];
    Seeing {
        viewer,
        own_white: vec![1.0; 4],
        usual_white: vec![1.0; 3],
        gains: [1.0; 3],
        scales: [1.0; 3],
        white: [1.0; 3],
        rod_color: [1.0; 3],
        unit_cd_m2: 1000.0,
        angles: Angles { px_per_deg: 40.0, distance_px: None, middle },
    }
}

/// Waves of all lengths.
fn frame(width: usize, height: usize, rods: bool) -> Frame {
    let plane = |seed: usize| -> Vec<f32> {
        (0..width * height).map(|i| ((i * (7 + seed) + i / width * 31) % 1000) as f32 / 1000.0).collect()
    };
    Frame {
        width,
        height,
        rgb: [plane(1), plane(2), plane(3)],
        more: if rods { vec![plane(4)] } else { Vec::new() },
        alpha: vec![1.0; width * height],
        ..Frame::default()
    }
}
