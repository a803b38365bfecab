//! Lights of a scene file.

use std::f64::consts::PI;
use std::fmt;
use std::ops::Range;

use schemars::JsonSchema;
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use super::build::Builder;
use super::colors::{ColorValue, SpectrumValue};
use super::error::Problem;
use super::spectra::{for_luminance, for_power};
use super::types::names;
use super::values::{Amount, At, Direction, Exponent, HalfTurn, Vector};
use crate::{Attenuation, Light, LightColor, LightColors, LightKind, Space};

/// A light.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightTable {
    /// A name for people.
    #[serde(default)]
    pub name: String,
    /// What kind of light it is.
    pub kind: KindName,
    /// Where a point or spot light is.
    pub position: Option<At<Vector>>,
    /// The way that the light of a directional or spot light travels.
    pub direction: Option<At<Direction>>,
    /// What it sends to all terms of a material that have no colour of their own below; white by
    /// default. 1 on a white matte surface that faces the light gives 1.
    pub color: Option<At<ColorValue>>,
    /// Its spectrum, in place of `color`: the name of a light source, or a table.
    pub spectrum: Option<At<SpectrumValue>>,
    /// What it sends to ambient terms; `color` by default.
    pub ambient: Option<At<ColorValue>>,
    /// What it sends to diffuse terms; `color` by default.
    pub diffuse: Option<At<ColorValue>>,
    /// What it sends to specular terms; `color` by default.
    pub specular: Option<At<ColorValue>>,
    /// Multiplies all its colours; 1 by default.
    pub intensity: Option<At<Amount>>,
    /// What a directional light gives on a surface that faces it, in lx, in place of `intensity`. A scene
    /// with one light in physical units must have all its lights in such.
    pub illuminance_lx: Option<At<Amount>>,
    /// What a point or spot light sends along its axis, in cd; it fades by the inverse square law.
    pub luminous_intensity_cd: Option<At<Amount>>,
    /// The same in W/sr between 300 and 780 nm.
    pub radiant_intensity_w_sr: Option<At<Amount>>,
    /// How bright the surroundings are that ambient light comes from, in cd/m².
    pub luminance_cd_m2: Option<At<Amount>>,
    /// How a point or spot light fades with distance; not at all by default.
    pub attenuation: Option<At<AttenuationValue>>,
    /// Half the opening angle of a spot's cone in degrees, 180 for all directions; 45 by default.
    pub cutoff_deg: Option<At<HalfTurn>>,
    /// Power of the cosine from a spot's axis by which its light falls off; 0 by default.
    pub exponent: Option<At<Exponent>>,
    /// What position and direction are relative to.
    pub attached_to: Option<At<AttachedTo>>,
}

names! {
    /// The kinds of light.
    pub(crate) KindName {
        /// From everywhere, on everything.
        #[default]
        Ambient = "ambient",
        /// Parallel light.
        Directional = "directional",
        /// From a point in all directions.
        Point = "point",
        /// From a point into a cone.
        Spot = "spot",
    }
}

names! {
    /// What a light moves with.
    pub(crate) AttachedTo {
        /// Nothing: it stands still.
        #[default]
        World = "world",
        /// The camera: x to the right, y up, -z along the view.
        Camera = "camera",
    }
}

/// How light fades with the distance d: 1 / (constant + linear d + quadratic d²).
#[derive(Debug, JsonSchema)]
#[schemars(untagged)]
pub(crate) enum AttenuationValue {
    /// A law with a name.
    Name(AttenuationName),
    /// The three factors; those that are missing are 0.
    Table(AttenuationTable),
}

names! {
    /// The laws that have a name.
    pub(crate) AttenuationName {
        /// No fading.
        #[default]
        None = "none",
        /// The inverse square law: 0, 0, 1.
        Physical = "physical",
    }
}

/// The factors of 1 / (constant + linear d + quadratic d²). Those that are missing are 0, but not
/// all of them may be.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AttenuationTable {
    /// The part that does not depend on distance.
    pub constant: Option<Amount>,
    /// The factor of d, in 1/m.
    pub linear: Option<Amount>,
    /// The factor of d², in 1/m².
    pub quadratic: Option<Amount>,
}

impl<'de> Deserialize<'de> for AttenuationValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value;
        impl<'de> Visitor<'de> for Value {
            type Value = AttenuationValue;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("\"physical\", \"none\", or a table of constant, linear and quadratic")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<AttenuationValue, E> {
                let name = serde::de::value::StrDeserializer::new(name);
                AttenuationName::deserialize(name).map(AttenuationValue::Name)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<AttenuationValue, A::Error> {
                AttenuationTable::deserialize(MapAccessDeserializer::new(map)).map(AttenuationValue::Table)
            }
        }
        deserializer.deserialize_any(Value)
    }
}

