//! `glanz check`: the certificate of models.

use std::collections::BTreeMap;

use clap::Args;
use glanz_bsdf::MODELS;
use glanz_bsdf::laws::{Certificate, Finding, Verdict, certify};
use glanz_plot::Lobe;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::Serialize;

use crate::args::MachineArgs;
use crate::input::lobes::SetArgs;
use crate::input::models::models;
use crate::print::failure::{ErrorFacts, Failure, Report};
use crate::print::{self, FormatArgs, finite};

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz check phong
  glanz check phong blinn-phong --set shininess=8,32
  glanz check --all --allow-known
  glanz check --all --format json

Looked at are reciprocity, energy (the greatest albedo and where), positivity, the side of the
light, finiteness up to grazing angles, the normalisation of the distribution of facets, limits,
single against double precision, and 16 lanes against scalar code. The exit code is 1 where a law
fails, even if the model itself declares that it breaks it; with --allow-known, such a law counts as
kept.";

/// Options of `glanz check`.
#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// Names of models, from `glanz bsdf list`, or BRDFs of one's own, as `glanz shader certify` takes them
    #[arg(value_name = "MODEL", value_parser = models(), hide_possible_values = true,
          required_unless_present = "all")]
    models: Vec<String>,

    /// Check every model of the list
    #[arg(long, conflicts_with = "models")]
    all: bool,

    /// Let laws fail that a model declares to break; what fails beside them still counts
    #[arg(long)]
    allow_known: bool,

    #[command(flatten)]
    set: SetArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

impl CheckArgs {
    /// Looks at every combination, and prints what is found.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        let lobes = match self.all {
            true => self.set.lobes(&MODELS.iter().map(|info| info.name.to_owned()).collect::<Vec<_>>())?,
            false => self.set.lobes(&self.models)?,
        };
        let certificates: Vec<_> = lobes.par_iter().map(|lobe| certify(&lobe.shape)).collect();
        let error = self.error(&lobes, &certificates);
        let told = match self.format.is_json() {
            true => print::json(&Document {
                certificates: certificates.iter().map(CertificateFacts::of).collect(),
                error: error.as_ref().map(Report::facts),
            }),
            false => print::text(&table(&lobes, &certificates)),
        };
        Report::of_judged(error, told)
    }

    /// What names the laws that fail, if any does.
    fn error(&self, lobes: &[Lobe], certificates: &[Certificate]) -> Option<Report> {
        let is_known = |finding: &Finding| matches!(finding.verdict, Verdict::Broken { known: Some(_) });
        let broken: Vec<_> = lobes
            .iter()
            .zip(certificates)
            .flat_map(|(lobe, certificate)| certificate.findings.iter().map(move |finding| (lobe, finding)))
            .filter(|(_, finding)| finding.is_broken() && !(self.allow_known && is_known(finding)))
            .collect();
        if broken.is_empty() {
            return None;
        }
        let name = |(lobe, finding): &(&Lobe, &Finding)| {
            let known = if is_known(finding) { " (known)" } else { "" };
            format!("{} of {}{known}", finding.law.name(), lobe.label)
        };
        let names: Vec<_> = broken.iter().map(name).collect();
        let laws = if broken.len() == 1 { "law fails" } else { "laws fail" };
        let report = Report::new(format_args!("{} {laws}: {}", broken.len(), names.join("; ")));
        Some(match broken.iter().all(|(_, finding)| is_known(finding)) {
            true => {
                report.help("each is a fault that its model is known to have; --allow-known lets those pass")
            }
            false => report,
        })
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

/// What is found of models.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct Document {
    /// One for each model and each combination of its parameters
    certificates: Vec<CertificateFacts>,
    /// Why the command fails, where a law does
    error: Option<ErrorFacts>,
}

/// What is found of one model with these parameters.
#[derive(Debug, Serialize, JsonSchema)]
struct CertificateFacts {
    /// The model's name
    model: &'static str,
    /// Its parameters
    params: BTreeMap<&'static str, f64>,
    /// Whether all laws hold that apply
    healthy: bool,
    /// What is found of each law
    findings: Vec<FindingFacts>,
}

/// What is found of a law.
#[derive(Debug, Serialize, JsonSchema)]
pub(super) struct FindingFacts {
    /// The law's name
    check: &'static str,
    /// Whether it holds
    verdict: VerdictFacts,
    /// Whether the model itself declares that it breaks the law
    known: bool,
    /// Why it is known to be broken, or does not apply
    reason: Option<&'static str>,
    /// The number that the verdict is about; null where there is none, or it is infinite
    value: Option<f64>,
    /// What was found, in words
    detail: String,
}

#[derive(Debug, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum VerdictFacts {
    Holds,
    Fails,
    #[serde(rename = "not applicable")]
    NotApplicable,
}

impl CertificateFacts {
    fn of(certificate: &Certificate) -> Self {
        Self {
            model: certificate.model,
            params: certificate.params.iter().copied().collect(),
            healthy: certificate.is_healthy(),
            findings: certificate.findings.iter().map(FindingFacts::of).collect(),
        }
    }
}

impl FindingFacts {
    /// Whether the law fails.
    pub(super) fn fails(&self) -> bool {
        matches!(self.verdict, VerdictFacts::Fails)
    }

    /// The law's name.
    pub(super) fn name(&self) -> &'static str {
        self.check
    }

    pub(super) fn of(finding: &Finding) -> Self {
        let (verdict, reason) = match finding.verdict {
            Verdict::Holds => (VerdictFacts::Holds, None),
            Verdict::Broken { known } => (VerdictFacts::Fails, known),
            Verdict::NotApplicable(reason) => (VerdictFacts::NotApplicable, Some(reason)),
        };
        Self {
            check: finding.law.name(),
            verdict,
            known: matches!(finding.verdict, Verdict::Broken { known: Some(_) }),
            reason,
            value: finding.value.and_then(finite),
            detail: finding.detail.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::vary::variation;
    use crate::print::Format;

    /// What is said of Phong's certificate, where no law but `unknown` is broken without being declared.
    fn message(allow_known: bool, unknown: Option<glanz_bsdf::Law>) -> Option<String> {
        let set = SetArgs { set: vec![variation("shininess=8").unwrap()] };
        let lobes = set.lobes(&["phong".to_owned()]).unwrap();
        let mut certificate = certify(&lobes[0].shape);
        for finding in certificate.findings.iter_mut().filter(|finding| Some(finding.law) == unknown) {
            finding.verdict = Verdict::Broken { known: None };
        }
        let (machine, format) = (MachineArgs { threads: None }, FormatArgs { format: Format::Text });
        let args = CheckArgs { models: Vec::new(), all: true, allow_known, set, machine, format };
        args.error(&lobes, &[certificate]).map(|report| report.to_string())
    }

    #[test]
    fn what_no_model_declares_fails_even_where_known_faults_are_allowed() {
        let reciprocity = "reciprocity of phong shininess=8 (known)";
        let positivity = "positivity of phong shininess=8";
        assert!(message(false, None).unwrap().contains(reciprocity));
        assert_eq!(message(true, None), None);
        let both = message(false, Some(glanz_bsdf::Law::Positivity)).unwrap();
        assert!(both.contains(reciprocity) && both.contains(positivity), "{both}");
        let one = message(true, Some(glanz_bsdf::Law::Positivity)).unwrap();
        assert_eq!(one, format!("1 law fails: {positivity}"));
    }
}
