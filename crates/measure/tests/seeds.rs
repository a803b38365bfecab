//! Tiny files of each reader, from which fuzzing begins.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use glanz_measure::{Format, Measured, PublishedFit, ReadOptions};

/// What the sniffing of contents must say of a seed.
type Expected = Option<Format>;

/// Targets with a file of each, none of them a file of readings where it holds fits.
fn samples() -> Vec<(&'static str, Vec<u8>, Expected)> {
    let texts = [
        (
            "csv",
            Format::Csv,
            "# quantity pi_f\ntheta_i_deg,phi_i_deg,theta_o_deg,phi_o_deg,r,g,b,weight\n30,180,20,0,0.3,0.2,0.1,2\n",
        ),
        ("csv", Format::Csv, "AOI;theta_o;450nm;550nm\n45;0;0,25;0,5\n45;30;;0,5\n"),
        (
            "astm",
            Format::Astm,
            "ASTM E1392\r\nCOMMENT \"paint\"\r\nNUM_POINTS 1\r\nVARS theta_i,phi_i,theta_s,phi_s,R,G,B\r\n0.5,3.14,0.5,0.0,0.5,0.4,0.3\r\n",
        ),
        ("astm", Format::Astm, "VARS theta_i,phi_i,theta_s,465nm,525nm\n0.5,3.14159265,0.5,0.2,0.3\n"),
        (
            "zemax",
            Format::Zemax,
            "Symmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType BRDF\nSampleRotation 1\n0\nAngleOfIncidence 2\n0 60\n\
             ScatterAzimuth 2\n0 180\nScatterRadial 2\n0 20\nMonochrome\nDataBegin\nTIS 0.1\n1 2\n3 4\nTIS 0.2\n1 2\n3 4\nDataEnd\n",
        ),
        (
            "lighttools",
            Format::LightTools,
            "Symmetry Asymmetric\nSpectralContent XYZ\nScatterAzimuth 2\n0 180\nScatterRadial 2\n0 40\nDataBegin\nAOI 0\nPOI 0\nSide Front\n\
             TristimulusValue TrisX\nScatterType BRDF\nTIS 0.5\n1 2\n3 4\nDataEnd\n",
        ),
        (
            "lighttools",
            Format::LightTools,
            "SpectralContent Monochrome\nScatterAzimuth 2\n0 180\nScatterRadial 2\n0 40\nDataBegin\nAOI 0\nPOI 0\nSide Front\n\
             Wavelength 550\nScatterType BRDF\nTIS 0.5\n1 2\n3 4\nDataEnd\n",
        ),
        (
            "pab",
            Format::Pab,
            "#sample_name \"film\"\n#intheta 30\n#inphi 0\n#upphi 90\n#format: theta phi DSF\n30 180 0.5\n60 0 0.25\n",
        ),
        (
            "pab",
            Format::Pab,
            "#colorimetry: CIE-XYZ\n#format: theta phi BSDF\n#incident_angle 150 10\n120 0 1 2 3\n",
        ),
        (
            "alta",
            Format::Alta,
            "#DIM 2 3\n#PARAM_IN RUSIN_TH_TD\n#PARAM_OUT INV_STERADIAN\n#VS 1\n0 0.4 1 2 3\n",
        ),
        (
            "ssdd",
            Format::Ssdd,
            "VERSION 0.3\nDATA_TYPE brdf\nCOLOR_MODEL monochrome\nPARAM_TYPE half_difference_coordinate_system\n\
             REDUCTION_TYPE bilateral_symmetry reciprocity\nPARAM0_LIST 0 90\nPARAM2_LIST 0 90\nPARAM3_LIST 0 90\nDATA ascii\n1\n2\n1\n2\n1\n2\n1\n2\n",
        ),
    ];
    let mut all: Vec<_> = texts
        .into_iter()
        .map(|(name, format, text)| (name, text.as_bytes().to_vec(), Some(format)))
        .collect();
    let matrix = format!("<IncidentDataStructure>Columns</IncidentDataStructure>{RINGS}");
    let xyz = ["Visible", "CIE-X", "CIE-Z"];
    all.push(("klems", xml(&matrix, BASIS, &xyz, "1, 2,\n3, 4,\n").into_bytes(), Some(Format::Klems)));
    let tree = "<IncidentDataStructure>TensorTree3</IncidentDataStructure>";
    let numbers = "{{1}{2}{3}{4}{5}{6}{7}{8 9 10 11 12 13 14 15}}";
    all.push(("tensor_tree", xml(tree, "", &["Visible"], numbers).into_bytes(), Some(Format::TensorTree)));
    let mut binary =
        b"#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n#FORMAT binary\n#SAMPLE_COUNT 1\n#ALTA_END_HEADER\n"
            .to_vec();
    [0.3_f64, 0.1, 2.0, 0.5].iter().for_each(|x| binary.extend(x.to_le_bytes()));
    all.push(("alta", binary, Some(Format::Alta)));
    all.push(("csail", csail(), Some(Format::Csail)));
    all.push(("rgl", rgl(), Some(Format::Rgl)));
    // Of formats whose files have one length a few numbers, which the targets repeat.
    let numbers: Vec<u8> = [150.0_f64, 1e-3, -1.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    all.push(("merl", numbers.clone(), None));
    all.push(("utia", numbers, None));
    let fit = "# x\na = Aggregate(Lambertian(albedo = [0.1, 0.2, 0.3]), NganWard(albedo = [1, 2, 3], roughness = 0.1))\n";
    all.push(("bbm_fit", fit.as_bytes().to_vec(), None));
    all
}

/// A division of two rings, of a patch each.
const RINGS: &str = "<AngleBasis><AngleBasisName>two</AngleBasisName>\
    <AngleBasisBlock><Theta>0</Theta><nPhis>1</nPhis><ThetaBounds><LowerTheta>0</LowerTheta><UpperTheta>30</UpperTheta></ThetaBounds></AngleBasisBlock>\
    <AngleBasisBlock><Theta>60</Theta><nPhis>1</nPhis><ThetaBounds><LowerTheta>30</LowerTheta><UpperTheta>90</UpperTheta></ThetaBounds></AngleBasisBlock>\
    </AngleBasis>";
const BASIS: &str = "<ColumnAngleBasis>two</ColumnAngleBasis><RowAngleBasis>two</RowAngleBasis>";

fn xml(definition: &str, basis: &str, wavelengths: &[&str], numbers: &str) -> String {
    let block = |wavelength: &&str| {
        format!(
            "<WavelengthData><Wavelength unit=\"Integral\">{wavelength}</Wavelength><WavelengthDataBlock>\
             <WavelengthDataDirection>Reflection Back</WavelengthDataDirection>{basis}\
             <ScatteringData>{numbers}</ScatteringData></WavelengthDataBlock></WavelengthData>"
        )
    };
    let blocks: String = wavelengths.iter().map(block).collect();
    format!(
        "<?xml version=\"1.0\"?>\n<WindowElement><Optical><Layer><DataDefinition>{definition}</DataDefinition>{blocks}</Layer>\
         </Optical></WindowElement>\n"
    )
}

/// Two cells along each angle.
fn csail() -> Vec<u8> {
    let head = [2, 2, 2, 2, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, 0, 0];
    let mut bytes: Vec<u8> = head.iter().flat_map(|x: &i32| x.to_le_bytes()).collect();
    (0..48).for_each(|n| bytes.extend((n as f32 - 1.0).to_le_bytes()));
    bytes
}

/// Two angles of the light, tables of 2 × 2.
fn rgl() -> Vec<u8> {
    let floats = |values: &[f32]| values.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let ones = |count: usize| floats(&vec![1.0; count]);
    let fields: [(&str, u8, &[u64], Vec<u8>); 9] = [
        ("version", 1, &[2], vec![1, 0]),
        ("description", 1, &[4], b"grey".to_vec()),
        ("phi_i", 10, &[1], floats(&[0.0])),
        ("theta_i", 10, &[2], floats(&[0.0, 1.57])),
        ("sigma", 10, &[2, 2], ones(4)),
        ("ndf", 10, &[2, 2], ones(4)),
        ("vndf", 10, &[1, 2, 2, 2], ones(8)),
        ("rgb", 10, &[1, 2, 3, 2, 2], ones(24)),
        ("jacobian", 1, &[1], vec![1]),
    ];
    let luminance: (&str, u8, &[u64], Vec<u8>) = ("luminance", 10, &[1, 2, 2, 2], ones(8));
    let fields: Vec<_> = fields.into_iter().chain([luminance]).collect();
    let size: usize =
        fields.iter().map(|(name, _, shape, _)| 2 + name.len() + 2 + 1 + 8 + 8 * shape.len()).sum();
    let (mut head, mut data) = (b"tensor_file\0\x01\x00".to_vec(), Vec::new());
    head.extend((fields.len() as u32).to_le_bytes());
    let begin = (head.len() + size).next_multiple_of(8);
    for (name, kind, shape, bytes) in &fields {
        head.extend((name.len() as u16).to_le_bytes());
        head.extend(name.as_bytes());
        head.extend((shape.len() as u16).to_le_bytes());
        head.push(*kind);
        head.extend(((begin + data.len()) as u64).to_le_bytes());
        shape.iter().for_each(|n| head.extend(n.to_le_bytes()));
        data.extend(bytes);
        data.resize(data.len().next_multiple_of(8), 0);
    }
    head.resize(begin, 0);
    head.extend(data);
    head
}

#[test]
fn seeds_are_files_of_their_readers() {
    for (name, bytes, expected) in samples() {
        if let Some(format) = expected {
            let read = Measured::read(&bytes, name, &ReadOptions::default());
            let measured = read.unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(measured.format, format);
            assert!(!measured.readings().is_empty(), "{name}");
        }
    }
    let fits = samples().into_iter().find(|(name, ..)| *name == "bbm_fit").unwrap().1;
    assert_eq!(PublishedFit::read(std::str::from_utf8(&fits).unwrap()).unwrap().len(), 1);
}

#[test]
#[ignore = "writes the seeds of the fuzz targets to fuzz/seeds"]
fn write_fuzz_seeds() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/seeds");
    for (number, (name, bytes, _)) in samples().into_iter().enumerate() {
        let target = folder.join(format!("measure_{name}"));
        std::fs::create_dir_all(&target).unwrap();
        std::fs::write(target.join(number.to_string()), bytes).unwrap();
    }
}
