//! From a text to a program.

use std::sync::Arc;

use naga::Span;

use crate::gpu::Kept;
use crate::intake::{self, Complaint, Front, Sources};
use crate::interface::{Interface, Port, Uniform, UniformValues};
use crate::lower::{self, Lowered, Slot};
use crate::names::{attribute_role, uniform_role};
use crate::{Language, Place, ShaderError, Specialized, Stage, Warning, check};

/// Stack of the thread that compiles: the front end's grows with the nesting of the text, which is limited to what this
/// holds.
#[cfg(not(target_arch = "wasm32"))]
const STACK: usize = 16 << 20;

/// A text that is to become a [`Program`].
///
/// ```
/// use glanz_shader::Shader;
///
/// let error = Shader::fragment("#version 330\nout vec4 color;\nvoid main() {\n  color = vec4(1.0)\n}")
///     .named("red.frag")
///     .compile()
///     .unwrap_err();
/// assert_eq!(error.to_string(), "red.frag:4:19: ';' is expected before '}'");
/// ```
#[derive(Clone)]
pub struct Shader<'a> {
    name: String,
    text: String,
    stage: Stage,
    language: Option<Language>,
    defines: Vec<(String, String)>,
    common: Option<(String, String)>,
    include: Option<intake::Include<'a>>,
    is_toy: bool,
    trace: bool,
}

impl<'a> Shader<'a> {
    /// A text of a stage.
    pub fn new(stage: Stage, text: impl Into<String>) -> Self {
        let name = format!("{} shader", stage.name());
        let (language, common, include) = (None, None, None);
        Self {
            name,
            text: text.into(),
            stage,
            language,
            defines: vec![],
            common,
            include,
            is_toy: false,
            trace: false,
        }
    }

    /// A fragment shader.
    pub fn fragment(text: impl Into<String>) -> Self {
        Self::new(Stage::Fragment, text)
    }

    /// A vertex shader.
    pub fn vertex(text: impl Into<String>) -> Self {
        Self::new(Stage::Vertex, text)
    }

    /// Its file's name, which errors show and which tells the language (`.wgsl`).
    #[must_use]
    pub fn named(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// The language, whatever the name says.
    #[must_use]
    pub fn language(mut self, language: Language) -> Self {
        self.language = Some(language);
        self
    }

    /// `#define name text` in front of a GLSL text.
    #[must_use]
    pub fn define(mut self, name: impl Into<String>, text: impl Into<String>) -> Self {
        self.defines.push((name.into(), text.into()));
        self
    }

    /// A GLSL text of this name in front, as Shadertoy's tab "Common" is.
    #[must_use]
    pub fn common(mut self, name: impl Into<String>, text: impl Into<String>) -> Self {
        self.common = Some((name.into(), text.into()));
        self
    }

    /// Where `#include` takes its files from: called with the path from the folder of this text
    /// ([`included_path`](crate::included_path)) and the name of the file that includes it.
    #[must_use]
    pub fn include(mut self, resolve: &'a (dyn Fn(&str, &str) -> Option<String> + Sync)) -> Self {
        self.include = Some(resolve);
        self
    }

    /// Shadertoy's names (`iTime`, `iResolution`, `iChannel0`…) are there, even if the text has a `main` of its own and
    /// does not declare them.
    #[must_use]
    pub fn toy(mut self) -> Self {
        self.is_toy = true;
        self
    }

    /// Compiles for a [`Trace`](crate::Trace): every named value is told of. The values are the same, the speed is not.
    #[must_use]
    pub fn traced(mut self) -> Self {
        self.trace = true;
        self
    }

    pub(crate) fn is_traced(&self) -> bool {
        self.trace
    }

    /// Compiles the text.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn compile(&self) -> Result<Program, ShaderError> {
        std::thread::scope(|scope| {
            let builder = std::thread::Builder::new().name("shader compiler".to_owned()).stack_size(STACK);
            let Ok(thread) = builder.spawn_scoped(scope, || self.compile_here()) else {
                return Err(ShaderError::Broken);
            };
            // A panic of the front end ends here.
            thread.join().unwrap_or(Err(ShaderError::Broken))
        })
    }

    /// Compiles the text. There are no threads here, so a panic of the front end is one of the program.
    #[cfg(target_arch = "wasm32")]
    pub fn compile(&self) -> Result<Program, ShaderError> {
        self.compile_here()
    }

