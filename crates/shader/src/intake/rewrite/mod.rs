//! Top-level items to what naga reads.

mod bodies;
mod choices;
mod circuit;
mod declarations;
mod effects;
mod entry;
mod legacy;
mod loops;
mod prelude;
mod refused;
mod samplers;
mod sizes;
mod writer;

use std::collections::{HashMap, HashSet};

use super::Complaint;
use super::items::{Declarator, Item, Reader};
use super::nesting::check_nesting;
use super::preprocess::Version;
use super::source::{Map, Origin};
use super::token::{Kind, Token};
use crate::lower::Purpose;
use crate::{Interpolation, Stage};

/// What is known of an input or output beside its type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct PortInfo {
    pub(crate) location: Option<u32>,
    pub(crate) interpolation: Interpolation,
}

/// What the text declares towards the host.
#[derive(Clone, Debug, Default)]
pub(crate) struct Given {
    /// Private variable → what it stands for.
    pub(crate) roles: HashMap<String, Purpose>,
    /// Input or output → what is known of it.
    pub(crate) ports: HashMap<String, PortInfo>,
    /// Where uniforms, inputs and outputs are declared.
    pub(crate) declared: HashMap<String, Origin>,
    /// Words that are right, but not in the version that the text names.
    pub(crate) remarks: Vec<(String, Origin)>,
}

/// The rewritten text.
pub(super) struct Rewritten {
    pub(super) text: String,
    pub(super) map: Map,
    pub(super) given: Given,
}

struct Rewriter {
    stage: Stage,
    version: Version,
    is_toy: bool,
    out: Vec<Token>,
    given: Given,
    /// Names of samplers → their types, of the whole text.
    samplers: HashMap<String, String>,
    /// Arrays of samplers → how many there are.
    sampler_arrays: HashMap<String, usize>,
    /// Structs → their members that are samplers, with their types.
    struct_samplers: HashMap<String, Vec<(Declarator, String)>>,
    /// Uniforms that are structs with samplers.
    holders: HashMap<String, samplers::Holder>,
    /// Whole constants of the text.
    constants: HashMap<String, i64>,
    /// Names of functions that the text defines.
    functions: HashSet<String>,
    /// Those whose call is more than its value.
    effects: HashSet<String>,
    /// Functions of GLSL's that gather texels and that functions of ours stand for.
    gathers: HashSet<String>,
    used: HashSet<String>,
    bindings: u32,
}

/// Rewrites the tokens of a stage. `is_toy`: Shadertoy's names are there, whether or not the text has a `mainImage`.
pub(super) fn rewrite(
    tokens: &[Token],
    stage: Stage,
    version: Version,
    is_toy: bool,
) -> Result<Rewritten, Complaint> {
    check_nesting(tokens)?;
    let tokens = &*sizes::sized(tokens);
    refused::check(tokens)?;
    let items = Reader::new(tokens).items()?;
    refused::check_recursion(&items)?;
    let used = tokens.iter().filter(|t| t.is_identifier()).map(|t| t.text.to_string()).collect();
    let functions = items.iter().filter_map(|item| match item {
        Item::Function { name, .. } => Some(name.text.to_string()),
        _ => None,
    });
    let mut rewriter = Rewriter {
        stage,
        version,
        is_toy,
        out: Vec::new(),
        given: Given::default(),
        samplers: HashMap::new(),
        sampler_arrays: HashMap::new(),
        struct_samplers: HashMap::new(),
        holders: HashMap::new(),
        constants: samplers::constants(&items),
        functions: functions.collect(),
        effects: effects::of_functions(&items),
        gathers: HashSet::new(),
        used,
        bindings: 0,
    };
    rewriter.prelude();
    rewriter.legacy_declarations(&items);
    for item in &items {
        rewriter.item(item)?;
    }
    rewriter.entry_point(&items, tokens.last().map(|t| t.origin).unwrap_or_default())?;
    let (text, map) = writer::write(&rewriter.out);
    Ok(Rewritten { text, map, given: rewriter.given })
}

impl Rewriter {
    fn item(&mut self, item: &Item) -> Result<(), Complaint> {
        match item {
            Item::Nothing(qualifiers) => self.default_layout(qualifiers),
            Item::Struct { qualifiers, keyword, name, members, variables } => {
                self.structure(qualifiers, keyword, name.as_ref(), members, variables)
            }
            Item::Block { qualifiers, name, members, instance } => {
                self.block(qualifiers, name, members, instance.as_ref())
            }
            Item::Variables { qualifiers, ty, variables } => self.variables(qualifiers, ty, variables),
            Item::Function { head, name, parameters, body } => self.function(head, name, parameters, body),
        }
    }

    /// Adds words that the user did not write; errors in them point to `origin`.
    fn generated(&mut self, text: &str, origin: Origin) {
        let token = |text: &str, spaced| Token {
            kind: Kind::Punctuation,
            text: text.into(),
            origin,
            spaced,
            first: false,
            hidden: None,
        };
        self.out.push(token(text, true));
    }

    fn push(&mut self, token: &Token) {
        self.out.push(token.clone());
    }

    /// Adds a declared name with array sizes and initial value.
    fn declarator(&mut self, declarator: &Declarator) -> Result<(), Complaint> {
        let name = self.safe_name(&declarator.name);
        self.out.push(Token { spaced: true, ..name });
        self.body(&declarator.dimensions, &HashMap::new())?;
        if !declarator.value.is_empty() {
            self.generated("=", declarator.name.origin);
            self.body(&declarator.value, &HashMap::new())?;
        }
        Ok(())
    }
}
