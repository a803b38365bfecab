//! Radiance's XML: matrices over Klems' patches and tensor trees.

use glanz_math::Vec3;
use glanz_measure::{Channels, Data, Format, Klems, Measured, ReadError, ReadOptions, write_klems};
use proptest::prelude::*;

fn at(theta_deg: f64, phi_deg: f64) -> Vec3<f64> {
    Vec3::from_angles(theta_deg.to_radians(), phi_deg.to_radians())
}

fn read(text: &str) -> Result<Measured, ReadError> {
    Measured::read(text.as_bytes(), "a.xml", &ReadOptions::default())
}

/// A file with blocks: the range of wavelengths, the part and the numbers.
fn file(structure: &str, definition: &str, basis: &str, blocks: &[(&str, &str, &str)]) -> String {
    let mut xml = format!(
        "<?xml version=\"1.0\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\"><Optical><Layer>\n\
         <Material><Name>grey</Name></Material><DataDefinition>\n\
         <IncidentDataStructure>{structure}</IncidentDataStructure>{definition}</DataDefinition>\n"
    );
    for (wavelength, direction, numbers) in blocks {
        xml += &format!(
            "<WavelengthData><Wavelength unit=\"Integral\">{wavelength}</Wavelength><WavelengthDataBlock>\n\
             <WavelengthDataDirection>{direction}</WavelengthDataDirection>{basis}\n\
             <ScatteringData>\n{numbers}\n</ScatteringData></WavelengthDataBlock></WavelengthData>\n"
        );
    }
    xml + "</Layer></Optical></WindowElement>\n"
}

/// A division of two rings, of one patch and of four.
const RINGS: &str = "<AngleBasis><AngleBasisName>two</AngleBasisName>\
    <AngleBasisBlock><Theta>0</Theta><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta><UpperTheta>30</UpperTheta></ThetaBounds></AngleBasisBlock>\
    <AngleBasisBlock><Theta>60</Theta><ThetaBounds><LowerTheta>30</LowerTheta><UpperTheta>90</UpperTheta></ThetaBounds><nPhis>4</nPhis></AngleBasisBlock>\
    </AngleBasis>";
const BASIS: &str = "<ColumnAngleBasis>two</ColumnAngleBasis><RowAngleBasis>two</RowAngleBasis>";

/// The row before the point, the column behind it.
fn numbers() -> String {
    (0..5).map(|row| (0..5).map(|column| format!("{row}.{column}, ")).collect::<String>() + "\n").collect()
}

#[test]
fn a_klems_matrix_is_read_as_it_was_written() {
    let f = |wi: Vec3<f64>, wo: Vec3<f64>| {
        let half = (wi + wo).normalized();
        let slope = (half.x * half.x + 9.0 * half.y * half.y) / (half.z * half.z);
        let value = 0.05 + libm::exp(-slope / 0.1);
        vec![0.9 * value, value, 1.1 * value]
    };
    let table = Klems::of_function(Channels::Xyz, &mut |wi, wo| f(wi, wo));
    let xml = write_klems(&table, "a <paint> & more").unwrap();
    let measured = read(&xml).unwrap();
    assert_eq!((measured.format, measured.description.as_str()), (Format::Klems, "a <paint> & more"));
    let Data::Klems(again) = &measured.data else { panic!("it is a matrix") };
    assert_eq!((&**again, write_klems(again, "a <paint> & more").unwrap()), (&table, xml));
    // In the middle of patches that are small against the highlight, the mean is about the value.
    let (wi, wo) = (at(40.0, 195.0), at(40.0, 0.0));
    let (got, want) = (measured.value(wi, wo).unwrap(), f(wi, wo));
    assert!((0..3).all(|c| (got[c] / want[c] - 1.0).abs() < 0.15), "{got:?} {want:?}");
    // Means of a reciprocal function are reciprocal, but for the points that are taken.
    let (a, b) =
        (measured.value(at(40.0, 195.0), at(60.0, 30.0)), measured.value(at(60.0, 30.0), at(40.0, 195.0)));
    assert!((a.unwrap()[1] / b.unwrap()[1] - 1.0).abs() < 0.1);
    assert_eq!(measured.readings().len(), 145 * 145);
    let rgb = Klems::of_function(Channels::Rgb, &mut |_, _| vec![0.1; 3]);
    assert_eq!(
        write_klems(&rgb, "").unwrap_err().to_string(),
        "Klems files have one or XYZ channels, and these data have RGB"
    );
}

