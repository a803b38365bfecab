//! Media and their boundaries: Fresnel reflection, films, and what lies below a coat.

use std::ops::Range;
use std::sync::Arc;

use glanz_color::read::{NamedIor, NamedSpectrum, ReadError, ior_partner, read_ior, read_ior_pair};
use glanz_color::{Ior, Spectrum};

use super::builder::Builder;
use super::spectra::unknown;
use crate::file::error::Problem;
use crate::file::tables::colors::SpectralTable;
use crate::file::tables::media::{IorPart, IorTable, IorValue};
use crate::file::tables::values::{At, Number};
use crate::{Boundary, CoatedBoundary, Film, Tint};

/// The thickest film: near 400 nm its fringes are as narrow as the spectral grid of 5 nm.
const THICKEST_FILM_NM: f64 = 1e4;

/// The greatest n and k that are given in numbers.
const GREATEST_INDEX: f64 = 50.0;

/// The name of a medium that has no other.
const IN_NUMBERS: &str = "n and k in numbers";

impl Builder {
    /// The film that a table describes, if it does.
    pub(super) fn film(&mut self, table: &SpectralTable) -> Result<Option<Film>, Problem> {
        let Some(thickness) = &table.film_nm else {
            return match &table.film_ior {
                Some(medium) => {
                    Err(Problem::at(&medium.span, "'film_ior' needs 'film_nm', the film's thickness"))
                }
                None => Ok(None),
            };
        };
        let others = keys_beside_a_film(table);
        if let Some((span, key)) = others.iter().find_map(|(span, key)| Some(((*span)?, key))) {
            return Err(Problem::at(
                span,
                format!("'{key}' beside 'film_nm': the film says how much is reflected"),
            ));
        }
        if !(0.0..=THICKEST_FILM_NM).contains(&thickness.0) {
            let message = format!("expected a film of 0 to {THICKEST_FILM_NM} nm, found {}", thickness.0);
            return Err(Problem::at(&thickness.span, message));
        }
        let film = table.film_ior.as_ref().map_or(Ok(Ior::constant(1.33)), |ior| self.medium(ior))?;
        if let (true, Some(given)) = (film.k.max() > 0.0, &table.film_ior) {
            return Err(Problem::at(&given.span, "a film must be clear; metals absorb"));
        }
        let base = table.ior.as_ref().map_or(Ok(air()), |ior| self.medium(ior))?;
        Ok(Some(Film { thickness_nm: thickness.0, film, base }))
    }

    /// Fresnel reflection at a surface of that index of refraction.
    pub(super) fn fresnel(&mut self, ior: Arc<Ior>, table: &SpectralTable) -> Result<Tint, Problem> {
        if let Some(scale) = &table.scale {
            return Err(Problem::at(&scale.span, "Fresnel reflection has no 'scale'")
                .help("the index of refraction says how much is reflected"));
        }
        let tint = match &table.polarization {
            None => Tint::Ior(ior),
            Some(polarization) => Tint::Polarized(ior, polarization.value),
        };
        self.under_coat(tint, table)
    }

    /// The tint of a film.
    pub(super) fn film_tint(&mut self, film: Film, table: &SpectralTable) -> Result<Tint, Problem> {
        self.under_coat(Tint::Film(Arc::new(film)), table)
    }

    /// A boundary as it is met in air, or below the coat that its table names.
    fn under_coat(&mut self, tint: Tint, table: &SpectralTable) -> Result<Tint, Problem> {
        let Some(coat) = &table.under_coat else { return Ok(tint) };
        let Some(below) = Boundary::of(&tint) else { return Ok(tint) };
        let ior = self.medium(&At { value: coat.ior.clone(), span: coat.span.clone() })?;
        if ior.k.max() > 0.0 {
            return Err(Problem::at(&coat.span, "a coat must be clear; metals absorb"));
        }
        Ok(Tint::Coated(Arc::new(CoatedBoundary { below, coat: ior, alpha: coat.alpha.0 })))
    }

