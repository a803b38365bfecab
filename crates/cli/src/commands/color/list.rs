//! `glanz color list`: what there is by name.

use std::fmt::Write;

use clap::{Args, ValueEnum};
use glanz_color::models::{Limit, Model};
use glanz_color::{IorKind, fluorescents, iors, lights, observers, reflectances};
use serde_json::{Value, json};

use crate::print::failure::Failure;
use crate::print::{self, FormatArgs, number};

/// Shown below the help.
pub const EXAMPLES: &str = "Examples:
  glanz color list lights
  glanz color list models --format json

Without a kind, all are listed.";

/// Options of `glanz color list`.
#[derive(Args, Debug)]
pub struct ListArgs {
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
    json: Value,
}

impl Kind {
    const ALL: [Self; 6] =
        [Self::Lights, Self::Observers, Self::Reflectances, Self::Metals, Self::Fluorescent, Self::Models];

    fn name(self) -> &'static str {
        match self {
            Self::Lights => "lights",
            Self::Observers => "observers",
            Self::Reflectances => "reflectances",
            Self::Metals => "metals",
            Self::Fluorescent => "fluorescent",
            Self::Models => "models",
        }
    }

    /// The heading of the third column.
    fn range_heading(self) -> &'static str {
        match self {
            Self::Models => "numbers",
            Self::Observers => "channels",
            Self::Fluorescent => "figures",
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
            Self::Models => model_entries(),
        }
    }
}

impl ListArgs {
    /// Prints the list.
    pub fn run(&self) -> Result<(), Failure> {
        let kinds: Vec<Kind> = self.kind.map_or(Kind::ALL.to_vec(), |kind| vec![kind]);
        if self.format.is_json() {
            let of = |kind: &Kind| kind.entries().into_iter().map(|entry| entry.json).collect::<Value>();
            return match self.kind {
                Some(kind) => print::json(&of(&kind)),
                None => print::json(&Value::Object(
                    kinds.iter().map(|kind| (kind.name().to_owned(), of(kind))).collect(),
                )),
            };
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
        json: json!({
            "name": info.name, "example": info.example, "title": info.title, "source": info.source,
            "range_nm": [info.range_nm.0, info.range_nm.1], "below": info.below,
        }),
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
            json: json!({
                "name": info.name, "title": info.title, "source": info.source, "channels": channels,
            }),
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
        json: json!({
            "name": info.name, "title": info.title, "source": info.source,
            "range_nm": [info.range_nm.0, info.range_nm.1],
        }),
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
            json: json!({
                "name": info.name, "title": info.title, "source": info.source,
                "kind": if metal { "metal" } else { "dielectric" },
                "range_nm": [info.range_nm.0, info.range_nm.1],
            }),
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
        json: json!({
            "name": info.name, "title": info.title, "source": info.source, "measured": info.measured,
        }),
    };
    fluorescents().iter().map(entry).collect()
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
            let ends = channel.range.map(|end| if end.is_finite() { json!(end) } else { Value::Null });
            json!({ "name": channel.name, "range": ends, "limit": limit })
        });
        Entry {
            name: info.name.to_owned(),
            title: info.title.to_owned(),
            range: numbers.collect::<Vec<_>>().join(", "),
            source: String::new(),
            json: json!({
                "name": info.name, "title": info.title, "srgb_only": info.srgb_only,
                "channels": channels.collect::<Vec<_>>(),
            }),
        }
    };
    Model::ALL.iter().map(entry).collect()
}