impl AttenuationValue {
    fn build(&self, span: &Range<usize>) -> Result<Attenuation, Problem> {
        match self {
            Self::Name(AttenuationName::None) => Ok(Attenuation::NONE),
            Self::Name(AttenuationName::Physical) => Ok(Attenuation::PHYSICAL),
            Self::Table(table) => {
                let factor = |amount: Option<Amount>| amount.map_or(0.0, |a| a.0);
                let attenuation = Attenuation {
                    constant: factor(table.constant),
                    linear: factor(table.linear),
                    quadratic: factor(table.quadratic),
                };
                let sum = attenuation.constant + attenuation.linear + attenuation.quadratic;
                match sum > 0.0 {
                    true => Ok(attenuation),
                    false => {
                        let message = "constant, linear and quadratic are all 0, which divides by 0";
                        Err(Problem::at(span, message).help("keys missing in a given table are 0"))
                    }
                }
            }
        }
    }
}

/// How strong a light is. All but the classic unit make the frame's unit 1 cd/m².
#[derive(Clone, Copy, Debug, PartialEq)]
enum Unit {
    /// 1 makes a white Lambert surface that faces the light 1.
    Classic(f64),
    Lux(f64),
    Candela(f64),
    WattPerSteradian(f64),
    CandelaPerSquareMetre(f64),
}

impl Unit {
    /// Whether the light's strength is an intensity, so that it fades with the square of the distance.
    fn is_intensity(self) -> bool {
        matches!(self, Self::Candela(_) | Self::WattPerSteradian(_))
    }

    /// What makes light of this colour that strong: the luminance that it gives a white Lambert surface that
    /// faces it, at a distance of 1 m if it is a lamp. That is 1/π of the illuminance.
    fn factor(self, color: &LightColor, span: &Range<usize>) -> Result<f64, Problem> {
        match self {
            Self::Classic(factor) => Ok(factor),
            _ if color.is_black() => Ok(0.0),
            Self::Lux(value) | Self::Candela(value) => for_luminance(color, value / PI, span),
            Self::WattPerSteradian(value) => Ok(for_power(color, value / PI)),
            Self::CandelaPerSquareMetre(value) => for_luminance(color, value, span),
        }
    }
}

impl LightTable {
    /// The light; `span` is where the table stands.
    pub fn build(&self, span: &Range<usize>, builder: &mut Builder) -> Result<Light, Problem> {
        self.refuse_foreign_keys()?;
        let unit = self.unit(span, builder)?;
        let missing = |key: &str| {
            let kind = self.kind.name();
            Problem::at(span, format!("a {kind} light needs '{key}', which is missing"))
        };
        let position = || self.position.as_ref().map(|p| p.0).ok_or_else(|| missing("position"));
        let direction = || self.direction.as_ref().map(|d| d.0).ok_or_else(|| missing("direction"));
        let attenuation = match &self.attenuation {
            Some(value) => value.build(&value.span)?,
            None if unit.is_intensity() => Attenuation::PHYSICAL,
            None => Attenuation::NONE,
        };
        let kind = match self.kind {
            KindName::Ambient => LightKind::Ambient,
            KindName::Directional => LightKind::Directional { direction: direction()? },
            KindName::Point => LightKind::Point { position: position()?, attenuation },
            KindName::Spot => LightKind::Spot {
                position: position()?,
                direction: direction()?,
                cutoff: self.cutoff_deg.as_ref().map_or(45.0, |c| c.0).to_radians(),
                exponent: self.exponent.as_ref().map_or(0.0, |e| e.0),
                smooth_edge: None,
                attenuation,
            },
        };
        let space = match self.attached_to.as_ref().map(|a| a.value) {
            Some(AttachedTo::Camera) => Space::Camera,
            Some(AttachedTo::World) | None => Space::World,
        };
        Ok(Light { name: self.name.clone(), space, ..Light::new(kind, self.colors(unit, span, builder)?) })
    }

