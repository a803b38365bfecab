//! Fits find the parameters of published fits again.

use glanz_bsdf::{DirectionPair, Shape};
use glanz_math::Vec3;
use glanz_measure::{
    Channels, Data, FitOptions, Format, Measured, Merl, Metric, Noise, Quantity, Readings, fit,
};

/// Material, kd, ks, F0, m: the lobe is Cook and Torrance's, times ks (F0 + (1 − F0)(1 − wo·h)⁵).
type Row = (&'static str, [f64; 3], [f64; 3], f64, f64);

/// Every fourth of 86 fits to the materials of MERL. Source: A. Ngan, F. Durand and W. Matusik, "Experimental analysis of BRDF
/// models", Eurographics Symposium on Rendering 2005, as tabulated in `fits/` of the BSDF benchmark of bsdfbenchmark/bbm.
const PUBLISHED: [Row; 22] = [
    ("blue-acrylic", [0.0143, 0.033, 0.0639], [0.0291, 0.0193, 0.0118], 0.117, 0.0137),
    ("alum-bronze", [0.0886, 0.0602, 0.0299], [0.118, 0.0698, 0.0371], 0.203, 0.0367),
    ("specular-black-phenolic", [0.00299, 0.00281, 0.00236], [0.02, 0.0126, 0.00771], 0.274, 0.00737),
    ("black-soft-plastic", [0.00601, 0.005, 0.00352], [0.0939, 0.0765, 0.0515], 0.136, 0.325),
    ("blue-metallic-paint2", [0.0162, 0.0205, 0.0272], [0.0341, 0.0468, 0.0641], 0.637, 0.019),
    ("red-metallic-paint", [0.0724, 0.00971, 0.00535], [0.0651, 0.0132, 0.00567], 0.611, 0.0123),
    ("colonial-maple-223", [0.101, 0.0339, 0.0141], [0.981, 0.851, 0.566], 0.00173, 0.166),
    ("beige-fabric", [0.228, 0.133, 0.0798], [0.175, 0.11, 0.0622], 0.158, 0.741),
    ("green-latex", [0.0589, 0.0763, 0.0219], [0.0445, 0.041, 0.0162], 0.391, 0.527),
    ("fruitwood-241", [0.0568, 0.0369, 0.0168], [0.305, 0.251, 0.166], 0.0233, 0.0924),
    ("green-metallic-paint", [0.00303, 0.0415, 0.0341], [0.164, 0.165, 0.117], 0.137, 0.143),
    ("specular-maroon-phenolic", [0.151, 0.0226, 0.00486], [0.019, 0.0117, 0.00786], 0.271, 0.00716),
    ("silver-metallic-paint", [0.0652, 0.0579, 0.041], [0.238, 0.2, 0.134], 0.661, 0.195),
    ("nylon", [0.239, 0.206, 0.129], [0.101, 0.0859, 0.0521], 0.0423, 0.0662),
    ("silver-paint", [0.191, 0.138, 0.084], [0.084, 0.0737, 0.0522], 0.924, 0.207),
    ("pickled-oak-260", [0.141, 0.0926, 0.053], [0.0253, 0.0221, 0.0151], 0.999, 0.158),
    ("polyurethane-foam", [0.0663, 0.0205, 0.00926], [0.144, 0.0792, 0.0491], 0.206, 0.943),
    ("specular-red-phenolic", [0.3, 0.0306, 0.00567], [0.00729, 0.00588, 0.00394], 0.57, 0.00677),
    ("silicon-nitrade", [0.0119, 0.00894, 0.00572], [0.0234, 0.0175, 0.0145], 0.526, 0.00712),
    ("teflon", [0.308, 0.266, 0.182], [0.319, 0.273, 0.183], 0.0203, 0.139),
    ("specular-white-phenolic", [0.282, 0.194, 0.0733], [0.0321, 0.0243, 0.0185], 0.184, 0.0164),
    ("yellow-matte-plastic", [0.291, 0.102, 0.0146], [0.116, 0.0923, 0.0653], 0.056, 0.0489),
];

/// The middles of every 55th of MERL's cells above the horizon: 20 000.
fn cells() -> Vec<[Vec3<f64>; 2]> {
    let data = Data::Merl(Merl::of(&mut |_, _| [0.1; 3]));
    let (description, notes) = (String::new(), Vec::new());
    let measured = Measured { format: Format::Merl, quantity: Quantity::Brdf, description, data, notes };
    let all = measured.readings();
    (0..all.len()).step_by(55).map(|i| all.pair(i)).collect()
}

/// What a goniometer with 5 % of noise, and 2e-4 everywhere, says of a material.
fn readings(cells: &[[Vec3<f64>; 2]], (_, kd, ks, f0, m): Row) -> Readings {
    let gloss = Shape::named("cook-torrance", &[("m", m)]).expect("m is in range");
    let (mut readings, mut noise) = (Readings::new(Channels::Rgb), Noise::new(88_172_645));
    for [wi, wo] in cells {
        let pair = DirectionPair::new(*wo, *wi);
        let lobe = gloss.f_cos(&pair) / wi.z * (f0 + (1.0 - f0) * (1.0 - pair.cos_view_half()).powi(5));
        let values = [0, 1, 2].map(|c| {
            let f = kd[c] / std::f64::consts::PI + ks[c] * lobe;
            (f * (1.0 + 0.05 * noise.normal()) + 2e-4 * noise.normal()).max(0.0) as f32
        });
        readings.push(*wi, *wo, &values);
    }
    readings
}

#[test]
fn slopes_of_published_fits_are_found_again_within_their_errors() {
    let cells = cells();
    let options = FitOptions { metric: Metric::CubeRoot, ..FitOptions::default() };
    let (mut off, mut told) = (Vec::new(), Vec::new());
    for row in PUBLISHED {
        let found = fit(&readings(&cells, row), &["cook-torrance:schlick", "lambert"], &options).unwrap();
        let m = &found.lobes[0].parameters[0];
        let log_error = (m.value / row.4).ln().abs();
        println!("{}: m {} for {}, {log_error:.5} ± {:?}", row.0, m.value, row.4, m.log_error);
        off.push(log_error);
        told.extend(m.log_error.map(|error| log_error / error));
    }
    off.sort_by(f64::total_cmp);
    told.sort_by(f64::total_cmp);
    println!("median {:.5}, most {:.5}", off[11], off[21]);
    assert!(off[11] < 5e-4 && off[21] < 0.01, "{off:?}");
    // Of normal errors half are within 0.67 standard errors, and 22 within 3.5.
    assert!(told.len() == 22 && told[11] > 0.3 && told[11] < 1.2 && told[21] < 3.5, "{told:?}");
}
