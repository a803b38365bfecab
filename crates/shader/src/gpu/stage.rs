//! A stage with an entry point of ours around its own.

use naga::{
    AddressSpace, BinaryOperator, Binding, BuiltIn, EntryPoint, Expression, Function, FunctionResult,
    GlobalVariable, Handle, Module, ResourceBinding, Scalar, ShaderStage, Statement, Type, TypeInner,
};

use super::build::Build;
use super::ports::{Columns, location};
use super::{ENTRY, GpuAttribute, GpuBinding, refused};
use crate::intake::{SAMPLER_SUFFIX, TEXTURE_SUFFIX};
use crate::lower::{Purpose, is_stand_in};
use crate::{Interpolation, Pair, Port, Program, ShaderError, Stage, ValueType};

type Value = Handle<Expression>;

/// The module of a stage, and what its host must know.
pub(super) struct Wrapped {
    pub(super) module: Module,
    pub(super) rows: usize,
    pub(super) attributes: Vec<GpuAttribute>,
    pub(super) bindings: Vec<GpuBinding>,
}

/// The user's entry point as a function.
struct Inner {
    function: Handle<Function>,
    arguments: Vec<(Handle<Type>, Option<Binding>)>,
    result: Option<(Handle<Type>, Option<Binding>)>,
}

/// Member names of the output, values, types, bindings.
type Members = Vec<(String, Value, Handle<Type>, Binding)>;

struct Wrapper<'a> {
    build: Build,
    pair: &'a Pair,
    program: &'a Program,
    inner: Inner,
    block: Value,
    /// The next port of the inputs.
    input: usize,
    attributes: Vec<GpuAttribute>,
    bindings: Vec<GpuBinding>,
    /// Variables that were blocks of the user's own.
    blocks: Vec<Handle<GlobalVariable>>,
}

impl Wrapped {
    pub(super) fn vertex(pair: &Pair) -> Result<Self, ShaderError> {
        let mut wrapper = Wrapper::new(pair, &pair.vertex)?;
        let outputs = wrapper.outputs()?;
        let mut members = vec![wrapper.position(&outputs)?];
        let mut at = 0;
        for varying in &pair.varyings {
            let (value, ty) = outputs[varying.output];
            for (value, ty, scalar) in wrapper.build.carried(value, ty)? {
                let binding = location(at, scalar, varying.interpolation);
                members.push((format!("varying{at}"), value, ty, binding));
                at += 1;
            }
        }
        Ok(wrapper.finish(members))
    }

    pub(super) fn fragment(pair: &Pair, color: usize) -> Result<Self, ShaderError> {
        let mut wrapper = Wrapper::new(pair, &pair.fragment)?;
        let outputs = wrapper.outputs()?;
        let (value, ty) = *outputs.get(color).ok_or_else(|| refused("there is no such colour"))?;
        let four = wrapper.build.color(value, ty)?;
        let vector = TypeInner::Vector { size: naga::VectorSize::Quad, scalar: Scalar::F32 };
        let ty = wrapper.build.ty(vector);
        let mut members: Members =
            vec![("color".to_owned(), four, ty, location(0, Scalar::F32, Interpolation::Perspective))];
        let ports = &pair.fragment.interface().outputs;
        if let Some(depth) = ports.iter().position(|port| port.builtin && port.name == "gl_FragDepth") {
            let (value, ty) = outputs[depth];
            members.push(("depth".to_owned(), value, ty, Binding::BuiltIn(BuiltIn::FragDepth)));
        }
        Ok(wrapper.finish(members))
    }
}

impl<'a> Wrapper<'a> {
    fn new(pair: &'a Pair, program: &'a Program) -> Result<Self, ShaderError> {
        let mut module = (*program.kept.module).clone();
        if module.functions.iter().any(|(_, own)| own.name.as_deref().is_some_and(is_stand_in)) {
            return Err(refused("textureGather is not there on the GPU"));
        }
        let inner = inner(&mut module)?;
        let group = u32::from(program.stage() == Stage::Fragment);
        let (bindings, blocks) = rebind(&mut module, program, group)?;
        let mut build = Build::new(module);
        let rows = 1 + program.lowered.layout.defaults.len().div_ceil(4);
        let block = build.block(group, rows as u32);
        Ok(Self { build, pair, program, inner, block, input: 0, attributes: vec![], bindings, blocks })
    }

    /// Fills the variables that the host and the stage before fill; gives those that are outputs.
    fn fill(&mut self) -> Result<Vec<Handle<GlobalVariable>>, ShaderError> {
        let globals: Vec<_> = self.build.module.global_variables.iter().map(|(handle, _)| handle).collect();
        let (mut word, mut outputs) = (4, Vec::new());
        for global in globals {
            let variable = self.build.module.global_variables[global].clone();
            let role = self.program.kept.roles.get(variable.name.as_deref().unwrap_or(""));
            let value = match (variable.space, role) {
                (AddressSpace::Private, Some(Purpose::Uniform(_))) => self.uniform(variable.ty, &mut word)?,
                (AddressSpace::Private, None) if self.blocks.contains(&global) => {
                    self.uniform(variable.ty, &mut word)?
                }
                (AddressSpace::Private, Some(Purpose::Input(_))) => self.inputs(variable.ty)?,
                (AddressSpace::Private, Some(Purpose::Output(_))) => {
                    outputs.push(global);
                    continue;
                }
                _ => continue,
            };
            let pointer = self.build.global(global);
            self.build.statement(Statement::Store { pointer, value });
        }
        Ok(outputs)
    }

