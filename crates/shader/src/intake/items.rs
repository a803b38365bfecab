//! Top-level items of a GLSL text: a reader that returns errors.

use super::Complaint;
use super::source::Origin;
use super::token::{Kind, Token};

/// Structs inside each other.
const MOST_DEPTH: usize = 200;

/// A name that is declared, with array sizes and initial value.
#[derive(Clone, Debug)]
pub(super) struct Declarator {
    pub(super) name: Token,
    /// `[`…`]`, all of them.
    pub(super) dimensions: Vec<Token>,
    /// What stands behind `=`.
    pub(super) value: Vec<Token>,
}

/// What stands before a type.
#[derive(Clone, Debug, Default)]
pub(super) struct Qualifiers {
    pub(super) words: Vec<Token>,
}

impl Qualifiers {
    pub(super) fn has(&self, word: &str) -> bool {
        self.words.iter().any(|t| t.is(word))
    }
}

/// A member of a struct or block.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub(super) qualifiers: Qualifiers,
    pub(super) ty: Vec<Token>,
    pub(super) declarators: Vec<Declarator>,
}

#[derive(Clone, Debug)]
pub(super) enum Item {
    /// `precision …;`, `layout(…) uniform;`, `invariant x;`, a stray `;`.
    Nothing(Qualifiers),
    /// `struct Name { … } variables;`, perhaps with qualifiers.
    Struct {
        qualifiers: Qualifiers,
        keyword: Token,
        name: Option<Token>,
        members: Vec<Member>,
        variables: Vec<Declarator>,
    },
    /// `uniform Name { … } instance;`
    Block {
        qualifiers: Qualifiers,
        name: Token,
        members: Vec<Member>,
        instance: Option<Declarator>,
    },
    Variables {
        qualifiers: Qualifiers,
        ty: Vec<Token>,
        variables: Vec<Declarator>,
    },
    /// A function or its prototype: up to its '(', the parameters, and the body with its braces or `;`.
    Function {
        head: Vec<Token>,
        name: Token,
        parameters: Vec<Token>,
        body: Vec<Token>,
    },
}

const QUALIFIERS: [&str; 27] = [
    "const",
    "uniform",
    "in",
    "out",
    "inout",
    "attribute",
    "varying",
    "smooth",
    "flat",
    "noperspective",
    "centroid",
    "sample",
    "patch",
    "invariant",
    "precise",
    "highp",
    "mediump",
    "lowp",
    "buffer",
    "shared",
    "coherent",
    "volatile",
    "restrict",
    "readonly",
    "writeonly",
    "subroutine",
    "layout",
];

/// Whether the word stands before types and says nothing to this machine.
pub(super) fn is_precision(word: &str) -> bool {
    matches!(word, "highp" | "mediump" | "lowp" | "precise")
}

pub(super) struct Reader<'a> {
    tokens: &'a [Token],
    at: usize,
    /// Depth of structs inside each other.
    depth: usize,
}

impl<'a> Reader<'a> {
    pub(super) fn new(tokens: &'a [Token]) -> Self {
        Self { tokens, at: 0, depth: 0 }
    }

    fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    fn is(&self, text: &str) -> bool {
        self.peek().is_some_and(|t| t.is(text))
    }

    fn take(&mut self, text: &str) -> bool {
        let found = self.is(text);
        self.at += usize::from(found);
        found
    }

    fn origin(&self) -> Origin {
        let here = self.peek().or(self.tokens.last());
        here.map(|t| t.origin).unwrap_or_default()
    }

    fn expected(&self, what: &str) -> Complaint {
        match self.peek() {
            None => Complaint::at(format!("{what} is expected, but the text ends"), self.origin()),
            // What is missing is missed behind what stands before, where it would be looked for.
            Some(token) => Complaint::at(format!("{what} is expected before '{}'", token.text), token.origin),
        }
    }

