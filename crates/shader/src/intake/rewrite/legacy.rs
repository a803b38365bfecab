//! Names of the fixed pipeline and of Shadertoy, which are declared where they are used.

use super::Rewriter;
use crate::Stage;
use crate::intake::items::Item;
use crate::intake::source::Origin;
use crate::lower::Purpose;

/// Which variable a name of the host's is.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Uniform,
    /// Comes from the mesh.
    Attribute,
    /// Goes from the vertex to the fragment stage.
    Varying,
    /// What the stage gives.
    Output,
}

/// Name, type, array size or initial value, what it is.
const NAMES: [(&str, &str, &str, Side); 27] = [
    (
        "gl_DepthRange",
        "glanz_DepthRangeParameters",
        " = glanz_DepthRangeParameters(0.0, 1.0, 1.0)",
        Side::Uniform,
    ),
    ("gl_Vertex", "vec4", "", Side::Attribute),
    ("gl_Normal", "vec3", "", Side::Attribute),
    ("gl_MultiTexCoord0", "vec4", "", Side::Attribute),
    ("gl_MultiTexCoord1", "vec4", "", Side::Attribute),
    ("gl_FrontColor", "vec4", "", Side::Varying),
    ("gl_TexCoord", "vec4", "[8]", Side::Varying),
    ("gl_FragColor", "vec4", "", Side::Output),
    ("gl_FragData", "vec4", "[8]", Side::Output),
    ("gl_ModelViewProjectionMatrix", "mat4", "", Side::Uniform),
    ("gl_ModelViewMatrix", "mat4", "", Side::Uniform),
    ("gl_ProjectionMatrix", "mat4", "", Side::Uniform),
    ("gl_NormalMatrix", "mat3", "", Side::Uniform),
    ("gl_LightSource", "glanz_Light", "[8]", Side::Uniform),
    ("gl_FrontMaterial", "glanz_Material", "", Side::Uniform),
    ("gl_LightModel", "glanz_LightModel", "", Side::Uniform),
    ("iResolution", "vec3", "", Side::Uniform),
    ("iTime", "float", "", Side::Uniform),
    ("iTimeDelta", "float", "", Side::Uniform),
    ("iFrameRate", "float", "", Side::Uniform),
    ("iFrame", "int", "", Side::Uniform),
    ("iMouse", "vec4", "", Side::Uniform),
    ("iDate", "vec4", "", Side::Uniform),
    ("iSampleRate", "float", "", Side::Uniform),
    ("iChannelTime", "float", "[4]", Side::Uniform),
    ("iChannelResolution", "vec3", "[4]", Side::Uniform),
    ("iGlobalTime", "float", "", Side::Uniform),
];

/// The structs that some of them have.
const STRUCTS: [(&str, &str); 4] = [
    (
        "glanz_DepthRangeParameters",
        "struct glanz_DepthRangeParameters { float near; float far; float diff; };",
    ),
    (
        "glanz_Light",
        "struct glanz_Light { vec4 ambient; vec4 diffuse; vec4 specular; vec4 position; vec4 halfVector; \
         vec3 spotDirection; float spotExponent; float spotCutoff; float spotCosCutoff; float constantAttenuation; \
         float linearAttenuation; float quadraticAttenuation; };",
    ),
    (
        "glanz_Material",
        "struct glanz_Material { vec4 emission; vec4 ambient; vec4 diffuse; vec4 specular; float shininess; };",
    ),
    ("glanz_LightModel", "struct glanz_LightModel { vec4 ambient; };"),
];

/// What functions of old versions are called since GLSL 1.30.
pub(super) fn modern_function(name: &str) -> Option<&'static str> {
    Some(match name {
        "texture1D" | "texture2D" | "texture3D" | "textureCube" | "shadow1D" | "shadow2D" => "texture",
        "texture2DLod" | "textureCubeLod" | "texture2DLodEXT" | "textureCubeLodEXT" => "textureLod",
        "texture2DProj" | "texture2DProjEXT" => "textureProj",
        "texture2DGradEXT" | "textureCubeGradEXT" | "texture2DGradARB" => "textureGrad",
        _ => return None,
    })
}