    /// Gives the user's entry point what it takes and runs it: the values of the outputs, by number.
    fn outputs(&mut self) -> Result<Vec<(Value, Handle<Type>)>, ShaderError> {
        let written = self.fill()?;
        let mut arguments = Vec::new();
        for (ty, binding) in self.inner.arguments.clone() {
            arguments.push(self.argument(ty, binding.is_some())?);
        }
        let result = self.build.call(self.inner.function, arguments);
        let mut all = Vec::new();
        if let Some((value, (ty, _))) = result.zip(self.inner.result.clone()) {
            self.build.leaves(value, ty, &mut all)?;
        }
        for global in written {
            let ty = self.build.module.global_variables[global].ty;
            let pointer = self.build.global(global);
            let value = self.build.load(pointer);
            self.build.leaves(value, ty, &mut all)?;
        }
        Ok(all)
    }

    fn uniform(&mut self, ty: Handle<Type>, word: &mut usize) -> Result<Value, ShaderError> {
        let block = self.block;
        self.build.out_of(ty, &mut |build, ty| {
            let first = *word;
            *word += Columns::of(build, ty)?.scalars();
            build.of_words(block, first, ty)
        })
    }

    /// A value of the next inputs.
    fn inputs(&mut self, ty: Handle<Type>) -> Result<Value, ShaderError> {
        let parts: Vec<_> = match &self.build.module.types[ty].inner {
            TypeInner::Struct { members, .. } => members.iter().map(|member| member.ty).collect(),
            TypeInner::Array { base, size: naga::ArraySize::Constant(size), .. } => {
                vec![*base; size.get() as usize]
            }
            _ => return self.port(ty),
        };
        let mut components = Vec::with_capacity(parts.len());
        for part in parts {
            components.push(self.inputs(part)?);
        }
        Ok(self.build.compose(ty, components))
    }

    /// An argument: one port, or a struct of them.
    fn argument(&mut self, ty: Handle<Type>, is_port: bool) -> Result<Value, ShaderError> {
        if is_port { self.port(ty) } else { self.inputs(ty) }
    }

    /// The next input.
    fn port(&mut self, ty: Handle<Type>) -> Result<Value, ShaderError> {
        let number = self.input;
        self.input += 1;
        let Some(port) = self.program.interface().inputs.get(number) else {
            return Err(refused("an input has no place"));
        };
        match self.program.stage() {
            Stage::Vertex if !port.builtin || port.name == "gl_VertexID" => self.attribute(number, port, ty),
            Stage::Vertex => Ok(self.build.zero(ty)),
            Stage::Fragment if port.builtin => self.of_pipeline(port, ty),
            Stage::Fragment => self.varying(number, ty),
        }
    }

    fn attribute(&mut self, input: usize, port: &Port, ty: Handle<Type>) -> Result<Value, ShaderError> {
        let first = self.attributes.len() as u32;
        let scalar = match port.ty.scalar {
            crate::Scalar::Bool => crate::Scalar::Uint,
            other => other,
        };
        for column in 0..port.ty.columns {
            let (location, ty) = (first + column as u32, ValueType { columns: 1, scalar, ..port.ty });
            self.attributes.push(GpuAttribute { input, column, location, ty });
        }
        self.build.of_locations(first, ty, Interpolation::Perspective)
    }

    fn varying(&mut self, input: usize, ty: Handle<Type>) -> Result<Value, ShaderError> {
        let inputs = &self.pair.fragment.interface().inputs;
        let mut first = 0;
        for varying in &self.pair.varyings {
            if varying.input == input {
                return self.build.of_locations(first, ty, varying.interpolation);
            }
            first += inputs[varying.input].ty.columns as u32;
        }
        Ok(self.build.zero(ty))
    }

    fn of_pipeline(&mut self, port: &Port, ty: Handle<Type>) -> Result<Value, ShaderError> {
        match port.name.as_str() {
            "gl_FragCoord" => Ok(self.build.of_pipeline(BuiltIn::Position { invariant: false }, ty)),
            "gl_FrontFacing" => Ok(self.build.of_pipeline(BuiltIn::FrontFacing, ty)),
            "gl_PrimitiveID" => Err(refused("gl_PrimitiveID is not there on GPUs")),
            _ => Ok(self.build.zero(ty)),
        }
    }

