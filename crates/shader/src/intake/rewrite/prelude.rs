//! Functions of GLSL that the front end lacks, written in GLSL.

use super::Rewriter;
use crate::intake::source::Origin;

/// Name, and its definitions. They are added where the text uses the name and does not define it.
const FUNCTIONS: [(&str, &str); 4] = [
    (
        "modf",
        "float modf(float x, out float i) { i = trunc(x); return x - i; } \
         vec2 modf(vec2 x, out vec2 i) { i = trunc(x); return x - i; } \
         vec3 modf(vec3 x, out vec3 i) { i = trunc(x); return x - i; } \
         vec4 modf(vec4 x, out vec4 i) { i = trunc(x); return x - i; }",
    ),
    (
        "matrixCompMult",
        "mat2 matrixCompMult(mat2 a, mat2 b) { return mat2(a[0] * b[0], a[1] * b[1]); } \
         mat3 matrixCompMult(mat3 a, mat3 b) { return mat3(a[0] * b[0], a[1] * b[1], a[2] * b[2]); } \
         mat4 matrixCompMult(mat4 a, mat4 b) { return mat4(a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]); }",
    ),
    // What these give the lowering knows (`lower/textures/gather.rs`); the bodies stand for it elsewhere.
    (
        "textureGather",
        "vec4 glanz_textureGather(texture2D t, sampler s, vec2 p) { return textureLod(sampler2D(t, s), p, 0.0); } \
         vec4 glanz_textureGather(texture2D t, sampler s, vec2 p, int c) { return textureLod(sampler2D(t, s), p, 0.0); }",
    ),
    (
        "textureGatherOffset",
        "vec4 glanz_textureGatherOffset(texture2D t, sampler s, vec2 p, ivec2 o) { \
            return textureLod(sampler2D(t, s), p, 0.0); } \
         vec4 glanz_textureGatherOffset(texture2D t, sampler s, vec2 p, ivec2 o, int c) { \
            return textureLod(sampler2D(t, s), p, 0.0); }",
    ),
];

impl Rewriter {
    pub(super) fn prelude(&mut self) {
        for (name, text) in FUNCTIONS {
            if self.used.contains(name) && !self.functions.contains(name) {
                self.generated(text, Origin::default());
                // Samplers go to them in two halves, as to the user's own.
                if name.starts_with("texture") {
                    self.gathers.insert(name.to_owned());
                }
            }
        }
    }
}
