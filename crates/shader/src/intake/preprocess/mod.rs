//! The preprocessor of GLSL: what naga's has not (includes, places of tokens, bounds) and what its versions differ in.

mod condition;
mod macros;

use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use super::source::{Origin, Sources};
use super::token::{Kind, Token, tokens};
use super::{Complaint, Include};
use macros::Macro;

/// Includes inside each other.
const MOST_INCLUDES: usize = 16;
/// Tokens after expansion; the longest shader in the wild has some 50 000.
const MOST_TOKENS: usize = 200_000;
/// Steps of expansion.
const MOST_STEPS: usize = 1_000_000;
/// Bytes of all files together.
const MOST_BYTES: usize = 4 << 20;

const VERSIONS: [u32; 18] =
    [100, 110, 120, 130, 140, 150, 300, 310, 320, 330, 400, 410, 420, 430, 440, 450, 460, 200];

/// The version that the text names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Version {
    /// 0 where there is none.
    pub(super) number: u32,
    pub(super) es: bool,
}

pub(super) struct Preprocessor<'a> {
    pub(super) sources: &'a mut Sources,
    include: Option<Include<'a>>,
    macros: HashMap<Rc<str>, Macro>,
    /// Of each conditional around: whether it holds, whether a branch held, whether `#else` was there.
    conditions: Vec<(bool, bool, bool)>,
    /// Where they stand.
    opened: Vec<Origin>,
    pub(super) version: Version,
    out: Vec<Token>,
    steps: usize,
    /// Whether a macro was expanded.
    uses_macros: bool,
    bytes: usize,
    /// The files around, by their paths.
    within: Vec<String>,
    /// Those that are to be included once.
    once: HashSet<String>,
}

/// The path of a file that is included, from the folder of the first file: what `path` means in the file `from`, which is
/// empty for the first one. `None` if it lies outside of the folder.
///
/// ```
/// use glanz_shader::included_path;
///
/// assert_eq!(included_path("", "./light.glsl").as_deref(), Some("light.glsl"));
/// assert_eq!(included_path("noise/value.glsl", "../math/mix.glsl").as_deref(), Some("math/mix.glsl"));
/// assert_eq!(included_path("", "../light.glsl"), None);
/// ```
pub fn included_path(from: &str, path: &str) -> Option<String> {
    if path.starts_with('/') || path.contains(['\\', ':']) {
        return None;
    }
    let folder = from.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut parts: Vec<&str> = Vec::new();
    for part in folder.split('/').chain(path.split('/')) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()?),
            part => parts.push(part),
        }
    }
    (!parts.is_empty()).then(|| parts.join("/"))
}

type Done = Result<(), Complaint>;

impl<'a> Preprocessor<'a> {
    pub(super) fn new(sources: &'a mut Sources, include: Option<Include<'a>>) -> Self {
        let mut new = Self {
            sources,
            include,
            macros: HashMap::new(),
            conditions: Vec::new(),
            opened: Vec::new(),
            version: Version::default(),
            out: Vec::new(),
            steps: 0,
            uses_macros: false,
            bytes: 0,
            within: Vec::new(),
            once: HashSet::new(),
        };
        new.define("GL_FRAGMENT_PRECISION_HIGH", "1");
        new
    }

    /// `#define name text`.
    pub(super) fn define(&mut self, name: &str, text: &str) {
        let file = self.sources.add("defines", text.to_owned());
        let body = tokens(text, file, 0);
        self.macros.insert(name.into(), Macro { parameters: None, body });
    }

    /// A text that stands in front.
    pub(super) fn before(&mut self, file: u32) -> Done {
        let length = self.sources.text(file).len();
        self.file(file, 0, length)
    }

    /// The tokens after all directives.
    pub(super) fn run(
        mut self,
        file: u32,
        base: usize,
        length: usize,
    ) -> Result<(Vec<Token>, Version), Complaint> {
        self.file(file, base, length)?;
        Ok((self.out, self.version))
    }

    fn file(&mut self, file: u32, base: usize, length: usize) -> Done {
        let text = self.sources.text(file).get(base..base + length).unwrap_or("").to_owned();
        self.bytes += text.len();
        if self.bytes > MOST_BYTES {
            return Err(Complaint::whole("the text with what it includes is longer than 4 MiB"));
        }
        let all = tokens(&text, file, base);
        let outer = self.conditions.len();
        let mut at = 0;
        while at < all.len() {
            let directive = all[at].first && all[at].is("#");
            let end = all[at + 1..].iter().position(|t| t.first && (directive || t.is("#")));
            let end = end.map_or(all.len(), |n| at + 1 + n);
            if directive {
                self.directive(&all[at], &all[at + 1..end])?;
            } else if self.active() {
                let expanded = self.expand(all[at..end].to_vec(), 0)?;
                self.out.extend(expanded);
                if self.out.len() > MOST_TOKENS {
                    return Err(self.too_long(all[at].origin));
                }
            }
            at = end;
        }
        if self.conditions.len() > outer {
            let origin = self.opened.last().copied().unwrap_or_default();
            return Err(Complaint::at("this #if has no #endif", origin));
        }
        Ok(())
    }

    fn active(&self) -> bool {
        self.conditions.iter().all(|c| c.0)
    }

