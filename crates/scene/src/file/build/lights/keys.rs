//! Which keys go with which kind of light.

use std::ops::Range;

use crate::file::error::Problem;
use crate::file::tables::lights::KindName::{
    Ambient, Directional, Disk, Environment, Point, Rectangle, Sphere, Spot,
};
use crate::file::tables::lights::{KindName, LightTable};
use crate::file::tables::values::At;

/// The kinds whose light comes from somewhere.
const NOT_AMBIENT: &[KindName] = &[Directional, Point, Spot, Rectangle, Disk, Sphere, Environment];

/// A key, its place where it is given, and the kinds of light that have it.
type Key<'a> = (&'static str, Option<&'a Range<usize>>, &'static [KindName]);

fn place<T>(value: &Option<At<T>>) -> Option<&Range<usize>> {
    value.as_ref().map(|v| &v.span)
}

impl LightTable {
    /// Keys that lights of this kind do not have.
    pub(super) fn refuse_foreign_keys(&self) -> Result<(), Problem> {
        for (key, span, kinds) in self.keys() {
            if let Some(span) = span.filter(|_| !kinds.contains(&self.kind)) {
                let kinds = kinds.iter().map(|kind| kind.name()).collect::<Vec<_>>().join(", ");
                let message = format!("{} light has no '{key}'", with_article(self.kind));
                return Err(Problem::at(span, message).help(format!("'{key}' is for lights of kind {kinds}")));
            }
        }
        self.refuse_keys_without_a_profile()
    }

    /// The keys that only some kinds of light have.
    fn keys(&self) -> [Key<'_>; 28] {
        [
            ("position", place(&self.position), &[Point, Spot, Rectangle, Disk, Sphere]),
            ("direction", place(&self.direction), &[Directional, Point, Spot, Rectangle, Disk]),
            ("target", place(&self.target), &[Point, Spot, Rectangle, Disk]),
            ("diffuse", place(&self.diffuse), NOT_AMBIENT),
            ("specular", place(&self.specular), NOT_AMBIENT),
            ("attenuation", place(&self.attenuation), &[Point, Spot]),
            ("cutoff_deg", place(&self.cutoff_deg), &[Spot]),
            ("cutoff_rad", place(&self.cutoff_rad), &[Spot]),
            ("smooth_edge", place(&self.smooth_edge), &[Spot]),
            ("exponent", place(&self.exponent), &[Spot]),
            ("attached_to", place(&self.attached_to), &[Directional, Point, Spot, Rectangle, Disk, Sphere]),
            ("illuminance_lx", place(&self.illuminance_lx), &[Directional]),
            ("luminous_intensity_cd", place(&self.luminous_intensity_cd), &[Point, Spot]),
            ("radiant_intensity_w_sr", place(&self.radiant_intensity_w_sr), &[Point, Spot]),
            (
                "luminance_cd_m2",
                place(&self.luminance_cd_m2),
                &[Ambient, Rectangle, Disk, Sphere, Environment],
            ),
            ("luminous_flux_lm", place(&self.luminous_flux_lm), &[Rectangle, Disk, Sphere]),
            ("profile", place(&self.profile), &[Point, Spot]),
            ("profile_c0", place(&self.profile_c0), &[Point, Spot]),
            ("dimming", place(&self.dimming), &[Point, Spot]),
            ("width", place(&self.width), &[Rectangle]),
            ("height", place(&self.height), &[Rectangle]),
            ("size", place(&self.size), &[Rectangle]),
            ("radius", place(&self.radius), &[Disk, Sphere]),
            ("up", place(&self.up), &[Rectangle]),
            ("two_sided", place(&self.two_sided), &[Rectangle, Disk]),
            ("file", place(&self.file), &[Environment]),
            ("rotate_deg", place(&self.rotate_deg), &[Environment]),
            ("rotation", place(&self.rotation), &[Environment]),
        ]
    }

    /// Keys of point and spot lights that mean something with a profile only.
    fn refuse_keys_without_a_profile(&self) -> Result<(), Problem> {
        if self.profile.is_some() {
            return Ok(());
        }
        let of_point = |span| if self.kind == Point { span } else { None };
        let given = [
            ("direction", of_point(place(&self.direction))),
            ("target", of_point(place(&self.target))),
            ("profile_c0", place(&self.profile_c0)),
            ("dimming", place(&self.dimming)),
        ];
        match given.into_iter().find_map(|(key, span)| Some((key, span?))) {
            None => Ok(()),
            Some((key, span)) => {
                let message = format!("{} light without 'profile' has no '{key}'", with_article(self.kind));
                Err(Problem::at(span, message))
            }
        }
    }
}

fn with_article(kind: KindName) -> String {
    let article = if matches!(kind, Ambient | Environment) { "an" } else { "a" };
    format!("{article} {}", kind.name())
}
