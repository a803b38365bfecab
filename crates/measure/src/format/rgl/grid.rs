//! Tables over the unit square, one for each of some parameters, between which they are mixed linearly.

/// A table for every setting of the parameters: rows by y, columns by x, nodes at the corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    width: usize,
    height: usize,
    /// The values of each parameter, the first varying most slowly.
    parameters: Vec<Vec<f32>>,
    values: Vec<f32>,
}

/// A table of which places can be told by the share of the whole that lies before them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Warp {
    grid: Grid,
    /// Integrals along each row up to a node, and of rows up to one.
    conditional: Vec<f32>,
    marginal: Vec<f32>,
}

/// Tables that count, and their weights: two per parameter.
type Mix = Vec<(usize, f32)>;

impl Grid {
    /// Nothing if there are not as many numbers as nodes, or fewer than 2 × 2.
    pub(super) fn new(
        [width, height]: [usize; 2],
        parameters: Vec<Vec<f32>>,
        values: Vec<f32>,
    ) -> Option<Self> {
        let tables: usize = parameters.iter().map(Vec::len).product();
        let is_whole = width > 1 && height > 1 && values.len() == tables * width * height;
        (is_whole && tables > 0).then_some(Self { width, height, parameters, values })
    }

    pub(super) fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// The tables between which a setting lies.
    pub(super) fn mix(&self, at: &[f32]) -> Mix {
        let mut mix = vec![(0, 1.0)];
        for (list, at) in self.parameters.iter().zip(at) {
            // The last node that is not beyond it, but not the last of all.
            let index =
                list.partition_point(|own| own <= at).saturating_sub(1).min(list.len().saturating_sub(2));
            let part = match list.get(index..index + 2) {
                Some([low, high]) => ((at - low) / (high - low)).clamp(0.0, 1.0),
                _ => 0.0,
            };
            mix = mix
                .into_iter()
                .flat_map(|(table, weight)| {
                    let table = table * list.len() + index;
                    [(table, weight * (1.0 - part)), (table + 1, weight * part)]
                })
                .filter(|(_, weight)| *weight > 0.0)
                .collect();
        }
        mix
    }

    fn mixed(&self, of: &[f32], per_table: usize, at: usize, mix: &Mix) -> f32 {
        mix.iter().map(|(table, weight)| of[table * per_table + at] * weight).sum()
    }

    fn node(&self, x: usize, y: usize, mix: &Mix) -> f32 {
        self.mixed(&self.values, self.width * self.height, y * self.width + x, mix)
    }

    /// Node and part of the way to the next, along x and y.
    fn place(&self, at: [f32; 2]) -> ([usize; 2], [f32; 2]) {
        let along = |at: f32, n: usize| {
            let scaled = at.clamp(0.0, 1.0) * (n - 1) as f32;
            let node = (scaled as usize).min(n - 2);
            (node, scaled - node as f32)
        };
        let ((x, u), (y, v)) = (along(at[0], self.width), along(at[1], self.height));
        ([x, y], [u, v])
    }

    /// The value at a place, linear between nodes.
    pub(super) fn at(&self, at: [f32; 2], mix: &Mix) -> f32 {
        let ([x, y], [u, v]) = self.place(at);
        let row = |y: usize| self.node(x, y, mix) * (1.0 - u) + self.node(x + 1, y, mix) * u;
        row(y) * (1.0 - v) + row(y + 1) * v
    }
}

