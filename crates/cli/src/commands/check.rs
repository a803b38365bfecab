//! `glanz check`: the certificate of models.

use clap::Args;
use glanz_bsdf::MODELS;
use glanz_bsdf::laws::{Certificate, Finding, Verdict, certify};
use glanz_plot::Lobe;
use rayon::prelude::*;
use serde_json::{Value, json};

use crate::args::MachineArgs;
use crate::input::lobes::{SetArgs, model_names};
use crate::print::failure::{Failure, Report};
use crate::print::{self, FormatArgs};

/// Shown after the help.
pub const EXAMPLES: &str = "\
Examples:
  glanz check phong
  glanz check phong blinn-phong --set shininess=8,32
  glanz check --all --format json

Looked at are reciprocity, energy (the greatest albedo and where), positivity, the side of the
light, finiteness up to grazing angles, the normalisation of the distribution of facets, limits,
single against double precision, and 16 lanes against scalar code. The exit code is 1 where a law
fails, even if the model is known to break it.";

/// Options of `glanz check`.
#[derive(Args, Debug)]
pub struct CheckArgs {
    /// Names of models, from `glanz bsdf list`
    #[arg(value_name = "MODEL", value_parser = model_names(), hide_possible_values = true,
          required_unless_present = "all")]
    models: Vec<String>,

    /// Check every model of the list
    #[arg(long, conflicts_with = "models")]
    all: bool,

    #[command(flatten)]
    set: SetArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl CheckArgs {
    /// Looks at every combination, and prints what is found.
    pub fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let lobes = match self.all {
            true => self.set.lobes(&MODELS.iter().map(|info| info.name.to_owned()).collect::<Vec<_>>())?,
            false => self.set.lobes(&self.models)?,
        };
        let certificates: Vec<_> = lobes.par_iter().map(|lobe| certify(&lobe.shape)).collect();
        match self.format.is_json() {
            true => print::json(&certificates.iter().map(describe).collect())?,
            false => print::text(&table(&lobes, &certificates))?,
        }
        verdict(&lobes, &certificates)
    }
}

/// The label of each case and its certificate, with an empty line between them.
fn table(lobes: &[Lobe], certificates: &[Certificate]) -> String {
    let blocks = lobes.iter().zip(certificates);
    blocks
        .map(|(lobe, certificate)| format!("{}\n{certificate}\n", lobe.label))
        .collect::<Vec<_>>()
        .join("\n")
}

fn describe(certificate: &Certificate) -> Value {
    let finding = |finding: &Finding| {
        let (verdict, reason) = match finding.verdict {
            Verdict::Holds => ("holds", None),
            Verdict::Broken { known } => ("fails", known),
            Verdict::NotApplicable(reason) => ("not applicable", Some(reason)),
        };
        let known = matches!(finding.verdict, Verdict::Broken { known: Some(_) });
        // JSON has no infinity; the verdict tells it.
        let value = finding.value.filter(|value| value.is_finite());
        json!({
            "check": finding.law.name(), "verdict": verdict, "known": known, "reason": reason,
            "value": value, "detail": finding.detail,
        })
    };
    let params: serde_json::Map<_, _> =
        certificate.params.iter().map(|(name, value)| ((*name).to_owned(), Value::from(*value))).collect();
    json!({
        "model": certificate.model, "params": params, "healthy": certificate.is_healthy(),
        "findings": certificate.findings.iter().map(finding).collect::<Vec<_>>(),
    })
}

/// The failure that names what is broken, if anything is.
fn verdict(lobes: &[Lobe], certificates: &[Certificate]) -> Result<(), Failure> {
    let broken: Vec<_> = lobes
        .iter()
        .zip(certificates)
        .flat_map(|(lobe, certificate)| {
            let findings = certificate.findings.iter().filter(|finding| finding.is_broken());
            findings.map(move |finding| (lobe, finding))
        })
        .collect();
    if broken.is_empty() {
        return Ok(());
    }
    let unknown = |finding: &Finding| matches!(finding.verdict, Verdict::Broken { known: None });
    let names: Vec<_> = broken
        .iter()
        .map(|(lobe, finding)| {
            let known = if unknown(finding) { "" } else { " (known)" };
            format!("{} of {}{known}", finding.law.name(), lobe.label)
        })
        .collect();
    let laws = if broken.len() == 1 { "law fails" } else { "laws fail" };
    let report = Report::new(format_args!("{} {laws}: {}", broken.len(), names.join("; ")));
    Err(match broken.iter().all(|(_, finding)| !unknown(finding)) {
        true => report.help("each is a fault that its model is known to have").judged(),
        false => report.judged(),
    })
}
