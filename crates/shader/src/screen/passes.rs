//! Several programs that fill pictures one after the other, each for the next and for itself in the next frame.

use std::sync::Arc;

use super::levels::Border;
use super::{Moment, Pictures, Screen, ScreenError, ScreenPicture, TexturePicture};
use crate::{Program, RunError, UniformError, UniformValues};

/// What a texture of a pass is.
#[derive(Clone, Debug, PartialEq)]
pub enum PassTexture {
    /// A picture.
    Picture(TexturePicture),
    /// What the pass of this number drew: in this frame if it comes before, else in the last one.
    Pass {
        /// Its number.
        number: usize,
        /// What happens beyond its border.
        border: Border,
        /// Whether looks give the nearest texel, not a mean of four.
        nearest: bool,
    },
}

/// Why a frame was not drawn.
#[derive(Clone, Debug, thiserror::Error)]
pub enum PassError {
    /// A pass cannot fill a picture.
    #[error(transparent)]
    Screen(#[from] ScreenError),
    /// A pass did not come to its end.
    #[error(transparent)]
    Run(#[from] RunError),
}

/// A program that fills a picture.
#[derive(Clone, Debug)]
pub struct Pass {
    /// Its fragment shader.
    pub program: Arc<Program>,
    /// What its textures are, in their order; opaque black where there is nothing.
    pub textures: Vec<Option<PassTexture>>,
    /// Uniforms that somebody has set, by their names.
    pub set: Vec<(String, Vec<f32>)>,
    /// Whether y counts from the top, as in WGSL.
    pub from_top: bool,
}

/// Passes, the last of which draws the picture. All are as large as it.
///
/// Before the first frame every pass has drawn nothing: all its numbers are 0. What a pass draws for another keeps its
/// numbers as they are.
///
/// ```
/// use std::sync::Arc;
/// use glanz_shader::{Border, Moment, Pass, PassTexture, Passes, Shader};
///
/// let program = |text: &str| Ok::<_, glanz_shader::ShaderError>(Arc::new(Shader::fragment(text).compile()?));
/// // Each frame adds to the one before.
/// let sum = "void mainImage(out vec4 c, vec2 at) { c = texelFetch(iChannel0, ivec2(at), 0) + vec4(0.25); }";
/// let show = "void mainImage(out vec4 c, vec2 at) { c = vec4(texelFetch(iChannel0, ivec2(at), 0).rgb, 1.0); }";
/// let pass = |text: &str| {
///     let textures = vec![Some(PassTexture::Pass { number: 0, border: Border::Hold, nearest: false })];
///     Ok::<_, glanz_shader::ShaderError>(Pass { program: program(text)?, textures, set: vec![], from_top: false })
/// };
/// let mut passes = Passes::new(vec![pass(sum)?, pass(show)?], [4, 2], 1)?;
/// let moment = |frame| Moment { size: [4, 2], frame, ..Moment::default() };
/// passes.skip(&moment(0), &mut |_| {})?;
/// passes.skip(&moment(1), &mut |_| {})?;
/// assert_eq!(passes.draw(&moment(2), &mut |_| {})?.pixels[0], [0.75, 0.75, 0.75, 1.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Passes {
    passes: Vec<Pass>,
    size: [u32; 2],
    samples: u32,
    /// What each pass has drawn.
    drawn: Vec<TexturePicture>,
    /// Whether any reads that.
    is_read: Vec<bool>,
}

impl Passes {
    /// Pictures of `size` pixels; the last pass has so many samples in each pixel, the others one.
    pub fn new(passes: Vec<Pass>, size: [u32; 2], samples: u32) -> Result<Self, ScreenError> {
        for pass in &passes {
            Screen::new(&pass.program, &pass.program.uniforms(), size)?;
            pass.uniforms(&Moment::default(), size)?;
        }
        let [width, height] = size.map(|side| side as usize);
        let nothing = ScreenPicture { width, height, pixels: vec![[0.0; 4]; width * height] };
        let drawn = vec![TexturePicture::of_pass(&nothing); passes.len()];
        let reads = |number: usize| passes.iter().any(|pass| pass.reads(number));
        let is_read = (0..passes.len()).map(reads).collect();
        Ok(Self { passes, size, samples, drawn, is_read })
    }