    fn compile_here(&self) -> Result<Program, ShaderError> {
        let mut sources = Sources::default();
        let file = sources.add(&self.name, self.text.clone());
        let language = self.language.unwrap_or_else(|| Language::of_file(&self.name));
        let common = self.common.as_ref().map(|(name, text)| sources.add(name, text.clone()));
        let texts = intake::Texts {
            file,
            common,
            defines: &self.defines,
            include: self.include,
            is_toy: self.is_toy,
        };
        let front = intake::read(&mut sources, &texts, self.stage, language);
        let front = front.map_err(|complaint| complaint.into_error(&sources))?;
        let purposes = |name: &str| front.given.roles.get(name).cloned();
        let lowered = lower::lower(&front.module, &front.info, self.stage, &purposes, self.trace);
        let lowered = lowered.map_err(|refused| {
            let origin = intake::origin_of(refused.span, &front.map);
            let complaint = Complaint { message: refused.message, origin, hints: vec![], unsupported: true };
            complaint.into_error(&sources)
        })?;
        Ok(Program::new(self, &sources, front, lowered))
    }
}

/// A compiled shader.
#[derive(Clone, Debug)]
pub struct Program {
    stage: Stage,
    interface: Interface,
    warnings: Vec<Warning>,
    pub(crate) lowered: Lowered,
    pub(crate) kept: Kept,
    /// Of each event of the trace.
    pub(crate) event_places: Vec<Option<Place>>,
    /// Where loops are.
    pub(crate) loop_places: Arc<[(Span, Place)]>,
}

impl Program {
    fn new(shader: &Shader<'_>, sources: &Sources, front: Front, lowered: Lowered) -> Self {
        let place = |span| intake::origin_of(span, &front.map).map(|origin| sources.place(origin));
        let event_places = lowered.placed.events.iter().map(|event| place(event.span)).collect();
        let loop_places =
            lowered.placed.loops.values().filter_map(|span| Some((*span, place(*span)?))).collect();
        let interface = interface(shader.stage, sources, &front, &lowered);
        let warnings = check::warnings(&front, shader.stage, sources);
        let kept = Kept { module: Arc::new(front.module), roles: Arc::new(front.given.roles) };
        Self { stage: shader.stage, interface, warnings, lowered, kept, event_places, loop_places }
    }

    /// Its stage.
    pub fn stage(&self) -> Stage {
        self.stage
    }

    /// What it takes and gives.
    pub fn interface(&self) -> &Interface {
        &self.interface
    }

    /// The uniforms with the values that the source gives them, 0 where it gives none.
    pub fn uniforms(&self) -> UniformValues {
        UniformValues::new(&self.interface.uniforms, &self.lowered.layout.defaults)
    }

    /// The program with these values of its uniforms, for a draw.
    pub fn specialize(&self, uniforms: &UniformValues) -> Specialized {
        Specialized::new(self, uniforms)
    }

    /// What is right but probably not meant.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// How many instructions run for each fragment (loops once) and once per draw, and how many registers they take.
    pub fn size(&self) -> (usize, usize, usize) {
        (self.lowered.placed.ops.len(), self.lowered.placed.prologue.len(), self.lowered.placed.registers)
    }

    /// Whether it looks into the texture of this number, or asks for its size; others are declared only.
    pub fn looks_into(&self, texture: usize) -> bool {
        self.lowered.placed.looks.iter().any(|look| look.texture == texture)
    }

    /// Whether fragments may be discarded.
    pub fn discards(&self) -> bool {
        self.lowered.placed.discarded.is_some()
    }
}

/// The variable to which a path belongs: `lights` of `lights[2].position`.
fn root(path: &str) -> &str {
    path.split(['.', '[']).next().unwrap_or(path)
}

fn interface(stage: Stage, sources: &Sources, front: &Front, lowered: &Lowered) -> Interface {
    let port = |slot: &Slot<u16>, is_input: bool| {
        let info = front.given.ports.get(&slot.name).or_else(|| front.given.ports.get(root(&slot.name)));
        let info = info.cloned().unwrap_or_default();
        let attribute = is_input && stage == Stage::Vertex && !slot.builtin;
        Port {
            name: slot.name.clone(),
            builtin: slot.builtin,
            ty: slot.ty,
            role: if attribute { attribute_role(&slot.name, slot.ty) } else { None },
            location: info.location.or(slot.location),
            interpolation: info.interpolation,
            place: front.given.declared.get(root(&slot.name)).map(|origin| sources.place(*origin)),
        }
    };
    let uniform = |leaf: &lower::Leaf| Uniform {
        name: leaf.path.clone(),
        ty: leaf.ty,
        role: uniform_role(&leaf.path, leaf.ty),
        range: front
            .ranges
            .iter()
            .find(|range| range.name == leaf.path)
            .map(|range| (range.least, range.most)),
        place: front.given.declared.get(root(&leaf.path)).map(|origin| sources.place(*origin)),
        word: leaf.offset,
    };
    Interface {
        uniforms: lowered.layout.uniforms.iter().map(uniform).collect(),
        textures: lowered.layout.textures.clone(),
        inputs: lowered.layout.inputs.iter().map(|slot| port(slot, true)).collect(),
        outputs: lowered.layout.outputs.iter().map(|slot| port(slot, false)).collect(),
    }
}
