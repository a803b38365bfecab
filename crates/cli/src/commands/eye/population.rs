//! `glanz eye --population`: do people agree on what they see?

use glanz_color::difference::ciede2000;
use glanz_eye::{Eye, Viewer};
use glanz_measure::Noise;
use glanz_picture::compare::frames::DeltaE;
use glanz_picture::compare::heat_colors;
use glanz_plot::{Canvas, ContactSheet};
use schemars::JsonSchema;
use serde::Serialize;

use super::draw::{self, Drawn};
use super::patches::means;
use super::source::Source;
use super::{EyeArgs, Show};
use crate::args::Target;
use crate::encode;
use crate::print;
use crate::print::failure::Failure;
use crate::progress::Progress;

/// Below this ΔE00 two patches match.
const MATCH: f64 = 2.0;
/// The hottest difference of the map.
const HOTTEST: f64 = 5.0;

/// What a population sees.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// The sheet of pictures
    file: String,
    /// How many people
    people: usize,
    /// Which ones
    seed: u64,
    /// ΔE00 of pixels between a person and the mean observer, over all people and the pixels that show a surface
    delta_e_00: SpreadFacts,
    /// Pairs of objects that match, ΔE00 below 2, for the mean observer or for one of the people
    matches: Vec<Match>,
    /// What was ignored or changed of the scene's file
    notes: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct SpreadFacts {
    mean: f64,
    median: f64,
    p95: f64,
    max: f64,
}

/// Two objects that some take for the same.
#[derive(Debug, Serialize, JsonSchema)]
struct Match {
    objects: [String; 2],
    /// ΔE00 for the mean observer
    mean_observer: f64,
    /// The least and the greatest ΔE00 among people
    range: [f64; 2],
    /// How many people see them match
    agree: usize,
}

impl EyeArgs {
    /// Draws what people see who differ as people do.
    pub(super) fn population(
        &self,
        count: usize,
        source: &mut Source,
        base: &Viewer,
        target: &Target,
    ) -> Result<(), Failure> {
        if self.eyes.show != Show::Picture {
            return Err(Failure::Usage("--population shows pictures alone: leave out --show".to_owned()));
        }
        let mut noise = Noise::new(self.eyes.seed);
        let people: Vec<Eye> = (0..count)
            .map(|_| {
                let deviations = [(); 8].map(|()| noise.normal());
                base.eye.individual(deviations)
            })
            .collect();
        let mut progress = Progress::new(1 + count, "eyes");
        let mut draw = |eye: &Eye| -> Result<Drawn, Failure> {
            let viewer = Viewer { eye: eye.clone(), viewing: base.viewing.clone() };
            let drawn = draw::draw(self, source, &viewer, &mut progress)?;
            progress.step();
            Ok(drawn)
        };
        let mean = draw(&base.eye)?;
        let drawn = people.iter().map(&mut draw).collect::<Result<Vec<_>, _>>()?;
        drop(progress);
        let deltas: Vec<DeltaE> =
            drawn.iter().map(|person| DeltaE::between(&person.frame, &mean.frame, 0.0)).collect();
        let (map, spread) = together(&deltas);
        let matches = matches(&mean, &drawn);
        self.people_sheet(&mean, &drawn, &map, &spread, target, source)?;
        self.tell_people(target, spread, matches, count, source.notes().to_vec())
    }

