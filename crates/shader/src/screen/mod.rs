//! Programs that fill a picture by themselves, as Shadertoy and glslViewer run them: neither mesh nor scene.

mod channels;
mod inputs;
mod levels;
mod moment;
mod passes;
mod picture;
mod pictures;

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use glanz_math::SimdLevel;

use self::inputs::Source;
use crate::interface::number;
use crate::{
    Interface, Machine, NoTextures, Program, RunError, Scalar, Stage, Textures, UniformError, UniformValues,
};

pub use channels::{Channel, Channels};
pub use levels::Border;
pub use moment::{Moment, is_of_a_pass};
pub use passes::{Pass, PassError, PassTexture, Passes};
pub use picture::ScreenPicture;
pub use pictures::{Pictures, TexturePicture};

/// Pixels along a side of what the machine draws at once.
const BLOCK: usize = 8;
/// Turns of loops that a block may take. Path tracers take a hundred thousand.
const FUEL: u32 = 1 << 22;

/// A program that cannot fill a picture.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ScreenError {
    /// It is no fragment shader.
    #[error("a {0} shader gives no pixels: a fragment shader is expected")]
    Stage(&'static str),
    /// It has no output.
    #[error("the shader gives no colour: it has neither an 'out vec4', nor gl_FragColor, nor mainImage")]
    NoColor,
    /// A uniform was set that it has not, or has otherwise.
    #[error(transparent)]
    Uniform(#[from] UniformError),
}

/// A fragment shader over all pixels of a picture.
///
/// `gl_FragCoord` counts from the bottom left corner, pixel centres lie at .5; inputs that are named as texture
/// coordinates go from 0 to 1. The bits are the same for every number of threads and every SIMD level.
///
/// ```
/// use glanz_shader::{Moment, Screen, Shader};
///
/// let text = "void mainImage(out vec4 color, in vec2 at) { color = vec4(at / iResolution.xy, fract(iTime), 1.0); }";
/// let program = Shader::fragment(text).compile()?;
/// let mut uniforms = program.uniforms();
/// let unfilled = Moment { size: [4, 2], time: 0.5, ..Moment::default() }.fill(&program, &mut uniforms);
/// assert!(unfilled.is_empty());
/// let picture = Screen::new(&program, &uniforms, [4, 2])?.draw(&mut |_| {})?;
/// // The upper left corner.
/// assert_eq!(picture.pixels[0], [0.125, 0.75, 0.5, 1.0]);
/// assert_eq!(picture.codes()[..4], [32, 191, 128, 255]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Screen<'a> {
    program: &'a Program,
    uniforms: &'a UniformValues,
    textures: &'a (dyn Textures + Sync),
    size: [u32; 2],
    samples: u32,
    level: SimdLevel,
    fuel: u32,
    from_top: bool,
    output: usize,
    sources: Vec<Source>,
}

impl<'a> Screen<'a> {
    /// A picture of `size` pixels, without textures, one sample in the middle of each pixel.
    pub fn new(
        program: &'a Program,
        uniforms: &'a UniformValues,
        size: [u32; 2],
    ) -> Result<Self, ScreenError> {
        if program.stage() != Stage::Fragment {
            return Err(ScreenError::Stage(program.stage().name()));
        }
        let output = color_output(program.interface()).ok_or(ScreenError::NoColor)?;
        let sources = program.interface().inputs.iter().map(Source::of).collect();
        let (level, fuel) = (SimdLevel::default(), FUEL);
        let textures = &NoTextures;
        Ok(Self {
            program,
            uniforms,
            textures,
            size,
            samples: 1,
            level,
            fuel,
            from_top: false,
            output,
            sources,
        })
    }

    /// What the program's textures are.
    #[must_use]
    pub fn textures(mut self, textures: &'a (dyn Textures + Sync)) -> Self {
        self.textures = textures;
        self
    }

    /// Samples in each pixel, at least 1; the pixel is their mean after each is cut to 0 … 1.
    #[must_use]
    pub fn samples(mut self, samples: u32) -> Self {
        self.samples = samples.max(1);
        self
    }

    /// The SIMD level; the picture does not depend on it.
    #[must_use]
    pub fn level(mut self, level: SimdLevel) -> Self {
        self.level = level;
        self
    }

    /// How many turns all loops of a block of 8×8 pixels may take together.
    #[must_use]
    pub fn fuel(mut self, turns: u32) -> Self {
        self.fuel = turns;
        self
    }

    /// Counts y from the top, as WGSL does, and not from the bottom, as GLSL does.
    #[must_use]
    pub fn from_top(mut self) -> Self {
        self.from_top = true;
        self
    }

    /// Names of inputs that nothing fills: they are 0.
    pub fn unfilled_inputs(&self) -> impl Iterator<Item = &str> {
        let inputs = self.program.interface().inputs.iter().zip(&self.sources);
        inputs.filter(|(_, source)| **source == Source::Nothing).map(|(port, _)| port.name.as_str())
    }