    fn expect(&mut self, text: &str) -> Result<&'a Token, Complaint> {
        match self.peek() {
            Some(token) if token.is(text) => {
                self.at += 1;
                Ok(token)
            }
            _ => Err(self.expected(&format!("'{text}'"))),
        }
    }

    fn identifier(&mut self, what: &str) -> Result<&'a Token, Complaint> {
        match self.peek() {
            Some(token) if token.is_identifier() => {
                self.at += 1;
                Ok(token)
            }
            _ => Err(self.expected(what)),
        }
    }

    /// From an opening bracket, which comes next, to the one that closes it, both included.
    fn balanced(&mut self) -> Result<&'a [Token], Complaint> {
        let (start, mut depth) = (self.at, 0usize);
        while let Some(token) = self.peek() {
            self.at += 1;
            match &*token.text {
                "(" | "{" | "[" => depth += 1,
                ")" | "}" | "]" => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                return Ok(&self.tokens[start..self.at]);
            }
        }
        Err(self.expected("a closing bracket"))
    }

    pub(super) fn items(mut self) -> Result<Vec<Item>, Complaint> {
        let mut all = Vec::new();
        while self.peek().is_some() {
            all.push(self.item()?);
        }
        Ok(all)
    }

    fn qualifiers(&mut self) -> Result<Qualifiers, Complaint> {
        let mut all = Qualifiers::default();
        while let Some(token) = self.peek() {
            // A type may be called `sample`, and a variable of it `patch`.
            let is_name = matches!(&*token.text, "sample" | "patch" | "buffer")
                && !self.tokens.get(self.at + 1).is_some_and(Token::is_identifier);
            if !QUALIFIERS.contains(&&*token.text) || is_name {
                break;
            }
            self.at += 1;
            all.words.push(token.clone());
            if token.is("layout") || token.is("subroutine") && self.is("(") {
                all.words.extend(self.balanced()?.iter().cloned());
            }
        }
        Ok(all)
    }

    fn item(&mut self) -> Result<Item, Complaint> {
        if self.take("precision") {
            while !self.take(";") {
                self.identifier("';'")?;
            }
            return Ok(Item::Nothing(Qualifiers::default()));
        }
        let qualifiers = self.qualifiers()?;
        if self.take(";") {
            return Ok(Item::Nothing(qualifiers));
        }
        if self.is("struct") {
            return self.structure(qualifiers);
        }
        let first = self.identifier("a declaration")?;
        if self.is("{") {
            return self.block(qualifiers, first);
        }
        if self.is(";") || self.is(",") {
            // `invariant gl_Position;`, `invariant a, b;`
            while self.take(",") {
                self.identifier("a name")?;
            }
            self.expect(";")?;
            return Ok(Item::Nothing(qualifiers));
        }
        let mut ty = vec![first.clone()];
        while self.is("[") {
            ty.extend(self.balanced()?.iter().cloned());
        }
        let name = self.identifier("a name")?;
        if self.is("(") {
            return self.function(&qualifiers, ty, name);
        }
        let variables = self.declarators(name)?;
        self.expect(";")?;
        Ok(Item::Variables { qualifiers, ty, variables })
    }

    fn function(&mut self, qualifiers: &Qualifiers, ty: Vec<Token>, name: &Token) -> Result<Item, Complaint> {
        let parameters = self.balanced()?.to_vec();
        let mut head: Vec<Token> =
            qualifiers.words.iter().filter(|t| !is_precision(&t.text)).cloned().collect();
        head.extend(ty);
        let body = if self.is("{") { self.balanced()?.to_vec() } else { vec![self.expect(";")?.clone()] };
        Ok(Item::Function { head, name: name.clone(), parameters, body })
    }

    fn structure(&mut self, qualifiers: Qualifiers) -> Result<Item, Complaint> {
        let keyword = self.expect("struct")?.clone();
        let name = if self.is("{") { None } else { Some(self.identifier("the name of the struct")?.clone()) };
        let members = self.members()?;
        let mut variables = Vec::new();
        if !self.is(";") {
            let first = self.identifier("';'")?;
            variables = self.declarators(first)?;
        }
        self.expect(";")?;
        Ok(Item::Struct { qualifiers, keyword, name, members, variables })
    }

    fn block(&mut self, qualifiers: Qualifiers, name: &Token) -> Result<Item, Complaint> {
        let members = self.members()?;
        let instance = if self.is(";") {
            None
        } else {
            let name = self.identifier("';'")?;
            self.declarators(name)?.into_iter().next()
        };
        self.expect(";")?;
        Ok(Item::Block { qualifiers, name: name.clone(), members, instance })
    }

    fn members(&mut self) -> Result<Vec<Member>, Complaint> {
        self.depth += 1;
        if self.depth > MOST_DEPTH {
            return Err(self.expected("a struct that is nested less"));
        }
        self.expect("{")?;
        let mut all = Vec::new();
        while !self.take("}") {
            if self.take(";") {
                continue;
            }
            let qualifiers = self.qualifiers()?;
            if self.is("struct") {
                return Err(Complaint::at("a struct cannot be defined inside another", self.origin()));
            }
            let mut ty = vec![self.identifier("a type")?.clone()];
            while self.is("[") {
                ty.extend(self.balanced()?.iter().cloned());
            }
            let name = self.identifier("the name of a member")?;
            let declarators = self.declarators(name)?;
            self.expect(";")?;
            all.push(Member { qualifiers, ty, declarators });
        }
        self.depth -= 1;
        Ok(all)
    }

    /// Declarators from the first name, which is behind, on.
    fn declarators(&mut self, first: &Token) -> Result<Vec<Declarator>, Complaint> {
        let mut all = Vec::new();
        let mut name = first.clone();
        loop {
            let mut new = Declarator { name, dimensions: Vec::new(), value: Vec::new() };
            while self.is("[") {
                new.dimensions.extend(self.balanced()?.iter().cloned());
            }
            if self.take("=") {
                new.value = self.initial_value()?;
            }
            all.push(new);
            if !self.take(",") {
                return Ok(all);
            }
            name = self.identifier("a name")?.clone();
        }
    }

    fn initial_value(&mut self) -> Result<Vec<Token>, Complaint> {
        let start = self.at;
        while let Some(token) = self.peek() {
            match &*token.text {
                "," | ";" => break,
                "(" | "{" | "[" => {
                    self.balanced()?;
                }
                // The next line's word: the ';' is missing before it.
                _ if token.first && self.at > start && token.is_identifier() && self.ends_value(start) => {
                    break;
                }
                _ => self.at += 1,
            }
        }
        if self.at == start {
            return Err(self.expected("a value"));
        }
        Ok(self.tokens[start..self.at].to_vec())
    }

    /// Whether a value could end before what comes next: no operator stands there.
    fn ends_value(&self, start: usize) -> bool {
        let before = self.tokens[start..self.at].last();
        before.is_some_and(|t| t.kind != Kind::Punctuation || matches!(&*t.text, ")" | "}" | "]"))
    }
}
