//! Gauss quadrature for a weight given at points, which may change its sign.

/// The most nodes of a rule; more lose their meaning in rounding.
pub const MOST_NODES: usize = 8;

/// A quadrature rule: ∫ w(λ) f(λ) dλ ≈ Σ weight · f(node).
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Where to sample, in nm, increasing.
    pub nodes_nm: Vec<f64>,
    /// What the samples count.
    pub weights: Vec<f64>,
}

/// Why a weight has no Gauss rule.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum GaussError {
    /// A number of nodes that is not offered.
    #[error("expected 1 to {MOST_NODES} nodes, found {0}")]
    Count(usize),
    /// A weight that changes its sign need not have orthogonal polynomials.
    #[error("the weight has no orthogonal polynomial of degree {0}: its square integrates to 0")]
    Degenerate(usize),
    /// Nor need their zeros be real.
    #[error("expected {expected} nodes within the weight's wavelengths, found {found}")]
    NotReal {
        /// How many were asked for.
        expected: usize,
        /// How many there are.
        found: usize,
    },
}

/// The Gauss rule of `count` nodes for the weight given at these wavelengths; it is exact for polynomials
/// up to degree 2 `count` − 1, summed over the points.
///
/// After Golub and Welsch (1969): the recurrence of the orthogonal polynomials (Stieltjes), its Jacobi
/// matrix, whose eigenvalues are the nodes, and the weights from its last polynomial. For a weight that
/// changes its sign, as C1 does, the matrix is not symmetric; its eigenvalues are found as what they also
/// are, the zeros of the polynomial of degree `count`.
///
/// # Errors
///
/// A count that is not offered, or a weight that has no such rule.
pub fn gauss(points: &[(f64, f64)], count: usize) -> Result<Rule, GaussError> {
    if !(1..=MOST_NODES).contains(&count) {
        return Err(GaussError::Count(count));
    }
    let scale = Scale::of(points);
    let measure: Vec<_> = points.iter().map(|(nm, w)| (scale.to_unit(*nm), *w)).collect();
    let polynomials = Recurrence::stieltjes(&measure, count)?;
    let zeros = polynomials.zeros();
    if zeros.len() != count {
        return Err(GaussError::NotReal { expected: count, found: zeros.len() });
    }
    let weights = zeros.iter().map(|t| polynomials.weight(*t)).collect();
    Ok(Rule { nodes_nm: zeros.into_iter().map(|t| scale.to_nm(t)).collect(), weights })
}

/// Wavelengths brought to −1 … 1, where powers do not run away.
struct Scale {
    middle: f64,
    half: f64,
}

impl Scale {
    fn of(points: &[(f64, f64)]) -> Self {
        let low = points.iter().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let high = points.iter().map(|p| p.0).fold(f64::NEG_INFINITY, f64::max);
        Self { middle: 0.5 * (low + high), half: 0.5 * (high - low) }
    }

    fn to_unit(&self, nm: f64) -> f64 {
        (nm - self.middle) / self.half
    }

    fn to_nm(&self, t: f64) -> f64 {
        self.middle + self.half * t
    }
}

/// p₀ = 1, p₍ₖ₊₁₎ = (t − αₖ) pₖ − βₖ p₍ₖ₋₁₎.
struct Recurrence {
    alpha: Vec<f64>,
    beta: Vec<f64>,
    /// ⟨p, p⟩ of the last polynomial but one.
    norm: f64,
}

impl Recurrence {
    fn stieltjes(measure: &[(f64, f64)], count: usize) -> Result<Self, GaussError> {
        let mut found = Self { alpha: Vec::new(), beta: Vec::new(), norm: 1.0 };
        for degree in 0..count {
            let (mut norm, mut first, mut size) = (0.0, 0.0, 0.0);
            for (t, weight) in measure {
                let [_, p] = found.values(*t).0;
                norm += weight * p * p;
                first += weight * p * p * t;
                size += weight.abs() * p * p;
            }
            // No more than rounding leaves of a sum that cancels.
            if norm.is_nan() || norm.abs() <= 1e-12 * size {
                return Err(GaussError::Degenerate(degree));
            }
            found.beta.push(if degree == 0 { 0.0 } else { norm / found.norm });
            found.alpha.push(first / norm);
            found.norm = norm;
        }
        Ok(found)
    }

    /// The last two polynomials at a point, and their derivatives.
    fn values(&self, t: f64) -> ([f64; 2], [f64; 2]) {
        let (mut p, mut slope) = ([0.0, 1.0], [0.0, 0.0]);
        for (alpha, beta) in self.alpha.iter().zip(&self.beta) {
            slope = [slope[1], p[1] + (t - alpha) * slope[1] - beta * slope[0]];
            p = [p[1], (t - alpha) * p[1] - beta * p[0]];
        }
        (p, slope)
    }

    /// The zeros of the last polynomial within −1 … 1.
    fn zeros(&self) -> Vec<f64> {
        // Zeros closer than 1/1000 of the range are not told apart; those of 8 nodes lie 20 times farther.
        const PIECES: usize = 2000;
        let at = |i: usize| -1.0 + 2.0 * i as f64 / PIECES as f64;
        let last = |t: f64| self.values(t).0[1];
        let changes = (0..PIECES).filter(|i| (last(at(*i)) < 0.0) != (last(at(i + 1)) < 0.0));
        changes.map(|i| bisect(at(i), at(i + 1), last)).collect()
    }

    fn weight(&self, node: f64) -> f64 {
        let ([before, _], [_, slope]) = self.values(node);
        self.norm / (slope * before)
    }
}

/// The zero of a function between two points where it has different signs.
fn bisect(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let rising = f(low) < 0.0;
    // The piece is halved until its ends are neighbouring numbers.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == rising {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
