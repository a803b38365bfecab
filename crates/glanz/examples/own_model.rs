//! A model of one's own: the moon's law of Lommel and Seeliger, with its certificate, its plot and its picture.
//!
//!     cargo run --features plot --example own_model [-- FOLDER]
#![expect(clippy::print_stdout, reason = "it tells what it made")]

use std::path::PathBuf;

use glanz::bsdf::{DirectionPair, LightTerm, Model, ModelInfo, ParamInfo, Side, albedo, laws};
use glanz::math::{PI, Real};
use glanz::plot::{self, Figure};
use glanz::{Camera, Error, Light, Lobe, Material, Mesh, Rgb, Scene, Shape, Shot};

/// Dust that scatters once: f = w / (4π (cosθi + cosθo)), with w the albedo of a grain.
#[derive(Clone, Debug)]
struct LommelSeeliger {
    grain_albedo: f64,
}

impl Model for LommelSeeliger {
    const INFO: ModelInfo = ModelInfo {
        name: "lommel-seeliger",
        title: "Lommel and Seeliger's law of dust",
        formula: "w cosθi / (4π (cosθi + cosθo))",
        source: "H. Seeliger, Zur Photometrie zerstreut reflectirender Substanzen, 1888",
        params: &[ParamInfo {
            name: "grain_albedo",
            symbol: "w",
            doc: "how much of the light that meets a grain it scatters",
            min: 0.0,
            max: 1.0,
            default: 0.5,
        }],
        term: LightTerm::Diffuse,
        side: Side::Reflection,
        anisotropic: false,
        delta: false,
        operations: 8,
        exempt: &[],
    };

    fn from_params(values: &[f64]) -> Self {
        Self { grain_albedo: values[0] }
    }

    fn params(&self) -> Vec<f64> {
        vec![self.grain_albedo]
    }

    fn f_cos<R: Real>(&self, pair: &DirectionPair<R>) -> R {
        let cos_i = pair.cos_i.max(pair.cos_i.zero());
        // Where both graze the quotient has no limit, but no light either.
        let sum = (cos_i + pair.cos_o.abs()).max(cos_i.lit(1e-6));
        cos_i.lit(self.grain_albedo / (4.0 * PI)) * cos_i / sum
    }
}

fn main() -> Result<(), Error> {
    let folder = std::env::args_os().nth(1).map_or_else(std::env::temp_dir, PathBuf::from);
    let dust = Shape::custom(LommelSeeliger { grain_albedo: 1.0 });
    println!("{}", laws::certify(&dust));
    println!("of the light along the normal {:.4} comes back", albedo(&dust, 1.0));

    let plot = folder.join("dust.svg");
    let mut lobes = plot::lobe(&[dust.clone(), Shape::named("lambert", &[])?]);
    lobes.theta_deg = vec![60.0];
    lobes.polar()?.save(&plot)?;
    println!("wrote {}", plot.display());

    // The full moon is as bright at its edge as in the middle; a matte ball that is as bright in the middle is not.
    let moons = [
        ("dust", Lobe::new(dust.with("grain_albedo", 0.6)?, Rgb::WHITE)),
        ("lambert", Lobe::new(Shape::named("lambert", &[])?, Rgb::gray(0.6 / 8.0))),
    ];
    for (name, lobe) in moons {
        let scene = Scene::new()
            .with_mesh(Mesh::builtin("sphere")?, Material::of_lobes(name, vec![lobe]))
            .with_light(Light::directional([0.0, 0.0, -1.0], [6.0; 3]))
            .with_camera(Camera::new([0.0, 0.0, 5.0], [0.0; 3]).with_fov_deg(30.0))
            .with_size(128, 128);
        let picture = folder.join(format!("moon-{name}.png"));
        Shot::new(&scene)?.save(&picture)?;
        println!("wrote {}", picture.display());
    }
    Ok(())
}
