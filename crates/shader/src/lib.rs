//! GLSL and WGSL of users, with no GPU and every value of every line in the open.
//!
//! A [`Shader`] is a text: GLSL as courses write it (1.10 to 4.60, ES, Shadertoy), WGSL, a file of BRDF Explorer, or one
//! function. It compiles to a [`Program`], whose [`Interface`] says what it takes and gives, and which a [`Machine`] runs
//! for 16 or 64 fragments at a time. The numbers are those of `glanz_math`: the same bits on every SIMD level.
//!
//! ```
//! use glanz_shader::{Machine, NoTextures, Row, Shader};
//!
//! let program = Shader::fragment(
//!     "#version 330
//!      uniform vec3 light = vec3(0.0, 0.0, 1.0);
//!      in vec3 normal;
//!      out vec4 color;
//!      void main() { color = vec4(vec3(max(dot(normalize(normal), light), 0.0)), 1.0); }",
//! )
//! .compile()?;
//! let mut uniforms = program.uniforms();
//! uniforms.set("light", &[0.6, 0.0, 0.8])?;
//! let mut machine = Machine::<1>::new(&program, &uniforms, &NoTextures, Default::default());
//! let normal = program.interface().input("normal").expect("it is declared");
//! machine.input(normal, 2)[0] = Row::splat(5.0);
//! machine.run()?;
//! assert_eq!(machine.output(0, 0)[0], Row::splat(0.8));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`Screen`] fills a picture by a fragment shader alone, as Shadertoy does.
//! What a value is at a pixel, line by line, is a [`Trace`]; what a name stands for, a [`Role`]; what is right but
//! probably not meant, a [`Warning`].

mod brdf;
mod check;
mod error;
#[cfg(feature = "fuzz")]
#[doc(hidden)]
pub mod fuzz;
pub mod gpu;
mod intake;
mod interface;
mod lower;
mod machine;
mod names;
mod pair;
mod program;
mod programs;
mod run;
mod screen;
mod specialize;
mod stage;
mod trace;

pub use brdf::{Brdf, BrdfSource};
pub use check::{Warning, check_stages};
pub use error::{Place, RunError, ShaderError};
pub use intake::{Range, included_path};
pub use interface::{Interface, Port, Uniform, UniformError, UniformValues};
pub use lower::TextureInfo;
pub use machine::{
    CubePlace, Lod, NoTextures, Row, TextureQuery, Textures, compared, panorama_place, turned,
};
pub use names::{Role, Space, attribute_role, uniform_role, varying_role};
pub use pair::{Pair, Source, Varying};
pub use program::{Program, Shader};
pub use programs::DefaultProgram;
pub use run::Machine;
pub use screen::{
    Border, Channel, Channels, Moment, Pass, PassError, PassTexture, Passes, Pictures, Screen, ScreenError,
    ScreenPicture, TexturePicture, is_of_a_pass,
};
pub use specialize::Specialized;
pub use stage::{Interpolation, Language, Scalar, Stage, ValueType};
pub use trace::{Record, RecordKind, Trace, TracePoint};
