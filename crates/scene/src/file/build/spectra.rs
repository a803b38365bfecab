//! From colours and spectral tables to the colours of lights and surfaces.

use std::ops::Range;
use std::sync::Arc;

use glanz_color::read::{NamedSpectrum, Quantity, ReadOptions, Scale, ValueScale, preferred};
use glanz_color::{FIRST_NM, Ior, LAST_NM, Observer, Outside, Reradiation, Spectrum, UnknownName};

use super::builder::Builder;
use super::remarks::check_scale;
use super::units::for_luminance;
use crate::file::error::Problem;
use crate::file::tables::colors::{ColorValue, SpectralTable, SpectrumValue};
use crate::file::tables::sampled::{ObserverValue, Sampled};
use crate::file::tables::spectra_files::{AxisUnit, Column, FileQuantity, FileScale, ScaleValue};
use crate::file::tables::values::{At, Number};
use crate::{LightColor, Pane, Tint};

/// What a function of wavelength stands for.
enum Function {
    Light(Spectrum),
    Fraction(Spectrum),
    /// From a file or given in numbers: what it stands for is where it stands.
    Either(Spectrum),
    Reradiation(Arc<Reradiation>),
    Ior(Arc<Ior>),
}

impl Builder {
    /// The colour of a lamp, in classic units: spectra get the luminance 1, or the power of D65 with
    /// that luminance where they are hardly visible, times `scale`.
    pub(super) fn light_color(&mut self, value: &At<ColorValue>) -> Result<LightColor, Problem> {
        match &value.value {
            ColorValue::Rgb(color) => Ok(color.0.into()),
            ColorValue::Spectral(table) => {
                if let Some(luminance) = &table.luminance_cd_m2 {
                    let help = "lights have illuminance_lx, luminous_intensity_cd and radiant_intensity_w_sr";
                    return Err(
                        Problem::at(&luminance.span, "'luminance_cd_m2' in the colour of a lamp").help(help)
                    );
                }
                self.unit_light(table, &value.span)
            }
        }
    }

    /// The same, from the key `spectrum` of a light.
    pub(super) fn light_spectrum(&mut self, value: &At<SpectrumValue>) -> Result<LightColor, Problem> {
        match &value.value {
            SpectrumValue::Table(table) => self.unit_light(table, &value.span),
            SpectrumValue::Name(name) => {
                let spectrum = Some(At { value: name.clone(), span: value.span.clone() });
                self.unit_light(&SpectralTable { spectrum, ..SpectralTable::default() }, &value.span)
            }
        }
    }

    fn unit_light(&mut self, table: &SpectralTable, span: &Range<usize>) -> Result<LightColor, Problem> {
        if let Some(pane) = &table.pane {
            return Err(Problem::at(&pane.span, "'pane' is for what surfaces do with light"));
        }
        if let Some(schlick) = &table.schlick {
            return Err(Problem::at(&schlick.span, "'schlick' is for what surfaces do with light"));
        }
        let spectrum = match self.function(table, span, true)? {
            Function::Light(spectrum) | Function::Either(spectrum) => spectrum,
            Function::Fraction(_) => {
                return Err(Problem::at(span, "a lamp needs light, found a reflectance")
                    .help("the light sources are listed by `glanz color list lights`"));
            }
            Function::Reradiation(_) | Function::Ior(_) => {
                return Err(Problem::at(span, "a lamp needs light, found what surfaces do with light"));
            }
        };
        let scale = table.scale.as_ref().map_or(1.0, |scale| scale.factor());
        if table.samples.is_some() {
            return Ok(LightColor::Spectrum(Arc::new(spectrum * scale)));
        }
        match LightColor::unit(&spectrum) {
            Some(unit) => Ok(unit.scaled(scale)),
            None => Err(Problem::at(span, "there is no light in this spectrum between 300 and 780 nm")),
        }
    }

