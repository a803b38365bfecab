//! Macros.

use std::collections::VecDeque;
use std::rc::Rc;

use super::{Done, MOST_STEPS, MOST_TOKENS, Preprocessor};
use crate::intake::Complaint;
use crate::intake::source::Origin;
use crate::intake::token::{Hidden, Kind, Token};

/// Expansions inside each other, of arguments.
const MOST_DEPTH: usize = 100;

#[derive(Clone, Debug)]
pub(super) struct Macro {
    /// Names; `None` of a macro without parentheses.
    pub(super) parameters: Option<Vec<Rc<str>>>,
    pub(super) body: Vec<Token>,
}

impl Preprocessor<'_> {
    pub(super) fn definition(&mut self, directive: &Token, rest: &[Token]) -> Done {
        let Some((name, rest)) = rest.split_first().filter(|(name, _)| name.is_identifier()) else {
            return Err(Complaint::at("#define wants a name", directive.origin));
        };
        let mut new = Macro { parameters: None, body: rest.to_vec() };
        if let Some(open) = rest.first()
            && open.is("(")
            && !open.spaced
        {
            let Some(close) = rest.iter().position(|t| t.is(")")) else {
                return Err(Complaint::at("the parameters of this macro lack their ')'", name.origin));
            };
            let inside = rest[1..close].iter();
            let names = inside.filter(|t| t.is_identifier()).map(|t| Rc::clone(&t.text)).collect();
            new = Macro { parameters: Some(names), body: rest[close + 1..].to_vec() };
        }
        self.macros.insert(Rc::clone(&name.text), new);
        Ok(())
    }

    /// All macros of the tokens expanded. What a macro makes has the place of its use.
    pub(super) fn expand(&mut self, tokens: Vec<Token>, depth: usize) -> Result<Vec<Token>, Complaint> {
        let mut input = VecDeque::from(tokens);
        let mut out = Vec::new();
        while let Some(token) = input.pop_front() {
            self.steps += 1;
            if self.steps > MOST_STEPS || out.len() > MOST_TOKENS || depth > MOST_DEPTH {
                return Err(self.too_long(token.origin));
            }
            if !token.is_identifier() || token.hides(&token.text) {
                out.push(token);
                continue;
            }
            if let Some(number) = self.built_in(&token) {
                out.push(Token { kind: Kind::Number, ..token.renamed(&number) });
                continue;
            }
            let Some(found) = self.macros.get(&token.text).cloned() else {
                out.push(token);
                continue;
            };
            let body = match &found.parameters {
                None => found.body.clone(),
                Some(_) if !input.front().is_some_and(|t| t.is("(")) => {
                    out.push(token);
                    continue;
                }
                Some(parameters) => {
                    let arguments = arguments(&token, &mut input)?;
                    self.substitute(&token, &found.body, parameters, &arguments, depth)?
                }
            };
            self.uses_macros = true;
            self.steps += body.len();
            if input.len() > MOST_TOKENS {
                return Err(self.too_long(token.origin));
            }
            replace(&token, body, &mut input);
        }
        Ok(out)
    }

    /// That the text is too long, and whether macros made it so.
    pub(super) fn too_long(&self, origin: Origin) -> Complaint {
        match self.uses_macros {
            true => Complaint::at("macros make the text too long", origin),
            false => Complaint::at(
                format!("the text is too long: more than {MOST_TOKENS} words, numbers and signs"),
                origin,
            ),
        }
    }

    fn built_in(&self, token: &Token) -> Option<String> {
        match &*token.text {
            "__LINE__" => Some(self.line_of(token.origin).to_string()),
            "__FILE__" => Some("0".to_owned()),
            "__VERSION__" => Some(self.version.number.max(110).to_string()),
            "GL_ES" if self.version.es => Some("1".to_owned()),
            _ => None,
        }
    }

    fn substitute(
        &mut self,
        token: &Token,
        body: &[Token],
        parameters: &[Rc<str>],
        arguments: &[Vec<Token>],
        depth: usize,
    ) -> Result<Vec<Token>, Complaint> {
        let given =
            if parameters.is_empty() && arguments.iter().all(Vec::is_empty) { 0 } else { arguments.len() };
        if given != parameters.len() {
            let wanted = parameters.len();
            let message = format!("the macro '{}' takes {wanted} arguments, not {given}", token.text);
            return Err(Complaint::at(message, token.origin));
        }
        let mut expanded = Vec::new();
        for argument in arguments {
            expanded.push(self.expand(argument.clone(), depth + 1)?);
        }
        let mut out: Vec<Token> = Vec::new();
        let mut glue = false;
        for (i, part) in body.iter().enumerate() {
            if part.is("##") {
                glue = true;
                continue;
            }
            let glued = glue || body.get(i + 1).is_some_and(|t| t.is("##"));
            let which = parameters.iter().position(|p| part.is_identifier() && *p == part.text);
            let piece = match which {
                None => vec![part.clone()],
                Some(k) if glued => arguments[k].clone(),
                Some(k) => expanded[k].clone(),
            };
            let mut piece = piece.into_iter();
            if glue && let (Some(last), Some(next)) = (out.last_mut(), piece.next()) {
                *last = last.renamed(&format!("{}{}", last.text, next.text));
            }
            glue = false;
            out.extend(piece);
            self.steps += 1;
            if out.len() > MOST_TOKENS {
                return Err(self.too_long(token.origin));
            }
        }
        Ok(out)
    }
}

/// The arguments of a use of a macro, whose '(' comes next.
fn arguments(token: &Token, input: &mut VecDeque<Token>) -> Result<Vec<Vec<Token>>, Complaint> {
    input.pop_front();
    let (mut all, mut depth) = (vec![Vec::new()], 0usize);
    while let Some(t) = input.pop_front() {
        match &*t.text {
            ")" if depth == 0 => return Ok(all),
            "," if depth == 0 => {
                all.push(Vec::new());
                continue;
            }
            "(" => depth += 1,
            ")" => depth -= 1,
            _ => {}
        }
        if let Some(last) = all.last_mut() {
            last.push(t);
        }
    }
    Err(Complaint::at(format!("the arguments of the macro '{}' lack their ')'", token.text), token.origin))
}

/// Puts a macro's body where its use was.
fn replace(token: &Token, body: Vec<Token>, input: &mut VecDeque<Token>) {
    let hidden = Some(Rc::new(Hidden { name: Rc::clone(&token.text), next: token.hidden.clone() }));
    if let Some(next) = input.front_mut() {
        next.spaced = true;
    }
    let last = body.len();
    for (i, part) in body.into_iter().rev().enumerate() {
        let first = token.first && i + 1 == last;
        let spaced = part.spaced || i + 1 == last;
        input.push_front(Token { origin: token.origin, hidden: hidden.clone(), first, spaced, ..part });
    }
}
