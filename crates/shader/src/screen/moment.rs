//! What a host tells a program about the picture and the time.

use crate::{Interface, Program, Role, Scalar, Uniform, UniformValues};

/// Whether a texture of this name is one that another pass draws, in glslViewer and elsewhere (`u_buffer0`,
/// `backbuffer`): there is one pass only.
pub fn is_of_a_pass(texture: &str) -> bool {
    let name = texture.to_lowercase();
    ["buffer", "pyramid", "u_scene", "shadowmap", "previousframe", "prevframe"]
        .iter()
        .any(|word| name.contains(word))
}

/// The rate of sound that Shadertoy tells, whether there is sound or not.
const SAMPLE_RATE: f32 = 44_100.0;

/// A moment of a program that fills a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// Size of the picture in pixels.
    pub size: [u32; 2],
    /// Seconds since the start.
    pub time: f32,
    /// Number of the frame.
    pub frame: u32,
    /// Frames in a second.
    pub fps: f32,
    /// Where the pointer is pressed, in pixels from the bottom left; `None` if it is not.
    pub mouse: Option<[f32; 2]>,
    /// Width and height of each texture; `None` where it has no picture.
    pub textures: Vec<Option<[u32; 2]>>,
}

impl Default for Moment {
    fn default() -> Self {
        Self { size: [800, 600], time: 0.0, frame: 0, fps: 25.0, mouse: None, textures: vec![] }
    }
}

impl Moment {
    /// Sets what the names of the uniforms ask for, and gives the names of those that nothing fills and that are 0.
    ///
    /// By its [`Role`]: resolution (as vec3 with 1, the aspect of pixels), time, time since the last frame, number of the
    /// frame, pointer. As vec4 the pointer is Shadertoy's: its place, then where it was pressed, y negative from the second
    /// frame on; `mousePos` has the picture's size there. By name, `i` or `u_` before it: `iDate` (1 January 2000 and the
    /// seconds since, so that a picture is the same tomorrow), `iFrameRate`, `iSampleRate`, `iChannelTime`,
    /// `iChannelResolution`, a texture's name with `Resolution` behind, `u_delta`, `u_pixelDensity`.
    pub fn fill(&self, program: &Program, values: &mut UniformValues) -> Vec<String> {
        let interface = program.interface();
        let mut unfilled = Vec::new();
        for uniform in &interface.uniforms {
            match self.value(uniform, interface) {
                Some(all) => {
                    let n = uniform.ty.scalars().min(all.len());
                    // Both are counted by the type.
                    let _ = values.set(&uniform.name, &all[..n]);
                }
                None => {
                    let is_zero = values.get(&uniform.name).is_some_and(|all| all.iter().all(|x| *x == 0.0));
                    unfilled.extend(is_zero.then(|| uniform.name.clone()));
                }
            }
        }
        unfilled
    }

    fn value(&self, uniform: &Uniform, interface: &Interface) -> Option<[f32; 4]> {
        let [width, height] = self.size.map(|side| side as f32);
        if let Some(value) = self.named(uniform, interface) {
            return Some(value);
        }
        Some(match uniform.role? {
            Role::Resolution => [width, height, 1.0, 1.0],
            Role::Time => [self.time; 4],
            Role::TimeDelta => [1.0 / self.fps; 4],
            Role::Frame => [self.frame as f32; 4],
            Role::Mouse => {
                let Some([x, y]) = self.mouse else { return Some(self.no_mouse(&uniform.name)) };
                let pressed = [x, if self.frame == 0 { y } else { -y }];
                let [z, w] = if is_size(&uniform.name) { [width, height] } else { pressed };
                [x, y, z, w]
            }
            _ => return None,
        })
    }

    fn no_mouse(&self, name: &str) -> [f32; 4] {
        let [width, height] = self.size.map(|side| side as f32);
        if is_size(name) { [0.0, 0.0, width, height] } else { [0.0; 4] }
    }

    /// What is told by the name alone.
    fn named(&self, uniform: &Uniform, interface: &Interface) -> Option<[f32; 4]> {
        let (name, ty) = (uniform.name.as_str(), uniform.ty);
        if ty.columns != 1 || ty.scalar == Scalar::Bool {
            return None;
        }
        let bare = name.strip_prefix("u_").or_else(|| name.strip_prefix('i')).unwrap_or(name);
        let (bare, index) = match bare.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
            Some((bare, index)) => (bare, index.parse::<usize>().ok()),
            None => (bare, None),
        };
        Some(match (bare.to_lowercase().as_str(), ty.rows, index) {
            ("date", 4, None) => [2000.0, 0.0, 1.0, self.time],
            ("framerate" | "fps", 1, None) => [self.fps; 4],
            ("samplerate", 1, None) => [SAMPLE_RATE; 4],
            ("channeltime", 1, Some(_)) => [self.time; 4],
            ("delta", 1, None) => [1.0 / self.fps; 4],
            ("pixeldensity", 1, None) => [1.0; 4],
            ("channelresolution", 2 | 3, Some(i)) => self.size_of(&format!("iChannel{i}"), interface),
            (_, 2 | 3, None) => {
                let texture = name.strip_suffix("Resolution")?;
                interface.textures.iter().find(|own| own.name == texture)?;
                self.size_of(texture, interface)
            }
            _ => return None,
        })
    }

    /// Of a texture's picture; 0 where there is none.
    fn size_of(&self, texture: &str, interface: &Interface) -> [f32; 4] {
        let index = interface.textures.iter().position(|own| own.name == texture);
        let size = index.and_then(|index| *self.textures.get(index)?);
        size.map_or([0.0; 4], |[width, height]| [width as f32, height as f32, 1.0, 1.0])
    }
}

/// Whether the last two numbers of a pointer of this name are the picture's size.
fn is_size(name: &str) -> bool {
    name.eq_ignore_ascii_case("mousepos")
}