    /// The tint of a surface.
    pub(super) fn tint(&mut self, value: &At<ColorValue>) -> Result<Tint, Problem> {
        let table = match &value.value {
            ColorValue::Rgb(color) => {
                check_scale(color.0, &value.span)?;
                return Ok(color.0.into());
            }
            ColorValue::Spectral(table) => table,
        };
        if let Some(luminance) = &table.luminance_cd_m2 {
            return Err(Problem::at(&luminance.span, "'luminance_cd_m2' is for light that a surface sends")
                .help("give it in 'emission'"));
        }
        if let Some(at_normal) = &table.schlick {
            return Ok(Tint::Schlick(Box::new(self.tint(at_normal)?)));
        }
        if let Some(pane) = &table.pane {
            let ior = self.medium(&At { value: pane.ior.clone(), span: pane.span.clone() })?;
            let absorption = pane.absorption.as_ref().map_or(Spectrum::ZERO, |samples| samples.0);
            return Ok(Tint::Pane(Arc::new(Pane { ior, thickness: pane.thickness_m.0, absorption })));
        }
        if let Some(film) = self.film(table)? {
            return self.film_tint(film, table);
        }
        let scale = table.scale.as_ref().map_or(1.0, |scale| scale.factor());
        Ok(match self.function(table, &value.span, false)? {
            Function::Fraction(spectrum) | Function::Either(spectrum) => {
                let spectrum = spectrum * scale;
                let most = spectrum.max();
                if most > 1.0 {
                    let note = format!("a reflectance of up to {most:.3} returns more light than arrives");
                    self.input.notes.push(note);
                }
                Tint::Spectrum(Arc::new(spectrum))
            }
            Function::Light(_) => {
                return Err(Problem::at(&value.span, "a surface needs a reflectance, found a light source")
                    .help("the reflectances are listed by `glanz color list reflectances`"));
            }
            Function::Reradiation(matrix) if scale == 1.0 => Tint::Reradiation(matrix),
            Function::Reradiation(matrix) => Tint::Reradiation(Arc::new(matrix.scaled(scale))),
            Function::Ior(ior) => self.fresnel(ior, table)?,
        })
    }

    /// Light that a surface sends itself. A luminance in cd/m² makes the scene one in photometric units.
    pub(super) fn emission(&mut self, value: &At<ColorValue>) -> Result<Tint, Problem> {
        let table = match &value.value {
            ColorValue::Rgb(color) => {
                let tint = Tint::Rgb(color.0);
                self.units.classic.extend((!tint.is_black()).then(|| value.span.clone()));
                return Ok(tint);
            }
            ColorValue::Spectral(table) => table,
        };
        let color = self.unit_light(table, &value.span)?;
        let color = match &table.luminance_cd_m2 {
            Some(luminance) => {
                self.units.photometric.push(luminance.span.clone());
                color.scaled(for_luminance(&color, luminance.0, &luminance.span)?)
            }
            None => {
                self.units.classic.push(value.span.clone());
                color
            }
        };
        Ok(match color {
            LightColor::Rgb(rgb) => Tint::Rgb(rgb),
            LightColor::Spectrum(spectrum) => Tint::Spectrum(spectrum),
        })
    }

    /// The one function that the table names; `light` tells which names are looked up first.
    fn function(
        &mut self,
        table: &SpectralTable,
        span: &Range<usize>,
        light: bool,
    ) -> Result<Function, Problem> {
        refuse_keys_out_of_place(table)?;
        match functions(table).as_slice() {
            ["spectrum"] => named(table.spectrum.as_ref().expect("it is given"), light),
            ["blackbody"] => {
                formula(table.blackbody.as_ref().expect("it is given"), |t| format!("blackbody({t})"))
            }
            ["line"] => formula(table.line.as_ref().expect("it is given"), |nm| format!("line({nm})")),
            ["gaussian"] => gaussian(table.gaussian.as_ref().expect("it is given")),
            ["file"] => self.read_function(table.file.as_ref().expect("it is given"), table, light),
            ["nm"] => self.read_numbers(table, span, light),
            ["samples"] => Ok(Function::Either(table.samples.as_ref().expect("it is given").0)),
            ["matrix"] => matrix(table.matrix.as_ref().expect("it is given")),
            ["reradiation"] => self.reradiation(table.reradiation.as_ref().expect("it is given")),
            ["dye"] => {
                let layer = self.dye(table.dye.as_ref().expect("it is given"))?;
                Ok(Function::Reradiation(Arc::new(layer)))
            }
            ["ior"] => Ok(Function::Ior(Arc::new(self.medium(table.ior.as_ref().expect("it is given"))?))),
            [] => Err(Problem::at(span, "a table in place of a colour names no function of wavelength")
                .help(
                    "give one of spectrum, blackbody, gaussian, line, file, nm with value, reradiation, ior",
                )),
            several => {
                let message =
                    format!("'{}' in one table: only one can be the colour", several.join("' and '"));
                Err(Problem::at(span, message))
            }
        }
    }

