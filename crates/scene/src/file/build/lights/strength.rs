//! How strong a light of a scene file is.

use std::f64::consts::PI;
use std::ops::Range;

use crate::file::build::builder::Builder;
use crate::file::build::units::{for_luminance, for_power};
use crate::file::error::Problem;
use crate::file::tables::lights::LightTable;
use crate::{Attenuation, LightColor, LightKind};

/// How strong a light is. All but the classic unit make the frame's unit 1 cd/m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Unit {
    /// 1 makes a white Lambert surface that faces the light 1.
    Classic(f64),
    Lux(f64),
    Candela(f64),
    WattPerSteradian(f64),
    CandelaPerSquareMetre(f64),
    /// Of a surface.
    Lumen(f64),
}

impl Unit {
    /// Whether the light's strength is an intensity, so that it fades with the square of the distance.
    pub(super) fn is_intensity(self) -> bool {
        matches!(self, Self::Candela(_) | Self::WattPerSteradian(_))
    }

    /// What makes light of this colour that strong: the luminance that it gives a white Lambert surface that
    /// faces it, at a distance of 1 m if it is a lamp. That is 1/π of the illuminance.
    pub(super) fn factor(self, color: &LightColor, span: &Range<usize>) -> Result<f64, Problem> {
        match self {
            Self::Classic(factor) => Ok(factor),
            _ if color.is_black() => Ok(0.0),
            Self::Lux(value) | Self::Candela(value) => for_luminance(color, value / PI, span),
            Self::WattPerSteradian(value) => Ok(for_power(color, value / PI)),
            Self::CandelaPerSquareMetre(value) | Self::Lumen(value) => for_luminance(color, value, span),
        }
    }

    /// The same, with the flux of a surface as its luminance: what shines evenly sends π times that into
    /// the half space above each part of it.
    pub(super) fn of_surface(self, kind: &LightKind) -> Self {
        match (self, kind) {
            (Self::Lumen(flux), LightKind::Area { shape, two_sided, .. }) => {
                let sides = if *two_sided { 2.0 } else { 1.0 };
                Self::CandelaPerSquareMetre(flux / (PI * sides * shape.area()))
            }
            (unit, _) => unit,
        }
    }
}

impl LightTable {
    /// The unit that the light's strength is given in. `most` is the greatest intensity of its profile in
    /// cd, which it has where nothing else is said.
    pub(super) fn unit(
        &self,
        most: Option<f64>,
        span: &Range<usize>,
        builder: &mut Builder,
    ) -> Result<Unit, Problem> {
        let physical = [
            ("illuminance_lx", &self.illuminance_lx, Unit::Lux as fn(f64) -> Unit),
            ("luminous_intensity_cd", &self.luminous_intensity_cd, Unit::Candela),
            ("radiant_intensity_w_sr", &self.radiant_intensity_w_sr, Unit::WattPerSteradian),
            ("luminance_cd_m2", &self.luminance_cd_m2, Unit::CandelaPerSquareMetre),
            ("luminous_flux_lm", &self.luminous_flux_lm, Unit::Lumen),
        ];
        let mut given = physical.iter().filter_map(|(key, value, unit)| Some((*key, value.as_ref()?, unit)));
        let first = given.next();
        let second = given.next().map(|(key, value, _)| (key, &value.span));
        let classic = self.intensity.as_ref().map(|intensity| ("intensity", &intensity.span));
        let (key, value_span, unit) = match (first, &self.profile, most) {
            (Some((key, value, unit)), ..) => {
                refuse_second(key, second.or(classic).or(self.dimming_place()))?;
                (key, &value.span, unit(value.0))
            }
            (None, Some(profile), Some(most)) if classic.is_none() => {
                ("profile", &profile.span, Unit::Candela(most * self.dimming.as_ref().map_or(1.0, |d| d.0)))
            }
            _ => {
                refuse_second("intensity", self.dimming_place())?;
                builder.units.classic.push(span.clone());
                return Ok(Unit::Classic(self.intensity.as_ref().map_or(1.0, |intensity| intensity.0)));
            }
        };
        if unit.is_intensity() {
            self.refuse_own_law(key)?;
        }
        builder.units.photometric.push(value_span.clone());
        Ok(unit)
    }

    /// An intensity in a physical unit fades in one way only.
    fn refuse_own_law(&self, key: &str) -> Result<(), Problem> {
        let Some(law) = &self.attenuation else { return Ok(()) };
        if law.build(&law.span)? == Attenuation::PHYSICAL {
            return Ok(());
        }
        let message = format!("'{key}' fades by the inverse square law");
        Err(Problem::at(&law.span, message).help("leave 'attenuation' out, or give \"physical\""))
    }

    fn dimming_place(&self) -> Option<(&'static str, &Range<usize>)> {
        self.dimming.as_ref().map(|dimming| ("dimming", &dimming.span))
    }
}

/// An error where something else says how strong the light is, too.
fn refuse_second(first: &str, second: Option<(&str, &Range<usize>)>) -> Result<(), Problem> {
    match second {
        None => Ok(()),
        Some((key, span)) => {
            Err(Problem::at(span, format!("'{key}' beside '{first}': one says how strong a light is")))
        }
    }
}