    /// A medium by its name, its index, its numbers or its file.
    pub(super) fn medium(&mut self, value: &At<IorValue>) -> Result<Ior, Problem> {
        match &value.value {
            IorValue::Name(name) => glanz_color::ior(name).map_err(|error| {
                unknown(&error, &value.span)
                    .help("`glanz color list metals` tells the names; or give a number, n and k as \"1.5+3i\", or a file: { file = \"Au.yml\" }")
            }),
            IorValue::Index(index) => Ok(Ior::constant(*index)),
            IorValue::Table(table) => self.medium_of_table(table, &value.span),
        }
    }

    fn medium_of_table(&mut self, table: &IorTable, span: &Range<usize>) -> Result<Ior, Problem> {
        let mut ior = match (&table.file, &table.n) {
            (Some(file), None) if table.k.is_none() && table.nm.is_none() => self.medium_of_file(file)?,
            (Some(file), _) => {
                return Err(Problem::at(&file.span, "'file' has n and k; beside it they are given twice"));
            }
            (None, Some(n)) => self.medium_of_numbers(table, n)?,
            (None, None) => {
                return Err(Problem::at(span, "a medium needs 'n', or a 'file' of n and k")
                    .help("such as { n = 0.2, k = 3.0 }, { nm = [...], n = [...], k = [...] } or { file = \"Au.yml\" }"));
            }
        };
        // A name, even an empty one, is of a medium as a scene holds it.
        if let Some(name) = &table.name {
            (ior.name, ior.source) = (name.clone(), table.source.clone());
        } else if !table.source.is_empty() {
            ior.source.clone_from(&table.source);
        }
        Ok(ior)
    }

    /// The medium of a file, or of a pair of files of n and k.
    fn medium_of_file(&mut self, file: &At<String>) -> Result<Ior, Problem> {
        let bytes = self.read_beside(file)?;
        let partner = ior_partner(file).map(|value| At { value, span: file.span.clone() });
        let k = partner.and_then(|partner| Some((self.read_beside(&partner).ok()?, partner.value)));
        let read = match &k {
            Some((k, name)) => read_ior_pair((&bytes, &file.value), (k, name)),
            None => read_ior(&bytes, &file.value),
        };
        self.settled(read, &file.value, &file.span)
    }

    fn medium_of_numbers(&mut self, table: &IorTable, n: &At<IorPart>) -> Result<Ior, Problem> {
        if let (IorPart::File(n_file), Some(At { value: IorPart::File(k_file), span })) = (&n.value, &table.k)
        {
            let n_file = At { value: n_file.file.clone(), span: n.span.clone() };
            let k_file = At { value: k_file.file.clone(), span: span.clone() };
            let (n, k) = (self.read_beside(&n_file)?, self.read_beside(&k_file)?);
            let read = read_ior_pair((&n, &n_file.value), (&k, &k_file.value));
            return self.settled(read, &n_file.value, &n_file.span);
        }
        let (eta, k) = match &table.nm {
            Some(nm) => return self.medium_at(nm, table, n),
            None => (samples(n)?, table.k.as_ref().map_or(Ok(Spectrum::ZERO), samples)?),
        };
        let medium = Ior { name: IN_NUMBERS.to_owned(), eta, k, source: String::new() };
        // The same at all wavelengths is a complex number, and has its name.
        let is_constant = eta.min() == eta.max() && k.min() == k.max();
        let number = is_constant.then(|| glanz_color::ior(&format!("{}+{}i", eta[0], k[0])).ok()).flatten();
        Ok(number.unwrap_or(medium))
    }