    fn read_function(
        &mut self,
        file: &At<String>,
        table: &SpectralTable,
        light: bool,
    ) -> Result<Function, Problem> {
        let bytes = self.read_beside(file)?;
        let spectra = glanz_color::read::read_spectra_with(&bytes, file, &read_options(table, light))
            .map_err(|error| Problem::at(&file.span, error.to_string()))?;
        let (chosen, remark) = choose(&spectra, file, table.column.as_ref())?;
        self.input.notes.extend(remark);
        let help = "if the file is wrong about it, say what it is with as = \"light\" or as = \"surface\"";
        match chosen.quantity {
            quantity if light && quantity.is_ratio() => {
                let message = "a lamp needs light, found a reflectance or transmittance in the file";
                return Err(Problem::at(&file.span, message).help(help));
            }
            Quantity::Light if !light => {
                let message = "a surface needs a reflectance, found light in the file";
                return Err(Problem::at(&file.span, message).help(help));
            }
            _ => {}
        }
        let told = chosen.notes.iter().map(|note| format!("'{}': {note}", file.value));
        self.input.notes.extend(told);
        let (spectrum, notes) = chosen
            .to_spectrum(Some(beyond(light)))
            .map_err(|error| Problem::at(&file.span, error.to_string()))?;
        self.input.notes.extend(notes.iter().map(|note| format!("'{}': {note}", file.value)));
        Ok(Function::Either(spectrum))
    }

    fn read_numbers(
        &mut self,
        table: &SpectralTable,
        span: &Range<usize>,
        light: bool,
    ) -> Result<Function, Problem> {
        let (Some(nm), Some(values)) = (&table.nm, &table.value) else {
            return Err(Problem::at(span, "'nm' and 'value' need each other; one of them is missing"));
        };
        let plain = |list: &[Number]| list.iter().map(|v| v.0).collect::<Vec<f64>>();
        if let Some(negative) = values.iter().find(|v| v.0 < 0.0) {
            let message = format!("expected values of at least 0, found {}", negative.0);
            return Err(Problem::at(&values.span, message));
        }
        let spectrum = Spectrum::from_table(&plain(nm), &plain(values), beyond(light))
            .map_err(|error| Problem::at(&nm.span, error.to_string()))?;
        let (first, last) = (nm[0].0, nm[nm.len() - 1].0);
        if last < FIRST_NM || first > LAST_NM {
            let message =
                format!("expected wavelengths in nm, some between 300 and 780, found {first} to {last}");
            return Err(Problem::at(&nm.span, message));
        }
        if light && (first > FIRST_NM || last < LAST_NM) {
            self.input.notes.push(format!("a lamp given from {first} to {last} nm sends nothing beyond"));
        }
        Ok(Function::Either(spectrum))
    }

    fn reradiation(&mut self, name: &At<String>) -> Result<Function, Problem> {
        let known = match glanz_color::fluorescent(name) {
            Ok(matrix) => return Ok(Function::Reradiation(Arc::new(matrix))),
            Err(error) => error,
        };
        if !name.contains('.') {
            return Err(unknown(&known, &name.span)
                .help("`glanz color list fluorescent` tells the names; or give a file (BFC, CSV)"));
        }
        let bytes = self.read_beside(name)?;
        let measured = glanz_color::read::read_reradiation(&bytes, name)
            .map_err(|error| Problem::at(&name.span, error.to_string()))?;
        let matrix = measured.to_reradiation().map_err(|error| Problem::at(&name.span, error.to_string()))?;
        self.input.notes.extend(measured.notes.iter().map(|note| format!("'{}': {note}", name.value)));
        let energy = matrix.energy();
        if !energy.ok {
            let (most, nm) = (energy.max_column_sum, energy.at_nm);
            self.input
                .notes
                .push(format!("'{}' sends out {most:.2} of the light at {nm} nm: impossible", name.value));
        }
        Ok(Function::Reradiation(Arc::new(matrix)))
    }