#[test]
fn rows_are_patches_of_the_detector() {
    let xml = file("Columns", RINGS, BASIS, &[("Visible", "Reflection Back", &numbers())]);
    let measured = read(&xml).unwrap();
    let value = |wi, wo| measured.value(wi, wo).map(|value: Vec<f64>| (value[0] * 10.0).round() / 10.0);
    assert_eq!((measured.format, value(at(10.0, 7.0), at(10.0, 99.0))), (Format::Klems, Some(0.0)));
    // The first patch of a ring lies about azimuth 0; light of that number comes from the other side.
    assert_eq!(value(at(10.0, 0.0), at(60.0, 40.0)), Some(1.0));
    assert_eq!(value(at(10.0, 0.0), at(60.0, 50.0)), Some(2.0));
    assert_eq!(value(at(60.0, 180.0), at(60.0, 0.0)), Some(1.1));
    assert_eq!(value(at(60.0, -90.0), at(60.0, -80.0)), Some(4.2));
    let turned = read(&xml.replace("Columns", "Rows")).unwrap();
    let flipped = turned.value(at(60.0, -90.0), at(60.0, -80.0)).unwrap()[0];
    assert!((flipped - 2.4).abs() < 1e-6);
}

#[test]
fn one_side_and_visible_light_are_chosen() {
    let grey = |value: &str| vec![value; 25].join(" ");
    let (a, b, c) = (grey("0.1"), grey("0.2"), grey("0.3"));
    let blocks = |names: [&'static str; 3]| {
        file(
            "Columns",
            RINGS,
            BASIS,
            &[
                (names[0], "Reflection Back", &a),
                (names[1], "Reflection Back", &b),
                (names[2], "Reflection Front", &c),
                (names[2], "Transmission Back", &c),
            ],
        )
    };
    let measured = read(&blocks(["Solar", "Visible", "Visible"])).unwrap();
    let rounded = |measured: &Measured| {
        let value = measured.value(at(20.0, 0.0), at(50.0, 0.0)).unwrap();
        value.iter().map(|x| (x * 1e6).round() / 1e6).collect::<Vec<f64>>()
    };
    assert_eq!(rounded(&measured), [0.2]);
    assert_eq!(
        measured.notes,
        ["'Reflection Back' is read, Radiance's front; 'Reflection Front' is left out", "left out: Solar"]
    );
    let front =
        read(&blocks(["Solar", "Visible", "Visible"]).replace("Reflection Back", "Transmission Front"))
            .unwrap();
    assert_eq!(rounded(&front), [0.3]);
    let nm = blocks(["600", "500", "x"]).replace("Integral", "Nanometers");
    let spectrum = read(&nm).unwrap();
    assert_eq!(
        (spectrum.channels(), rounded(&spectrum)),
        (&Channels::Wavelengths(vec![500.0, 600.0]), vec![0.2, 0.1])
    );
    // Y with the chromaticity of light of equal energy: X and Z are Y.
    let yuv = file(
        "TensorTree4",
        "",
        "",
        &[
            ("CIE-u", "Reflection Back", "{0.2105263}"),
            ("Visible", "Reflection Back", "{0.5}"),
            ("CIE-v", "Reflection Back", "{0.4736842}"),
        ],
    );
    assert_eq!(rounded(&read(&yuv).unwrap()), [0.5; 3]);
    assert!(
        read(&yuv.replace("Reflection", "Transmission"))
            .unwrap_err()
            .to_string()
            .contains("no reflected light")
    );
}

