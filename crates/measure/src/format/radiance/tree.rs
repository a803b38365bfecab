//! Tensor trees: cells of the light's and the detector's directions, halved where the values change.
//!
//! Directions are places in a square that Shirley and Chiu's map takes to the disc below the hemisphere. Trees of three
//! dimensions depend on differences of azimuths alone.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

use glanz_math::Vec3;

use super::{Block, element, line_of_text, xyz_of_yuv};
use crate::format::LEAST_COSINE;
use crate::{Channels, Quantity, ReadError, Readings};

/// No tree is deeper: a cell would be less than a millionth of the disc.
const MOST_DEPTH: usize = 24;

/// A tree for each channel.
///
/// ```
/// use glanz_math::Vec3;
/// use glanz_measure::{Data, Measured};
///
/// let xml = "<WindowElement><Layer><DataDefinition><IncidentDataStructure>TensorTree4</IncidentDataStructure>
///   </DataDefinition><WavelengthData><Wavelength>Visible</Wavelength><WavelengthDataBlock>
///   <WavelengthDataDirection>Reflection Back</WavelengthDataDirection><AngleBasis>LBNL/Shirley-Chiu</AngleBasis>
///   <ScatteringData>{ 0.25 }</ScatteringData></WavelengthDataBlock></WavelengthData></Layer></WindowElement>";
/// let measured = Measured::read(xml.as_bytes(), "grey.xml", &Default::default())?;
/// let Data::Tree(tree) = &measured.data else { panic!("it is a tree") };
/// let at = |theta: f64| Vec3::from_angles(theta, 0.0);
/// assert_eq!(tree.value(at(0.5), at(0.8)), Some(vec![0.25]));
/// # Ok::<(), glanz_measure::ReadError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TensorTree {
    channels: Channels,
    quantity: Quantity,
    /// Dimensions: three or four.
    dimensions: usize,
    trees: Vec<Tree>,
    /// Whether the trees are of Y, u′ and v′.
    is_yuv: bool,
}

/// A part of a tree.
#[derive(Clone, Debug, PartialEq)]
enum Tree {
    /// Halves along all dimensions: bit d of the number is the half along dimension d.
    Branches(Vec<Tree>),
    /// A grid of 2ˡᵒᵍ cells along all dimensions, the last of which varies most quickly.
    Cells { log: usize, values: Vec<f32> },
}

impl TensorTree {
    pub(super) fn read(
        dimensions: usize,
        channels: Channels,
        blocks: &[Block],
        is_yuv: bool,
        quantity: Quantity,
    ) -> Result<Self, ReadError> {
        let tree = |block: &Block| {
            let data = element(block.node, "ScatteringData")?;
            let mut reader =
                Reader { rest: data.text().unwrap_or_default(), line: line_of_text(data), dimensions };
            let tree = reader.tree(0)?;
            match reader.next() {
                Some(c) => Err(reader.wrong(&format!("expected the end of the numbers, found '{c}'"))),
                None => Ok(tree),
            }
        };
        let trees = blocks.iter().map(tree).collect::<Result<Vec<Tree>, ReadError>>()?;
        Ok(Self { channels, quantity, dimensions, trees, is_yuv })
    }

    /// What the values belong to.
    pub fn channels(&self) -> &Channels {
        &self.channels
    }

    /// Whether the values depend on differences of azimuths alone.
    pub fn is_isotropic(&self) -> bool {
        self.dimensions == 3
    }