    /// An observer by name, or a sensor from a file with a curve for each of its channels.
    pub(super) fn observer(&mut self, value: &At<ObserverValue>) -> Result<Observer, Problem> {
        let name = match &value.value {
            ObserverValue::Table(table) => return Ok(table.observer()),
            ObserverValue::Name(name) => &At { value: name.clone(), span: value.span.clone() },
        };
        let known = match glanz_color::observer(name) {
            Ok(observer) => return Ok(observer),
            Err(error) => error,
        };
        if !name.contains('.') {
            return Err(unknown(&known, &name.span)
                .help("`glanz color list observers` tells the names; or give a file (CSV)"));
        }
        let bytes = self.read_beside(name)?;
        crate::read::read_sensor(&bytes, name).map_err(|message| Problem::at(&name.span, message))
    }
}

/// The keys of a table that are functions of wavelength.
fn functions(table: &SpectralTable) -> Vec<&'static str> {
    let given = [
        ("spectrum", table.spectrum.is_some()),
        ("blackbody", table.blackbody.is_some()),
        ("gaussian", table.gaussian.is_some()),
        ("line", table.line.is_some()),
        ("file", table.file.is_some()),
        ("nm", table.nm.is_some() || table.value.is_some()),
        ("samples", table.samples.is_some()),
        ("reradiation", table.reradiation.is_some()),
        ("dye", table.dye.is_some()),
        ("matrix", table.matrix.is_some()),
        ("ior", table.ior.is_some()),
    ];
    given.iter().filter(|(_, given)| *given).map(|(name, _)| *name).collect()
}

/// Keys that mean something with another key only, or elsewhere.
fn refuse_keys_out_of_place(table: &SpectralTable) -> Result<(), Problem> {
    if let Some(thickness) = &table.film_nm {
        return Err(Problem::at(&thickness.span, "'film_nm' is for what surfaces do with light"));
    }
    if let Some(medium) = &table.film_ior {
        return Err(Problem::at(&medium.span, "'film_ior' is for what surfaces do with light"));
    }
    if let (Some(polarization), None) = (&table.polarization, &table.ior) {
        return Err(Problem::at(&polarization.span, "'polarization' needs 'ior'"));
    }
    if let (Some(coat), None) = (&table.under_coat, &table.ior) {
        return Err(Problem::at(&coat.span, "'under_coat' needs 'ior' or 'film_nm'"));
    }
    let of_files = [
        (table.column.as_ref().map(|v| &v.span), "'column'"),
        (table.quantity.as_ref().map(|v| &v.span), "'as'"),
        (table.unit.as_ref().map(|v| &v.span), "'unit'"),
        (table.pixel.as_ref().map(|v| &v.span), "'pixel'"),
        (
            table.scale.as_ref().filter(|v| matches!(v.value, ScaleValue::File(_))).map(|v| &v.span),
            "a word as 'scale'",
        ),
    ];
    match of_files.into_iter().find_map(|(span, key)| Some((span?, key))) {
        Some((span, key)) if table.file.is_none() => Err(Problem::at(span, format!("{key} needs 'file'"))),
        _ => Ok(()),
    }
}

fn matrix(rows: &At<Vec<Sampled>>) -> Result<Function, Problem> {
    let rows_of = |rows: &[Sampled]| rows.iter().map(|row| row.0).collect::<Vec<Spectrum>>();
    let matrix = Reradiation::try_from(rows_of(rows)).map_err(|error| Problem::at(&rows.span, error))?;
    Ok(Function::Reradiation(Arc::new(matrix)))
}

fn named(name: &At<String>, light: bool) -> Result<Function, Problem> {
    let as_light = || glanz_color::light(name).map(Function::Light);
    let as_share = || glanz_color::reflectance(name).map(Function::Fraction);
    let found = if light {
        as_light().or_else(|error| as_share().map_err(|_| error))
    } else {
        as_share().or_else(|error| as_light().map_err(|_| error))
    };
    let list = if light { "lights" } else { "reflectances" };
    found.map_err(|error| {
        unknown(&error, &name.span).help(format!("`glanz color list {list}` tells the names"))
    })
}

fn formula(
    value: &At<crate::file::tables::values::Amount>,
    name: impl Fn(f64) -> String,
) -> Result<Function, Problem> {
    let light = glanz_color::light(&name(value.0)).map_err(|error| unknown(&error, &value.span))?;
    Ok(Function::Light(light))
}

