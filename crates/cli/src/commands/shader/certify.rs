//! `glanz shader certify`: the laws of physics for a BRDF of one's own, and the line that breaks them.

use std::collections::BTreeMap;

use clap::Args;
use glanz_bsdf::laws::{Certificate, Finding, Law, certify};
use glanz_bsdf::{Shape, albedo};
use glanz_math::Vec3;
use glanz_plot::Lobe;
use glanz_shader::{Brdf, Record, RecordKind, Trace};
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::MachineArgs;
use crate::commands::check::FindingFacts;
use crate::input::lobes::SetArgs;
use crate::input::models::{Model, model, models, told};
use crate::input::shader_text::Texts;
use crate::print::failure::{ErrorFacts, Failure, Report};
use crate::print::{self, FormatArgs, finite, number};

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz shader certify my.brdf
  glanz shader certify my.brdf --set n=1,20,100 --format json
  glanz shader certify 'float f(vec3 L, vec3 V, vec3 N) { return 0.5 * dot(N, V); }'
  glanz shader certify 'n = 20 in 1..100; (n + 8) / (8 * pi) * pow(max(dot(N, H), 0), n)'

A BRDF of one's own is a .brdf file of BRDF Explorer; a file with one function in GLSL or WGSL that
takes vec3 L, V, N (to the light, to the viewer, the normal) and X, Y (tangent, bitangent) or H
(half vector) where it needs them; such a function as text; or an expression over these and pi behind
its parameters, each with its value and, if wanted, its range. It gives f, without the cosine: a float,
or a vec3, of which a shape is the mean, since the tint of a lobe carries the colour. Uniforms and the
parameters of a .brdf are the model's; of a colour kd they are kd_r, kd_g and kd_b.

The laws are those of `glanz check`, in single precision. Where one fails, the worst directions are told,
and for values that are negative or no numbers the line where they come up. The exit code is 1 then.";

/// Options of `glanz shader certify`.
#[derive(Args, Debug)]
pub(crate) struct CertifyArgs {
    /// Files or texts of BRDFs; names of models, from `glanz bsdf list`, to compare with
    #[arg(value_name = "BRDF", required = true, value_parser = models(), hide_possible_values = true)]
    brdfs: Vec<String>,

    #[command(flatten)]
    set: SetArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl CertifyArgs {
    /// Judges every combination, and prints what is found.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let models = self.brdfs.iter().map(|word| model(word)).collect::<Result<Vec<_>, _>>()?;
        let shapes: Vec<Shape> = models.iter().map(|model| model.shape.clone()).collect();
        let lobes = self.set.of_shapes(&shapes)?;
        let certificates: Vec<_> = lobes.par_iter().map(|lobe| certify(&lobe.shape)).collect();
        let judged: Vec<_> =
            lobes.iter().zip(&certificates).map(|(lobe, found)| judged(lobe, found, &models)).collect();
        let error = error(&judged);
        let told = match self.format.is_json() {
            true => {
                let error = error.as_ref().map(Report::facts);
                print::json(&Document { certificates: judged, error })
            }
            false => print::text(&text(&judged)),
        };
        Report::of_judged(error, told)
    }
}

/// What is found of a lobe, with the causes.
fn judged(lobe: &Lobe, certificate: &Certificate, models: &[Model]) -> CertificateFacts {
    let source = lobe.shape.source();
    let own = models.iter().filter_map(|model| model.own.as_ref());
    let own = own.into_iter().find(|(brdf, _)| source.is_some() && brdf.shape().source() == source);
    let finding = |finding: &Finding| FindingCause {
        finding: FindingFacts::of(finding),
        wo: finding.wo.map(array),
        wi: finding.wi.map(array),
        cause: own.and_then(|(brdf, texts)| cause(finding, brdf, texts, &lobe.shape)),
        hint: finding.is_broken().then(|| hint(finding, &lobe.shape)).flatten(),
        row: finding.to_string(),
    };
    let remarks = own.iter().flat_map(|(brdf, _)| brdf.remarks());
    CertificateFacts {
        model: certificate.model,
        params: certificate.params.iter().copied().collect(),
        healthy: certificate.is_healthy(),
        remarks: remarks.map(|remark| told(certificate.model, remark)).collect(),
        findings: certificate.findings.iter().map(finding).collect(),
        label: lobe.label.clone(),
    }
}

fn array(w: Vec3<f64>) -> [f64; 3] {
    [w.x, w.y, w.z]
}

/// Where in the text a broken law comes from: the first value that is no number, or the last one before the negative value.
fn cause(finding: &Finding, brdf: &Brdf, texts: &Texts, shape: &Shape) -> Option<CauseFacts> {
    let (wo, wi) = (finding.wo?, finding.wi?);
    if !finding.is_broken() || !matches!(finding.law, Law::Grazing | Law::Positivity) {
        return None;
    }
    let trace = brdf.trace(&shape.params(), wo, wi);
    let record = match finding.law {
        Law::Grazing => trace.first_not_finite().or_else(|| last(&trace)),
        _ => last(&trace),
    }?;
    let place = record.place.as_ref()?;
    let code =
        texts.get(&place.file).and_then(|text| text.lines().nth(place.line as usize - 1).map(str::to_owned));
    Some(CauseFacts {
        file: place.file.clone(),
        line: place.line,
        column: place.column,
        name: record.name.clone(),
        value: record.values(0).iter().map(|value| finite(f64::from(*value))).collect(),
        words: record.values(0).iter().map(f32::to_string).collect::<Vec<_>>().join(", "),
        code: code.map(|code| code.trim().to_owned()),
    })
}

