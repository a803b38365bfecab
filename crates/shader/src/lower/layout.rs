//! What a program takes and gives, and the whole program.

use naga::{
    AddressSpace, Binding, BuiltIn, FunctionArgument, Handle, ImageClass, ImageDimension, Span, Type,
    TypeInner,
};

use super::{Item, Lowered, Lowering, MOST_SCALARS, Refused, Reg};
use crate::{Stage, ValueType};

/// What a private global of a GLSL text stands for. The name is the one by which the host knows it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    Uniform(String),
    Input(String),
    Output(String),
}

/// A scalar, vector or matrix, by itself or in a struct or array.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Leaf {
    /// As the source would name it: `lights[2].position`.
    pub(crate) path: String,
    pub(crate) ty: ValueType,
    /// Scalars before it.
    pub(crate) offset: usize,
}

/// An input or output: registers side by side if it is an input.
#[derive(Clone, Debug)]
pub(crate) struct Slot<R> {
    pub(crate) name: String,
    pub(crate) builtin: bool,
    pub(crate) ty: ValueType,
    pub(crate) location: Option<u32>,
    pub(crate) registers: Vec<R>,
}

impl<R> Slot<R> {
    /// The same with other numbers of registers.
    pub(super) fn with_registers<T>(self, f: impl Fn(R) -> T) -> Slot<T> {
        let Self { name, builtin, ty, location, registers } = self;
        Slot { name, builtin, ty, location, registers: registers.into_iter().map(f).collect() }
    }
}

/// A texture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextureInfo {
    /// Its name in the source.
    pub name: String,
    /// `1d`, `2d`, `3d` or `cube`.
    pub dimension: &'static str,
    /// Whether it has layers.
    pub layered: bool,
    /// Whether it is compared with a depth.
    pub compared: bool,
}

/// What a program takes and gives.
#[derive(Clone, Debug, Default)]
pub(crate) struct Layout {
    /// With the word where it lies as `offset`.
    pub(crate) uniforms: Vec<Leaf>,
    /// All words of the uniforms as the source initialises them, and those of long constant arrays.
    pub(crate) defaults: Vec<u32>,
    pub(crate) inputs: Vec<Slot<u16>>,
    pub(crate) outputs: Vec<Slot<u16>>,
    pub(crate) textures: Vec<TextureInfo>,
}

type Slots = Vec<Slot<Reg>>;