/// The name under which a name with the reserved prefix is declared.
fn own_name(name: &str) -> String {
    name.strip_prefix("gl_").map_or_else(|| name.to_owned(), |rest| format!("glanz_{rest}"))
}

impl Rewriter {
    /// Declares what the text uses of [`NAMES`] and does not declare itself.
    pub(super) fn legacy_declarations(&mut self, items: &[Item]) {
        let declared = |wanted: &str| {
            items.iter().any(|item| match item {
                Item::Variables { variables, .. } => variables.iter().any(|v| v.name.is(wanted)),
                Item::Block { members, .. } => {
                    members.iter().any(|m| m.declarators.iter().any(|d| d.name.is(wanted)))
                }
                _ => false,
            })
        };
        let is_toy = self.is_toy || self.functions.contains("mainImage");
        let vertex = self.stage == Stage::Vertex;
        if vertex && self.used.contains("ftransform") {
            for name in ["gl_Vertex", "gl_ModelViewProjectionMatrix"] {
                self.used.insert(name.to_owned());
            }
        }
        for (name, ty, dimensions, side) in NAMES {
            let wanted = self.used.contains(name) && !declared(name);
            if !wanted || side == Side::Uniform && !name.starts_with("gl_") && !is_toy {
                continue;
            }
            if let Some((_, text)) = STRUCTS.iter().find(|(name, _)| *name == ty) {
                self.generated(text, Origin::default());
            }
            self.declare(ty, &own_name(name), dimensions, Origin::default());
            let role = match (side, vertex) {
                (Side::Uniform, _) => Purpose::Uniform(name.to_owned()),
                (Side::Attribute, _) | (Side::Varying, false) => Purpose::Input(name.to_owned()),
                (Side::Varying, true) | (Side::Output, _) => Purpose::Output(name.to_owned()),
            };
            self.given.roles.insert(own_name(name), role);
        }
        if self.used.contains("gl_Color") {
            self.declare("vec4", "glanz_Color", "", Origin::default());
            self.given.roles.insert("glanz_Color".to_owned(), Purpose::Input("gl_Color".to_owned()));
        }
        if vertex && self.used.contains("ftransform") {
            let text = "vec4 glanz_ftransform() { return glanz_ModelViewProjectionMatrix * glanz_Vertex; }";
            self.generated(text, Origin::default());
        }
        if is_toy {
            self.channels(&declared);
        }
    }

    /// Shadertoy's textures.
    fn channels(&mut self, declared: &dyn Fn(&str) -> bool) {
        for channel in ["iChannel0", "iChannel1", "iChannel2", "iChannel3"] {
            if self.used.contains(channel) && !declared(channel) {
                self.declare_sampler("sampler2D", channel, Origin::default());
            }
        }
    }

    /// `type name[dimensions];`
    pub(super) fn declare(&mut self, ty: &str, name: &str, dimensions: &str, origin: Origin) {
        self.generated(&format!("{ty} {name}{dimensions};"), origin);
    }

    /// What stands in the output for a name of the pipeline.
    pub(super) fn legacy_name(&self, name: &str) -> Option<String> {
        Some(match name {
            "gl_VertexID" => "int(gl_VertexIndex)".to_owned(),
            "gl_InstanceID" => "int(gl_InstanceIndex)".to_owned(),
            "gl_PrimitiveID" => "int(gl_PrimitiveID)".to_owned(),
            "gl_Color" => "glanz_Color".to_owned(),
            "ftransform" => "glanz_ftransform".to_owned(),
            _ if name.starts_with("gl_") && NAMES.iter().any(|n| n.0 == name) => own_name(name),
            _ => return None,
        })
    }
}
