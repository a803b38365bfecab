//! Variables, structs and blocks.

use super::bodies::is_sampler_type;
use super::{PortInfo, Rewriter};
use crate::intake::Complaint;
use crate::intake::items::{Declarator, Member, Qualifiers, is_precision};
use crate::intake::source::Origin;
use crate::intake::token::Token;
use crate::lower::Purpose;
use crate::{Interpolation, Stage};

/// Which way a declaration goes.
#[derive(Clone, Copy, PartialEq)]
enum Storage {
    Uniform,
    Input,
    Output,
    Plain,
}

impl Rewriter {
    fn storage(&mut self, qualifiers: &Qualifiers) -> Result<Storage, Complaint> {
        let vertex = self.stage == Stage::Vertex;
        for token in &qualifiers.words {
            let storage = match &*token.text {
                "uniform" => Storage::Uniform,
                "in" | "attribute" => Storage::Input,
                "out" => Storage::Output,
                "varying" if vertex => Storage::Output,
                "varying" => Storage::Input,
                "buffer" | "shared" => {
                    return Err(Complaint::unsupported(
                        "storage and shared memory are not there",
                        token.origin,
                    ));
                }
                "patch" => {
                    return Err(Complaint::unsupported("tessellation shaders are not there", token.origin));
                }
                _ => continue,
            };
            if matches!(&*token.text, "attribute" | "varying") && self.version.number >= 140 {
                let modern = if storage == Storage::Input { "in" } else { "out" };
                let message = format!("'{}' is '{modern}' since GLSL 1.30", token.text);
                self.given.remarks.push((message, token.origin));
            }
            return Ok(storage);
        }
        Ok(Storage::Plain)
    }

    /// `layout(…) in;` says which stage this is.
    pub(super) fn default_layout(&mut self, qualifiers: &Qualifiers) -> Result<(), Complaint> {
        for token in &qualifiers.words {
            let stage = match &*token.text {
                "triangles"
                | "lines"
                | "points"
                | "triangle_strip"
                | "line_strip"
                | "max_vertices"
                | "triangles_adjacency"
                | "lines_adjacency"
                | "invocations" => "geometry",
                "quads" | "isolines" | "vertices" | "equal_spacing" => "tessellation",
                _ => continue,
            };
            return Err(Complaint::unsupported(format!("{stage} shaders are not there"), token.origin));
        }
        Ok(())
    }

    /// Remembers what a variable stands for, under the name by which the host knows it.
    fn give(
        &mut self,
        variable: &str,
        host: &str,
        storage: Storage,
        qualifiers: &Qualifiers,
        origin: Origin,
    ) {
        let role = match storage {
            Storage::Uniform => Purpose::Uniform(host.to_owned()),
            Storage::Input => Purpose::Input(host.to_owned()),
            Storage::Output => Purpose::Output(host.to_owned()),
            Storage::Plain => return,
        };
        self.given.roles.insert(variable.to_owned(), role);
        self.given.declared.insert(host.to_owned(), origin);
        if storage != Storage::Uniform {
            let interpolation = if qualifiers.has("flat") {
                Interpolation::Flat
            } else if qualifiers.has("noperspective") {
                Interpolation::Linear
            } else {
                Interpolation::Perspective
            };
            let location = location(&qualifiers.words);
            self.given.ports.insert(host.to_owned(), PortInfo { location, interpolation });
        }
    }

    pub(super) fn variables(
        &mut self,
        qualifiers: &Qualifiers,
        ty: &[Token],
        variables: &[Declarator],
    ) -> Result<(), Complaint> {
        let storage = self.storage(qualifiers)?;
        let Some(name) = ty.first() else { return Ok(()) };
        if is_sampler_type(&name.text) {
            for variable in variables {
                self.declare_samplers(&name.text, &variable.name.text, variable, variable.name.origin)?;
            }
            return Ok(());
        }
        for variable in variables {
            // What the pipeline has is only declared anew.
            if variable.name.text.starts_with("gl_") {
                continue;
            }
            if qualifiers.has("const") {
                self.generated("const", name.origin);
            }
            self.body(ty, &std::collections::HashMap::new())?;
            self.declarator(variable)?;
            self.generated(";", variable.name.origin);
            let own = self.safe_name(&variable.name).text.to_string();
            self.give(&own, &variable.name.text, storage, qualifiers, variable.name.origin);
            if storage == Storage::Uniform {
                self.hold(&name.text, variable)?;
            }
        }
        Ok(())
    }