    /// Where a vertex is, in WebGPU's clip space and upside down.
    fn position(
        &mut self,
        outputs: &[(Value, Handle<Type>)],
    ) -> Result<(String, Value, Handle<Type>, Binding), ShaderError> {
        let build = &mut self.build;
        let ty = build.ty(TypeInner::Vector { size: naga::VectorSize::Quad, scalar: Scalar::F32 });
        let ports = &self.program.interface().outputs;
        let own = ports.iter().position(|port| port.builtin && port.name == "gl_Position");
        let place = own.map_or_else(|| build.zero(ty), |own| outputs[own].0);
        let [x, y, z, w] = core::array::from_fn(|axis| build.member(place, axis));
        let [right, up] = [0, 1].map(|word| build.word(self.block, word, Scalar::F32));
        let [right, up] = [right, up].map(|shift| build.binary(BinaryOperator::Multiply, shift, w));
        let x = build.binary(BinaryOperator::Add, x, right);
        let y = build.binary(BinaryOperator::Add, y, up);
        let y = build.value(Expression::Unary { op: naga::UnaryOperator::Negate, expr: y });
        let (sum, half) = (build.binary(BinaryOperator::Add, z, w), build.number(0.5));
        let z = build.binary(BinaryOperator::Multiply, sum, half);
        let value = build.compose(ty, vec![x, y, z, w]);
        let binding = Binding::BuiltIn(BuiltIn::Position { invariant: false });
        Ok(("place".to_owned(), value, ty, binding))
    }

    fn finish(mut self, members: Members) -> Wrapped {
        let (ty, value) = self.build.output(members);
        let (mut module, mut function) = self.build.finish(Some(value));
        function.result = Some(FunctionResult { ty, binding: None });
        module.entry_points.push(EntryPoint {
            name: ENTRY.to_owned(),
            stage: match self.program.stage() {
                Stage::Vertex => ShaderStage::Vertex,
                Stage::Fragment => ShaderStage::Fragment,
            },
            early_depth_test: None,
            workgroup_size: [0; 3],
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
        let rows = 1 + self.program.lowered.layout.defaults.len().div_ceil(4);
        Wrapped { module, rows, attributes: self.attributes, bindings: self.bindings }
    }
}

/// The entry point, or the last function, as a function without bindings.
fn inner(module: &mut Module) -> Result<Inner, ShaderError> {
    let entry = module.entry_points.pop();
    module.entry_points.clear();
    let Some(entry) = entry else {
        let Some((function, own)) = module.functions.iter().last() else {
            return Err(refused("there is no function in this text"));
        };
        let arguments = own.arguments.iter().map(|argument| (argument.ty, None)).collect();
        return Ok(Inner {
            function,
            arguments,
            result: own.result.as_ref().map(|result| (result.ty, None)),
        });
    };
    let mut own = entry.function;
    own.name = Some("shader_main".to_owned());
    let arguments = own.arguments.iter_mut().map(|argument| (argument.ty, argument.binding.take())).collect();
    let result = own.result.as_mut().map(|result| (result.ty, result.binding.take()));
    let function = module.functions.append(own, naga::Span::UNDEFINED);
    Ok(Inner { function, arguments, result })
}

/// Whether the host fills a variable by a block.
fn is_block(space: AddressSpace) -> bool {
    matches!(space, AddressSpace::Uniform | AddressSpace::Storage { .. } | AddressSpace::Immediate)
}

/// Textures and samplers, with bindings of ours; and the blocks, now variables that our entry point fills.
type Bound = (Vec<GpuBinding>, Vec<Handle<GlobalVariable>>);

fn rebind(module: &mut Module, program: &Program, group: u32) -> Result<Bound, ShaderError> {
    let (mut all, mut blocks) = (Vec::<GpuBinding>::new(), Vec::new());
    // What the names of textures and of their samplers have in common.
    let mut stems = Vec::<String>::new();
    for (handle, global) in module.global_variables.iter_mut() {
        if is_block(global.space) {
            blocks.push(handle);
            (global.space, global.binding) = (AddressSpace::Private, None);
            continue;
        }
        if global.space != AddressSpace::Handle {
            continue;
        }
        let binding = 1 + all.len() as u32;
        global.binding = Some(ResourceBinding { group, binding });
        let inner = &module.types[global.ty].inner;
        let is_sampler = matches!(inner, TypeInner::Sampler { .. });
        let is_cube = matches!(inner, TypeInner::Image { dim: naga::ImageDimension::Cube, .. });
        let name = global.name.as_deref().unwrap_or("");
        let texture = match is_sampler {
            true => stems.iter().position(|stem| name.strip_suffix(SAMPLER_SUFFIX) == Some(stem)),
            false => {
                stems.push(name.strip_suffix(TEXTURE_SUFFIX).unwrap_or(name).to_owned());
                Some(stems.len() - 1)
            }
        };
        all.push(GpuBinding { binding, texture, is_sampler, is_cube });
    }
    debug_assert_eq!(stems.len(), program.interface().textures.len(), "they have the same order");
    let plain = |info: &crate::TextureInfo| {
        matches!(info.dimension, "2d" | "cube") && !info.layered && !info.compared
    };
    match program.interface().textures.iter().all(plain) {
        true => Ok((all, blocks)),
        false => Err(refused("textures other than plain pictures and cube maps are not there on the GPU")),
    }
}