fn gaussian(value: &At<[crate::file::tables::values::Amount; 2]>) -> Result<Function, Problem> {
    let [center, width] = value.value.map(|v| v.0);
    let name = format!("gaussian({center},{width})");
    let spectrum = glanz_color::light(&name).map_err(|error| unknown(&error, &value.span))?;
    Ok(Function::Either(spectrum))
}

/// What lies beyond the ends of a table: nothing of a lamp, since its ultraviolet would make things glow;
/// of a surface what is at the end.
fn beyond(light: bool) -> Outside {
    if light { Outside::Zero } else { Outside::Hold }
}

/// The spectrum of that name among those of a file; the only one where there is no name.
/// What the table says of its file.
fn read_options(table: &SpectralTable, light: bool) -> ReadOptions {
    let quantity = |of: FileQuantity| match of {
        FileQuantity::Light => Quantity::Light,
        FileQuantity::Surface | FileQuantity::Reflectance => Quantity::Reflectance,
        FileQuantity::Transmittance => Quantity::Transmittance,
        FileQuantity::Absorbance => Quantity::Absorbance,
    };
    let unit = |unit: AxisUnit| match unit {
        AxisUnit::Nanometres => Scale::Nanometres,
        AxisUnit::Micrometres => Scale::Micrometres,
        AxisUnit::Metres => Scale::Metres,
        AxisUnit::Angstroms => Scale::Angstroms,
        AxisUnit::InverseCentimetres => Scale::InverseCentimetres,
        AxisUnit::Terahertz => Scale::Terahertz,
        AxisUnit::Hertz => Scale::Hertz,
        AxisUnit::Electronvolts => Scale::Electronvolts,
    };
    ReadOptions {
        quantity: table.quantity.as_ref().map(|of| quantity(of.value)),
        default_quantity: Some(if light { Quantity::Light } else { Quantity::Reflectance }),
        unit: table.unit.as_ref().map(|of| unit(of.value)),
        scale: match table.scale.as_ref().map(|scale| &scale.value) {
            Some(ScaleValue::File(FileScale::Percent)) => Some(ValueScale::Percent),
            Some(ScaleValue::File(FileScale::Fraction)) => Some(ValueScale::Fraction),
            Some(ScaleValue::Factor(_)) | None => None,
        },
        pixel: table.pixel.as_ref().map(|at| (at.value[0] as usize, at.value[1] as usize)),
    }
}

/// How many of a file's other spectra are named.
const NAMED: usize = 6;

/// The spectrum that is meant: the only one, that of the column, or the one that comes first, which is told.
fn choose<'a>(
    spectra: &'a [NamedSpectrum],
    file: &At<String>,
    column: Option<&At<Column>>,
) -> Result<(&'a NamedSpectrum, Option<String>), Problem> {
    let names = || spectra.iter().map(|spectrum| spectrum.name.as_str()).collect::<Vec<_>>().join(", ");
    let Some(column) = column else {
        if let Some((found, why)) = preferred(spectra) {
            let (file, count, name) = (&file.value, spectra.len(), &found.name);
            let others = || spectra.iter().map(|one| one.name.as_str()).filter(|name| name != &found.name);
            let more = if others().count() > NAMED { ", …" } else { "" };
            let others = others().take(NAMED).collect::<Vec<_>>().join(", ");
            let choice = format!("'column' takes another: {others}{more}");
            let remark = format!("'{file}' holds {count} spectra: '{name}' is taken, {why}; {choice}");
            return Ok((found, Some(remark)));
        }
        let none = || Problem::at(&file.span, format!("'{}' holds no spectrum", file.value));
        return spectra.first().map(|only| (only, None)).ok_or_else(none);
    };
    let (found, what) = match &column.value {
        Column::Name(name) => (spectra.iter().find(|spectrum| spectrum.name == *name), "name"),
        Column::Number(number) => (spectra.get((*number as usize).wrapping_sub(1)), "number"),
    };
    found.map(|found| (found, None)).ok_or_else(|| {
        Problem::at(&column.span, format!("'{}' has no spectrum of that {what}", file.value))
            .help(format!("it has: {}", names()))
    })
}

pub(super) fn unknown(error: &UnknownName, span: &Range<usize>) -> Problem {
    Problem::at(span, error.to_string())
}
