//! The kinds of plots, and which options act on which.

use clap::ValueEnum;

use super::PlotArgs;
use crate::print::failure::Failure;

/// The kinds of plots.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(super) enum Kind {
    /// Values about a point of the surface, in the plane of incidence
    #[default]
    Polar,
    /// The same over the angle of the light
    Cartesian,
    /// The lobe for one view direction as a body
    Lobe3d,
    /// The part of the light that leaves, over the angle of the viewer
    Albedo,
    /// Values over half and difference angle (Rusinkiewicz 1998) at φd = 90°, in false colours
    Slice,
    /// The reflectance of media over the angle of incidence, exact and by Schlick's formula
    Fresnel,
    /// The factors D, G and F of microfacet models; G while the viewer stays and the light moves
    Terms,
    /// What arrives of a light over distance
    Attenuation,
    /// What arrives of a spot over the angle from its axis
    Spot,
    /// The directions N, L, V, R and H at a point, with their angles and cosines
    Vectors,
}

use Kind::{Albedo, Attenuation, Cartesian, Fresnel, Lobe3d, Polar, Slice, Spot, Terms, Vectors};

/// Kinds that plot values of lobes.
const VALUES: &[Kind] = &[Polar, Cartesian, Lobe3d, Slice];
/// Kinds that plot lobes by their tint.
const TINTED: &[Kind] = &[Polar, Cartesian, Lobe3d, Albedo, Slice];
/// Kinds that plot models.
const MODELS: &[Kind] = &[Polar, Cartesian, Lobe3d, Albedo, Slice, Terms];

/// An option, the kinds that it acts on, and whether it is given.
type Effect = (&'static str, &'static [Kind], fn(&PlotArgs) -> bool);

/// Options that do not act on all kinds.
const EFFECTS: [Effect; 14] = [
    ("a model", MODELS, |args| !args.models.is_empty()),
    ("--set", &[Polar, Cartesian, Lobe3d, Albedo, Slice, Terms, Attenuation, Spot], |args| {
        !args.set.set.is_empty()
    }),
    ("--theta", &[Polar, Cartesian, Lobe3d, Terms], |args| !args.theta.is_empty()),
    ("--phi", MODELS, |args| args.phi.is_some()),
    ("--quantity", VALUES, |args| args.quantity.is_some()),
    ("--unit", VALUES, |args| args.unit.is_some()),
    ("--log", &[Polar, Cartesian, Lobe3d, Albedo, Slice, Fresnel, Terms, Attenuation, Spot], |args| args.log),
    ("--ior", &[Polar, Cartesian, Lobe3d, Albedo, Slice, Fresnel, Terms], |args| args.ior.is_some()),
    ("--tint", TINTED, |args| args.tint.is_some()),
    ("--lambda-nm", &[Polar, Cartesian, Lobe3d, Albedo, Slice, Fresnel, Terms], |args| {
        args.lambda_nm.is_some()
    }),
    ("--polarised", &[Fresnel], |args| args.polarised),
    ("--distance", &[Attenuation], |args| args.distance.is_some()),
    ("--wo", &[Vectors], |args| args.wo.is_some()),
    ("--wi", &[Vectors], |args| args.wi.is_some()),
];

impl Kind {
    /// The name on the command line.
    fn name(self) -> String {
        self.to_possible_value().map_or(String::new(), |value| value.get_name().to_owned())
    }

    /// That every option acts on the kind.
    pub(super) fn check_options(self, args: &PlotArgs) -> Result<(), Failure> {
        let useless = EFFECTS.iter().find(|(_, kinds, given)| given(args) && !kinds.contains(&self));
        let Some((option, kinds, _)) = useless else { return Ok(()) };
        let names: Vec<_> = kinds.iter().map(|kind| kind.name()).collect();
        let names = enumerated(&names);
        Err(Failure::Usage(format!("{option} has no effect on --kind {}; it acts on {names}", self.name())))
    }
}

/// Names in a sentence: `a, b and c`.
pub(super) fn enumerated(names: &[String]) -> String {
    match names {
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
        [] => String::new(),
    }
}
