//! The whole command: from the start of the process to a PNG on disk.

use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::workspace::{Profile, Workspace, run_quietly};
use crate::{Failure, Result};

/// The benchmark's sphere as a scene file: that of the peers, with one light.
const SCENE: &str = "\
[image]
width = 1920
height = 1080
samples = 1
background = [0.05, 0.05, 0.08]

[camera]
eye = [0.0, 0.0, EYE]
fov_deg = 40.0

[ambient]
color = [1.0, 1.0, 1.0]

[[lights]]
kind = \"point\"
position = [2.98, 0.29, 3.0]
ambient = [0.0, 0.0, 0.0]

[materials.red]
model = \"phong\"
ambient = [0.05, 0.01, 0.01]
diffuse = [0.8, 0.1, 0.1]
specular = [0.6, 0.6, 0.6]
shininess = 32.0

[[objects]]
mesh = { sphere = { slices = 64, stacks = 32 } }
material = \"red\"
";

/// The silhouette of the sphere, in heights of the picture.
const SILHOUETTE: f64 = 0.7;

/// Measures time and memory of `glanz render`.
pub(super) fn run_all(workspace: &Workspace, quick: bool) -> Result<Vec<Value>> {
    let glanz = workspace.glanz(Profile::Release)?;
    let folder = workspace.target_folder("bench")?;
    let scene = folder.join("sphere.toml");
    std::fs::write(&scene, scene_text()).map_err(Failure::during(scene.display()))?;
    let picture = folder.join("sphere.png");
    let render = || {
        let mut command = workspace.command(&glanz);
        command.arg("render").arg(&scene).arg("-o").arg(&picture);
        command
    };
    let mut times = Vec::new();
    for run in 0..if quick { 12 } else { 44 } {
        let start = Instant::now();
        run_quietly(&mut render())?;
        // The first runs read the program from disk.
        if run >= 4 {
            times.push(1e3 * start.elapsed().as_secs_f64());
        }
    }
    times.sort_by(f64::total_cmp);
    let mut line = json!({
        "table": "The whole command: `glanz render`, 64×32 sphere, 1 light, from process start to a 1080p PNG on disk",
        "name": "glanz",
        "median ms": rounded(times[times.len() / 2]),
        "min ms": rounded(times[0]),
        "max ms": rounded(times[times.len() - 1]),
    });
    if let Some(peak) = peak_memory(&mut render(), &picture)? {
        line["peak memory MB"] = json!(rounded(peak as f64 / 1e6));
    }
    println!("{line}");
    Ok(vec![line])
}

/// The scene with the eye where a unit sphere's outline covers that part of the height.
fn scene_text() -> String {
    let slope = (20.0_f64).to_radians().tan() * SILHOUETTE;
    SCENE.replace("EYE", &format!("{:.9}", (1.0 + slope.powi(-2)).sqrt()))
}

fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

/// The most memory that the process held, in bytes, as Linux counts it; asked for again and again
/// while it runs, so what it takes within its last fraction of a millisecond is missed.
fn peak_memory(command: &mut Command, picture: &Path) -> Result<Option<u64>> {
    let mut child = command.spawn().map_err(Failure::during(picture.display()))?;
    let status = format!("/proc/{}/status", child.id());
    let mut peak = None;
    while child.try_wait().map_err(Failure::during(picture.display()))?.is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        peak = peak.max(high_water_mark(&text));
        std::thread::sleep(Duration::from_micros(200));
    }
    Ok(peak)
}

/// `VmHWM` of a process's status, in bytes.
fn high_water_mark(status: &str) -> Option<u64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_high_water_mark_is_found() {
        assert_eq!(high_water_mark("Name:\tglanz\nVmHWM:\t   2048 kB\nVmRSS:\t 1 kB\n"), Some(2 << 20));
        assert_eq!(high_water_mark("Name:\tglanz\n"), None);
    }

    #[test]
    fn the_eye_sees_the_sphere_at_the_right_size() {
        let text = scene_text();
        let eye = text.lines().find_map(|line| line.strip_prefix("eye = [0.0, 0.0, ")).expect("an eye");
        let distance: f64 = eye.trim_end_matches(']').parse().expect("a number");
        let outline = (1.0 / distance).asin().tan() / 20.0_f64.to_radians().tan();
        assert!((outline - SILHOUETTE).abs() < 1e-8);
    }
}
