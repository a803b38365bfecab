//! A program as a pipeline of the device.

use glanz_render::prepare::PreparedProgram;
use glanz_render::view::program::ProgramPicture;
use glanz_shader::gpu::{ENTRY, GpuAttribute, GpuBinding, GpuPair, GpuStage};
use glanz_shader::{Scalar, Stage};
use wgpu::ShaderStages;

use crate::GpuError;
use crate::device::Device;
use crate::textures::{Textures, dimension};

/// Depths of pixels.
pub(crate) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Stack of the thread that compiles: the driver's front end grows with the nesting of the text.
const STACK: usize = 16 << 20;

/// A program, ready to be given values.
pub(crate) struct Pipeline {
    pub(crate) pair: GpuPair,
    pub(crate) pipeline: wgpu::RenderPipeline,
    groups: [wgpu::BindGroupLayout; 2],
}

impl Pipeline {
    pub(crate) fn new(device: &Device, program: &PreparedProgram) -> Result<Self, GpuError> {
        let color = program.color.ok_or_else(|| GpuError::unsupported("the program writes no colour"))?;
        let pair = program.pair.to_gpu(color)?;
        let most = device.device.limits().max_uniform_buffer_binding_size as usize;
        if let Some(stage) = [&pair.vertex, &pair.fragment].into_iter().find(|stage| 16 * stage.rows > most) {
            let (bytes, most) = (16 * stage.rows, most / 1024);
            let what = format!("a stage has {bytes} bytes of uniforms, and this GPU takes {most} KiB");
            return Err(GpuError::unsupported(what));
        }
        let groups = [
            device.device.create_bind_group_layout(&layout(&entries(&pair.vertex, Stage::Vertex))),
            device.device.create_bind_group_layout(&layout(&entries(&pair.fragment, Stage::Fragment))),
        ];
        let pipeline = std::thread::scope(|scope| {
            let builder = std::thread::Builder::new().name("GPU compiler".to_owned()).stack_size(STACK);
            let thread = builder.spawn_scoped(scope, || made(device, &pair, &groups)).ok()?;
            thread.join().ok()
        });
        let pipeline = pipeline.ok_or_else(|| device.failed("its compiler broke down on this program"))?;
        Ok(Self { pair, pipeline: pipeline?, groups })
    }

    /// The resources of a stage: its block of words, its textures and samplers.
    pub(crate) fn group(
        &self,
        device: &Device,
        stage: Stage,
        words: &wgpu::Buffer,
        given: (&[Option<ProgramPicture>], &mut Textures),
    ) -> wgpu::BindGroup {
        let (pictures, textures) = given;
        let own = self.stage(stage);
        for binding in &own.bindings {
            textures.make(device, picture_of(binding, pictures), binding.is_cube);
        }
        let mut entries = vec![wgpu::BindGroupEntry { binding: 0, resource: words.as_entire_binding() }];
        for binding in &own.bindings {
            let (view, sampler) = textures.get(picture_of(binding, pictures), binding.is_cube);
            entries.push(wgpu::BindGroupEntry {
                binding: binding.binding,
                resource: match binding.is_sampler {
                    true => wgpu::BindingResource::Sampler(sampler),
                    false => wgpu::BindingResource::TextureView(view),
                },
            });
        }
        let layout = &self.groups[usize::from(stage == Stage::Fragment)];
        let descriptor = wgpu::BindGroupDescriptor { label: Some("values"), layout, entries: &entries };
        device.device.create_bind_group(&descriptor)
    }

    pub(crate) fn stage(&self, stage: Stage) -> &GpuStage {
        match stage {
            Stage::Vertex => &self.pair.vertex,
            Stage::Fragment => &self.pair.fragment,
        }
    }
}

/// The picture of a texture or sampler; samplers of WGSL, which stand by themselves, filter as the first texture.
fn picture_of<'a>(
    binding: &GpuBinding,
    pictures: &[Option<ProgramPicture<'a>>],
) -> Option<ProgramPicture<'a>> {
    pictures.get(binding.texture.unwrap_or(0)).copied().flatten()
}

fn layout(entries: &[wgpu::BindGroupLayoutEntry]) -> wgpu::BindGroupLayoutDescriptor<'_> {
    wgpu::BindGroupLayoutDescriptor { label: Some("values of a stage"), entries }
}

