//! Area lights, and where lights are and point.

use std::ops::Range;

use glam::DVec3;

use crate::file::error::Problem;
use crate::file::tables::lights::{KindName, LightTable};
use crate::file::tables::values::{At, Positive};
use crate::{AreaShape, LightKind};

/// The sine of the angle below which two directions are taken for parallel.
const PARALLEL: f64 = 1e-6;

/// Whether two directions leave no plane between them that rounding would not turn.
pub(super) fn are_parallel(a: DVec3, b: DVec3) -> bool {
    a.normalize().cross(b.normalize()).length() < PARALLEL
}

impl LightTable {
    /// An error about a key that lights of this kind need.
    pub(super) fn missing(&self, key: &str, span: &Range<usize>) -> Problem {
        let kind = self.kind.name();
        let article = if self.kind == KindName::Environment { "an" } else { "a" };
        Problem::at(span, format!("{article} {kind} light needs '{key}', which is missing"))
    }

    /// Where it is.
    pub(super) fn place(&self, span: &Range<usize>) -> Result<DVec3, Problem> {
        self.position.as_ref().map(|position| position.0).ok_or_else(|| self.missing("position", span))
    }

    /// Which way it points.
    pub(super) fn directed(&self, span: &Range<usize>) -> Result<DVec3, Problem> {
        self.given_direction()?.ok_or_else(|| self.missing("direction", span))
    }

    /// The same, if it is said.
    pub(super) fn given_direction(&self) -> Result<Option<DVec3>, Problem> {
        let Some(target) = &self.target else {
            return Ok(self.direction.as_ref().map(|direction| direction.0));
        };
        if self.direction.is_some() {
            return Err(Problem::at(
                &target.span,
                "'target' beside 'direction': one says where a light points",
            ));
        }
        let position = self.position.as_ref().map_or(DVec3::ZERO, |position| position.0);
        let direction = target.0 - position;
        // Below this the direction is lost in the rounding of the coordinates.
        match direction.length() > 1e-12 * position.length().max(1.0) {
            true => Ok(Some(direction)),
            false => {
                Err(Problem::at(&target.span, "'position' and 'target' are the same point; they must differ"))
            }
        }
    }

    /// The form and size of a light that is a surface.
    pub(super) fn area_shape(&self, span: &Range<usize>) -> Result<Option<AreaShape>, Problem> {
        let length = |key: &str, value: &Option<At<Positive>>| {
            value.as_ref().map(|value| value.0).ok_or_else(|| self.missing(key, span))
        };
        Ok(Some(match self.kind {
            KindName::Rectangle => self.rectangle(length)?,
            KindName::Disk => AreaShape::Disk { radius: length("radius", &self.radius)? },
            KindName::Sphere => AreaShape::Sphere { radius: length("radius", &self.radius)? },
            _ => return Ok(None),
        }))
    }

    fn rectangle(
        &self,
        length: impl Fn(&str, &Option<At<Positive>>) -> Result<f64, Problem>,
    ) -> Result<AreaShape, Problem> {
        match (&self.size, self.width.is_some() || self.height.is_some()) {
            (Some(size), true) => {
                Err(Problem::at(&size.span, "'size' beside 'width' and 'height'")
                    .help("give one or the other"))
            }
            (Some(size), false) => {
                let [width, height] = size.value.map(|length| length.0);
                Ok(AreaShape::Rectangle { width, height })
            }
            (None, _) => Ok(AreaShape::Rectangle {
                width: length("width", &self.width)?,
                height: length("height", &self.height)?,
            }),
        }
    }

    /// The surface that shines.
    pub(super) fn area(&self, shape: AreaShape, span: &Range<usize>) -> Result<LightKind, Problem> {
        let position = self.place(span)?;
        let direction = match shape {
            AreaShape::Sphere { .. } => DVec3::NEG_Y,
            _ => self.directed(span)?,
        };
        let up = match &self.up {
            Some(up) if are_parallel(up.0, direction) => {
                return Err(Problem::at(&up.span, "'up' is parallel to the direction of the light")
                    .help("it says how a rectangle is turned about its direction"));
            }
            Some(up) => up.0,
            None if are_parallel(DVec3::Y, direction) => DVec3::NEG_Z,
            None => DVec3::Y,
        };
        let two_sided = self.two_sided.as_ref().is_some_and(|two_sided| two_sided.value);
        Ok(LightKind::Area { shape, position, direction, up, two_sided })
    }
}