    fn directive(&mut self, hash: &Token, rest: &[Token]) -> Done {
        let Some((name, rest)) = rest.split_first() else { return Ok(()) };
        match &*name.text {
            "if" | "ifdef" | "ifndef" => {
                let around = self.active();
                let holds = around && self.holds(name, rest)?;
                // Where nothing around is active, no branch ever is.
                self.conditions.push((holds, holds || !around, false));
                self.opened.push(name.origin);
                Ok(())
            }
            "elif" | "else" => self.otherwise(name, rest),
            "endif" => {
                let popped = self.conditions.pop();
                self.opened.pop();
                popped.map(|_| ()).ok_or_else(|| Complaint::at("this #endif has no #if", name.origin))
            }
            _ if !self.active() => Ok(()),
            "define" => self.definition(name, rest),
            "undef" => {
                rest.first().map(|t| self.macros.remove(&t.text));
                Ok(())
            }
            "include" => self.inclusion(name, rest),
            "version" => self.read_version(name, rest),
            "line" => self.line(hash, name, rest),
            "error" => {
                let words: Vec<&str> = rest.iter().map(|t| &*t.text).collect();
                Err(Complaint::at(format!("#error {}", words.join(" ")), name.origin))
            }
            "pragma" => {
                self.pragma(rest);
                Ok(())
            }
            "extension" => Ok(()),
            other => Err(Complaint::at(format!("'#{other}' is no directive of GLSL"), name.origin)),
        }
    }

    fn holds(&mut self, name: &Token, rest: &[Token]) -> Result<bool, Complaint> {
        if name.is("if") {
            return self.condition(name, rest);
        }
        let Some(what) = rest.first().filter(|t| t.is_identifier()) else {
            return Err(Complaint::at(format!("#{} wants the name of a macro", name.text), name.origin));
        };
        Ok(self.is_defined(&what.text) == name.is("ifdef"))
    }

    fn otherwise(&mut self, name: &Token, rest: &[Token]) -> Done {
        let Some((_, taken, ended)) = self.conditions.pop() else {
            return Err(Complaint::at(format!("this #{} has no #if", name.text), name.origin));
        };
        if ended {
            return Err(Complaint::at(format!("this #{} stands after #else", name.text), name.origin));
        }
        let is_else = name.is("else");
        let holds = !taken && (is_else || self.condition(name, rest)?);
        self.conditions.push((holds, taken || holds, is_else));
        Ok(())
    }

    fn is_defined(&self, name: &str) -> bool {
        self.macros.contains_key(name)
            || matches!(name, "__LINE__" | "__FILE__" | "__VERSION__")
            || name == "GL_ES" && self.version.es
    }

    fn inclusion(&mut self, name: &Token, rest: &[Token]) -> Done {
        let between = |inside: &[Token]| inside.iter().map(|t| &*t.text).collect::<String>();
        let path = match rest {
            [text, ..] if text.kind == Kind::Text => text.text.to_string(),
            [open, inside @ .., close] if open.is("<") && close.is(">") => between(inside),
            [open, inside @ .., close] if open.is("'") && close.is("'") => between(inside),
            _ => return Err(Complaint::at("#include wants a file in quotation marks", name.origin)),
        };
        if self.within.len() >= MOST_INCLUDES {
            return Err(Complaint::at(
                format!("more than {MOST_INCLUDES} includes inside each other"),
                name.origin,
            ));
        }
        let Some((path, text)) = self.included(&path, name) else {
            return Err(Complaint::at(format!("the file '{path}' is not there to be included"), name.origin));
        };
        if self.once.contains(&path) {
            return Ok(());
        }
        let length = text.len();
        let file = self.sources.add(&path, text);
        self.within.push(path);
        self.file(file, 0, length)?;
        self.within.pop();
        Ok(())
    }

    /// Path and text of a file that is included: looked for from the file that includes it, then from the first one.
    fn included(&self, path: &str, name: &Token) -> Option<(String, String)> {
        let include = self.include?;
        let from = self.sources.place(name.origin).file;
        let within = self.within.last().map_or("", String::as_str);
        let paths = [included_path(within, path), included_path("", path)];
        paths.into_iter().flatten().find_map(|path| {
            let text = include(&path, &from)?;
            Some((path, text))
        })
    }

    /// `#pragma once`: the file is included no more.
    fn pragma(&mut self, rest: &[Token]) {
        if let ([word, ..], Some(path)) = (rest, self.within.last())
            && word.is("once")
        {
            self.once.insert(path.clone());
        }
    }

    fn read_version(&mut self, name: &Token, rest: &[Token]) -> Done {
        let number: u32 = rest.first().and_then(|t| t.text.parse().ok()).unwrap_or(0);
        if !VERSIONS.contains(&number) {
            return Err(Complaint::at("this is no version of GLSL: 110 to 460, 100, 300 es", name.origin));
        }
        let es = number == 100 || rest.get(1).is_some_and(|t| t.is("es"));
        self.version = Version { number, es };
        Ok(())
    }

    fn line(&mut self, hash: &Token, name: &Token, rest: &[Token]) -> Done {
        let numbers = self.expand(rest.to_vec(), 0)?;
        let Some(line) = numbers.first().and_then(|t| t.text.parse().ok()) else {
            return Err(Complaint::at("#line wants a number", name.origin));
        };
        let end = rest.last().map_or(name.origin.end, |t| t.origin.end);
        self.sources.mark(hash.origin.file, end, line);
        Ok(())
    }

    fn line_of(&self, origin: Origin) -> u32 {
        self.sources.place(origin).line
    }
}
