//! The back end.

use std::sync::{Arc, Mutex, PoisonError};

use glanz_render::cpu::Renderer;
use glanz_render::prepare::{Prepared, PreparedProgram};
use glanz_render::view::program::{FrameUniforms, StageValues};
use glanz_render::view::samples::{SUBPIXEL, positions};
use glanz_render::{Aovs, Backend, BackendError, DebugView, DrawOptions, Frame, View};
use glanz_scene::{AlphaMode, Program};
use glanz_shader::Stage;
use glanz_shader::gpu::GpuStage;

use crate::GpuError;
use crate::device::Device;
use crate::devices::{Choice, DeviceInfo};
use crate::mesh::Mesh;
use crate::pipeline::Pipeline;
use crate::target::Target;
use crate::textures::{Textures, is_there};

/// Draws objects that have programs on a device; what is behind them comes from the CPU.
///
/// ```
/// use glanz_gpu::{Choice, Gpu};
/// use glanz_render::Shot;
/// use glanz_scene::{Mesh, Program, ProgramText, Scene, library};
///
/// let text = "in vec3 normal; out vec4 color; void main() { color = vec4(0.5 * normalize(normal) + 0.5, 1.0); }";
/// let mut scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?).with_size(32, 32);
/// scene.programs.push(Program::of_fragment(ProgramText::new("normals.frag", text)));
/// scene.program = Some(0);
///
/// match Gpu::open(&Choice::Best) {
///     Ok(gpu) => {
///         println!("{}", gpu.info());
///         let rgba = Shot::new(&scene)?.on(Box::new(gpu)).rgba8()?;
///         assert_eq!(rgba.len(), 4 * 32 * 32);
///     }
///     Err(error) => println!("{error}"),
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Gpu {
    device: Arc<Device>,
    cpu: Renderer,
    programs: Compiled,
    failed: Option<BackendError>,
}

/// Programs as pipelines, the latest at the end.
type Compiled = Arc<Mutex<Vec<(Program, Arc<Pipeline>)>>>;

/// Most programs that are kept compiled.
const MOST_PROGRAMS: usize = 32;

/// An object, ready to be drawn.
struct Drawn {
    pipeline: Arc<Pipeline>,
    mesh: Mesh,
    /// The words of the vertex stage, whose first row is the host's.
    words: wgpu::Buffer,
    groups: [wgpu::BindGroup; 2],
}

impl Gpu {
    /// Opens a device.
    ///
    /// # Errors
    /// If there is none, or its driver fails.
    pub fn open(choice: &Choice) -> Result<Self, GpuError> {
        let device = Arc::new(Device::open(choice)?);
        Ok(Self { device, cpu: Renderer::new(), programs: Compiled::default(), failed: None })
    }

    /// Another back end on the same device, which shares what is compiled.
    #[must_use]
    pub fn again(&self) -> Self {
        let (device, programs) = (Arc::clone(&self.device), Arc::clone(&self.programs));
        Self { device, cpu: Renderer::new(), programs, failed: None }
    }

    /// The device.
    pub fn info(&self) -> &DeviceInfo {
        &self.device.info
    }

    /// Whether a GPU draws such a picture, and else why it does not. Devices and programs may have limits beyond.
    ///
    /// # Errors
    /// What it does not draw.
    pub fn check(prepared: &Prepared, options: &DrawOptions) -> Result<(), GpuError> {
        let refused = |what: &str| Err(GpuError::unsupported(what));
        if options.show != DebugView::Shaded {
            return refused("the GPU shows programs only, no normals, depths or other debug views");
        }
        if options.aovs != Aovs::default() {
            return refused("the GPU gives no planes beside colour: no depth, normals or object numbers");
        }
        if prepared.first_channel() != 0 {
            return refused("the GPU draws three channels, and this observer has more");
        }
        for (number, object) in prepared.objects.iter().enumerate() {
            if object.program.is_none() {
                return refused(&format!(
                    "the GPU draws objects that have a program, and object {} of the scene has none: \
                     --fs FILE or the scene's 'program' gives it one",
                    number + 1
                ));
            }
            if prepared.materials[object.material].alpha_mode == AlphaMode::Blend {
                return refused("the GPU draws opaque objects only, and this scene blends some");
            }
        }
        Ok(())
    }