#[test]
fn trees_branch_by_bits_and_grids_by_rows() {
    // Along the light's radius a branch, along the detector's square a grid.
    let branches: Vec<String> = (0..8).map(|n| format!("{{{n}}}")).collect();
    let cells: Vec<String> = (0..8).map(|n| n.to_string()).collect();
    for (tree, name) in [(branches.join(" "), "branches"), (cells.join(",\n"), "cells")] {
        let xml = file("TensorTree3", "", "", &[("Visible", "Reflection Back", &format!("{{{tree}}}"))]);
        let measured = read(&xml).unwrap();
        assert_eq!((measured.format, measured.is_isotropic()), (Format::TensorTree, true));
        // Light lies in the first half of dimension 0; y below 0 is the first half of dimension 2.
        let value = |turn: f64, wo_phi: f64| {
            measured.value(at(30.0, 180.0 + turn), at(50.0, wo_phi + turn)).unwrap()[0]
        };
        let expected = if name == "cells" { [2.0, 3.0, 0.0, 1.0] } else { [2.0, 6.0, 0.0, 4.0] };
        for turn in [0.0, 77.0] {
            let got = [-20.0, 20.0, -110.0, 160.0].map(|phi| value(turn, phi));
            assert_eq!(got, expected, "{name}");
        }
        assert_eq!(measured.readings().len(), 4);
    }
}

#[test]
fn errors_of_xml_have_their_line() {
    let wrong = |xml: &str| {
        let error = read(xml).unwrap_err();
        (error.line(), error.to_string())
    };
    let klems = file("Columns", RINGS, BASIS, &[("Visible", "Reflection Back", &numbers())]);
    assert_eq!(
        wrong(&klems.replace("2.3,", "2.3 x,")),
        (Some(10), "expected a row of numbers, found 'x'".to_owned())
    );
    assert_eq!(wrong(&klems.replace("2.3,", "")), (Some(7), "expected 5 × 5 numbers, found 24".to_owned()));
    let (line, message) = wrong(&klems.replace("BasisName>two", "BasisName>one"));
    assert_eq!(line, Some(3));
    assert!(message.starts_with("the angle basis 'two' is neither defined nor known"), "{message}");
    assert_eq!(wrong(&klems.replace("</Layer>", "")).0, Some(15));
    assert_eq!(wrong(&klems.replace("Columns", "Heaps")).0, Some(3));
    // What stands above the XML counts.
    assert_eq!(wrong(&format!("Recover using: genBSDF\n{}", klems.replace("2.3,", "2.3 x,"))).0, Some(11));
    let tree =
        |numbers: &str| wrong(&file("TensorTree4", "", "", &[("Visible", "Reflection Back", numbers)]));
    assert_eq!(
        tree("{\n1 2 3\n}"),
        (Some(10), "3 numbers are no grid of 4 dimensions: expected a power of 16".to_owned())
    );
    assert_eq!(tree("{1} 2").1, "expected the end of the numbers, found '2'");
    assert_eq!(tree("{{1} 2}").1, "expected '{', found '2'");
    assert_eq!(tree("{1").1, "expected '}', found the end");
    assert_eq!(tree(&"{".repeat(100_000)).1, "the tree is deeper than 24");
    assert!(read("<a>1</a>").is_err());
}

proptest! {
    #[test]
    fn mutated_xml_is_read_or_refused(
        is_tree in any::<bool>(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..5),
        numbers_only in any::<bool>(),
    ) {
        let xml = match is_tree {
            true => file("TensorTree3", "", "", &[("Visible", "Reflection Back", "{{1}{2}{3}{4}{5}{6}{7}{8 9 10 11 12 13 14 15}}")]),
            false => file("Columns", RINGS, BASIS, &[("Visible", "Reflection Back", &numbers())]),
        };
        let mut bytes = xml.into_bytes();
        let from = if numbers_only { bytes.len() - 200 } else { 0 };
        for (at, byte) in &changes {
            let at = from + at.index(bytes.len() - from);
            bytes[at] = if numbers_only { b" {}<>.-e9,"[usize::from(*byte) % 10] } else { *byte };
        }
        if let Ok(measured) = Measured::read(&bytes, "x", &ReadOptions::default()) {
            let readings = measured.readings();
            for index in 0..readings.len() {
                let [wi, wo] = readings.pair(index);
                let _ = measured.value(wi, wo);
            }
        }
    }
}
