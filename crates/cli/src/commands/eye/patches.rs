//! What an eye loses between the objects of a scene: pairs of colours that become alike.

use std::collections::BTreeMap;
use std::fmt::Write;

use glanz_color::difference::ciede2000;
use glanz_color::models::{ColorModel, Lab, LinearSrgb};
use glanz_picture::Frame;
use schemars::JsonSchema;
use serde::Serialize;

use super::draw::Drawn;
use super::variants::Variants;

/// Below this ΔE00 two large patches look alike to most people.
const ALIKE: f64 = 2.0;
/// From this on nobody takes them for the same.
const APART: f64 = 5.0;
/// The most objects between which all pairs are told.
const MOST: usize = 40;

/// What eyes lose between the objects of a scene, against the first eye.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Patches {
    /// The objects that the picture shows, with a name
    objects: Vec<String>,
    /// For each further eye
    eyes: Vec<Loss>,
}

/// What one eye loses.
#[derive(Debug, Serialize, JsonSchema)]
struct Loss {
    /// What it is called on the sheet
    label: String,
    /// The mean ΔE00 between pairs of objects for the first eye
    mean_before: f64,
    /// The same for this one
    mean: f64,
    /// Pairs that the first eye tells apart, ΔE00 at least 5, and this one hardly, below 2; those first that lose most
    alike: Vec<Pair>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct Pair {
    objects: [String; 2],
    /// ΔE00 for the first eye
    before: f64,
    /// ΔE00 for this one
    now: f64,
}

impl Patches {
    /// For the pictures of a sheet.
    pub(super) fn of(variants: &Variants, drawn: &[Drawn]) -> Self {
        let nothing = Self { objects: Vec::new(), eyes: Vec::new() };
        let Some(first) = drawn.first() else { return nothing };
        let means: Vec<BTreeMap<usize, Lab>> = drawn.iter().map(|eye| means(&eye.frame)).collect();
        let named = |number: &usize| first.objects.get(*number).is_some_and(|name| !name.is_empty());
        let objects: Vec<usize> = means[0].keys().copied().filter(named).take(MOST).collect();
        if objects.len() < 2 || drawn.len() < 2 {
            return nothing;
        }
        let name = |number: usize| first.objects[number].clone();
        let losses = variants.eyes.iter().zip(&means).skip(1).map(|(variant, seen)| {
            let (mut before_sum, mut now_sum, mut count, mut alike) = (0.0, 0.0, 0, Vec::new());
            for (i, a) in objects.iter().enumerate() {
                for b in &objects[i + 1..] {
                    let (Some(x), Some(y)) = (seen.get(a), seen.get(b)) else { continue };
                    let (before, now) = (ciede2000(means[0][a], means[0][b]), ciede2000(*x, *y));
                    (before_sum, now_sum, count) = (before_sum + before, now_sum + now, count + 1);
                    if before >= APART && now < ALIKE {
                        alike.push(Pair { objects: [name(*a), name(*b)], before, now });
                    }
                }
            }
            alike.sort_by(|a, b| (b.before - b.now).total_cmp(&(a.before - a.now)));
            let count = f64::from(count.max(1));
            Loss {
                label: variant.label.replace('\n', ", "),
                mean_before: before_sum / count,
                mean: now_sum / count,
                alike,
            }
        });
        Self { eyes: losses.collect(), objects: objects.into_iter().map(name).collect() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.eyes.is_empty()
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let mut text = String::new();
        if self.is_empty() {
            return text;
        }
        let first = self.eyes[0].mean_before;
        let mut line =
            |words: std::fmt::Arguments<'_>| writeln!(text, "{words}").expect("a string takes everything");
        line(format_args!("mean dE00 between {} objects: {first:.1} for the first eye", self.objects.len()));
        for loss in &self.eyes {
            let count = loss.alike.len();
            line(format_args!("{:<28} {:>6.1}   {count} pairs become alike", loss.label, loss.mean));
            for Pair { objects: [a, b], before, now } in loss.alike.iter().take(5) {
                line(format_args!("    {a} and {b}: {before:.1} to {now:.1}"));
            }
        }
        text
    }
}

/// The mean colour of each object that the picture shows, by its number, for the white of the screen.
pub(super) fn means(frame: &Frame) -> BTreeMap<usize, Lab> {
    let mut sums: BTreeMap<usize, ([f64; 3], usize)> = BTreeMap::new();
    for (i, object) in frame.object.iter().enumerate().filter(|(_, object)| **object != 0) {
        let (sum, count) = sums.entry(*object as usize - 1).or_default();
        for (sum, plane) in sum.iter_mut().zip(&frame.rgb) {
            *sum += f64::from(plane[i]);
        }
        *count += 1;
    }
    let lab = |(sum, count): ([f64; 3], usize)| LinearSrgb(sum.map(|v| v / count as f64)).to::<Lab>();
    sums.into_iter().map(|(object, sum)| (object, lab(sum))).collect()
}
