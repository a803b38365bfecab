//! Lights of a scene file.

use std::ops::Range;

use schemars::JsonSchema;
use serde::Deserialize;

use super::attenuation::AttenuationValue;
use super::build::Builder;
use super::colors::{ColorValue, SpectrumValue};
use super::environment::Turn;
use super::error::Problem;
use super::luminaires::ProfileValue;
use super::strength::Unit;
use super::values::{Amount, At, Direction, Exponent, HalfTurn, Number, Positive, Vector};
use crate::names::names;
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
    /// Where a point or spot light is; the centre of a rectangle, disk or sphere.
    pub position: Option<At<Vector>>,
    /// The way that the light of a directional or spot light travels; the way that a rectangle or disk
    /// faces; the axis of a point light's `profile`, down by default.
    pub direction: Option<At<Direction>>,
    /// The point that a spot, rectangle, disk or profile is directed at, in place of `direction`.
    pub target: Option<At<Vector>>,
    /// What it sends to all terms of a material that have no colour of their own below; white by
    /// default. 1 on a white matte surface that faces the light gives 1. Of a rectangle, disk, sphere or
    /// environment it is the radiance: 1 is that of such a surface.
    pub color: Option<At<ColorValue>>,
    /// Its spectrum, in place of `color`: the name of a light source, or a table.
    pub spectrum: Option<At<SpectrumValue>>,
    /// What it sends to ambient terms; `color` by default, but nothing of a rectangle, disk, sphere or
    /// environment.
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
    /// What a point or spot light sends along its axis, or where its `profile` is greatest, in cd; it
    /// fades by the inverse square law.
    pub luminous_intensity_cd: Option<At<Amount>>,
    /// The same in W/sr between 300 and 780 nm.
    pub radiant_intensity_w_sr: Option<At<Amount>>,
    /// How bright the surroundings are that ambient light comes from, or an environment where its picture
    /// is 1, or a rectangle, disk or sphere, in cd/m².
    pub luminance_cd_m2: Option<At<Amount>>,
    /// What a rectangle, disk or sphere sends in all, from both sides if it has two, in lm.
    pub luminous_flux_lm: Option<At<Amount>>,
    /// How a point or spot light fades with distance; not at all by default.
    pub attenuation: Option<At<AttenuationValue>>,
    /// Half the opening angle of a spot's cone in degrees, 180 for all directions; 45 by default.
    pub cutoff_deg: Option<At<HalfTurn>>,
    /// The same in radians, where degrees cannot say it exactly.
    pub cutoff_rad: Option<At<Amount>>,
    /// Cosines of the angles between which a spot fades from full to nothing, in place of `exponent`, as in glTF.
    pub smooth_edge: Option<At<[Number; 2]>>,
    /// Power of the cosine from a spot's axis by which its light falls off; 0 by default.
    pub exponent: Option<At<Exponent>>,
    /// A luminaire's profile for a point or spot light: an LM-63 (`.ies`) or EULUMDAT (`.ldt`) file,
    /// relative to the scene file. With `intensity` or `luminous_intensity_cd` it is relative to its
    /// maximum; without, the light has the file's candela.
    pub profile: Option<At<ProfileValue>>,
    /// Where the half plane C 0° of the profile points; +X by default, +Y of a light along X.
    pub profile_c0: Option<At<Direction>>,
    /// The share of the profile's candela that the light has; 1 by default.
    pub dimming: Option<At<Amount>>,
    /// Across a rectangle, in m.
    pub width: Option<At<Positive>>,
    /// Along the `up` of a rectangle, in m.
    pub height: Option<At<Positive>>,
    /// Width and height of a rectangle, in m, in place of the two.
    pub size: Option<At<[Positive; 2]>>,
    /// Of a disk or sphere, in m.
    pub radius: Option<At<Positive>>,
    /// Where the height of a rectangle points; +Y by default, -Z of one that faces up or down.
    pub up: Option<At<Direction>>,
    /// Whether a rectangle or disk shines on its back, too; not by default.
    pub two_sided: Option<At<bool>>,
    /// The picture of an environment: a Radiance HDR or OpenEXR file in equirectangular projection,
    /// relative to the scene file. Without it the same comes from all directions.
    pub file: Option<At<String>>,
    /// How an environment is turned: degrees about +Y, or rotations as those of objects.
    pub rotate_deg: Option<At<Turn>>,
    /// The same as the three rows of a matrix.
    pub rotation: Option<At<[[Number; 3]; 3]>>,
    /// What position and direction are relative to.
    pub attached_to: Option<At<AttachedTo>>,
}

names! {
    /// The kinds of light.
    pub(crate) KindName {
        /// From everywhere, on everything.
        Ambient = "ambient",
        /// Parallel light.
        Directional = "directional",
        /// From a point in all directions.
        Point = "point",
        /// From a point into a cone.
        Spot = "spot",
        /// From a rectangle that shines evenly.
        Rectangle = "rectangle",
        /// From a disk that shines evenly.
        Disk = "disk",
        /// From a sphere that shines evenly.
        Sphere = "sphere",
        /// From surroundings at infinite distance.
        Environment = "environment",
    } default Ambient
}

impl KindName {
    /// Whether it is a surface that shines.
    fn is_surface(self) -> bool {
        matches!(self, Self::Rectangle | Self::Disk | Self::Sphere)
    }
}

names! {
    /// What a light moves with.
    pub(crate) AttachedTo {
        /// Nothing: it stands still.
        World = "world",
        /// The camera: x to the right, y up, -z along the view.
        Camera = "camera",
    } default World
}

impl LightTable {
    /// The light; `span` is where the table stands.
    pub fn build(&self, span: &Range<usize>, builder: &mut Builder) -> Result<Light, Problem> {
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
        let ambient = match (&self.ambient, self.kind.is_surface() || self.kind == KindName::Environment) {
            // What comes from all around is this light itself.
            (None, true) => LightColor::BLACK,
            (color, _) => part(color)?,
        };
        if self.kind == KindName::Ambient {
            return Ok(LightColors::ambient(ambient));
        }
        Ok(LightColors { ambient, diffuse: part(&self.diffuse)?, specular: part(&self.specular)? })
    }
}