    fn people_sheet(
        &self,
        mean: &Drawn,
        drawn: &[Drawn],
        map: &[f32],
        spread: &SpreadFacts,
        target: &Target,
        source: &Source,
    ) -> Result<(), Failure> {
        let first = &mean.pictures[0].1;
        let cell = (first.width, first.height);
        let heat = Canvas { width: cell.0, height: cell.1, rgba: heat_colors(map, HOTTEST) };
        let shown = drawn.iter().take(4).map(|person| &person.pictures[0].1);
        let pictures: Vec<&Canvas> = [first, &heat].into_iter().chain(shown).collect();
        let names = (1..=pictures.len() - 2).map(|n| format!("person {n}"));
        let columns = ["mean observer".to_owned(), format!("mean dE00 of people, 0..{HOTTEST}")]
            .into_iter()
            .chain(names);
        let sheet = ContactSheet {
            captions: columns
                .enumerate()
                .map(|(i, name)| match i {
                    1 => vec![name, format!("mean {:.2}, 95 % {:.2}", spread.mean, spread.p95)],
                    _ => vec![name],
                })
                .collect(),
            per_row: 3.min(pictures.len()),
            count: pictures.len(),
            cell,
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        for (index, picture) in pictures.iter().enumerate() {
            sheet.put(&mut canvas, index, picture);
        }
        encode::deliver(
            canvas.into(),
            target,
            &encode::metadata_of_sheet(source.content_hash(), Vec::new()),
        )?;
        self.wrote(target);
        Ok(())
    }

    fn tell_people(
        &self,
        target: &Target,
        spread: SpreadFacts,
        matches: Vec<Match>,
        people: usize,
        notes: Vec<String>,
    ) -> Result<(), Failure> {
        let Target::File(path) = target else { return Ok(()) };
        if self.format.is_json() {
            let file = path.display().to_string();
            let seed = self.eyes.seed;
            return print::json(&Document { file, people, seed, delta_e_00: spread, matches, notes });
        }
        let mut text = format!(
            "dE00 of {people} people from the mean observer: mean {:.2}, median {:.2}, 95 % {:.2}, most {:.2}\n",
            spread.mean, spread.median, spread.p95, spread.max
        );
        for Match { objects: [a, b], mean_observer, range: [least, most], agree } in &matches {
            text.push_str(&format!(
                "{a} and {b}: {mean_observer:.1} for the mean observer, {least:.1} to {most:.1} for people; {agree} of {people} see a match\n"
            ));
        }
        print::text(&text)
    }
}

/// The mean map of all people, and the spread over them and the pixels that show a surface.
fn together(deltas: &[DeltaE]) -> (Vec<f32>, SpreadFacts) {
    let count = deltas.len().max(1) as f32;
    let pixels = deltas.first().map_or(0, |delta| delta.map.len());
    let map = (0..pixels).map(|i| deltas.iter().map(|delta| delta.map[i]).sum::<f32>() / count).collect();
    let mut all: Vec<f32> =
        deltas.iter().flat_map(|delta| delta.map.iter().copied()).filter(|v| *v > 0.0).collect();
    all.sort_by(f32::total_cmp);
    let at = |part: f64| {
        all.get((part * (all.len().saturating_sub(1)) as f64) as usize).copied().map_or(0.0, f64::from)
    };
    let mean = all.iter().map(|v| f64::from(*v)).sum::<f64>() / all.len().max(1) as f64;
    (map, SpreadFacts { mean, median: at(0.5), p95: at(0.95), max: at(1.0) })
}

/// Pairs of named objects that match for somebody.
fn matches(mean: &Drawn, people: &[Drawn]) -> Vec<Match> {
    let usual = means(&mean.frame);
    let others: Vec<_> = people.iter().map(|person| means(&person.frame)).collect();
    let named: Vec<usize> = usual
        .keys()
        .copied()
        .filter(|number| mean.objects.get(*number).is_some_and(|name| !name.is_empty()))
        .take(40)
        .collect();
    let mut matches = Vec::new();
    for (i, a) in named.iter().enumerate() {
        for b in &named[i + 1..] {
            let seen = others.iter().filter_map(|person| Some(ciede2000(*person.get(a)?, *person.get(b)?)));
            let seen: Vec<f64> = seen.collect();
            let mean_observer = ciede2000(usual[a], usual[b]);
            let agree = seen.iter().filter(|delta| **delta < MATCH).count();
            if mean_observer < MATCH || agree > 0 {
                let least = seen.iter().copied().fold(f64::INFINITY, f64::min);
                let most = seen.iter().copied().fold(0.0, f64::max);
                let objects = [a, b].map(|number| mean.objects[*number].clone());
                matches.push(Match { objects, mean_observer, range: [least, most], agree });
            }
        }
    }
    matches
}
