//! Functions: parameters and what stands between their braces.

use std::collections::HashMap;

use super::Rewriter;
use super::circuit::shortened;
use super::legacy::modern_function;
use super::loops::with_conditions;
use crate::intake::items::is_precision;
use crate::intake::token::{Kind, Token};
use crate::intake::{Complaint, SAMPLER_SUFFIX, TEXTURE_SUFFIX};

/// Words of later versions that earlier ones may use as names.
const LATER_WORDS: [&str; 12] = [
    "sample",
    "buffer",
    "shared",
    "patch",
    "precise",
    "texture1D",
    "texture2D",
    "texture3D",
    "textureCube",
    "sampler",
    "samplerShadow",
    "texture2DArray",
];

pub(super) fn is_sampler_type(word: &str) -> bool {
    word.trim_start_matches(['i', 'u']).starts_with("sampler")
        && word.ends_with(|c: char| c.is_alphanumeric())
}

/// The type of the texture in a sampler.
pub(super) fn texture_type(sampler: &str) -> String {
    sampler.replacen("sampler", "texture", 1).replace("Shadow", "")
}

/// The type of its other half.
pub(super) fn sampler_type(sampler: &str) -> &'static str {
    if sampler.ends_with("Shadow") { "samplerShadow" } else { "sampler" }
}

/// Whether a function with a result may come to its end without a return, as the front end sees it.
fn may_fall_through(head: &[Token], body: &[Token]) -> bool {
    if body.len() < 2 || head.iter().any(|t| t.is("void")) {
        return false;
    }
    let (mut depth, mut begins, mut last) = (0u32, true, None);
    for token in body {
        match &*token.text {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 1 && begins && !token.is("{") && !token.is("}") {
            last = Some(token);
        }
        begins = depth == 1 && matches!(&*token.text, "{" | "}" | ";");
    }
    !last.is_some_and(|token| token.is("return"))
}

impl Rewriter {
    /// A name that is no word of GLSL 450.
    pub(super) fn safe_name(&self, token: &Token) -> Token {
        if LATER_WORDS.contains(&&*token.text) && !self.is_word(&token.text) {
            return token.renamed(&format!("{}_glanz", token.text));
        }
        token.clone()
    }

    /// Whether the text uses the word as GLSL means it.
    fn is_word(&self, word: &str) -> bool {
        matches!(word, "sample" | "buffer" | "shared" | "patch" | "precise") && self.version.number >= 400
    }

    pub(super) fn function(
        &mut self,
        head: &[Token],
        name: &Token,
        parameters: &[Token],
        body: &[Token],
    ) -> Result<(), Complaint> {
        head.iter().for_each(|t| self.push(t));
        let name = self.safe_name(name);
        self.out.push(Token { spaced: true, ..name });
        let samplers = self.parameters(parameters)?;
        let conditioned = with_conditions(body)?;
        let body = conditioned.as_deref().unwrap_or(body);
        let written_out = self.written_out(body)?;
        let body = written_out.as_deref().unwrap_or(body);
        let shortened = shortened(body, &self.effects);
        let body = shortened.as_deref().unwrap_or(body);
        let Some((close, inside)) = body.split_last().filter(|_| may_fall_through(head, body)) else {
            return self.body(body, &samplers);
        };
        self.body(inside, &samplers)?;
        let ty: Vec<&str> =
            head.iter().map(|t| &*t.text).filter(|word| !is_precision(word) && *word != "const").collect();
        // What a function gives that ends without a return is undefined; here it is 0.
        self.generated(&format!("{} glanz_nothing; return glanz_nothing;", ty.join(" ")), close.origin);
        self.push(close);
        Ok(())
    }

    /// Writes the parameters; those that are samplers, with their types.
    fn parameters(&mut self, tokens: &[Token]) -> Result<HashMap<String, String>, Complaint> {
        let mut samplers = HashMap::new();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at += 1;
            if is_precision(&token.text) || token.is("const") {
                continue;
            }
            if !is_sampler_type(&token.text) || !token.is_identifier() {
                let token = self.safe_name(token);
                self.out.push(token);
                continue;
            }
            let (texture, sampler) = (texture_type(&token.text), sampler_type(&token.text));
            match tokens.get(at).filter(|t| t.is_identifier()) {
                Some(name) => {
                    at += 1;
                    if tokens.get(at).is_some_and(|t| t.is("[")) {
                        let message =
                            "arrays of samplers as parameters are not there: pass one, or name the uniform";
                        return Err(Complaint::unsupported(message, name.origin));
                    }
                    samplers.insert(name.text.to_string(), token.text.to_string());
                    let text =
                        format!("{texture} {0}{TEXTURE_SUFFIX}, {sampler} {0}{SAMPLER_SUFFIX}", name.text);
                    self.out.push(token.renamed(&text));
                }
                // A prototype may leave the name out.
                None => self.out.push(token.renamed(&format!("{texture}, {sampler}"))),
            }
        }
        Ok(samplers)
    }

    /// Writes tokens in which names are replaced. `local`: samplers among the function's parameters.
    pub(super) fn body(
        &mut self,
        tokens: &[Token],
        local: &HashMap<String, String>,
    ) -> Result<(), Complaint> {
        // The functions in whose arguments we stand.
        let mut calls: Vec<bool> = Vec::new();
        let mut at = 0;
        while let Some(token) = tokens.get(at) {
            at += 1;
            if token.kind != Kind::Identifier {
                if token.is("(") {
                    let before = at.checked_sub(2).and_then(|i| tokens.get(i));
                    calls.push(before.is_some_and(|t| self.takes_halves(&t.text)));
                } else if token.is(")") {
                    calls.pop();
                }
                self.push(token);
                continue;
            }
            if at > 1 && tokens[at - 2].is(".") {
                let token = self.safe_name(token);
                self.out.push(token);
                continue;
            }
            if token.is("precision") {
                while tokens.get(at).is_some_and(|t| !t.is(";")) {
                    at += 1;
                }
                at += 1;
                continue;
            }
            if is_precision(&token.text) {
                continue;
            }
            let to_function = calls.last() == Some(&true);
            if let Some((text, taken)) = self.sampler_use(token, &tokens[at..], local, to_function) {
                self.out.push(token.renamed(&text));
                at += taken;
                continue;
            }
            let is_call = tokens.get(at).is_some_and(|t| t.is("("));
            let replaced = self.replacement(token, is_call);
            self.out.push(replaced);
        }
        Ok(())
    }

    /// Whether samplers go to the function in two halves.
    fn takes_halves(&self, function: &str) -> bool {
        self.functions.contains(function) || self.gathers.contains(function)
    }

    fn replacement(&mut self, token: &Token, is_call: bool) -> Token {
        if self.gathers.contains(&*token.text) {
            return token.renamed(&format!("glanz_{}", token.text));
        }
        if self.functions.contains(&*token.text) {
            return self.safe_name(token);
        }
        if is_call && let Some(modern) = modern_function(&token.text) {
            if self.version.number >= 130 {
                let message = format!("'{}' is '{modern}' since GLSL 1.30", token.text);
                self.given.remarks.push((message, token.origin));
            }
            return token.renamed(modern);
        }
        match self.legacy_name(&token.text) {
            Some(name) => token.renamed(&name),
            None => self.safe_name(token),
        }
    }
}
