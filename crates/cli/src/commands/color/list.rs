//! `glanz color list`: what there is by name.

use std::collections::BTreeMap;
use std::fmt::Write;

use clap::{Args, ValueEnum};
use glanz_color::models::{Limit, Model};
use glanz_color::{IorKind, fluorescents, iors, lights, observers, reflectances};
use schemars::JsonSchema;
use serde::Serialize;

use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, finite, number};

/// Shown below the help.
pub(crate) const EXAMPLES: &str = "Examples:
  glanz color list lights
  glanz color list models --format json

Without a kind, all are listed.";

/// Options of `glanz color list`.
#[derive(Args, Debug)]
pub(crate) struct ListArgs {
    /// What to list
    #[arg(value_enum, value_name = "KIND")]
    kind: Option<Kind>,

    #[command(flatten)]
    format: FormatArgs,
}

/// What can be listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// Illuminants of the CIE and lights by formula
    Lights,
    /// Standard observers, cones and rods
    Observers,
    /// Measured reflectances
    Reflectances,
    /// Metals and transparent media, by refractive index
    Metals,
    /// Materials that glow
    Fluorescent,
    /// Dyes by their spectra of absorption and emission
    Dyes,
    /// Colour models
    Models,
}

/// One thing by name.
struct Entry {
    name: String,
    title: String,
    /// The wavelengths in nm for which there are values, or what else stands there.
    range: String,
    source: String,
    facts: EntryFacts,
}

/// What there is by name.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The entries of each kind that was asked for, all without one: lights, observers, reflectances, metals,
    /// fluorescent, dyes, models
    #[serde(flatten)]
    lists: BTreeMap<&'static str, Vec<EntryFacts>>,
}

/// One thing by name, with the keys of its kind.
#[derive(Debug, Default, Serialize, JsonSchema)]
struct EntryFacts {
    name: &'static str,
    title: &'static str,
    /// Of all but colour models
    #[serde(skip_serializing_if = "Option::is_none")]
    source: Option<&'static str>,
    /// Of lights: a name, for those that have a number in theirs
    #[serde(skip_serializing_if = "Option::is_none")]
    example: Option<&'static str>,
    /// Of lights, reflectances and metals: the wavelengths for which there are values
    #[serde(skip_serializing_if = "Option::is_none")]
    range_nm: Option<[f64; 2]>,
    /// Of lights: what stands for the wavelengths below
    #[serde(skip_serializing_if = "Option::is_none")]
    below: Option<&'static str>,
    /// Of observers: the names of their channels; of colour models: their channels
    #[serde(skip_serializing_if = "Option::is_none")]
    channels: Option<Channels>,
    /// Of metals: metal or dielectric
    #[serde(skip_serializing_if = "Option::is_none")]
    kind: Option<&'static str>,
    /// Of fluorescent materials: whether the figures are measured
    #[serde(skip_serializing_if = "Option::is_none")]
    measured: Option<bool>,
    /// Of dyes: photons emitted for each absorbed
    #[serde(skip_serializing_if = "Option::is_none")]
    quantum_yield: Option<f64>,
    /// Of dyes: where the quantum yield comes from
    #[serde(skip_serializing_if = "Option::is_none")]
    yield_source: Option<&'static str>,
    /// Of colour models: whether they are made of sRGB and hold no other colour
    #[serde(skip_serializing_if = "Option::is_none")]
    srgb_only: Option<bool>,
}

/// The channels of an observer or a colour model.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
enum Channels {
    OfObserver(Vec<String>),
    OfModel(Vec<ChannelFacts>),
}

/// A number of a colour model.
#[derive(Debug, Serialize, JsonSchema)]
struct ChannelFacts {
    name: &'static str,
    /// The least and the greatest value; null where there is none
    range: [Option<f64>; 2],
    /// Whether values outside are meant (nominal), wrong (strict), or go round (cyclic)
    limit: &'static str,
}

impl Kind {
    const ALL: [Self; 7] = [
        Self::Lights,
        Self::Observers,
        Self::Reflectances,
        Self::Metals,
        Self::Fluorescent,
        Self::Dyes,
        Self::Models,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Lights => "lights",
            Self::Observers => "observers",
            Self::Reflectances => "reflectances",
            Self::Metals => "metals",
            Self::Fluorescent => "fluorescent",
            Self::Dyes => "dyes",
            Self::Models => "models",
        }
    }

    /// The heading of the third column.
    fn range_heading(self) -> &'static str {
        match self {
            Self::Models => "numbers",
            Self::Observers => "channels",
            Self::Fluorescent => "figures",
            Self::Dyes => "yield",
            _ => "nm",
        }
    }

    fn entries(self) -> Vec<Entry> {
        match self {
            Self::Lights => light_entries(),
            Self::Observers => observer_entries(),
            Self::Reflectances => reflectance_entries(),
            Self::Metals => metal_entries(),
            Self::Fluorescent => fluorescent_entries(),
            Self::Dyes => dye_entries(),
            Self::Models => model_entries(),
        }
    }
}

impl ListArgs {
    /// Prints the list.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let kinds: Vec<Kind> = self.kind.map_or(Kind::ALL.to_vec(), |kind| vec![kind]);
        if self.format.is_json() {
            let of = |kind: &Kind| kind.entries().into_iter().map(|entry| entry.facts).collect();
            let lists = kinds.iter().map(|kind| (kind.name(), of(kind))).collect();
            return print::json(&Document { lists });
        }
        let tables: Vec<_> = kinds.iter().map(|kind| table(*kind, kinds.len() > 1)).collect();
        print::text(&tables.join("\n"))
    }
}