    /// The unit that the light's strength is given in.
    fn unit(&self, span: &Range<usize>, builder: &mut Builder) -> Result<Unit, Problem> {
        let physical = [
            ("illuminance_lx", &self.illuminance_lx, Unit::Lux as fn(f64) -> Unit),
            ("luminous_intensity_cd", &self.luminous_intensity_cd, Unit::Candela),
            ("radiant_intensity_w_sr", &self.radiant_intensity_w_sr, Unit::WattPerSteradian),
            ("luminance_cd_m2", &self.luminance_cd_m2, Unit::CandelaPerSquareMetre),
        ];
        let mut given = physical.iter().filter_map(|(key, value, unit)| Some((key, value.as_ref()?, unit)));
        let Some((key, value, unit)) = given.next() else {
            builder.classic.push(span.clone());
            return Ok(Unit::Classic(self.intensity.as_ref().map_or(1.0, |intensity| intensity.0)));
        };
        let other = given.next().map(|(other, value, _)| (*other, &value.span));
        let classic = self.intensity.as_ref().map(|intensity| ("intensity", &intensity.span));
        if let Some((other, span)) = other.or(classic) {
            return Err(Problem::at(
                span,
                format!("'{other}' beside '{key}': one says how strong a light is"),
            ));
        }
        let unit = unit(value.0);
        let own_law = self.attenuation.as_ref().filter(|_| unit.is_intensity());
        if let Some(law) = own_law
            && law.build(&law.span)? != Attenuation::PHYSICAL
        {
            let message = format!("'{key}' fades by the inverse square law");
            return Err(Problem::at(&law.span, message).help("leave 'attenuation' out, or give \"physical\""));
        }
        builder.photometric.push(value.span.clone());
        Ok(unit)
    }

    fn colors(&self, unit: Unit, span: &Range<usize>, builder: &mut Builder) -> Result<LightColors, Problem> {
        if let (Some(spectrum), Some(_)) = (&self.spectrum, &self.color) {
            return Err(Problem::at(&spectrum.span, "'spectrum' beside 'color': only one can be the colour"));
        }
        let all = match (&self.spectrum, &self.color) {
            (Some(spectrum), _) => builder.light_spectrum(spectrum)?,
            (None, Some(color)) => builder.light_color(color)?,
            (None, None) => glanz_color::Rgb::WHITE.into(),
        };
        // The strength is that of the light's own colour; parts with a colour of their own are in proportion.
        let factor = unit.factor(&all, span)?;
        let mut part = |color: &Option<At<ColorValue>>| {
            let color = color.as_ref().map_or(Ok(all.clone()), |color| builder.light_color(color))?;
            Ok(color.scaled(factor))
        };
        let ambient = part(&self.ambient)?;
        if self.kind == KindName::Ambient {
            return Ok(LightColors::ambient(ambient));
        }
        Ok(LightColors { ambient, diffuse: part(&self.diffuse)?, specular: part(&self.specular)? })
    }

    /// Keys that lights of this kind do not have.
    fn refuse_foreign_keys(&self) -> Result<(), Problem> {
        fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
            value.as_ref().map(|v| &v.span)
        }
        use KindName::{Ambient, Directional, Point, Spot};
        let given: [(&str, _, &[KindName]); 12] = [
            ("position", place(&self.position), &[Point, Spot]),
            ("direction", place(&self.direction), &[Directional, Spot]),
            ("diffuse", place(&self.diffuse), &[Directional, Point, Spot]),
            ("specular", place(&self.specular), &[Directional, Point, Spot]),
            ("attenuation", place(&self.attenuation), &[Point, Spot]),
            ("cutoff_deg", place(&self.cutoff_deg), &[Spot]),
            ("exponent", place(&self.exponent), &[Spot]),
            ("attached_to", place(&self.attached_to), &[Directional, Point, Spot]),
            ("illuminance_lx", place(&self.illuminance_lx), &[Directional]),
            ("luminous_intensity_cd", place(&self.luminous_intensity_cd), &[Point, Spot]),
            ("radiant_intensity_w_sr", place(&self.radiant_intensity_w_sr), &[Point, Spot]),
            ("luminance_cd_m2", place(&self.luminance_cd_m2), &[Ambient]),
        ];
        for (key, span, kinds) in given {
            if let Some(span) = span.filter(|_| !kinds.contains(&self.kind)) {
                let kinds = kinds.iter().map(|kind| kind.name()).collect::<Vec<_>>().join(", ");
                let kind = match self.kind {
                    Ambient => "an ambient",
                    Directional => "a directional",
                    Point => "a point",
                    Spot => "a spot",
                };
                let message = format!("{kind} light has no '{key}'");
                return Err(Problem::at(span, message).help(format!("'{key}' is for lights of kind {kinds}")));
            }
        }
        Ok(())
    }
}
