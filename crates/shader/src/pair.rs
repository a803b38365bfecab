//! A vertex and a fragment shader together, and what stands in for the one that is not there.

mod stand_in;

use crate::{Interpolation, Port, Program, Role, Shader, ShaderError, Space};

/// Where the text of a stage comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The user.
    Own,
    /// The other stage: it gives what that one asks for, or shows what that one gives.
    StandIn,
}

/// An input of the fragment shader that the vertex shader gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Varying {
    /// Number of the fragment shader's input.
    pub input: usize,
    /// Number of the vertex shader's output.
    pub output: usize,
    /// How many numbers it is.
    pub components: usize,
    /// How it goes from the vertices to the pixels.
    pub interpolation: Interpolation,
}

/// Two stages that fit.
///
/// ```
/// use glanz_shader::{Pair, Shader, Source, Space};
///
/// let fragment = Shader::fragment("in vec3 normal; out vec4 c; void main() { c = vec4(normalize(normal), 1.0); }");
/// let pair = Pair::new(None, Some(&fragment))?;
/// assert_eq!((pair.vertex_source, pair.space), (Source::StandIn, Space::World));
/// assert_eq!(pair.varyings.len(), 1);
/// # Ok::<(), glanz_shader::ShaderError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Pair {
    /// The vertex shader.
    pub vertex: Program,
    /// The fragment shader.
    pub fragment: Program,
    /// Where the vertex shader comes from.
    pub vertex_source: Source,
    /// Where the fragment shader comes from.
    pub fragment_source: Source,
    /// What goes from the one to the other.
    pub varyings: Vec<Varying>,
    /// What the program takes lights and the eye to be relative to, where their names do not say it: the world if it
    /// knows the model's matrix or where the eye is, else the eye if it knows a matrix that leads there.
    pub space: Space,
}

impl Pair {
    /// Compiles the stages, makes the one that is not given, and joins them.
    ///
    /// # Errors
    /// If one does not compile, or takes what the other does not give.
    pub fn new(vertex: Option<&Shader<'_>>, fragment: Option<&Shader<'_>>) -> Result<Self, ShaderError> {
        let own_vertex = vertex.map(Shader::compile).transpose()?;
        let own_fragment = fragment.map(Shader::compile).transpose()?;
        let traced = vertex.or(fragment).is_some_and(Shader::is_traced);
        let source = |own: &Option<Program>| if own.is_some() { Source::Own } else { Source::StandIn };
        let (vertex_source, fragment_source) = (source(&own_vertex), source(&own_fragment));
        let fragment = match (own_fragment, &own_vertex) {
            (Some(own), _) => own,
            (None, Some(vertex)) => stand_in::fragment(vertex, traced)?,
            (None, None) => {
                let message = "a program needs a vertex shader, a fragment shader or both".to_owned();
                return Err(ShaderError::Invalid { message, place: None, hints: vec![] });
            }
        };
        let by_order = own_vertex.is_none() || fragment_source == Source::StandIn;
        let vertex = match own_vertex {
            Some(own) => own,
            None => stand_in::vertex(&fragment, traced)?,
        };
        let varyings = if by_order { in_order(&vertex, &fragment) } else { joined(&vertex, &fragment)? };
        let space = space(&vertex, &fragment);
        Ok(Self { vertex, fragment, vertex_source, fragment_source, varyings, space })
    }
}

/// The inputs of a fragment shader that vertices give.
fn taken(fragment: &Program) -> impl Iterator<Item = (usize, &Port)> {
    fragment.interface().inputs.iter().enumerate().filter(|(_, port)| !port.builtin)
}

fn varying((input, port): (usize, &Port), (output, given): (usize, &Port)) -> Varying {
    let interpolation = match (port.interpolation, given.interpolation) {
        (Interpolation::Perspective, other) => other,
        (own, _) => own,
    };
    Varying { input, output, components: port.ty.scalars(), interpolation }
}

/// What a stand-in was written for, in the order of the inputs.
fn in_order(vertex: &Program, fragment: &Program) -> Vec<Varying> {
    let output = |input: usize| {
        let name = format!("{}{input}", stand_in::PREFIX);
        vertex.interface().outputs.iter().enumerate().find(|(_, given)| given.name == name)
    };
    let shown = |input: usize| {
        // A stand-in for the fragment shader has one input: the colour.
        let color = stand_in::color_of(vertex)?;
        (fragment.interface().inputs[input].name == stand_in::COLOR).then_some(color)
    };
    taken(fragment)
        .filter_map(|(input, port)| {
            let given = output(input).or_else(|| shown(input))?;
            Some(varying((input, port), given))
        })
        .collect()
}

/// By name, or by location where both have one.
fn joined(vertex: &Program, fragment: &Program) -> Result<Vec<Varying>, ShaderError> {
    let given = || vertex.interface().outputs.iter().enumerate().filter(|(_, port)| !port.builtin);
    let mut all = Vec::new();
    for (input, port) in taken(fragment) {
        let same_place = |p: &Port| p.location.is_some() && p.location == port.location;
        let found =
            given().find(|(_, p)| p.name == port.name).or_else(|| given().find(|(_, p)| same_place(p)));
        match found {
            Some((output, other)) if other.ty == port.ty => {
                all.push(varying((input, port), (output, other)));
            }
            // Old varyings that nobody writes are 0.
            None if port.name.starts_with("gl_") => {}
            found => return Err(unfit(port, found.map(|(_, other)| other), vertex)),
        }
    }
    Ok(all)
}

fn unfit(port: &Port, other: Option<&Port>, vertex: &Program) -> ShaderError {
    let message = match other {
        Some(other) => format!(
            "'{}' is a {} in the vertex shader and a {} in the fragment shader",
            port.name, other.ty, port.ty
        ),
        None => {
            let names: Vec<_> = vertex.interface().outputs.iter().filter(|p| !p.builtin).collect();
            let hint = glanz_math::names::did_you_mean(&port.name, names.iter().map(|p| p.name.as_str()));
            format!("the fragment shader takes '{}', which the vertex shader does not give{hint}", port.name)
        }
    };
    ShaderError::Invalid { message, place: port.place.clone(), hints: vec![] }
}

/// See [`Pair::space`].
fn space(vertex: &Program, fragment: &Program) -> Space {
    let uniforms = || vertex.interface().uniforms.iter().chain(&fragment.interface().uniforms);
    let has = |roles: &[Role]| uniforms().any(|own| own.role.is_some_and(|role| roles.contains(&role)));
    if has(&[Role::EyePosition, Role::Model]) {
        return Space::World;
    }
    if has(&[Role::ModelView, Role::View]) { Space::Eye } else { Space::World }
}