    /// Draws. `progress` is told which part is done, from any thread, with the feature `rayon` on all of them.
    pub fn draw(&self, progress: &mut (dyn FnMut(f64) + Send)) -> Result<ScreenPicture, RunError> {
        let [width, height] = self.size.map(|side| side as usize);
        let mut pixels = vec![[0.0; 4]; width * height];
        let total = height.div_ceil(BLOCK);
        let (done, progress) = (AtomicUsize::new(0), Mutex::new(progress));
        let strip = |machine: &mut Machine<'_, 4>, (index, rows): (usize, &mut [[f32; 4]])| {
            self.strip(machine, index * BLOCK, rows)?;
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            // Who finds it locked leaves it to the next.
            if let Ok(mut progress) = progress.try_lock() {
                progress(done as f64 / total as f64);
            }
            Ok(())
        };
        let machine = || self.machine();
        #[cfg(feature = "rayon")]
        {
            use rayon::prelude::*;
            pixels.par_chunks_mut(BLOCK * width).enumerate().try_for_each_init(machine, strip)?;
        }
        #[cfg(not(feature = "rayon"))]
        {
            let mut machine = machine();
            pixels.chunks_mut(BLOCK * width).enumerate().try_for_each(|rows| strip(&mut machine, rows))?;
        }
        if !self.from_top {
            let rows: Vec<&[[f32; 4]]> = pixels.chunks(width).rev().collect();
            pixels = rows.concat();
        }
        Ok(ScreenPicture { width, height, pixels })
    }

    fn machine(&self) -> Machine<'a, 4> {
        let mut machine = Machine::<4>::new(self.program, self.uniforms, self.textures, self.level);
        machine.set_fuel(self.fuel);
        machine
    }

    /// Rows from `first` on, in the direction in which the program counts them.
    fn strip(
        &self,
        machine: &mut Machine<'_, 4>,
        first: usize,
        rows: &mut [[f32; 4]],
    ) -> Result<(), RunError> {
        let width = self.size[0] as usize;
        for left in (0..width).step_by(BLOCK) {
            for sample in 0..self.samples {
                let offset = offset(sample);
                self.run(machine, [left as f32 + offset[0], first as f32 + offset[1]])?;
                self.gather(machine, left, rows);
            }
        }
        Ok(())
    }

    /// Runs a block, whose lower left sample is `at`.
    fn run(&self, machine: &mut Machine<'_, 4>, at: [f32; 2]) -> Result<(), RunError> {
        for (i, (port, source)) in self.program.interface().inputs.iter().zip(&self.sources).enumerate() {
            for k in 0..port.ty.scalars() {
                let value = |g: usize, lane: usize| {
                    let [x, y] = place(g, lane);
                    let at = [at[0] + x as f32, at[1] + y as f32];
                    bits(source.value(k, at, self.size, self.from_top), port.ty.scalar)
                };
                for (g, row) in machine.input(i, k).iter_mut().enumerate() {
                    row.0 = std::array::from_fn(|lane| value(g, lane));
                }
            }
        }
        machine.run()
    }

    /// Adds the samples of a block to its pixels.
    fn gather(&self, machine: &Machine<'_, 4>, left: usize, rows: &mut [[f32; 4]]) {
        let width = self.size[0] as usize;
        let ty = self.program.interface().outputs[self.output].ty;
        let discarded = machine.discarded();
        let (n, share) = (ty.scalars().min(4), 1.0 / self.samples as f32);
        let values: [_; 4] = std::array::from_fn(|k| (k < n).then(|| machine.output(self.output, k)));
        for g in 0..4 {
            for lane in 0..BLOCK * BLOCK / 4 {
                let [x, y] = place(g, lane);
                let index = y * width + left + x;
                if left + x >= width || index >= rows.len() || discarded[g] >> lane & 1 == 1 {
                    continue;
                }
                let component = |k: usize| values[k].map(|rows| number(rows[g].0[lane].to_bits(), ty.scalar));
                let color = whole_color(std::array::from_fn(component));
                for (sum, value) in rows[index].iter_mut().zip(color) {
                    // NaN must not vanish in the cut.
                    let cut = if self.samples > 1 && !value.is_nan() { value.clamp(0.0, 1.0) } else { value };
                    *sum += cut * share;
                }
            }
        }
    }
}

/// Colours of fewer than four components: a number is grey, and what has no alpha is opaque.
fn whole_color([red, green, blue, alpha]: [Option<f32>; 4]) -> [f32; 4] {
    let red = red.unwrap_or(0.0);
    let grey = if green.is_none() { red } else { 0.0 };
    [red, green.unwrap_or(grey), blue.unwrap_or(grey), alpha.unwrap_or(1.0)]
}

/// The output that is the colour.
fn color_output(interface: &Interface) -> Option<usize> {
    let outputs = || interface.outputs.iter().enumerate().filter(|(_, port)| !port.builtin);
    let usual = outputs().find(|(_, port)| {
        matches!(port.name.as_str(), "gl_FragColor" | "gl_FragData[0]") || port.location == Some(0)
    });
    usual.or_else(|| outputs().next()).map(|(index, _)| index)
}

/// Where in its block the lane of a row of registers lies.
fn place(g: usize, lane: usize) -> [usize; 2] {
    [g % 2 * 4 + lane % 4, g / 2 * 4 + lane / 4]
}

/// Where in the pixel a sample lies: the first in its middle, all of them evenly spread (the additive sequence of
/// M. Roberts, 2018, by the plastic number).
fn offset(sample: u32) -> [f32; 2] {
    let n = f64::from(sample);
    [0.754_877_666_246_692_8, 0.569_840_290_998_053_2].map(|step| (0.5 + n * step).fract() as f32)
}

/// A number as the bits of its type.
fn bits(value: f32, scalar: Scalar) -> f32 {
    match scalar {
        Scalar::Float => value,
        Scalar::Int | Scalar::Uint => f32::from_bits(value as i32 as u32),
        Scalar::Bool => f32::from_bits(if value == 0.0 { 0 } else { u32::MAX }),
    }
}
