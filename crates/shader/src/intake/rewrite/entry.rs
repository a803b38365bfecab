//! The entry point, where the text has another one than `main`.

use super::Rewriter;
use crate::intake::Complaint;
use crate::intake::items::{Item, is_precision};
use crate::intake::source::Origin;
use crate::intake::token::Token;
use crate::lower::Purpose;

/// A parameter of a function.
struct Parameter {
    ty: String,
    name: String,
    dimensions: String,
}

impl Rewriter {
    /// `main`, if the text has it; else one that calls `mainImage` as Shadertoy does, or the last function with inputs
    /// named after its parameters.
    pub(super) fn entry_point(&mut self, items: &[Item], end: Origin) -> Result<(), Complaint> {
        if self.functions.contains("main") {
            return Ok(());
        }
        if self.functions.contains("mainImage") {
            self.declare("vec4", "glanz_image", "", end);
            self.given.roles.insert("glanz_image".to_owned(), Purpose::Output("gl_FragColor".to_owned()));
            self.generated("void main() { mainImage(glanz_image, gl_FragCoord.xy); }", end);
            return Ok(());
        }
        let last = items.iter().rev().find_map(|item| match item {
            Item::Function { head, name, parameters, body } if body.len() > 1 => {
                Some((head, name, parameters))
            }
            _ => None,
        });
        let Some((head, name, parameters)) = last else {
            return Err(Complaint::whole("there is no function in this text: a shader has 'void main()'"));
        };
        self.call(head, name, parameters)
    }

    fn call(&mut self, head: &[Token], name: &Token, tokens: &[Token]) -> Result<(), Complaint> {
        let origin = name.origin;
        if head.iter().any(|t| t.is("void")) {
            let message = "a shader has 'void main()'; a function that stands for it returns a value";
            return Err(Complaint::at(message, origin));
        }
        let mut arguments = Vec::new();
        for parameter in parameters(tokens)? {
            let own = format!("glanz_{}", parameter.name);
            self.declare(&parameter.ty, &own, &parameter.dimensions, origin);
            self.given.roles.insert(own.clone(), Purpose::Input(parameter.name));
            arguments.push(own);
        }
        let ty: Vec<&str> = head.iter().map(|t| &*t.text).collect();
        self.declare(&ty.join(" "), "glanz_result", "", origin);
        self.given.roles.insert("glanz_result".to_owned(), Purpose::Output("result".to_owned()));
        let text = format!("void main() {{ glanz_result = {}({}); }}", name.text, arguments.join(", "));
        self.generated(&text, origin);
        Ok(())
    }
}

fn parameters(tokens: &[Token]) -> Result<Vec<Parameter>, Complaint> {
    let inside = tokens.get(1..tokens.len().saturating_sub(1)).unwrap_or_default();
    let mut all = Vec::new();
    for words in inside.split(|t| t.is(",")) {
        let skipped = |t: &&Token| !is_precision(&t.text) && !t.is("const") && !t.is("in");
        let words: Vec<&Token> = words.iter().filter(skipped).collect();
        match &words[..] {
            [] => {}
            [word] if word.is("void") => {}
            [word, ..] if word.is("out") || word.is("inout") => {
                let message = "a function that stands for a shader has no out parameters";
                return Err(Complaint::at(message, word.origin));
            }
            [ty, name, dimensions @ ..] => all.push(Parameter {
                ty: ty.text.to_string(),
                name: name.text.to_string(),
                dimensions: dimensions.iter().map(|t| &*t.text).collect(),
            }),
            [word] => return Err(Complaint::at("this parameter has no name", word.origin)),
        }
    }
    Ok(all)
}