fn entries(own: &GpuStage, stage: Stage) -> Vec<wgpu::BindGroupLayoutEntry> {
    let visibility = match stage {
        Stage::Vertex => ShaderStages::VERTEX,
        Stage::Fragment => ShaderStages::FRAGMENT,
    };
    let entry = |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let ty = wgpu::BufferBindingType::Uniform;
    let words = wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let texture = |is_cube| wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: true },
        view_dimension: dimension(is_cube),
        multisampled: false,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let of =
        |own: &GpuBinding| entry(own.binding, if own.is_sampler { sampler } else { texture(own.is_cube) });
    core::iter::once(entry(0, words)).chain(own.bindings.iter().map(of)).collect()
}

fn made(
    device: &Device,
    pair: &GpuPair,
    groups: &[wgpu::BindGroupLayout; 2],
) -> Result<wgpu::RenderPipeline, GpuError> {
    let module = |text: &str, label| {
        let source = wgpu::ShaderSource::Wgsl(text.into());
        device.device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some(label), source })
    };
    device.checked(|| {
        let (vertex, fragment) =
            (module(&pair.vertex.text, "vertex"), module(&pair.fragment.text, "fragment"));
        let layout = pipeline_layout(device, groups);
        let attributes: Vec<_> = pair.vertex.attributes.iter().zip(offsets(pair)).map(attribute).collect();
        let array_stride = stride(pair) as u64;
        let step_mode = wgpu::VertexStepMode::Vertex;
        let buffer = wgpu::VertexBufferLayout { array_stride, step_mode, attributes: &attributes };
        let buffers = [Some(buffer)];
        let buffers = if attributes.is_empty() { &[][..] } else { &buffers[..] };
        let target =
            wgpu::ColorTargetState { format: device.format, blend: None, write_mask: wgpu::ColorWrites::ALL };
        let compilation_options = wgpu::PipelineCompilationOptions::default();
        device.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("program"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &vertex,
                entry_point: Some(ENTRY),
                compilation_options: compilation_options.clone(),
                buffers,
            },
            // The picture is upside down, and so is which way round triangles go.
            primitive: wgpu::PrimitiveState { front_face: wgpu::FrontFace::Cw, ..Default::default() },
            depth_stencil: Some(nearest()),
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &fragment,
                entry_point: Some(ENTRY),
                compilation_options,
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    })
}

fn pipeline_layout(device: &Device, groups: &[wgpu::BindGroupLayout; 2]) -> wgpu::PipelineLayout {
    device.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(&groups[0]), Some(&groups[1])],
        immediate_size: 0,
    })
}

/// What is nearest is seen; of what is equally near, what comes first.
fn nearest() -> wgpu::DepthStencilState {
    wgpu::DepthStencilState {
        format: DEPTH,
        depth_write_enabled: Some(true),
        depth_compare: Some(wgpu::CompareFunction::Less),
        stencil: wgpu::StencilState::default(),
        bias: wgpu::DepthBiasState::default(),
    }
}

/// The first byte of each attribute of a vertex.
fn offsets(pair: &GpuPair) -> impl Iterator<Item = u64> + '_ {
    pair.vertex.attributes.iter().scan(0, |next, attribute| {
        let own = *next;
        *next += 4 * attribute.ty.rows as u64;
        Some(own)
    })
}

/// Bytes of a vertex.
pub(crate) fn stride(pair: &GpuPair) -> usize {
    pair.vertex.attributes.iter().map(|attribute| 4 * attribute.ty.rows).sum()
}

fn attribute((own, offset): (&GpuAttribute, u64)) -> wgpu::VertexAttribute {
    use wgpu::VertexFormat as Format;
    let format = match (own.ty.scalar, own.ty.rows) {
        (Scalar::Float, 1) => Format::Float32,
        (Scalar::Float, 2) => Format::Float32x2,
        (Scalar::Float, 3) => Format::Float32x3,
        (Scalar::Float, _) => Format::Float32x4,
        (Scalar::Int, 1) => Format::Sint32,
        (Scalar::Int, 2) => Format::Sint32x2,
        (Scalar::Int, 3) => Format::Sint32x3,
        (Scalar::Int, _) => Format::Sint32x4,
        (Scalar::Uint | Scalar::Bool, 1) => Format::Uint32,
        (Scalar::Uint | Scalar::Bool, 2) => Format::Uint32x2,
        (Scalar::Uint | Scalar::Bool, 3) => Format::Uint32x3,
        (Scalar::Uint | Scalar::Bool, _) => Format::Uint32x4,
    };
    wgpu::VertexAttribute { format, offset, shader_location: own.location }
}