    /// The BRDF of the cell that a pair of directions lies in, one number per channel; nothing below the horizon.
    pub fn value(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Option<Vec<f64>> {
        if wi.z <= 0.0 || wo.z <= 0.0 {
            return None;
        }
        self.at(&self.place(wi, wo), wo.z.max(LEAST_COSINE))
    }

    fn at(&self, place: &[f64], cos_o: f64) -> Option<Vec<f64>> {
        let mut values: Vec<f64> = self.trees.iter().map(|tree| f64::from(tree.at(place.to_vec()))).collect();
        if let (true, [y, u, v]) = (self.is_yuv, &values[..]) {
            values = xyz_of_yuv([*y, *u, *v]).to_vec();
        }
        values.iter().map(|value| self.quantity.brdf(*value, cos_o)).collect()
    }

    /// The place of a pair of directions in the unit cube.
    fn place(&self, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
        if self.dimensions == 4 {
            return [square(-wi.x, -wi.y), square(wo.x, wo.y)].concat();
        }
        let sin = libm::sqrt(wi.x * wi.x + wi.y * wi.y);
        let (c, s) = if sin > 0.0 { (-wi.x / sin, -wi.y / sin) } else { (1.0, 0.0) };
        let [x, y] = square(c * wo.x + s * wo.y, c * wo.y - s * wo.x);
        vec![(0.5 - 1e-9 - 0.5 * sin).max(0.0), x, y]
    }

    /// The readings in the middle of all cells of the first channel.
    pub(crate) fn readings(&self) -> Readings {
        let mut readings = Readings::new(self.channels.clone());
        let mut cells = Vec::new();
        if let Some(tree) = self.trees.first() {
            tree.cells(&vec![0.0; self.dimensions], 1.0, &mut cells);
        }
        for (low, size) in cells {
            let mut middle: Vec<f64> = low.iter().map(|x| x + 0.5 * size).collect();
            if self.dimensions == 3 {
                // Beyond one half there is no light.
                if low[0] >= 0.5 {
                    continue;
                }
                middle[0] = 0.5 * (low[0] + (low[0] + size).min(0.5));
            }
            let [wi, wo] = self.pair(&middle);
            if let Some(values) = self.at(&middle, wo.z.max(LEAST_COSINE)) {
                readings.push(wi, wo, &values.iter().map(|value| *value as f32).collect::<Vec<f32>>());
            }
        }
        readings
    }

    fn pair(&self, place: &[f64]) -> [Vec3<f64>; 2] {
        let above = |x: f64, y: f64| Vec3::new(x, y, libm::sqrt((1.0 - x * x - y * y).max(0.0)));
        match *place {
            [light, x, y] => {
                let ([x, y], sin) = (disc(x, y), 1.0 - 2.0 * light);
                [above(-sin, 0.0), above(x, y)]
            }
            [u, v, x, y] => {
                let ([u, v], [x, y]) = (disc(u, v), disc(x, y));
                [above(-u, -v), above(x, y)]
            }
            _ => unreachable!("a tree has three or four dimensions"),
        }
    }
}

impl Tree {
    fn at(&self, mut place: Vec<f64>) -> f32 {
        let mut tree = self;
        while let Self::Branches(branches) = tree {
            let mut branch = 0;
            for (dimension, x) in place.iter_mut().enumerate() {
                let half = usize::from(*x >= 0.5);
                branch |= half << dimension;
                *x = 2.0 * *x - half as f64;
            }
            tree = &branches[branch];
        }
        let Self::Cells { log, values } = tree else { return 0.0 };
        let side = 1_usize << log;
        let cell = |x: &f64| ((x * side as f64) as usize).min(side - 1);
        values[place.iter().fold(0, |index, x| (index << log) + cell(x))]
    }

    /// The least corner and the size of all cells.
    fn cells(&self, low: &[f64], size: f64, cells: &mut Vec<(Vec<f64>, f64)>) {
        match self {
            Self::Branches(branches) => {
                for (number, branch) in branches.iter().enumerate() {
                    let half = |(d, x): (usize, &f64)| x + 0.5 * size * (number >> d & 1) as f64;
                    branch.cells(&low.iter().enumerate().map(half).collect::<Vec<f64>>(), 0.5 * size, cells);
                }
            }
            Self::Cells { log, values } => {
                let (side, n) = (1_usize << log, low.len());
                let size = size / side as f64;
                for index in 0..values.len() {
                    let along = |d: usize| (index >> (log * (n - 1 - d)) & (side - 1)) as f64;
                    cells.push(((0..n).map(|d| low[d] + size * along(d)).collect(), size));
                }
            }
        }
    }
}

/// Reads braces and numbers.
struct Reader<'a> {
    rest: &'a str,
    line: u32,
    dimensions: usize,
}

impl<'a> Reader<'a> {
    fn wrong(&self, message: &str) -> ReadError {
        ReadError::at(self.line, message)
    }

