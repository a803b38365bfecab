//! Two of a number, that compute in step.

use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use crate::{Real, RealFunction};

/// Two [`Real`]s under [`Real`], or the truth values of their comparison.
///
/// The steps of a formula wait for one another, and a processor can look only so far ahead for others to do meanwhile.
/// Two blocks of pixels in step give it twice as many. Only for arithmetic: what looks at lanes one by one
/// ([`Real::to_array`]) is not for pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twice<T>(pub T, pub T);

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<T: $trait<Output = T>> $trait for Twice<T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0), self.1.$method(other.1))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);
operator!(BitAnd, bitand);
operator!(BitOr, bitor);

impl<T: Neg<Output = T>> Neg for Twice<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<T: Not<Output = T>> Not for Twice<T> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0, !self.1)
    }
}

impl<R: Real> Real for Twice<R> {
    type Mask = Twice<R::Mask>;
    const LANES: usize = 2 * R::LANES;

    #[inline(always)]
    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self {
        let one = self.0.apply(
            function,
            arguments.map(
                #[inline(always)]
                |argument| argument.0,
            ),
        );
        Self(
            one,
            self.1.apply(
                function,
                arguments.map(
                    #[inline(always)]
                    |argument| argument.1,
                ),
            ),
        )
    }

    /// # Panics
    /// Always: a pair has more lanes than the array.
    #[inline(always)]
    fn to_array(self) -> [f32; 16] {
        unreachable!("pairs are only for arithmetic")
    }
    /// # Panics
    /// Always: a pair has more lanes than the array.
    #[inline(always)]
    fn with_array(self, _: &[f32; 16]) -> Self {
        unreachable!("pairs are only for arithmetic")
    }
    #[inline(always)]
    fn at_own_level<T>(self, f: impl FnOnce() -> T) -> T {
        self.0.at_own_level(f)
    }
    #[inline(always)]
    fn lit(self, value: f64) -> Self {
        Self(self.0.lit(value), self.1.lit(value))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        Twice(self.0.lt(other.0), self.1.lt(other.1))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        Twice(self.0.le(other.0), self.1.le(other.1))
    }
    #[inline(always)]
    fn select(self, mask: Self::Mask, other: Self) -> Self {
        Self(self.0.select(mask.0, other.0), self.1.select(mask.1, other.1))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.max(other.1))
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.min(other.1))
    }
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        R::any(mask.0) || R::any(mask.1)
    }
    #[inline(always)]
    fn log2(self) -> Self {
        Self(self.0.log2(), self.1.log2())
    }
    #[inline(always)]
    fn exp2(self) -> Self {
        Self(self.0.exp2(), self.1.exp2())
    }
    #[inline(always)]
    fn exp2_above_floor(self) -> Self {
        Self(self.0.exp2_above_floor(), self.1.exp2_above_floor())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_of_the_two_is_what_it_would_be_alone() {
        for (a, b) in [(0.25f32, 3.0), (0.0, 0.5), (1.0, 0.999)] {
            let pair = Twice(a, b);
            let both = |f: fn(f32) -> f32| Twice(f(a), f(b));
            assert_eq!(pair.pow(pair.lit(32.0)), both(|x| x.pow(32.0)));
            assert_eq!((pair * pair - pair).abs().sqrt(), both(|x| (x * x - x).abs().sqrt()));
            assert_eq!(pair.clamp(0.1, 0.9), both(|x| Real::clamp(x, 0.1, 0.9)));
            assert_eq!((-pair).select(pair.lt(pair.lit(0.5)), pair), both(|x| if x < 0.5 { -x } else { x }));
        }
        assert!(Twice::<f32>::any(Twice(false, true)) && !Twice::<f32>::any(Twice(false, false)));
    }
}
