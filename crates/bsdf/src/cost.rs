//! Counts the arithmetic operations of every model, so that [`ModelInfo::operations`](crate::ModelInfo::operations) is true.

use core::cell::Cell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use glanz_math::{Real, RealFunction, Vec3};

use crate::{DirectionPair, MODELS, Shape};

/// What a logarithm takes in glanz-math: its polynomial, and the exponent's bits.
const LOG2: u32 = 24;
/// What an exponential takes.
const EXP2: u32 = 20;

std::thread_local! {
    static COUNT: Cell<u32> = const { Cell::new(0) };
}

/// A number that counts what is done with it. A comparison and the choice that follows are one operation.
#[derive(Clone, Copy)]
struct Counted(f64);

impl Counted {
    fn after(operations: u32, value: f64) -> Self {
        COUNT.with(|count| count.set(count.get() + operations));
        Self(value)
    }
}

impl Add for Counted {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::after(1, self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::after(1, self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::after(1, self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::after(1, self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        Self::after(1, -self.0)
    }
}

impl Real for Counted {
    type Mask = bool;
    const LANES: usize = 1;

    fn apply<const N: usize>(self, function: &(impl RealFunction<N> + ?Sized), arguments: [Self; N]) -> Self {
        Self(function.in_f64(arguments.map(|argument| argument.0)))
    }

    fn lit(self, value: f64) -> Self {
        Self(value)
    }
    fn sqrt(self) -> Self {
        Self::after(1, libm::sqrt(self.0))
    }
    fn lt(self, other: Self) -> bool {
        self.0 < other.0
    }
    fn le(self, other: Self) -> bool {
        self.0 <= other.0
    }
    fn select(self, mask: bool, other: Self) -> Self {
        Self::after(1, if mask { self.0 } else { other.0 })
    }
    fn any(mask: bool) -> bool {
        mask
    }
    fn log2(self) -> Self {
        Self::after(LOG2, libm::log2(self.0))
    }
    fn exp2(self) -> Self {
        Self::after(EXP2, libm::exp2(self.0))
    }
    fn exp2_above_floor(self) -> Self {
        self.exp2()
    }
    fn to_array(self) -> [f32; 16] {
        [self.0 as f32; 16]
    }
    fn with_array(self, values: &[f32; 16]) -> Self {
        Self(f64::from(values[0]))
    }
}

/// The operations of a shape for a pair within its lobe.
fn operations(shape: &Shape) -> u32 {
    let counted = |w: Vec3<f64>| Vec3::new(Counted(w.x), Counted(w.y), Counted(w.z));
    let wo = Vec3::from_angles(0.7, 0.3);
    let wi = match shape.info().side {
        crate::Side::Reflection => Vec3::from_angles(0.65, 0.3 + glanz_math::PI),
        crate::Side::Transmission => -Vec3::from_angles(libm::asin(libm::sin(0.7) / shape.eta()), 0.3),
    };
    let pair = DirectionPair::new(counted(wo), counted(wi));
    COUNT.with(|count| count.set(0));
    let _ = shape.f_cos(&pair);
    COUNT.with(Cell::get)
}

#[test]
fn every_model_tells_how_many_operations_it_takes() {
    let wrong: Vec<_> = MODELS
        .iter()
        .map(|info| (info.name, info.operations, operations(&Shape::named(info.name, &[]).unwrap())))
        .filter(|(_, told, counted)| told != counted)
        .collect();
    assert!(wrong.is_empty(), "name, told, counted: {wrong:#?}");
}