    /// The next sign that is neither space nor a comma.
    fn next(&mut self) -> Option<char> {
        let rest = self.rest.trim_start_matches(|c: char| c.is_whitespace() || c == ',');
        let skipped = &self.rest[..self.rest.len() - rest.len()];
        self.line += skipped.matches('\n').count() as u32;
        self.rest = rest;
        rest.chars().next()
    }

    fn take(&mut self, sign: char) -> Result<(), ReadError> {
        match self.next() {
            Some(c) if c == sign => {
                self.rest = &self.rest[c.len_utf8()..];
                Ok(())
            }
            Some(c) => Err(self.wrong(&format!("expected '{sign}', found '{c}'"))),
            None => Err(self.wrong(&format!("expected '{sign}', found the end"))),
        }
    }

    fn tree(&mut self, depth: usize) -> Result<Tree, ReadError> {
        if depth > MOST_DEPTH {
            return Err(self.wrong(&format!("the tree is deeper than {MOST_DEPTH}")));
        }
        self.take('{')?;
        let tree = if self.next() == Some('{') {
            let branches = (0..1 << self.dimensions).map(|_| self.tree(depth + 1));
            Tree::Branches(branches.collect::<Result<Vec<Tree>, ReadError>>()?)
        } else {
            self.cells()?
        };
        self.take('}')?;
        Ok(tree)
    }

    fn cells(&mut self) -> Result<Tree, ReadError> {
        let mut values = Vec::new();
        while self.next().is_some_and(|c| c != '}' && c != '{') {
            let end = self.rest.find(|c: char| c.is_whitespace() || matches!(c, ',' | '{' | '}'));
            let (word, rest): (&'a str, &'a str) = self.rest.split_at(end.unwrap_or(self.rest.len()));
            let value = word.parse::<f32>();
            values.push(value.map_err(|_| self.wrong(&format!("expected a number, found '{word}'")))?);
            self.rest = rest;
        }
        let log = (0..=MOST_DEPTH)
            .find(|log| 1_usize.checked_shl((log * self.dimensions) as u32) == Some(values.len()));
        match log {
            Some(log) => Ok(Tree::Cells { log, values }),
            None => {
                let message = format!(
                    "{} numbers are no grid of {} dimensions: expected a power of {}",
                    values.len(),
                    self.dimensions,
                    1 << self.dimensions
                );
                Err(self.wrong(&message))
            }
        }
    }
}

/// The place in the unit square of a point of the disc (P. Shirley and K. Chiu, A Low Distortion Map Between Disk and
/// Square, 1997).
fn square(x: f64, y: f64) -> [f64; 2] {
    let r = libm::sqrt(x * x + y * y);
    let phi = libm::atan2(y, x);
    let phi = if phi < -FRAC_PI_4 { phi + TAU } else { phi };
    let quarter = |from: f64| (phi - from) * r / FRAC_PI_4;
    let (a, b) = match phi / FRAC_PI_4 {
        side if side < 1.0 => (r, quarter(0.0)),
        side if side < 3.0 => (-quarter(0.5 * PI), r),
        side if side < 5.0 => (-r, -quarter(PI)),
        _ => (quarter(1.5 * PI), -r),
    };
    [a, b].map(|x| (0.5 * (x + 1.0)).clamp(0.0, 1.0 - 1e-12))
}

/// The point of the disc of a place in the unit square.
fn disc(u: f64, v: f64) -> [f64; 2] {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let (r, phi) = if a == 0.0 && b == 0.0 {
        (0.0, 0.0)
    } else if a.abs() >= b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else {
        (b, 0.5 * PI - FRAC_PI_4 * a / b)
    };
    [r * libm::cos(phi), r * libm::sin(phi)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_square_is_the_disc() {
        for [u, v] in [[0.1, 0.2], [0.9, 0.3], [0.5, 0.8], [0.2, 0.7], [0.6, 0.1], [0.5, 0.5]] {
            let [x, y] = disc(u, v);
            let [a, b] = square(x, y);
            assert!((a - u).abs() < 1e-9 && (b - v).abs() < 1e-9, "{u} {v}: {a} {b}");
        }
        // Along x lies the middle of the right edge.
        assert!((square(1.0, 0.0)[0] - 1.0).abs() < 1e-9 && (square(1.0, 0.0)[1] - 0.5).abs() < 1e-9);
    }
}
