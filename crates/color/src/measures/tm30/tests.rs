use super::*;
use crate::lights::fine_light;

/// Both oracles interpolate spectra and samples, and find the temperature, in their own ways: colour-science 0.4.7
/// (`colour_fidelity_index_ANSIIESTM3018` of the light by 1 nm) and luxpy 1.12.5 (`spd_to_ies_tm30_metrics`), which are
/// as far from each other.
const INDEX: f64 = 0.01;
const SHIFT: f64 = 5e-4;

struct Known {
    name: &'static str,
    rf: f64,
    rg: f64,
    first_samples: [f64; 6],
    fidelity: [f64; BINS],
    chroma: [f64; BINS],
    hue: [f64; BINS],
}

const KNOWN: [Known; 3] = [
    Known {
        name: "FL2",
        rf: 70.121,
        rg: 86.4165,
        first_samples: [78.886, 58.985, 66.882, 65.669, 35.776, 66.061],
        fidelity: [
            60.201, 61.274, 52.54, 68.32, 79.547, 87.528, 76.767, 72.731, 76.158, 62.294, 69.612, 76.538,
            81.345, 71.372, 63.593, 65.26,
        ],
        chroma: [
            -24.9284, -17.6643, -8.8873, 5.4159, 11.1022, 4.449, -7.7325, -14.6376, -17.2413, -15.4344,
            -3.6436, 5.0472, 10.9961, 6.6762, -6.4451, -16.3692,
        ],
        hue: [
            -0.02207, 0.14015, 0.24428, 0.1962, 0.09135, -0.06728, -0.12237, -0.08468, 0.00628, 0.16583,
            0.19037, 0.11432, -0.08082, -0.14671, -0.2635, -0.17003,
        ],
    },
    Known {
        name: "LED-B5",
        rf: 79.4684,
        rg: 94.1478,
        first_samples: [89.65, 79.631, 79.216, 77.795, 65.33, 81.896],
        fidelity: [
            74.492, 78.067, 76.539, 78.923, 84.047, 91.941, 90.631, 83.23, 80.175, 66.803, 63.535, 81.921,
            85.404, 84.08, 72.704, 84.051,
        ],
        chroma: [
            -13.5785, -9.3498, -5.2368, 1.1073, 2.1956, 1.9736, -3.8567, -9.8503, -13.1501, -8.1778, 0.5747,
            5.1623, 10.457, 4.502, 8.3185, -5.9544,
        ],
        hue: [
            -0.01056, 0.07983, 0.13166, 0.12607, 0.06302, -0.01704, -0.04136, -0.00581, 0.1171, 0.21935,
            0.20602, 0.10795, 0.00874, -0.08109, -0.23455, -0.0735,
        ],
    },
    Known {
        name: "LED-RGB1",
        rf: 71.0005,
        rg: 107.0087,
        first_samples: [75.691, 64.153, 76.259, 55.016, 60.531, 77.428],
        fidelity: [
            68.195, 62.671, 54.25, 72.561, 83.259, 74.575, 67.482, 65.753, 69.599, 65.02, 67.61, 69.496,
            86.337, 81.828, 76.111, 77.321,
        ],
        chroma: [
            16.4459, 14.733, 5.4767, -6.8816, -8.5327, 2.0684, 10.9963, 20.8498, 17.2882, 10.5568, 3.1934,
            -3.2653, -6.1283, -6.977, 2.6609, 13.9907,
        ],
        hue: [
            -0.01034, -0.15122, -0.23647, -0.18207, -0.00269, 0.17429, 0.17687, 0.03462, -0.07428, -0.19823,
            -0.23891, -0.18916, -0.08774, 0.10357, 0.14436, 0.0819,
        ],
    },
];

#[test]
fn lights_have_the_numbers_of_colour_science() {
    for known in &KNOWN {
        let found = evaluate(&fine_light(known.name).unwrap()).unwrap();
        let near =
            |a: f64, b: f64, tolerance: f64| assert!((a - b).abs() < tolerance, "{}: {a} {b}", known.name);
        near(found.rf, known.rf, INDEX);
        near(found.rg, known.rg, INDEX);
        for (found, known) in found.samples.iter().zip(known.first_samples) {
            near(*found, known, INDEX);
        }
        for (i, bin) in found.bins.iter().enumerate() {
            near(bin.fidelity, known.fidelity[i], 2.0 * INDEX);
            near(100.0 * bin.chroma_shift, known.chroma[i], 100.0 * SHIFT);
            near(bin.hue_shift, known.hue[i], SHIFT);
        }
    }
}

#[test]
fn lights_have_the_indices_of_luxpy() {
    for (name, rf, rg) in [
        ("FL4", 56.6994, 83.4911),
        ("FL11", 80.0405, 101.0567),
        ("LED-B3", 85.3242, 97.8633),
        ("HP1", 34.193, 53.964),
    ] {
        let found = evaluate(&fine_light(name).unwrap()).unwrap();
        assert!(
            (found.rf - rf).abs() < INDEX && (found.rg - rg).abs() < INDEX,
            "{name}: {} {}",
            found.rf,
            found.rg
        );
    }
}

#[test]
fn references_show_colours_as_they_should_be() {
    for name in ["A", "D65", "blackbody(3500)", "D(5600)"] {
        let found = evaluate(&(fine_light(name).unwrap() * 7.0)).unwrap();
        assert!(found.rf > 99.9 && (found.rg - 100.0).abs() < 0.05, "{name}: {found:?}");
        for (i, bin) in found.bins.iter().enumerate() {
            let (sin, cos) = HueBin::middle_deg(i).to_radians().sin_cos();
            assert!((bin.vector[0] - cos).abs() < 2e-3 && (bin.vector[1] - sin).abs() < 2e-3);
        }
        assert_eq!(found.bins.iter().map(|bin| bin.samples).sum::<usize>(), SAMPLES);
    }
    // Between 4000 and 5000 K the reference is a mixture, which is itself.
    let mixed = reference(4500.0).unwrap();
    assert!(evaluate(&mixed).unwrap().rf > 99.9);
}

#[test]
fn lights_without_a_reference_are_refused() {
    assert_eq!(evaluate(&FineSpectrum::from_fn(|_| 0.0)), Err(RenderingError::Unseen));
    assert!(matches!(
        evaluate(&fine_light("blackbody(60000)").unwrap()),
        Err(RenderingError::NoDaylight { .. })
    ));
}
