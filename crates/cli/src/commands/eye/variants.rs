//! The eyes of a sheet: columns and rows.

use std::str::FromStr;

use glanz_eye::{Eye, EyeError, Viewer, level_cd_m2};

use super::source::Source;
use super::{EyesArgs, Show};
use crate::print::failure::Failure;
use crate::print::number;

/// Ages in years: a list, or evenly from one to another.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ages(pub Vec<f64>);

/// The most eyes of a film.
const MOST: usize = 10_000;

impl FromStr for Ages {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const EXPECTED: &str = "expected years, such as 20,50,80, or FIRST:LAST:COUNT, such as 20:80:60";
        let number = |text: &str| text.trim().parse::<f64>().map_err(|_| EXPECTED.to_owned());
        let parts: Vec<&str> = text.split(':').collect();
        match parts[..] {
            [list] => list.split(',').map(number).collect::<Result<_, _>>().map(Self),
            [first, last, count] => {
                let count =
                    count.trim().parse::<usize>().ok().filter(|n| (2..=MOST).contains(n)).ok_or(EXPECTED)?;
                let (first, last) = (number(first)?, number(last)?);
                let step = (last - first) / (count - 1) as f64;
                Ok(Self((0..count).map(|i| first + step * i as f64).collect()))
            }
            _ => Err(EXPECTED.to_owned()),
        }
    }
}

/// An eye of the sheet.
#[derive(Clone, Debug)]
pub(super) struct Variant {
    /// What it is called.
    pub label: String,
    pub viewer: Viewer,
}

/// All eyes, row by row.
#[derive(Clone, Debug)]
pub(super) struct Variants {
    pub columns: Vec<String>,
    pub rows: Vec<String>,
    pub eyes: Vec<Variant>,
}

impl Variants {
    /// What the command line asks for, beside what the scene says.
    pub(super) fn of(args: &EyesArgs, source: &Source) -> Result<Self, Failure> {
        let base = base(args, source)?;
        let columns = columns(args, &base)?;
        let rows = rows(args, &base, source, columns.len())?;
        let mut eyes = Vec::new();
        for (row, viewing) in &rows {
            for (column, eye) in &columns {
                let words = [column.as_str(), row.as_str()].into_iter().filter(|word| !word.is_empty());
                let label = words.collect::<Vec<_>>().join("\n");
                let viewer = Viewer { eye: eye.clone(), viewing: viewing.clone() };
                viewer.check().map_err(Failure::Usage)?;
                eyes.push(Variant { label, viewer });
            }
        }
        let names = |list: Vec<String>| if list.iter().all(String::is_empty) { Vec::new() } else { list };
        Ok(Self {
            columns: columns.into_iter().map(|(name, _)| name).collect(),
            rows: names(rows.into_iter().map(|(name, _)| name).collect()),
            eyes,
        })
    }

    /// What is odd about the eyes, each thing once.
    pub(super) fn remarks(&self) -> Vec<String> {
        let mut remarks: Vec<String> =
            self.eyes.iter().filter_map(|variant| variant.viewer.eye.remark()).collect();
        remarks.dedup();
        remarks.truncate(3);
        remarks
    }
}

/// The eye that the options change.
pub(super) fn base(args: &EyesArgs, source: &Source) -> Result<Viewer, Failure> {
    let mut viewer = source.viewer().cloned().unwrap_or_default();
    if let Some(name) = args.observer() {
        if !Eye::is_named(name) {
            let message = format!("--observer is an eye here, such as age:70 or field:10, found '{name}'");
            return Err(Failure::Usage(message));
        }
        viewer.eye =
            name.parse().map_err(|error: EyeError| Failure::Usage(format!("--observer: {error}")))?;
    }
    let viewing = &mut viewer.viewing;
    viewing.glare |= args.glare;
    viewing.chromatic |= args.chromatic;
    viewing.noise = args.noise.or(viewing.noise);
    viewing.acuity |= args.acuity;
    viewing.gaze = args.gaze.or(viewing.gaze);
    viewing.px_per_deg = args.px_per_deg.or(viewing.px_per_deg);
    viewing.adaptation_cd_m2 = args.adaptation.or(viewing.adaptation_cd_m2);
    if let Some(rods) = args.rods {
        viewing.rods = rods.into();
    }
    // A scene that knows its luminance is seen by rods where it is dark.
    viewing.night |= source.photometric();
    Ok(viewer)
}