fn table(kind: Kind, headed: bool) -> String {
    let entries = kind.entries();
    let width = |of: fn(&Entry) -> &str, heading: &str| {
        let widths = entries.iter().map(|entry| of(entry).chars().count());
        widths.max().unwrap_or(0).max(heading.chars().count())
    };
    let name = width(|entry| &entry.name, "name");
    let title = width(|entry| &entry.title, "title");
    let range = width(|entry| &entry.range, kind.range_heading());
    let mut text = if headed { format!("{}\n", kind.name()) } else { String::new() };
    let mut line = |a: &str, b: &str, c: &str, d: &str| {
        let line = format!("{a:<name$}  {b:<title$}  {c:<range$}  {d}");
        writeln!(text, "{}", line.trim_end()).expect("a string takes everything");
    };
    line("name", "title", kind.range_heading(), "source");
    for entry in &entries {
        line(&entry.name, &entry.title, &entry.range, &entry.source);
    }
    text
}

fn range((from, to): (f64, f64)) -> String {
    format!("{}-{}", number(from), number(to))
}

fn light_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::LightInfo| Entry {
        name: info.name.to_owned(),
        title: info.title.to_owned(),
        range: range(info.range_nm),
        source: info.source.to_owned(),
        facts: EntryFacts {
            name: info.name,
            title: info.title,
            source: Some(info.source),
            example: Some(info.example),
            range_nm: Some(info.range_nm.into()),
            below: Some(info.below),
            ..EntryFacts::default()
        },
    };
    lights().iter().map(entry).collect()
}

fn observer_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::ObserverInfo| {
        let channels: Vec<String> = glanz_color::observer(info.name)
            .map(|observer| observer.channels.into_iter().map(|channel| channel.name).collect())
            .unwrap_or_default();
        Entry {
            name: info.name.to_owned(),
            title: info.title.to_owned(),
            range: channels.join(", "),
            source: info.source.to_owned(),
            facts: EntryFacts {
                name: info.name,
                title: info.title,
                source: Some(info.source),
                channels: Some(Channels::OfObserver(channels)),
                ..EntryFacts::default()
            },
        }
    };
    observers().iter().map(entry).collect()
}

fn reflectance_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::ReflectanceInfo| Entry {
        name: info.name.to_owned(),
        title: info.title.to_owned(),
        range: range(info.range_nm),
        source: info.source.to_owned(),
        facts: EntryFacts {
            name: info.name,
            title: info.title,
            source: Some(info.source),
            range_nm: Some(info.range_nm.into()),
            ..EntryFacts::default()
        },
    };
    reflectances().iter().map(entry).collect()
}

fn metal_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::IorInfo| {
        let metal = info.kind == IorKind::Metal;
        Entry {
            name: info.name.to_owned(),
            title: format!("{}{}", info.title, if metal { "" } else { " (transparent)" }),
            range: range(info.range_nm),
            source: info.source.to_owned(),
            facts: EntryFacts {
                name: info.name,
                title: info.title,
                source: Some(info.source),
                kind: Some(if metal { "metal" } else { "dielectric" }),
                range_nm: Some(info.range_nm.into()),
                ..EntryFacts::default()
            },
        }
    };
    iors().iter().map(entry).collect()
}

fn fluorescent_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::FluorescentInfo| Entry {
        name: info.name.to_owned(),
        title: info.title.to_owned(),
        range: if info.measured { "measured" } else { "model" }.to_owned(),
        source: info.source.to_owned(),
        facts: EntryFacts {
            name: info.name,
            title: info.title,
            source: Some(info.source),
            measured: Some(info.measured),
            ..EntryFacts::default()
        },
    };
    fluorescents().iter().map(entry).collect()
}

fn dye_entries() -> Vec<Entry> {
    let entry = |info: &glanz_color::dyes::DyeInfo| Entry {
        name: info.name.to_owned(),
        title: info.title.to_owned(),
        range: number(info.quantum_yield),
        source: format!("{}; yield: {}", info.source, info.yield_source),
        facts: EntryFacts {
            name: info.name,
            title: info.title,
            source: Some(info.source),
            quantum_yield: Some(info.quantum_yield),
            yield_source: Some(info.yield_source),
            ..EntryFacts::default()
        },
    };
    glanz_color::dyes::dyes().iter().map(entry).collect()
}

fn model_entries() -> Vec<Entry> {
    let entry = |model: &Model| {
        let info = model.info();
        let numbers = info.channels.iter().map(|channel| match channel.range {
            [low, high] if low.is_finite() && high.is_finite() => {
                format!("{} {} to {}", channel.name, number(low), number(high))
            }
            [low, _] if low.is_finite() => format!("{} from {}", channel.name, number(low)),
            _ => channel.name.to_owned(),
        });
        let channels = info.channels.iter().map(|channel| {
            let limit = match channel.limit {
                Limit::Nominal => "nominal",
                Limit::Strict => "strict",
                Limit::Cyclic => "cyclic",
            };
            ChannelFacts { name: channel.name, range: channel.range.map(finite), limit }
        });
        Entry {
            name: info.name.to_owned(),
            title: info.title.to_owned(),
            range: numbers.collect::<Vec<_>>().join(", "),
            source: String::new(),
            facts: EntryFacts {
                name: info.name,
                title: info.title,
                srgb_only: Some(info.srgb_only),
                channels: Some(Channels::OfModel(channels.collect())),
                ..EntryFacts::default()
            },
        }
    };
    Model::ALL.iter().map(entry).collect()
}
