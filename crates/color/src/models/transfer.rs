//! Transfer functions: linear light to code values and back.

/// How a space encodes linear light.
///
/// All are continued odd-symmetrically below zero and without bound above one, so colours outside of a
/// space's gamut survive the way there and back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transfer {
    /// Code values are linear light.
    Linear,
    /// IEC 61966-2-1:1999: linear up to 0.0031308, then a power of 1/2.4. The standard's two branches
    /// miss each other by 3e-8.
    Srgb,
    /// ITU-R BT.2020-2 (2015), the camera's curve, with α and β to the precision that makes it smooth.
    Bt2020,
    /// A pure power: linear light is the code value to this exponent.
    Power(f64),
}

/// α of BT.2020, which makes the curve continuous at β: 4.5 β = α β^0.45 − α + 1. BT.2020-2 prints 1.099.
const BT2020_ALPHA: f64 = 1.0 + 5.5 * BT2020_BETA;
/// β of BT.2020, which makes its slope continuous too: 5.5 β + 1 = 10 β^0.55. BT.2020-2 prints 0.018.
const BT2020_BETA: f64 = 0.018_053_968_510_807_806;

impl Transfer {
    /// The code value of linear light.
    pub fn encode(self, linear: f64) -> f64 {
        let light = linear.abs();
        let code = match self {
            Self::Linear => light,
            Self::Srgb if light <= 0.003_130_8 => light * 12.92,
            Self::Srgb => 1.055 * libm::pow(light, 1.0 / 2.4) - 0.055,
            Self::Bt2020 if light < BT2020_BETA => light * 4.5,
            Self::Bt2020 => BT2020_ALPHA * libm::pow(light, 0.45) - (BT2020_ALPHA - 1.0),
            Self::Power(exponent) => libm::pow(light, 1.0 / exponent),
        };
        code.copysign(linear)
    }

    /// Linear light from a code value.
    pub fn decode(self, code: f64) -> f64 {
        let value = code.abs();
        let light = match self {
            Self::Linear => value,
            Self::Srgb if value <= 0.04045 => value / 12.92,
            Self::Srgb => libm::pow((value + 0.055) / 1.055, 2.4),
            Self::Bt2020 if value < BT2020_BETA * 4.5 => value / 4.5,
            Self::Bt2020 => libm::pow((value + (BT2020_ALPHA - 1.0)) / BT2020_ALPHA, 1.0 / 0.45),
            Self::Power(exponent) => libm::pow(value, exponent),
        };
        light.copysign(code)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The gap between the branches of sRGB, which its standard leaves; the others lose rounding only.
    const GAP: f64 = 1e-7;

    const ALL: [Transfer; 4] =
        [Transfer::Linear, Transfer::Srgb, Transfer::Bt2020, Transfer::Power(563.0 / 256.0)];

    #[test]
    fn known_values() {
        // colour-science 0.4.7: eotf_inverse_sRGB, oetf_BT2020 (α = 1.0993, β = 0.0181), Adobe RGB (1998).
        assert!((Transfer::Srgb.encode(0.18) - 0.461_356_129_5).abs() < 1e-10);
        assert!((Transfer::Bt2020.encode(0.18) - 0.408_846_4).abs() < 1e-5);
        assert!((Transfer::Power(563.0 / 256.0).encode(0.18) - 0.458_529_465_7).abs() < 1e-10);
    }

    #[test]
    fn bt2020_is_smooth_where_its_branches_meet() {
        let (below, above) = (BT2020_BETA * (1.0 - 1e-9), BT2020_BETA * (1.0 + 1e-9));
        let jump = Transfer::Bt2020.encode(above) - Transfer::Bt2020.encode(below);
        assert!((jump - 4.5 * (above - below)).abs() < 1e-13);
    }

    proptest! {
        #[test]
        fn light_survives_the_way_to_code_values_and_back(linear in -4.0..4.0_f64) {
            for transfer in ALL {
                let back = transfer.decode(transfer.encode(linear));
                prop_assert!((back - linear).abs() < GAP, "{transfer:?}: {linear} became {back}");
            }
        }
    }
}
