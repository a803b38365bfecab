//! What is measured: a table, a model, or a material.

use std::path::Path;
use std::sync::Arc;

use glanz_bsdf::{DirectionPair, MODELS, Shape};
use glanz_color::{Observer, Spectrum, SpectrumKind, fluorescent};
use glanz_math::Vec3;
use glanz_math::names::did_you_mean;
use glanz_measure::{Channels, Data, FactorOptions, Factored, Measured, forty_five_zero};
use glanz_plot::Factor;
use glanz_render::MaterialResponse;
use glanz_scene::file::LoadOptions;
use glanz_scene::{Lobe, Material, OpenError, Tint, library};

use super::AppearanceArgs;
use crate::commands::bsdf::shape_of;
use crate::commands::measure::{is_measured, read};
use crate::input::media;
use crate::input::spectra::{Source, TableArgs, source};
use crate::load::failure_of_scene;
use crate::print;
use crate::print::failure::{Failure, Report};

/// What is measured.
pub(super) enum Subject {
    /// A table, with values everywhere.
    Table(Box<Measured>),
    /// A model at one wavelength, and the material that it is at all of them.
    Model { shape: Box<Shape>, factor: Factor, matte: f64, material: Box<Material> },
    /// A material.
    Material(Box<Material>),
}

/// A BRDF of some numbers.
pub(super) type Brdf<'a> = Box<dyn FnMut(Vec3<f64>, Vec3<f64>) -> Vec<f64> + 'a>;

impl Subject {
    /// The one that the command line names.
    pub(super) fn of(args: &AppearanceArgs) -> Result<Self, Failure> {
        let (name, path) = (args.name.as_str(), Path::new(&args.name));
        let ending = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        if args.material.is_some() && ending != "toml" {
            return Err(Failure::Usage("--material is of scene files, whose names end in .toml".to_owned()));
        }
        let is_name = MODELS.iter().any(|info| info.name == name);
        let is_word = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
        let found = match ending.as_str() {
            "toml" => Self::Material(Box::new(of_scene(path, args.material.as_deref())?)),
            table if table == "txt" || is_measured(path) => of_data(path, args)?,
            _ if is_name || !is_word => return of_model(args),
            _ => Self::Material(Box::new(of_library(name)?)),
        };
        match args.of_models() {
            Some(option) => Err(Failure::Usage(format!("{option} is of models, and '{name}' is none"))),
            None => Ok(found),
        }
    }

    /// Names of the channels of [`Numbers::shown`].
    pub(super) fn channels(&self) -> Vec<String> {
        match self {
            Self::Table(measured) => measured.channels().names(),
            Self::Model { .. } | Self::Material(_) => vec!["Y".to_owned()],
        }
    }

    /// X, Y and Z at 45°/0°, under a light and for an observer other than those that are asked for; none for what has colours of
    /// its own light only.
    pub(super) fn xyz_under(&self, light: &Source, observer: &Observer) -> Option<[f64; 3]> {
        let material = match self {
            Self::Table(measured) if !measured.channels().has_spectra() => return None,
            Self::Table(measured) => {
                let factors = forty_five_zero(&mut |wi, wo| of_measured(measured, wi, wo));
                return measured.channels().xyz(&factors, &light.fine, observer);
            }
            Self::Model { material, .. } | Self::Material(material) => material,
        };
        let response = MaterialResponse::new(material, &light.spectrum, observer).ok()?;
        forty_five_zero(&mut |wi, wo| response.brdf(wi, wo).to_vec()).try_into().ok()
    }
}

/// What is measured, under a light and for an observer.
pub(super) struct Numbers<'a> {
    subject: &'a Subject,
    light: &'a Source,
    observer: &'a Observer,
    response: Option<MaterialResponse>,
}

impl<'a> Numbers<'a> {
    /// Under a light, for an observer with X, Y and Z.
    pub(super) fn new(
        subject: &'a Subject,
        light: &'a Source,
        observer: &'a Observer,
    ) -> Result<Self, Failure> {
        let response = match subject {
            Subject::Table(_) => None,
            Subject::Model { material, .. } | Subject::Material(material) => {
                let response = MaterialResponse::new(material, &light.spectrum, observer);
                Some(response.map_err(Failure::new)?)
            }
        };
        Ok(Self { subject, light, observer, response })
    }