    pub(super) fn structure(
        &mut self,
        qualifiers: &Qualifiers,
        keyword: &Token,
        name: Option<&Token>,
        members: &[Member],
        variables: &[Declarator],
    ) -> Result<(), Complaint> {
        let made_up = format!("glanz_struct{}", self.out.len());
        let name = name.cloned().unwrap_or_else(|| keyword.renamed(&made_up));
        self.define_struct(keyword, &name, members)?;
        if variables.is_empty() {
            return Ok(());
        }
        self.variables(qualifiers, &[Token { first: false, spaced: true, ..name }], variables)
    }

    fn define_struct(&mut self, keyword: &Token, name: &Token, members: &[Member]) -> Result<(), Complaint> {
        self.out.push(keyword.renamed("struct"));
        self.out.push(Token { spaced: true, first: false, ..name.clone() });
        self.generated("{", name.origin);
        let (mut samplers, mut plain) = (Vec::new(), 0);
        for member in members {
            let Some(ty) = member.ty.first() else { continue };
            for declarator in &member.declarators {
                if is_sampler_type(&ty.text) {
                    samplers.push((declarator.clone(), ty.text.to_string()));
                    continue;
                }
                plain += 1;
                self.member(&member.ty, declarator)?;
            }
        }
        if plain == 0 {
            self.generated("float glanz_nothing;", name.origin);
        }
        self.generated("};", name.origin);
        if !samplers.is_empty() {
            self.struct_samplers.insert(name.text.to_string(), samplers);
        }
        Ok(())
    }

    fn member(&mut self, ty: &[Token], declarator: &Declarator) -> Result<(), Complaint> {
        let ty: Vec<Token> = ty.iter().filter(|t| !is_precision(&t.text)).cloned().collect();
        self.body(&ty, &std::collections::HashMap::new())?;
        self.declarator(declarator)?;
        self.generated(";", declarator.name.origin);
        Ok(())
    }

    pub(super) fn block(
        &mut self,
        qualifiers: &Qualifiers,
        name: &Token,
        members: &[Member],
        instance: Option<&Declarator>,
    ) -> Result<(), Complaint> {
        let storage = self.storage(qualifiers)?;
        if name.is("gl_PerVertex") {
            return Ok(());
        }
        let Some(instance) = instance else {
            for member in members {
                let mut all = member.qualifiers.clone();
                all.words.extend(qualifiers.words.iter().cloned());
                self.variables(&all, &member.ty, &member.declarators)?;
            }
            return Ok(());
        };
        let ty = name.renamed(&format!("{}_glanz_block", name.text));
        self.define_struct(name, &ty, members)?;
        self.generated(&ty.text, name.origin);
        self.declarator(instance)?;
        self.generated(";", instance.name.origin);
        let own = self.safe_name(&instance.name).text.to_string();
        self.give(&own, &name.text, storage, qualifiers, name.origin);
        for member in members.iter().filter(|m| m.qualifiers.has("flat")) {
            for declarator in &member.declarators {
                let info = PortInfo { location: None, interpolation: Interpolation::Flat };
                self.given.ports.insert(format!("{}.{}", name.text, declarator.name.text), info);
            }
        }
        Ok(())
    }
}

/// The number in `layout(location = …)`.
fn location(words: &[Token]) -> Option<u32> {
    let at = words.iter().position(|t| t.is("location"))?;
    words.get(at + 2)?.text.parse().ok()
}