    fn frame(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Result<Frame, GpuError> {
        Self::check(prepared, options)?;
        let most = self.device.info.max_size;
        if view.width.max(view.height) > most {
            return Err(GpuError::unsupported(format!("this GPU draws pictures up to {most}×{most} pixels")));
        }
        let mut frame = self.cpu.background(prepared, view, options);
        let objects = self.objects(prepared, view, options)?;
        let device = &*self.device;
        let (size, samples) = ([view.width, view.height], positions(options.samples));
        let target = device.checked(|| Target::new(device, size))?;
        let mut sums = vec![[0.0f32; 4]; size[0] as usize * size[1] as usize];
        for sample in samples {
            device.checked(|| {
                let row = GpuStage::host_row(shift(*sample, size));
                for object in &objects {
                    device.queue.write_buffer(&object.words, 0, &bytes(&row));
                }
                target.draw(device, |pass| objects.iter().for_each(|object| object.draw(pass)));
            })?;
            target.read(device, |pixel, numbers| {
                for (sum, number) in sums[pixel].iter_mut().zip(numbers) {
                    *sum += number;
                }
            })?;
        }
        lay_over(&mut frame, &sums, samples.len() as f32, &options.primaries);
        Ok(frame)
    }

    fn objects(
        &self,
        prepared: &Prepared,
        view: &View,
        options: &DrawOptions,
    ) -> Result<Vec<Drawn>, GpuError> {
        let uniforms = FrameUniforms::new(prepared, view, options.moment);
        let mut textures = Textures::default();
        let mut all = Vec::new();
        for object in &prepared.objects {
            let Some((number, values)) = object.program.zip(uniforms.of(object)) else { continue };
            let program = &prepared.programs[number];
            let mut pictures = values.vertex_textures.iter().chain(&values.fragment_textures).flatten();
            if !pictures.all(is_there) {
                let what =
                    "the GPU takes cube maps as six square faces of one size, no panoramas or environments";
                return Err(GpuError::unsupported(what));
            }
            let pipeline = self.pipeline(program)?;
            let inputs = &program.pair.vertex.interface().inputs;
            let device = &*self.device;
            let drawn = device.checked(|| {
                let attributes = &pipeline.pair.vertex.attributes;
                let mesh = Mesh::new(device, &prepared.geometry, object, attributes, inputs);
                Drawn::new(device, pipeline, mesh, &values, &mut textures)
            })?;
            all.push(drawn);
        }
        Ok(all)
    }

    fn pipeline(&self, program: &PreparedProgram) -> Result<Arc<Pipeline>, GpuError> {
        // What uniforms are set to is no part of what is compiled.
        let source = Program { uniforms: Default::default(), ..program.source.clone() };
        let mut programs = self.programs.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = programs.iter().find(|(known, _)| *known == source) {
            return Ok(Arc::clone(known));
        }
        let made = Arc::new(Pipeline::new(&self.device, program)?);
        if programs.len() == MOST_PROGRAMS {
            programs.remove(0);
        }
        programs.push((source, Arc::clone(&made)));
        Ok(made)
    }
}

impl Backend for Gpu {
    fn draw(&mut self, prepared: &Prepared, view: &View, options: &DrawOptions) -> Frame {
        match self.frame(prepared, view, options) {
            Ok(frame) => frame,
            Err(error) => {
                self.failed = Some(error.into());
                // Of no use but for its size and its channels.
                self.cpu.background(prepared, view, options)
            }
        }
    }

    fn take_error(&mut self) -> Option<BackendError> {
        self.failed.take()
    }
}

impl Drawn {
    fn new(
        device: &Device,
        pipeline: Arc<Pipeline>,
        mesh: Mesh,
        values: &StageValues,
        textures: &mut Textures,
    ) -> Self {
        let words = |words: &[u32], stage: &GpuStage| {
            let mut all = GpuStage::host_row([0.0; 2]).to_vec();
            all.extend(words);
            all.resize(4 * stage.rows, 0);
            device.buffer("words", wgpu::BufferUsages::UNIFORM, &bytes(&all))
        };
        let vertex = words(values.vertex.words(), &pipeline.pair.vertex);
        let fragment = words(values.fragment.words(), &pipeline.pair.fragment);
        let groups = [
            pipeline.group(device, Stage::Vertex, &vertex, (&values.vertex_textures, textures)),
            pipeline.group(device, Stage::Fragment, &fragment, (&values.fragment_textures, textures)),
        ];
        Self { pipeline, mesh, words: vertex, groups }
    }