    /// The BRDF in the channels that are shown.
    pub(super) fn shown(&self) -> Brdf<'_> {
        match (self.subject, &self.response) {
            (Subject::Table(measured), _) => Box::new(|wi, wo| of_measured(measured, wi, wo)),
            (Subject::Model { shape, factor, matte, .. }, _) => Box::new(move |wi, wo| {
                let reflected = factor.f_cos(shape, &DirectionPair::new(wo, wi)) / wi.z.max(1e-12);
                vec![reflected + matte * core::f64::consts::FRAC_1_PI]
            }),
            (Subject::Material(_), response) => {
                let response = response.as_ref().expect("materials have one");
                Box::new(|wi, wo| vec![response.brdf(wi, wo)[1]])
            }
        }
    }

    /// The BRDF in the channels that are shown, and then in those that [`Self::xyz`] makes colours of.
    pub(super) fn all(&self) -> Brdf<'_> {
        let mut shown = self.shown();
        match &self.response {
            None => shown,
            Some(response) => Box::new(move |wi, wo| {
                let mut values = shown(wi, wo);
                values.extend(response.brdf(wi, wo));
                values
            }),
        }
    }

    /// The part of light at an angle from the normal that perfect mirrors reflect, in the channels of [`Self::shown`].
    pub(super) fn shown_mirror(&self, degrees: f64) -> Vec<f64> {
        let theta = degrees.to_radians();
        match (self.subject, &self.response) {
            (Subject::Model { shape, factor, .. }, _) if shape.info().delta => {
                let wo = Vec3::from_angles(theta, 0.0);
                vec![factor.value(shape, &DirectionPair::new(wo, Vec3::new(-wo.x, -wo.y, wo.z)))]
            }
            (Subject::Material(_), Some(response)) => vec![response.mirror(theta)[1]],
            _ => vec![0.0; self.subject.channels().len()],
        }
    }

    /// The same in those of [`Self::all`].
    pub(super) fn all_mirror(&self, degrees: f64) -> Vec<f64> {
        let mut values = self.shown_mirror(degrees);
        values.extend(self.response.iter().flat_map(|response| response.mirror(degrees.to_radians())));
        values
    }

    /// X, Y and Z of radiance factors that [`Self::all`] gave.
    pub(super) fn xyz(&self, factors: &[f64]) -> Option<[f64; 3]> {
        match self.subject {
            Subject::Table(measured) => measured.channels().xyz(factors, &self.light.fine, self.observer),
            _ => factors.last_chunk::<3>().copied().filter(|xyz| xyz.iter().all(|value| value.is_finite())),
        }
    }

    /// X, Y and Z of the perfect diffuser.
    pub(super) fn white(&self) -> Option<[f64; 3]> {
        match (self.subject, &self.response) {
            (Subject::Table(measured), _) => measured.channels().white(&self.light.fine, self.observer),
            (_, response) => response.as_ref().map(MaterialResponse::white),
        }
    }

    /// What a reader of the numbers should know of what was measured.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.response.as_ref().is_some_and(MaterialResponse::has_mirror) {
            notes.push(
                "the material has a perfect mirror: its light is in gloss and in the sphere (SCI), and in no receptor \
                 beside its direction"
                    .to_owned(),
            );
        }
        if let Subject::Table(measured) = self.subject {
            notes.extend(measured.notes.iter().cloned());
            notes.extend(note_of_channels(measured.channels(), self.light));
        }
        notes
    }
}

/// How colours come from channels that are no spectra.
fn note_of_channels(channels: &Channels, light: &Source) -> Option<String> {
    let note = match channels {
        Channels::Rgb => {
            "RGB is taken as linear sRGB, so colours are under D65 for cie1931, whatever light and observer"
        }
        Channels::Xyz => "X, Y and Z are taken as of D65 for cie1931, with Y = 1 for the perfect diffuser",
        Channels::Luminance => "one channel is taken as a grey, the same at all wavelengths",
        Channels::Wavelengths(nm) => {
            let (first, last) = (nm.first()?, nm.last()?);
            let outside =
                light.spectrum.points().filter(|(at, value)| *value > 0.0 && (at < first || at > last));
            let is_seen = outside.into_iter().any(|(at, _)| (400.0..=700.0).contains(&at));
            return is_seen.then(|| format!("beyond {first} to {last} nm the end values are held"));
        }
    };
    Some(note.to_owned())
}

