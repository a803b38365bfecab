//! Lights.

use std::ops::Range;

use super::strength::Unit;
use crate::file::build::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::colors::ColorValue;
use crate::file::tables::lights::{AttachedTo, AttenuationName, AttenuationValue, KindName, LightTable};
use crate::file::tables::values::{Amount, At};
use crate::{Attenuation, Light, LightColor, LightColors, LightKind, Space};

impl AttenuationValue {
    /// The law; `span` is where the value stands.
    pub(crate) fn build(&self, span: &Range<usize>) -> Result<Attenuation, Problem> {
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

impl LightTable {
    /// The light; `span` is where the table stands.
    pub(crate) fn build(&self, span: &Range<usize>, builder: &mut Builder) -> Result<Light, Problem> {
        self.refuse_foreign_keys()?;
        let luminaire = self.luminaire(builder)?;
        let shape = self.area_shape(span)?;
        let most = luminaire.as_ref().map(|luminaire| luminaire.profile.max());
        let unit = self.unit(most, span, builder)?;
        let kind = match shape {
            Some(shape) => self.area(shape, span)?,
            None => self.kind(unit, span, builder)?,
        };
        let space = match self.attached_to.as_ref().map(|a| a.value) {
            Some(AttachedTo::Camera) => Space::Camera,
            Some(AttachedTo::World) | None => Space::World,
        };
        // Light from a surface is as bright as the surface, whose size makes it more or less.
        let unit = unit.of_surface(&kind);
        Ok(Light {
            name: self.name.clone(),
            kind,
            colors: self.colors(unit, span, builder)?,
            space,
            luminaire,
        })
    }

    /// The geometry of lights that are no surfaces.
    fn kind(&self, unit: Unit, span: &Range<usize>, builder: &mut Builder) -> Result<LightKind, Problem> {
        let attenuation = match &self.attenuation {
            Some(value) => value.build(&value.span)?,
            None if unit.is_intensity() => Attenuation::PHYSICAL,
            None => Attenuation::NONE,
        };
        Ok(match self.kind {
            KindName::Directional => LightKind::Directional { direction: self.directed(span)? },
            KindName::Point => LightKind::Point { position: self.place(span)?, attenuation },
            KindName::Spot => LightKind::Spot {
                position: self.place(span)?,
                direction: self.directed(span)?,
                cutoff: self.cutoff()?,
                exponent: self.exponent.as_ref().map_or(0.0, |e| e.0),
                smooth_edge: self.smooth_edge.as_ref().map(|edge| (edge.value[0].0, edge.value[1].0)),
                attenuation,
            },
            KindName::Environment => self.environment(builder)?,
            // The others have a surface.
            _ => LightKind::Ambient,
        })
    }

    /// Half the opening angle of a spot's cone, in radians.
    fn cutoff(&self) -> Result<f64, Problem> {
        match (&self.cutoff_deg, &self.cutoff_rad) {
            (Some(_), Some(radians)) => Err(Problem::at(&radians.span, "'cutoff_rad' beside 'cutoff_deg'")),
            (None, Some(radians)) if radians.0 <= std::f64::consts::PI => Ok(radians.0),
            (None, Some(radians)) => Err(Problem::at(&radians.span, "expected at most π")),
            (degrees, None) => Ok(degrees.as_ref().map_or(45.0, |degrees| degrees.0).to_radians()),
        }
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
        let ambient = match (&self.ambient, self.kind) {
            // As in OpenGL: light without a direction is a lamp's only where it is said.
            (None, kind) if kind != KindName::Ambient => LightColor::BLACK,
            (color, _) => part(color)?,
        };
        if self.kind == KindName::Ambient {
            return Ok(LightColors::ambient(ambient));
        }
        Ok(LightColors { ambient, diffuse: part(&self.diffuse)?, specular: part(&self.specular)? })
    }
}