    /// n and k at the wavelengths of a list.
    fn medium_at(&mut self, nm: &At<Vec<Number>>, table: &IorTable, n: &At<IorPart>) -> Result<Ior, Problem> {
        let axis: Vec<f64> = nm.iter().map(|nm| nm.0).collect();
        if axis.is_empty() || axis.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Err(Problem::at(&nm.span, "expected wavelengths in nm, increasing"));
        }
        let part = |part: &At<IorPart>| -> Result<NamedSpectrum, Problem> {
            let values: Vec<f64> = match &part.value {
                IorPart::Number(number) => vec![number.0; axis.len()],
                IorPart::Values(values) => values.iter().map(|value| value.0).collect(),
                IorPart::File(_) => {
                    return Err(Problem::at(&part.span, "a file has its own wavelengths, but 'nm' is given"));
                }
            };
            if values.len() != axis.len() {
                let message =
                    format!("expected {} values, one for each of 'nm', found {}", axis.len(), values.len());
                return Err(Problem::at(&part.span, message));
            }
            Ok(NamedSpectrum { nm: axis.clone(), values, ..NamedSpectrum::default() })
        };
        let eta = part(n)?;
        let k = table.k.as_ref().map(part).transpose()?;
        let name = IN_NUMBERS.to_owned();
        self.settled(Ok(NamedIor { name, eta, k, ..NamedIor::default() }), "ior", &nm.span)
    }

    /// A medium on the grid, with the remarks of what was assumed.
    fn settled(
        &mut self,
        read: Result<NamedIor, ReadError>,
        name: &str,
        span: &Range<usize>,
    ) -> Result<Ior, Problem> {
        let (ior, notes) =
            read.and_then(|medium| medium.to_ior()).map_err(|error| Problem::at(span, error.to_string()))?;
        self.input.notes.extend(notes.iter().map(|note| format!("'{name}': {note}")));
        Ok(ior)
    }
}

/// n or k as a scene holds it.
fn samples(part: &At<IorPart>) -> Result<Spectrum, Problem> {
    let spectrum = match &part.value {
        IorPart::Number(number) => Spectrum::constant(number.0),
        IorPart::Values(values) => {
            let values: Vec<f64> = values.iter().map(|value| value.0).collect();
            Spectrum::try_from(values).map_err(|error| {
                Problem::at(&part.span, error).help("give the wavelengths of shorter lists as 'nm'")
            })?
        }
        IorPart::File(_) => {
            return Err(Problem::at(&part.span, "n and k come both from files, or none of them"));
        }
    };
    if spectrum.min() < 0.0 || spectrum.max() > GREATEST_INDEX {
        let message = format!(
            "expected numbers from 0 to {GREATEST_INDEX}, found {} to {}",
            spectrum.min(),
            spectrum.max()
        );
        return Err(Problem::at(&part.span, message));
    }
    Ok(spectrum)
}

/// What a film lies on that says nothing else.
pub(in crate::file) fn air() -> Ior {
    Ior { name: "air".to_owned(), ..Ior::constant(1.0) }
}

/// The keys that a film has none of, where they stand.
fn keys_beside_a_film(table: &SpectralTable) -> [(Option<&Range<usize>>, &'static str); 14] {
    [
        (table.scale.as_ref().map(|v| &v.span), "scale"),
        (table.spectrum.as_ref().map(|v| &v.span), "spectrum"),
        (table.reradiation.as_ref().map(|v| &v.span), "reradiation"),
        (table.dye.as_ref().map(|v| &v.span), "dye"),
        (table.file.as_ref().map(|v| &v.span), "file"),
        (table.column.as_ref().map(|v| &v.span), "column"),
        (table.blackbody.as_ref().map(|v| &v.span), "blackbody"),
        (table.gaussian.as_ref().map(|v| &v.span), "gaussian"),
        (table.line.as_ref().map(|v| &v.span), "line"),
        (table.nm.as_ref().map(|v| &v.span), "nm"),
        (table.value.as_ref().map(|v| &v.span), "value"),
        (table.samples.as_ref().map(|v| &v.span), "samples"),
        (table.matrix.as_ref().map(|v| &v.span), "matrix"),
        (table.polarization.as_ref().map(|v| &v.span), "polarization"),
    ]
}
