//! The dispersion formulas of the refractiveindex.info database.

/// Formulas of n over the wavelength λ in vacuum in µm, by their numbers in the database. Source: M. Polyanskiy,
/// "Refractiveindex.info database of optical constants", Scientific Data 11, 2024, and its document "Dispersion formulas".
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Formula {
    number: u8,
    c: Vec<f64>,
}

impl Formula {
    /// The formula of that number; `None` if there is none, or it has no coefficient.
    pub(super) fn new(number: u8, c: Vec<f64>) -> Option<Self> {
        ((1..=9).contains(&number) && !c.is_empty()).then_some(Self { number, c })
    }

    /// A coefficient from 1; 0 beyond the last.
    fn c(&self, number: usize) -> f64 {
        self.c.get(number - 1).copied().unwrap_or(0.0)
    }

    /// The sum over pairs of coefficients, from the second one on.
    fn pairs(&self, term: impl Fn(f64, f64) -> f64) -> f64 {
        self.c[1..].chunks(2).map(|pair| term(pair[0], pair.get(1).copied().unwrap_or(0.0))).sum()
    }

    /// n at a wavelength in nm; NaN where the formula has none.
    pub(super) fn at(&self, nm: f64) -> f64 {
        let um = nm * 1e-3;
        let um2 = um * um;
        let c = |number| self.c(number);
        match self.number {
            1 => (1.0 + c(1) + self.pairs(|b, r| b * um2 / (um2 - r * r))).sqrt(),
            2 => (1.0 + c(1) + self.pairs(|b, r| b * um2 / (um2 - r))).sqrt(),
            3 => (c(1) + self.pairs(|b, power| b * libm::pow(um, power))).sqrt(),
            4 => {
                let resonance = |i| c(i) * libm::pow(um, c(i + 1)) / (um2 - libm::pow(c(i + 2), c(i + 3)));
                let resonances: f64 = [2, 6].into_iter().filter(|i| c(*i) != 0.0).map(resonance).sum();
                let powers = self.c.get(9..).unwrap_or_default().chunks(2);
                let powers = powers.map(|pair| pair[0] * libm::pow(um, pair.get(1).copied().unwrap_or(0.0)));
                (c(1) + resonances + powers.sum::<f64>()).sqrt()
            }
            5 => c(1) + self.pairs(|b, power| b * libm::pow(um, power)),
            6 => 1.0 + c(1) + self.pairs(|b, r| b / (r - 1.0 / um2)),
            7 => {
                let inverse = 1.0 / (um2 - 0.028);
                c(1) + c(2) * inverse + c(3) * inverse * inverse + um2 * (c(4) + um2 * (c(5) + um2 * c(6)))
            }
            8 => {
                let ratio = c(1) + c(2) * um2 / (um2 - c(3)) + c(4) * um2;
                ((1.0 + 2.0 * ratio) / (1.0 - ratio)).sqrt()
            }
            _ => {
                let apart = um - c(5);
                (c(1) + c(2) / (um2 - c(3)) + c(4) * apart / (apart * apart + c(6))).sqrt()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(number: u8, c: &[f64], nm: f64) -> f64 {
        Formula::new(number, c.to_vec()).expect("it is known").at(nm)
    }

    #[test]
    fn the_formulas_give_the_published_indices() {
        // Schott N-BK7 by Sellmeier's formula with squared resonances: n_d = 1.5168.
        let bk7 = [0.0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653];
        assert!((at(2, &bk7, 587.56) - 1.5168).abs() < 1e-5);
        // The same with the resonances' roots.
        let root: Vec<f64> =
            bk7.iter().enumerate().map(|(i, c)| if i > 0 && i % 2 == 0 { c.sqrt() } else { *c }).collect();
        assert!((at(1, &root, 587.56) - 1.5168).abs() < 1e-5);
        // Air by P. E. Ciddor 1996: n − 1 = 2.7717e-4 at the line d, rounded to 1e-8.
        let air = [0.0, 0.05792105, 238.0185, 0.00167917, 57.362];
        assert!((at(6, &air, 587.56) - 1.000_277_17).abs() < 1e-8, "{}", at(6, &air, 587.56));
    }

    #[test]
    fn what_is_written_two_ways_is_the_same() {
        // 3 and 5 are powers of λ, of n² and of n.
        assert!((at(5, &[1.5, 0.004, -2.0], 500.0) - 1.516).abs() < 1e-12);
        assert!((at(3, &[2.25, 0.01, -2.0], 500.0) - (2.29f64).sqrt()).abs() < 1e-12);
        // 4 with a resonance of power 2 is 2 with the constant 1.
        let four = at(4, &[1.0, 1.2, 2.0, 0.1, 2.0], 600.0);
        assert!((four - at(2, &[0.0, 1.2, 0.01], 600.0)).abs() < 1e-12);
        // 4's powers come after two resonances.
        let c = [2.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, -2.0];
        assert!((at(4, &c, 500.0) - (2.29f64).sqrt()).abs() < 1e-12);
        // 7 without resonances is a polynomial of λ².
        assert!((at(7, &[1.4, 0.0, 0.0, 0.1, 0.01, 0.001], 1000.0) - 1.511).abs() < 1e-12);
        // 8: Lorentz and Lorenz's ratio of 0.25 is n = √2.
        assert!((at(8, &[0.25], 500.0) - 2f64.sqrt()).abs() < 1e-12);
        assert!((at(9, &[2.0, 0.1, 0.05, 0.0, 0.0, 1.0], 500.0) - 2.5f64.sqrt()).abs() < 1e-12);
        assert!(Formula::new(10, vec![1.0]).is_none() && Formula::new(1, Vec::new()).is_none());
    }
}