impl Warp {
    pub(super) fn new(mut grid: Grid) -> Self {
        let (w, h) = (grid.width, grid.height);
        let tables = grid.values.len() / (w * h);
        let (mut conditional, mut marginal) = (vec![0.0; grid.values.len()], vec![0.0; tables * h]);
        for table in 0..tables {
            let values = &mut grid.values[table * w * h..(table + 1) * w * h];
            let rows = &mut conditional[table * w * h..(table + 1) * w * h];
            let ends = &mut marginal[table * h..(table + 1) * h];
            // Sums in f64, as the tables are made elsewhere.
            for y in 0..h {
                let mut sum = 0.0_f64;
                for x in 1..w {
                    sum += 0.5 * (f64::from(values[y * w + x - 1]) + f64::from(values[y * w + x]));
                    rows[y * w + x] = sum as f32;
                }
            }
            let mut sum = 0.0_f64;
            for y in 1..h {
                sum += 0.5 * (f64::from(rows[y * w - 1]) + f64::from(rows[(y + 1) * w - 1]));
                ends[y] = sum as f32;
            }
            let scale = if sum > 0.0 { (1.0 / sum) as f32 } else { 0.0 };
            values.iter_mut().chain(rows.iter_mut()).chain(ends.iter_mut()).for_each(|value| *value *= scale);
        }
        Self { grid, conditional, marginal }
    }

    pub(super) fn grid(&self) -> &Grid {
        &self.grid
    }

    /// The place in the square of even probability that belongs to a place of the table, and the density there.
    pub(super) fn invert(&self, at: [f32; 2], mix: &Mix) -> ([f32; 2], f32) {
        let grid = &self.grid;
        let ([x, y], [u, v]) = grid.place(at);
        let cell = grid.width * grid.height;
        let column = |x: usize| grid.node(x, y, mix) * (1.0 - v) + grid.node(x, y + 1, mix) * v;
        let (c0, c1) = (column(x), column(x + 1));
        let density = c0 * (1.0 - u) + c1 * u;
        let row = |x: usize, y: usize| grid.mixed(&self.conditional, cell, y * grid.width + x, mix);
        let before = row(x, y) * (1.0 - v) + row(x, y + 1) * v;
        let (r0, r1) = (row(grid.width - 1, y), row(grid.width - 1, y + 1));
        let whole = r0 * (1.0 - v) + r1 * v;
        let s = if whole > 0.0 { (u * (c0 + 0.5 * u * (c1 - c0)) + before) / whole } else { 0.0 };
        let t = v * (r0 + 0.5 * v * (r1 - r0)) + grid.mixed(&self.marginal, grid.height, y, mix);
        let [w, h] = [grid.width - 1, grid.height - 1].map(|n| n as f32);
        ([s, t], density * w * h)
    }

    /// The place of the table that belongs to one in the square of even probability: [`Self::invert`] the other way.
    pub(super) fn place(&self, [s, t]: [f32; 2], mix: &Mix) -> [f32; 2] {
        let grid = &self.grid;
        let (w, h) = (grid.width, grid.height);
        let row_end = |y: usize| grid.mixed(&self.conditional, w * h, y * w + w - 1, mix);
        let marginal = |y: usize| grid.mixed(&self.marginal, h, y, mix);
        let y = (1..h - 1).take_while(|y| marginal(*y) <= t).count();
        let v = solved(t - marginal(y), row_end(y), row_end(y + 1));
        let along = |x: usize| {
            let of = |y: usize| grid.mixed(&self.conditional, w * h, y * w + x, mix);
            of(y) * (1.0 - v) + of(y + 1) * v
        };
        let s = s * along(w - 1);
        let x = (1..w - 1).take_while(|x| along(*x) <= s).count();
        let column = |x: usize| grid.node(x, y, mix) * (1.0 - v) + grid.node(x, y + 1, mix) * v;
        let u = solved(s - along(x), column(x), column(x + 1));
        [(x as f32 + u) / (w - 1) as f32, (y as f32 + v) / (h - 1) as f32]
    }
}

/// The x of 0 … 1 up to which a line from `a` to `b` has the integral `area`.
fn solved(area: f32, a: f32, b: f32) -> f32 {
    let root = (a * a + 2.0 * area * (b - a)).max(0.0).sqrt();
    let x = if a + root > 0.0 { 2.0 * area / (a + root) } else { 0.0 };
    x.clamp(0.0, 1.0)
}
