//! Matrices over Klems' patches.

use glanz_math::Vec3;
use roxmltree::Node;

use super::patches::Patches;
use super::{Block, at, element, line_of_text, words, xyz_of_yuv};
use crate::format::{LEAST_COSINE, text};
use crate::{Channels, Quantity, ReadError, Readings, WriteError};

/// Pairs of directions in a pair of patches of which the mean is taken.
const SAMPLES: usize = 64;

/// A matrix of means over patches of the hemisphere: as many columns as there are patches of the light.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Channels, Klems, Measured, write_klems};
///
/// let white = Klems::of_function(Channels::Luminance, &mut |_, _| vec![0.3]);
/// let again = Measured::read(write_klems(&white, "white")?.as_bytes(), "white.xml", &Default::default())?;
/// let at = |theta: f64| Vec3::from_angles(theta, 0.0);
/// let value = again.value(at(0.5), at(0.8)).expect("both are above the horizon");
/// assert!((value[0] - 0.3).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Klems {
    channels: Channels,
    quantity: Quantity,
    /// Of the light, whose patch k looks to (−x, −y, z) of the detector's.
    light: Patches,
    detector: Patches,
    /// Channel by channel, row by row; a row is a patch of the detector.
    values: Vec<f32>,
}

impl Klems {
    pub(super) fn read(
        definition: Node,
        is_by_rows: bool,
        channels: Channels,
        blocks: &[Block],
        quantity: Quantity,
    ) -> Result<Self, ReadError> {
        let first = blocks.first().ok_or_else(|| ReadError::broken("there are no numbers"))?.node;
        let basis = |name: &str| Patches::named(definition, words(element(first, name)?));
        let (light, detector) = (basis("ColumnAngleBasis")?, basis("RowAngleBasis")?);
        let (columns, rows) = (light.len(), detector.len());
        let mut values = Vec::new();
        for block in blocks {
            let data = element(block.node, "ScatteringData")?;
            let numbers = numbers(data)?;
            if numbers.len() != columns.saturating_mul(rows) {
                let message = format!("expected {rows} × {columns} numbers, found {}", numbers.len());
                return Err(at(data, message));
            }
            match is_by_rows {
                true => values.extend((0..rows * columns).map(|i| numbers[i % columns * rows + i / columns])),
                false => values.extend(numbers),
            }
        }
        Ok(Self { channels, quantity, light, detector, values })
    }

    /// With X, Y and Z in place of Y, u′ and v′.
    pub(super) fn of_yuv(mut self, is_yuv: bool) -> Self {
        let n = self.values.len() / 3;
        for i in (0..n).take_while(|_| is_yuv) {
            let yuv = [0, 1, 2].map(|c| f64::from(self.values[c * n + i]));
            xyz_of_yuv(yuv).iter().enumerate().for_each(|(c, value)| self.values[c * n + i] = *value as f32);
        }
        self
    }

    /// A matrix of a function over Klems' full division of 145 patches: `f` gives the BRDF in 1/sr, one number per
    /// channel, for a direction to the light and one to the detector. Each element is the mean of 64 pairs of directions.
    pub fn of_function(channels: Channels, f: &mut dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64>) -> Self {
        let patches = Patches::full();
        let (n, count) = (patches.len(), channels.count());
        let mut values = vec![0.0; n * n * count];
        for row in 0..n {
            for column in 0..n {
                let mut sum = vec![0.0; count];
                for sample in 0..SAMPLES {
                    let [a, b, c, d] = spread(sample);
                    let wi = opposite(patches.direction(column, [a, b]));
                    let all = f(wi, patches.direction(row, [c, d]));
                    sum.iter_mut().zip(all).for_each(|(sum, value)| *sum += value);
                }
                for (channel, sum) in sum.iter().enumerate() {
                    values[(channel * n + row) * n + column] = (sum / SAMPLES as f64) as f32;
                }
            }
        }
        Self { channels, quantity: Quantity::Brdf, light: patches.clone(), detector: patches, values }
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// The BRDF of the patches that a pair of directions lies in, one number per channel; nothing below the horizon.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return None;
        }
        let (column, row) = (self.light.find(opposite(wi))?, self.detector.find(wo)?);
        self.element(row, column, wo.z.max(LEAST_COSINE))
    }

    fn element(&self, row: usize, column: usize, cos_o: f64) -> Option<Vec<f64>> {
        let (columns, rows) = (self.light.len(), self.detector.len());
        let at = |channel: usize| self.values[(channel * rows + row) * columns + column];
        (0..self.channels.count()).map(|c| self.quantity.brdf(f64::from(at(c)), cos_o)).collect()
    }

    /// The readings in the middle of all pairs of patches.
    pub(crate) fn readings(&self) -> Readings {
        let mut readings = Readings::new(self.channels.clone());
        for column in 0..self.light.len() {
            let wi = opposite(self.light.middle(column));
            for row in 0..self.detector.len() {
                let wo = self.detector.middle(row);
                if let Some(value) = self.element(row, column, wo.z.max(LEAST_COSINE)) {
                    readings.push(wi, wo, &value.iter().map(|value| *value as f32).collect::<Vec<f32>>());
                }
            }
        }
        readings
    }
}