fn of_measured(measured: &Measured, wi: Vec3<f64>, wo: Vec3<f64>) -> Vec<f64> {
    measured.value(wi, wo).unwrap_or_else(|| vec![0.0; measured.channels().count()])
}

/// A table as it is; readings as they are drawn, smoothed by Gaussians.
fn of_data(path: &Path, args: &AppearanceArgs) -> Result<Subject, Failure> {
    let measured = read(path, &args.read)?;
    if !matches!(measured.data, Data::Readings(_)) {
        return Ok(Subject::Table(Box::new(measured)));
    }
    let factored = Factored::of(&measured, &FactorOptions::default())
        .map_err(|error| Failure::from(Report::new(error).file(path)))?;
    measured.notes.iter().for_each(|note| print::note(format_args!("note: {note}")));
    print::note(format_args!("note: readings are smoothed; the numbers are of what lies between them"));
    Ok(Subject::Material(Box::new(Material::measured(path.display().to_string(), &factored))))
}

fn of_model(args: &AppearanceArgs) -> Result<Subject, Failure> {
    let shape = shape_of(&args.name, &args.set)?;
    let factor = args.factor.factor()?;
    let tint = match (&args.factor.ior, &args.factor.tint) {
        (Some(word), _) => media::tint(word)?,
        (None, Some(word)) => match word.trim().parse::<f64>() {
            Ok(value) => grey(value),
            Err(_) => {
                let found = source(word, Some(SpectrumKind::Surface), &TableArgs::default())?;
                Tint::Spectrum(Arc::new(found.spectrum))
            }
        },
        (None, None) => grey(1.0),
    };
    let mut lobes = vec![Lobe::new(shape.clone(), tint)];
    if args.diffuse > 0.0 {
        lobes.push(Lobe::new(lambert(), grey(args.diffuse)));
    }
    let material = Box::new(Material::of_lobes(args.name.clone(), lobes));
    Ok(Subject::Model { shape: Box::new(shape), factor, matte: args.diffuse, material })
}

/// The material of a scene file: the one that is named, or the only one.
pub(in crate::commands::measure) fn of_scene(path: &Path, name: Option<&str>) -> Result<Material, Failure> {
    let opened = glanz_scene::open(path, &LoadOptions::default()).map_err(|error| match error {
        OpenError::Scene(error) => failure_of_scene(error, "--material"),
        OpenError::Model(error) => Report::from(&error).into(),
    })?;
    let materials = opened.scene.materials;
    let names: Vec<&str> = materials.iter().map(|material| material.name.as_str()).collect();
    let listed = names.join(", ");
    let wrong = |message: String| Err(Failure::Usage(message));
    match name {
        Some(name) => match names.iter().position(|own| *own == name) {
            Some(index) => Ok(materials[index].clone()),
            None => {
                let near = did_you_mean(name, names.iter().copied());
                wrong(format!("--material {name}: the scene has {listed}{near}"))
            }
        },
        None if materials.len() == 1 => Ok(materials[0].clone()),
        None if materials.is_empty() => wrong(format!("'{}' has no material", path.display())),
        None => {
            wrong(format!("'{}' has several materials; name one with --material: {listed}", path.display()))
        }
    }
}

/// A material of the library, or a matte surface that re-radiates.
pub(in crate::commands::measure) fn of_library(name: &str) -> Result<Material, Failure> {
    if let Ok(material) = library::material(name) {
        return Ok(material);
    }
    if let Ok(matrix) = fluorescent(name) {
        let lobe = Lobe::new(lambert(), Tint::Reradiation(Arc::new(matrix)));
        return Ok(Material::of_lobes(name, vec![lobe]));
    }
    let known = MODELS.iter().map(|info| info.name).chain(library::names());
    let near = did_you_mean(name, known);
    Err(Failure::Usage(format!("there is no model, material or fluorescent surface '{name}'{near}")))
}

fn grey(value: f64) -> Tint {
    Tint::Spectrum(Arc::new(Spectrum::constant(value)))
}

fn lambert() -> Shape {
    Shape::named("lambert", &[]).expect("the list of models has it")
}