impl Lowering<'_> {
    pub(super) fn program(mut self) -> Result<Lowered, Refused> {
        let module = self.module;
        self.discarded = self.no_lanes();
        // Functions stand behind those that they call.
        for (handle, function) in module.functions.iter() {
            if self.discards(&function.body) {
                self.discarding.insert(handle);
            }
        }
        let (mut inputs, mut outputs) = (Slots::new(), Slots::new());
        let mut written = Vec::new();
        for (handle, global) in module.global_variables.iter() {
            let span = module.global_variables.get_span(handle);
            let item = self.global(global, span, &mut inputs, &mut written)?;
            self.globals.insert(handle, item);
        }
        // A text without an entry point stands for its last function.
        let (function, info) = match (&module.entry_points[..], module.functions.iter().last()) {
            ([entry, ..], _) => (&entry.function, self.info.get_entry_point(0)),
            ([], Some((handle, function))) => (function, &self.info[handle]),
            ([], None) => return Err(Refused::new("there is no function in this text", Span::UNDEFINED)),
        };
        let mut arguments = Vec::new();
        for argument in &function.arguments {
            arguments.push(Item::Value(self.argument(argument, &mut inputs)?));
        }
        let result = self.inline(function, info, arguments)?;
        if let (Some(regs), Some(result)) = (result, &function.result) {
            self.ports(result.ty, result.binding.as_ref(), Some("result"), &regs, &mut outputs);
        }
        for (var, name, ty) in written {
            let regs = self.state.variables[var].registers.clone();
            self.leaf_ports(&name, ty, &regs, &mut outputs);
        }
        let discarded = self.state.variables[self.discarded].registers[0];
        self.allocate(inputs, outputs, discarded)
    }

    fn global(
        &mut self,
        global: &naga::GlobalVariable,
        span: Span,
        inputs: &mut Slots,
        written: &mut Vec<(usize, String, Handle<Type>)>,
    ) -> Result<Item, Refused> {
        let name = global.name.as_deref().unwrap_or("");
        match global.space {
            AddressSpace::Private => match (self.roles)(name) {
                Some(Purpose::Uniform(name)) => self.uniform(&name, global, span),
                Some(Purpose::Input(path)) => {
                    let n = self.register_size(global.ty, span)?;
                    let regs = self.fresh(n);
                    self.leaf_ports(&path, global.ty, &regs, inputs);
                    let var = self.variable(name, regs);
                    self.state.variables[var].constant = Some("an input");
                    Ok(Item::Place { var, offset: 0, dynamic: None })
                }
                role => {
                    let n = self.register_size(global.ty, span)?;
                    let regs = global.init.map(|init| self.constant(init)).transpose()?;
                    let regs = regs.unwrap_or_else(|| self.zeros(n));
                    let var = self.variable(name, regs);
                    if let Some(Purpose::Output(path)) = role {
                        written.push((var, path, global.ty));
                    }
                    Ok(Item::Place { var, offset: 0, dynamic: None })
                }
            },
            AddressSpace::Uniform | AddressSpace::Storage { .. } | AddressSpace::Immediate => {
                self.uniform(name, global, span)
            }
            AddressSpace::Handle => self.handle(name, &self.module.types[global.ty].inner.clone(), span),
            AddressSpace::WorkGroup
            | AddressSpace::TaskPayload
            | AddressSpace::RayPayload
            | AddressSpace::IncomingRayPayload
            | AddressSpace::Function => {
                Err(Refused::new("memory that workgroups or rays share is not there", span))
            }
        }
    }

    fn handle(&mut self, name: &str, inner: &TypeInner, span: Span) -> Result<Item, Refused> {
        match *inner {
            TypeInner::Sampler { .. } => Ok(Item::Nothing),
            TypeInner::Image { dim, arrayed, class } => {
                let compared = match class {
                    ImageClass::Depth { .. } => true,
                    ImageClass::Sampled { .. } => false,
                    ImageClass::Storage { .. } | ImageClass::External => {
                        return Err(Refused::new("images that are written are not there", span));
                    }
                };
                let dimension = match dim {
                    ImageDimension::D1 => "1d",
                    ImageDimension::D2 => "2d",
                    ImageDimension::D3 => "3d",
                    ImageDimension::Cube => "cube",
                };
                let name = name.strip_suffix(crate::intake::TEXTURE_SUFFIX).unwrap_or(name);
                let name = match (self.roles)(name) {
                    Some(Purpose::Uniform(path)) => path,
                    _ => name.to_owned(),
                };
                self.layout.textures.push(TextureInfo { name, dimension, layered: arrayed, compared });
                Ok(Item::Texture(self.layout.textures.len() - 1))
            }
            _ => Err(Refused::new("arrays of textures are not there", span)),
        }
    }

    fn uniform(&mut self, name: &str, global: &naga::GlobalVariable, span: Span) -> Result<Item, Refused> {
        let n = self.uniform_size(global.ty, span)?;
        let word = self.layout.defaults.len();
        let mut words = vec![0; n];
        if let Some(init) = global.init {
            let regs = self.constant(init)?;
            for (word, r) in words.iter_mut().zip(regs) {
                *word = self.state.prologue.iter().find(|op| op.d == r).map_or(0, |op| op.imm);
            }
        }
        self.layout.defaults.extend(words);
        self.check_uniforms(span)?;
        let mut leaves = Vec::new();
        self.leaves(name, global.ty, word, &mut leaves);
        self.layout.uniforms.extend(leaves);
        Ok(Item::Uniform { word, dynamic: None })
    }

    pub(super) fn check_uniforms(&self, span: Span) -> Result<(), Refused> {
        match self.layout.defaults.len() > 1 << 16 {
            true => Err(Refused::new("there are too many uniforms", span)),
            false => Ok(()),
        }
    }

    /// The scalars, vectors and matrices in a type.
    fn leaves(&self, path: &str, ty: Handle<Type>, offset: usize, out: &mut Vec<Leaf>) {
        match &self.module.types[ty].inner {
            TypeInner::Struct { members, .. } => {
                let mut at = offset;
                for member in members {
                    let name = member.name.as_deref().unwrap_or("");
                    let dot = if path.is_empty() || name.is_empty() { "" } else { "." };
                    self.leaves(&format!("{path}{dot}{name}"), member.ty, at, out);
                    at += self.size_of(member.ty);
                }
            }
            TypeInner::Array { base, size, .. } => {
                for i in 0..self.count(*size) {
                    self.leaves(&format!("{path}[{i}]"), *base, offset + i * self.size_of(*base), out);
                }
            }
            inner => out.push(Leaf { path: path.to_owned(), ty: self.value_type(inner), offset }),
        }
    }

    fn leaf_ports(&self, path: &str, ty: Handle<Type>, regs: &[Reg], out: &mut Slots) {
        let mut leaves = Vec::new();
        self.leaves(path, ty, 0, &mut leaves);
        for leaf in leaves {
            let registers = regs[leaf.offset..leaf.offset + leaf.ty.scalars()].to_vec();
            out.push(Slot { name: leaf.path, builtin: false, ty: leaf.ty, location: None, registers });
        }
    }

    fn argument(&mut self, argument: &FunctionArgument, inputs: &mut Slots) -> Result<Vec<Reg>, Refused> {
        let n = self.register_size(argument.ty, Span::UNDEFINED)?.min(MOST_SCALARS);
        let regs = self.fresh(n);
        self.ports(argument.ty, argument.binding.as_ref(), argument.name.as_deref(), &regs, inputs);
        Ok(regs)
    }

    /// The ports of an argument or result with its bindings.
    fn ports(
        &self,
        ty: Handle<Type>,
        binding: Option<&Binding>,
        name: Option<&str>,
        regs: &[Reg],
        out: &mut Slots,
    ) {
        if let (None, TypeInner::Struct { members, .. }) = (binding, &self.module.types[ty].inner) {
            let mut at = 0;
            for member in members {
                let n = self.size_of(member.ty);
                let part = regs.get(at..at + n).unwrap_or_default();
                self.ports(member.ty, member.binding.as_ref(), member.name.as_deref(), part, out);
                at += n;
            }
            return;
        }
        let (name, builtin) = match binding {
            Some(Binding::BuiltIn(builtin)) => (builtin_name(*builtin, self.stage).to_owned(), true),
            Some(Binding::Location { location, .. }) => {
                (name.map_or_else(|| format!("location{location}"), str::to_owned), false)
            }
            None => (name.unwrap_or("").to_owned(), false),
        };
        let location = match binding {
            Some(Binding::Location { location, .. }) => Some(*location),
            _ => None,
        };
        let ty = self.value_type(&self.module.types[ty].inner);
        out.push(Slot { name, builtin, ty, location, registers: regs.to_vec() });
    }
}

/// GLSL's names of what the pipeline gives and takes, for WGSL, too. The position that a fragment shader takes is that on
/// the screen.
fn builtin_name(builtin: BuiltIn, stage: Stage) -> &'static str {
    match builtin {
        BuiltIn::Position { .. } if stage == Stage::Fragment => "gl_FragCoord",
        BuiltIn::Position { .. } => "gl_Position",
        BuiltIn::FragDepth => "gl_FragDepth",
        BuiltIn::FrontFacing => "gl_FrontFacing",
        BuiltIn::PointCoord => "gl_PointCoord",
        BuiltIn::PointSize => "gl_PointSize",
        BuiltIn::VertexIndex => "gl_VertexID",
        BuiltIn::InstanceIndex => "gl_InstanceID",
        BuiltIn::PrimitiveIndex => "gl_PrimitiveID",
        BuiltIn::SampleIndex => "gl_SampleID",
        BuiltIn::SampleMask => "gl_SampleMask",
        BuiltIn::ClipDistances => "gl_ClipDistance",
        BuiltIn::BaseVertex => "gl_BaseVertex",
        BuiltIn::BaseInstance => "gl_BaseInstance",
        BuiltIn::DrawIndex => "gl_DrawID",
        _ => "gl_other",
    }
}
