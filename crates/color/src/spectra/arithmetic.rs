//! Spectra as numbers: every operation goes wavelength by wavelength, and a scalar stands for the constant spectrum.

use core::iter::Sum;
use core::ops::{Add, AddAssign, Div, DivAssign, Index, IndexMut, Mul, MulAssign, Neg, Sub, SubAssign};

use super::Spectrum;

/// An operator between spectra, and between a spectrum and a scalar, with its assigning form.
macro_rules! operator {
    ($Trait:ident, $method:ident, $Assign:ident, $assign:ident, $op:tt) => {
        impl $Trait for Spectrum {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                Self(core::array::from_fn(|i| self.0[i] $op other.0[i]))
            }
        }

        impl $Assign for Spectrum {
            fn $assign(&mut self, other: Self) {
                *self = *self $op other;
            }
        }
    };
}

operator!(Add, add, AddAssign, add_assign, +);
operator!(Sub, sub, SubAssign, sub_assign, -);
operator!(Mul, mul, MulAssign, mul_assign, *);
operator!(Div, div, DivAssign, div_assign, /);

impl Mul<f64> for Spectrum {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.map(|value| value * factor)
    }
}

impl Mul<Spectrum> for f64 {
    type Output = Spectrum;
    fn mul(self, spectrum: Spectrum) -> Spectrum {
        spectrum * self
    }
}

impl MulAssign<f64> for Spectrum {
    fn mul_assign(&mut self, factor: f64) {
        *self = *self * factor;
    }
}

impl Div<f64> for Spectrum {
    type Output = Self;
    fn div(self, divisor: f64) -> Self {
        self.map(|value| value / divisor)
    }
}

impl Div<Spectrum> for f64 {
    type Output = Spectrum;
    fn div(self, divisor: Spectrum) -> Spectrum {
        divisor.map(|value| self / value)
    }
}

impl DivAssign<f64> for Spectrum {
    fn div_assign(&mut self, divisor: f64) {
        *self = *self / divisor;
    }
}

impl Neg for Spectrum {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|value| -value)
    }
}

impl Sum for Spectrum {
    fn sum<I: Iterator<Item = Self>>(spectra: I) -> Self {
        spectra.fold(Self::ZERO, Add::add)
    }
}

impl<'a> Sum<&'a Self> for Spectrum {
    fn sum<I: Iterator<Item = &'a Self>>(spectra: I) -> Self {
        spectra.copied().sum()
    }
}

/// The sample of that number, from 0 at 300 nm.
impl Index<usize> for Spectrum {
    type Output = f64;
    fn index(&self, index: usize) -> &f64 {
        &self.0[index]
    }
}

impl IndexMut<usize> for Spectrum {
    fn index_mut(&mut self, index: usize) -> &mut f64 {
        &mut self.0[index]
    }
}

/// The values, without their wavelengths; [`Spectrum::points`] gives both.
impl<'a> IntoIterator for &'a Spectrum {
    type Item = &'a f64;
    type IntoIter = core::slice::Iter<'a, f64>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectra::SAMPLES;
    use proptest::prelude::*;

    fn spectrum() -> impl Strategy<Value = Spectrum> {
        prop::collection::vec(-100.0..100.0_f64, SAMPLES)
            .prop_map(|values| Spectrum::try_from(values).expect("as many values as samples"))
    }

    proptest! {
        #[test]
        fn every_operation_goes_wavelength_by_wavelength(a in spectrum(), b in spectrum(), s in 0.1..9.0_f64) {
            let constant = Spectrum::constant(s);
            prop_assert_eq!((s * a, a * s, a / s), (constant * a, a * constant, a / constant));
            prop_assert_eq!(s / a, constant / a);
            prop_assert_eq!((-a, a - b), (Spectrum::ZERO - a, a + -b));
            let [mut sum, mut difference, mut product, mut quotient] = [a; 4];
            sum += b;
            difference -= b;
            product *= b;
            quotient /= b;
            prop_assert_eq!([sum, difference, product, quotient], [a + b, a - b, a * b, a / b]);
            let [mut product, mut quotient] = [a; 2];
            product *= s;
            quotient /= s;
            prop_assert_eq!([product, quotient], [a * s, a / s]);
            prop_assert_eq!([a, b].iter().sum::<Spectrum>(), a + b);
            prop_assert_eq!([a, b].into_iter().sum::<Spectrum>(), a + b);
            for (i, value) in (&(a * b)).into_iter().enumerate() {
                prop_assert_eq!(*value, a[i] * b[i]);
            }
        }

        #[test]
        fn a_spectrum_survives_serde_to_the_last_bit(a in spectrum()) {
            let text = serde_json::to_string(&a).expect("numbers are plain");
            prop_assert_eq!(serde_json::from_str::<Spectrum>(&text).expect("it was written so"), a);
        }
    }

    #[test]
    fn a_list_of_another_length_is_no_spectrum() {
        let error = serde_json::from_str::<Spectrum>("[1.0, 2.0]").unwrap_err();
        assert_eq!(error.to_string(), "expected 97 samples, found 2");
    }
}