/// The numbers of an element.
fn numbers(data: Node) -> Result<Vec<f32>, ReadError> {
    let first = line_of_text(data);
    let mut numbers = Vec::new();
    for (number, line) in (first..).zip(data.text().unwrap_or_default().lines()) {
        // In XML a comma stands between numbers.
        for value in text::row(number, &line.replace(',', " "))? {
            numbers.push(value as f32);
        }
    }
    Ok(numbers)
}

fn opposite(w: Vec3<f64>) -> Vec3<f64> {
    Vec3::new(-w.x, -w.y, w.z)
}

/// A point of the unit cube in four dimensions, of a sequence that fills it evenly (M. Roberts, The Unreasonable
/// Effectiveness of Quasirandom Sequences, 2018: powers of the root of x⁵ = x + 1).
fn spread(sample: usize) -> [f64; 4] {
    const ROOT: f64 = 1.167_303_978_261_418_6;
    let mut step = 1.0;
    [0; 4].map(|_: i32| {
        step /= ROOT;
        let at = 0.5 + step * (sample as f64 + 1.0);
        at - libm::floor(at)
    })
}

/// The XML of a matrix, as Radiance and WINDOW read it: `Reflection Back`, for all light, and X and Z beside it where there
/// are tristimulus values.
///
/// # Errors
///
/// [`WriteError`] where the channels are others than one or XYZ.
pub fn write_klems(table: &Klems, name: &str) -> Result<String, WriteError> {
    let parts: &[(&str, usize)] = match &table.channels {
        Channels::Luminance => &[("Visible", 0)],
        Channels::Xyz => &[("Visible", 1), ("CIE-X", 0), ("CIE-Z", 2)],
        other => {
            return Err(WriteError::Channels {
                format: "Klems",
                expected: "one or XYZ",
                found: other.to_string(),
            });
        }
    };
    let mut xml = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\">\n",
    );
    xml += "<WindowElementType>System</WindowElementType>\n<FileType>BSDF</FileType>\n<Optical>\n<Layer>\n";
    xml += &format!("<Material><Name>{}</Name><Manufacturer>Glanz</Manufacturer>", escaped(name));
    xml += "<DeviceType>Other</DeviceType></Material>\n";
    xml += "<DataDefinition>\n<IncidentDataStructure>Columns</IncidentDataStructure>\n";
    xml += &basis(&table.light);
    if table.detector != table.light {
        xml += &basis(&table.detector);
    }
    xml += "</DataDefinition>\n";
    for (wavelength, channel) in parts {
        block(&mut xml, table, wavelength, *channel);
    }
    xml += "</Layer>\n</Optical>\n</WindowElement>\n";
    Ok(xml)
}

fn escaped(words: &str) -> String {
    words.trim().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace(['\n', '\r'], " ")
}

fn basis(patches: &Patches) -> String {
    let mut xml = format!("<AngleBasis><AngleBasisName>{}</AngleBasisName>\n", escaped(&patches.name));
    for ring in &patches.rings {
        let [low, high] = ring.theta.map(|theta| (theta.to_degrees() * 1e9).round() / 1e9);
        let middle = if ring.count == 1 { low } else { 0.5 * (low + high) };
        xml += &format!("<AngleBasisBlock><Theta>{middle}</Theta><nPhis>{}</nPhis>", ring.count);
        xml += &format!(
            "<ThetaBounds><LowerTheta>{low}</LowerTheta><UpperTheta>{high}</UpperTheta></ThetaBounds>"
        );
        xml += "</AngleBasisBlock>\n";
    }
    xml + "</AngleBasis>\n"
}

fn block(xml: &mut String, table: &Klems, wavelength: &str, channel: usize) {
    let (columns, rows) = (table.light.len(), table.detector.len());
    *xml += "<WavelengthData>\n<LayerNumber>System</LayerNumber>\n";
    *xml += &format!("<Wavelength unit=\"Integral\">{wavelength}</Wavelength>\n");
    *xml += "<SourceSpectrum>CIE Illuminant D65 1nm.ssp</SourceSpectrum>\n";
    *xml += "<DetectorSpectrum>ASTM E308 1931 Y.dsp</DetectorSpectrum>\n<WavelengthDataBlock>\n";
    *xml += "<WavelengthDataDirection>Reflection Back</WavelengthDataDirection>\n";
    *xml += &format!("<ColumnAngleBasis>{}</ColumnAngleBasis>\n", escaped(&table.light.name));
    *xml += &format!("<RowAngleBasis>{}</RowAngleBasis>\n", escaped(&table.detector.name));
    *xml += "<ScatteringDataType>BRDF</ScatteringDataType>\n<ScatteringData>\n";
    for row in 0..rows {
        let middle = table.detector.middle(row);
        let of = |column: usize| {
            let value = f64::from(table.values[(channel * rows + row) * columns + column]);
            (table.quantity.brdf(value, middle.z.max(LEAST_COSINE)).unwrap_or(0.0) as f32).to_string()
        };
        *xml += &(0..columns).map(of).collect::<Vec<String>>().join(",\t");
        *xml += ",\n";
    }
    *xml += "</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n";
}