/// The last event of the first lane; a value rather than the `return` behind it.
fn last(trace: &Trace) -> Option<&Record> {
    let records: Vec<_> = trace.of_lane(0).collect();
    let value = records.iter().rfind(|record| record.kind == RecordKind::Value);
    value.or(records.last()).copied()
}

/// What usually is behind a broken law.
fn hint(finding: &Finding, shape: &Shape) -> Option<String> {
    Some(match finding.law {
        Law::Energy => match albedo(shape, 1.0) {
            much if much > 1.0 + 2e-4 => format!(
                "along the normal {} times the light comes back: is the lobe normalised, (n + 8) / (8 π) or the like, \
                 and divided by 4 cosθi cosθo if it is D F G?",
                number((much * 1e3).round() / 1e3)
            ),
            _ => "along the normal no more comes back than arrives: a divisor such as √(cosθi cosθo) or cosθo grows \
                  without bound near the horizon"
                .to_owned(),
        },
        Law::Reciprocity => {
            "what stands for one direction must stand for the other: f / cosθi alone breaks it".to_owned()
        }
        Law::Positivity => "clamp what may turn negative: max(x, 0.0)".to_owned(),
        Law::Grazing => {
            "keep divisors from 0, and what stands under roots and powers from below 0: max(x, 1e-6)".to_owned()
        }
        _ => return None,
    })
}

fn error(judged: &[CertificateFacts]) -> Option<Report> {
    let broken = |facts: &CertificateFacts| -> Vec<String> {
        let broken = facts.findings.iter().filter(|found| found.finding.fails());
        broken.map(|found| format!("{} of {}", found.finding.name(), facts.label)).collect()
    };
    let names: Vec<_> = judged.iter().flat_map(broken).collect();
    if names.is_empty() {
        return None;
    }
    let laws = if names.len() == 1 { "law fails" } else { "laws fail" };
    Some(Report::new(format_args!("{} {laws}: {}", names.len(), names.join("; "))))
}

/// For people.
fn text(judged: &[CertificateFacts]) -> String {
    let blocks: Vec<_> = judged.iter().map(CertificateFacts::text).collect();
    blocks.join("\n")
}

/// What is found of BRDFs.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    /// One for each BRDF and each combination of its parameters
    certificates: Vec<CertificateFacts>,
    /// Why the command fails, where a law does
    error: Option<ErrorFacts>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct CertificateFacts {
    /// The model's name: the file's, or the text
    model: &'static str,
    /// Its parameters
    params: BTreeMap<&'static str, f64>,
    /// Whether all laws hold that apply
    healthy: bool,
    /// What is right but probably not meant
    remarks: Vec<String>,
    /// What is found of each law
    findings: Vec<FindingCause>,
    #[serde(skip)]
    label: String,
}

#[derive(Debug, Serialize, JsonSchema)]
struct FindingCause {
    #[serde(flatten)]
    finding: FindingFacts,
    /// The unit vector to the viewer in the worst case: x along the tangent, z along the normal
    wo: Option<[f64; 3]>,
    /// The unit vector to the light in the worst case
    wi: Option<[f64; 3]>,
    /// Where a value that is negative or no number comes from
    cause: Option<CauseFacts>,
    /// What usually is behind it
    hint: Option<String>,
    #[serde(skip)]
    row: String,
}

#[derive(Debug, Serialize, JsonSchema)]
struct CauseFacts {
    file: String,
    line: u32,
    column: u32,
    /// The variable, or return
    name: String,
    /// Its components; null for what is no number
    value: Vec<Option<f64>>,
    /// The line of the text
    code: Option<String>,
    #[serde(skip)]
    words: String,
}

impl CertificateFacts {
    fn text(&self) -> String {
        let mut lines = vec![self.label.clone()];
        lines.extend(self.remarks.iter().map(|remark| format!("  remark: {remark}")));
        for found in &self.findings {
            lines.extend(found.row.lines().map(|line| format!("  {line}")));
            let below = |text: String| format!("  {:<13}  {:<12}  {text}", "", "");
            lines.extend(found.cause.iter().map(|cause| below(cause.text())));
            lines.extend(found.hint.iter().map(|hint| below(format!("hint: {hint}"))));
        }
        lines.join("\n") + "\n"
    }
}

impl CauseFacts {
    fn text(&self) -> String {
        let Self { file, line, column, name, words, .. } = self;
        let is = if words.is_empty() { String::new() } else { format!(" is {words}") };
        let code = self.code.as_ref().map_or_else(String::new, |code| format!(": {code}"));
        format!("{file}:{line}:{column}: '{name}'{is}{code}")
    }
}