    /// The passes.
    pub fn list(&self) -> &[Pass] {
        &self.passes
    }

    /// Whether a frame depends on the one before.
    pub fn remembers(&self) -> bool {
        let later = |(number, pass): (usize, &Pass)| (number..self.passes.len()).any(|own| pass.reads(own));
        self.passes.iter().enumerate().any(later)
    }

    /// Draws of a frame only what the next one needs.
    pub fn skip(&mut self, moment: &Moment, progress: &mut (dyn FnMut(f64) + Send)) -> Result<(), PassError> {
        self.frame(moment, progress, false).map(drop)
    }

    /// Draws a frame: all passes, and gives what the last has drawn.
    pub fn draw(
        &mut self,
        moment: &Moment,
        progress: &mut (dyn FnMut(f64) + Send),
    ) -> Result<ScreenPicture, PassError> {
        self.frame(moment, progress, true)
    }

    fn frame(
        &mut self,
        moment: &Moment,
        progress: &mut (dyn FnMut(f64) + Send),
        is_shown: bool,
    ) -> Result<ScreenPicture, PassError> {
        let count = self.passes.len();
        let mut last = ScreenPicture { width: 0, height: 0, pixels: Vec::new() };
        for number in 0..count {
            let is_last = number + 1 == count;
            let is_drawn = self.is_read[number] || is_last && is_shown;
            if !is_drawn {
                continue;
            }
            let samples = if is_last { self.samples } else { 1 };
            let mut within = |part| progress((number as f64 + part) / count as f64);
            let picture = self.pass(number, moment, samples, &mut within)?;
            if self.is_read[number] {
                self.drawn[number] = TexturePicture::of_pass(&picture);
            }
            last = picture;
        }
        Ok(last)
    }

    /// The uniforms of a pass, and the names of those that nothing fills.
    pub fn uniforms(
        &self,
        number: usize,
        moment: &Moment,
    ) -> Result<(UniformValues, Vec<String>), UniformError> {
        self.passes[number].uniforms(moment, self.size)
    }

    fn pass(
        &self,
        number: usize,
        moment: &Moment,
        samples: u32,
        progress: &mut (dyn FnMut(f64) + Send),
    ) -> Result<ScreenPicture, PassError> {
        let pass = &self.passes[number];
        let picture = |texture: &Option<PassTexture>| match texture.as_ref()? {
            PassTexture::Picture(picture) => Some(picture.clone()),
            PassTexture::Pass { number, border, nearest } => {
                let picture = self.drawn.get(*number)?.clone().bordered(*border);
                Some(if *nearest { picture.nearest() } else { picture })
            }
        };
        let pictures = Pictures(pass.textures.iter().map(picture).collect());
        let (values, _) = pass.uniforms(moment, self.size).map_err(ScreenError::from)?;
        let screen = Screen::new(&pass.program, &values, self.size)?.textures(&pictures).samples(samples);
        let screen = if pass.from_top { screen.from_top() } else { screen };
        Ok(screen.draw(progress)?)
    }
}

impl Pass {
    fn reads(&self, number: usize) -> bool {
        let is_it = |texture: &PassTexture| matches!(texture, PassTexture::Pass { number: own, .. } if *own == number);
        self.textures.iter().flatten().any(is_it)
    }

    fn uniforms(
        &self,
        moment: &Moment,
        size: [u32; 2],
    ) -> Result<(UniformValues, Vec<String>), UniformError> {
        let of = |texture: &Option<PassTexture>| match texture.as_ref()? {
            PassTexture::Picture(picture) => Some(picture.size()),
            PassTexture::Pass { .. } => Some(size),
        };
        let textures = self.textures.iter().map(of).collect();
        let mut values = self.program.uniforms();
        let mut unfilled = Moment { textures, ..moment.clone() }.fill(&self.program, &mut values);
        for (name, numbers) in &self.set {
            values.set(name, numbers)?;
            unfilled.retain(|own| own != name);
        }
        Ok((values, unfilled))
    }
}