    fn draw(&self, pass: &mut wgpu::RenderPass) {
        if self.mesh.count == 0 {
            return;
        }
        pass.set_pipeline(&self.pipeline.pipeline);
        for (number, group) in (0..).zip(&self.groups) {
            pass.set_bind_group(number, group, &[]);
        }
        if !self.pipeline.pair.vertex.attributes.is_empty() {
            pass.set_vertex_buffer(0, self.mesh.vertices.slice(..));
        }
        pass.set_index_buffer(self.mesh.indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(0..self.mesh.count, 0, 0..1);
    }
}

fn bytes(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// By how much the picture is moved so that a sample comes to the middle of its pixel: right and up, in halves of the
/// picture.
fn shift(sample: [i32; 2], [width, height]: [u32; 2]) -> [f32; 2] {
    let [x, y] = sample.map(|step| step as f32 / SUBPIXEL as f32);
    [(0.5 - x) * 2.0 / width as f32, (y - 0.5) * 2.0 / height as f32]
}

/// Lays sums of linear sRGB and of coverage over what is there.
fn lay_over(frame: &mut Frame, sums: &[[f32; 4]], samples: f32, primaries: &[[f32; 3]; 3]) {
    for (pixel, [red, green, blue, covered]) in sums.iter().enumerate() {
        if *covered == 0.0 {
            continue;
        }
        let rest = 1.0 - covered / samples;
        for (channel, plane) in frame.rgb.iter_mut().enumerate() {
            let part = |own: f32, primary: usize| own * primaries[primary][channel];
            let own = part(*red, 0) + part(*green, 1) + part(*blue, 2);
            plane[pixel] = own / samples + plane[pixel] * rest;
        }
        frame.alpha[pixel] = covered / samples + frame.alpha[pixel] * rest;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_right_of_the_middle_moves_the_picture_left() {
        assert_eq!(shift([128, 128], [64, 32]), [0.0, 0.0]);
        // A quarter of a pixel right and down: left by it, and up.
        assert_eq!(shift([192, 192], [64, 32]), [-0.25 * 2.0 / 64.0, 0.25 * 2.0 / 32.0]);
    }

    #[test]
    fn a_lost_device_is_an_error_and_no_panic() {
        let Ok(gpu) = Gpu::open(&Choice::Best) else {
            eprintln!("!!! SKIPPED: there is no GPU here");
            return;
        };
        let text = "#version 330\nout vec4 c; void main() { c = vec4(1.0); }";
        let mut scene = glanz_scene::Scene::new()
            .with_mesh(glanz_scene::Mesh::builtin("cube").unwrap(), glanz_scene::Material::default_gray())
            .with_size(8, 8);
        scene.set_program(Program::of_fragment(glanz_scene::ProgramText::new("own.frag", text)));
        let shot = |gpu: &Gpu| glanz_render::Shot::new(&scene).unwrap().on(Box::new(gpu.again()));
        assert_eq!(shot(&gpu).rgba8().unwrap().len(), 4 * 8 * 8);
        assert_eq!(gpu.programs.lock().unwrap().len(), 1, "what is compiled is shared");
        gpu.device.device.destroy();
        let error = shot(&gpu).rgba8().unwrap_err();
        assert!(error.to_string().starts_with("the device "), "{error}");
    }

    #[test]
    fn what_covers_half_a_pixel_lies_over_half_of_what_is_behind() {
        let plane = || vec![1.0; 1];
        let mut frame = Frame {
            width: 1,
            height: 1,
            rgb: [plane(), plane(), plane()],
            alpha: plane(),
            ..Frame::default()
        };
        let primaries = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        lay_over(&mut frame, &[[0.5, 0.25, 0.0, 1.0]], 2.0, &primaries);
        assert_eq!(frame.pixel(0, 0), [0.75, 0.625, 0.5, 1.0]);
    }
}
