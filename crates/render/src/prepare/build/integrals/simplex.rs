//! The least value of a function of three numbers, without its derivatives.
//!
//! Source: J. A. Nelder and R. Mead, "A Simplex Method for Function Minimization", The Computer Journal 7,
//! 1965. The libraries at hand bring random numbers along, which the browser does not have.

/// More steps than these bring nothing that `f32` could hold.
const STEPS: usize = 160;

/// Relative difference of the values below which the simplex has arrived.
const CLOSE: f64 = 1e-7;

type Corner = ([f64; 3], f64);

/// Where `f` is least, searched from `start` with first steps of this size.
pub(crate) fn minimum(f: impl Fn(&[f64; 3]) -> f64, start: [f64; 3], size: [f64; 3]) -> [f64; 3] {
    let corner = |p: [f64; 3]| (p, f(&p));
    let moved = |axis: usize| {
        let mut p = start;
        p[axis] += size[axis];
        corner(p)
    };
    let mut simplex: [Corner; 4] = [corner(start), moved(0), moved(1), moved(2)];
    for _ in 0..STEPS {
        simplex.sort_by(|a, b| a.1.total_cmp(&b.1));
        let (best, worst) = (simplex[0], simplex[3]);
        if (worst.1 - best.1).abs() <= CLOSE * best.1.abs() {
            break;
        }
        let center: [f64; 3] =
            core::array::from_fn(|i| simplex[..3].iter().map(|c| c.0[i]).sum::<f64>() / 3.0);
        let along = |t: f64| corner(core::array::from_fn(|i| center[i] + t * (worst.0[i] - center[i])));
        let reflected = along(-1.0);
        let tried = match reflected.1 {
            value if value < best.1 => {
                let expanded = along(-2.0);
                if expanded.1 < value { expanded } else { reflected }
            }
            value if value < simplex[2].1 => reflected,
            value if value < worst.1 => along(-0.5),
            _ => along(0.5),
        };
        if tried.1 < worst.1 {
            simplex[3] = tried;
            continue;
        }
        for other in &mut simplex[1..] {
            *other = corner(core::array::from_fn(|i| 0.5 * (other.0[i] + best.0[i])));
        }
    }
    simplex.sort_by(|a, b| a.1.total_cmp(&b.1));
    simplex[0].0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bottom_of_a_curved_valley_is_found() {
        // H. H. Rosenbrock 1960, in three dimensions.
        let valley = |p: &[f64; 3]| {
            let step = |a: f64, b: f64| 100.0 * (b - a * a) * (b - a * a) + (1.0 - a) * (1.0 - a);
            step(p[0], p[1]) + step(p[1], p[2])
        };
        let mut at = [-0.5, 0.7, 0.2];
        for _ in 0..4 {
            at = minimum(valley, at, [0.3; 3]);
        }
        assert!(at.iter().all(|x| (x - 1.0).abs() < 1e-2), "{at:?}");
    }
}