/// A name and an eye for each column.
fn columns(args: &EyesArgs, base: &Viewer) -> Result<Vec<(String, Eye)>, Failure> {
    let ages =
        args.age.as_ref().map_or_else(|| vec![None], |ages| ages.0.iter().copied().map(Some).collect());
    let deficiencies: Vec<Option<&str>> = match args.deficiency.is_empty() {
        true => vec![None],
        false => args.deficiency.iter().map(|name| Some(name.trim())).collect(),
    };
    let mut columns = Vec::new();
    for age in &ages {
        for deficiency in &deficiencies {
            let mut eye = base.eye.clone();
            let mut words = Vec::new();
            if let Some(age) = age {
                eye.age = *age;
                words.push(format!("{} years", number((age * 10.0).round() / 10.0)));
            }
            if let Some(name) = deficiency {
                let lack: Eye = if *name == "none" { Eye::default() } else { deficient(name)? };
                (eye.cones, eye.shift_nm) = (lack.cones, lack.shift_nm);
                words.push((*name).to_owned());
            }
            eye.check().map_err(|error| Failure::Usage(error.to_string()))?;
            let name = if words.is_empty() { eye.to_string() } else { words.join(", ") };
            columns.push((name, eye));
        }
    }
    Ok(columns)
}

/// An eye that has this deficiency and is the standard one else.
fn deficient(name: &str) -> Result<Eye, Failure> {
    let wrong = |what: String| Failure::Usage(format!("--deficiency: {what}"));
    let eye: Eye = name.parse().map_err(|error: EyeError| wrong(error.to_string()))?;
    let bare = Eye { cones: eye.cones, shift_nm: eye.shift_nm, ..Eye::default() };
    match bare == eye && eye != Eye::default() {
        true => Ok(eye),
        false => Err(wrong(format!(
            "expected none, protan, deutan, tritan, rods, protan:10 or deutan:10, found '{name}'"
        ))),
    }
}

/// A name and a way to look for each row.
fn rows(
    args: &EyesArgs,
    base: &Viewer,
    source: &Source,
    columns: usize,
) -> Result<Vec<(String, glanz_eye::Viewing)>, Failure> {
    if source.photometric() && !args.level.is_empty() {
        let message = "--level is for scenes in classic units; this one is in photometric units and has luminances of its own";
        return Err(Failure::Usage(message.to_owned()));
    }
    let levels: Vec<Option<(&str, f64)>> = match args.level.is_empty() {
        true => vec![None],
        false => {
            let names = args.level.iter().map(|name| name.trim());
            let levels: Result<_, String> =
                names.map(|name| level_cd_m2(name).map(|level| Some((name, level)))).collect();
            levels.map_err(|error| Failure::Usage(format!("--level: {error}")))?
        }
    };
    let adapted = degrees(args, base, levels.len(), columns);
    let mut rows = Vec::new();
    for level in &levels {
        for degree in &adapted {
            let mut viewing = base.viewing.clone();
            let mut words = Vec::new();
            if let Some((name, luminance)) = level {
                viewing.level_cd_m2 = Some(*luminance);
                let is_name = name.parse::<f64>().is_err();
                words.push(if is_name { (*name).to_owned() } else { format!("{name} cd/m²") });
            }
            if let Some(degree) = degree {
                viewing.adapted = *degree;
                words.push(match *degree {
                    0.0 => "unadapted".to_owned(),
                    1.0 => "adapted".to_owned(),
                    part => format!("adapted {}", number(part)),
                });
            }
            rows.push((words.join("\n"), viewing));
        }
    }
    Ok(rows)
}

/// The degrees of adaptation that are drawn: those asked for, or both ends where ages differ and nothing else does.
fn degrees(args: &EyesArgs, base: &Viewer, levels: usize, columns: usize) -> Vec<Option<f64>> {
    if !args.adapted.is_empty() {
        return args.adapted.iter().copied().map(Some).collect();
    }
    let lens = base.eye.lens != glanz_eye::Lens::Cie170 || base.eye.age != Eye::default().age;
    let ages = args.age.is_some() || lens;
    let film = columns > 8;
    match ages && levels == 1 && !film && args.show == Show::Picture {
        true => vec![Some(0.0), Some(1.0)],
        false => vec![None],
    }
}
