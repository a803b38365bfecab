// The lights and the material of a scene, filled in, and @TITLE@ for each pixel.
// Places and directions are in the camera's space.

struct LightSource {
    posDir: vec4<f32>,              // a position if its w is 1, a direction towards the light if it is 0
    ambient: vec4<f32>,
    diffuse: vec4<f32>,
    specular: vec4<f32>,
    constantAttenuation: f32,
    linearAttenuation: f32,
    quadraticAttenuation: f32,
    spotDirection: vec3<f32>,
    spotCutoff: f32,                // in degrees; 180 of what is no spot
    spotExponent: f32,
}

struct Material {
    ambient: vec4<f32>,
    diffuse: vec4<f32>,
    specular: vec4<f32>,
    emission: vec4<f32>,
    shininess: f32,
}

struct Matrices {
    mvp: mat4x4<f32>,
    mv: mat4x4<f32>,
    normal_matrix: mat3x3<f32>,
}

struct VertexInput {
    @location(0) pos: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

struct VertexOutput {
    @builtin(position) clip: vec4<f32>,
    @location(0) eyePosition: vec3<f32>,
    @location(1) eyeNormal: vec3<f32>,
}

@group(0) @binding(0) var<uniform> matrices: Matrices;

@VALUES@
@vertex
fn vertex_main(in: VertexInput) -> VertexOutput {
    var out: VertexOutput;
    out.clip = matrices.mvp * vec4<f32>(in.pos, 1.0);
    out.eyePosition = (matrices.mv * vec4<f32>(in.pos, 1.0)).xyz;
    out.eyeNormal = matrices.normal_matrix * in.normal;
    return out;
}

fn highlight(L: vec3<f32>, V: vec3<f32>, N: vec3<f32>) -> f32 {
    if (dot(N, L) <= 0.0) {
        return 0.0;
    }
    return pow(max(dot(reflect(-L, N), V), 0.0), material.shininess);
}

@fragment
fn fragment_main(in: VertexOutput, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    let N = select(-1.0, 1.0, front) * normalize(in.eyeNormal);
    let V = -normalize(in.eyePosition);
    var ambient = vec4<f32>(0.0);
    var diffuse = vec4<f32>(0.0);
    var specular = vec4<f32>(0.0);
    for (var i = 0u; i < count; i++) {
        let light = source[i];
        var L = light.posDir.xyz;
        var factor = 1.0;
        var cone = 1.0;
        if (light.posDir.w != 0.0) {
            L = light.posDir.xyz - in.eyePosition;
            let d = length(L);
            L = L / d;
            factor = 1.0 / (light.constantAttenuation + light.linearAttenuation * d + light.quadraticAttenuation * d * d);
            if (light.spotCutoff != 180.0) {
                let spotDot = dot(-L, light.spotDirection);
                cone = select(0.0, pow(max(spotDot, 0.0), light.spotExponent), spotDot >= cos(radians(light.spotCutoff)));
                factor *= cone;
            }
        }
        ambient += light.ambient * cone;
        diffuse += light.diffuse * max(dot(N, L), 0.0) * factor;
        specular += light.specular * highlight(L, V, N) * factor;
    }
    let sum = material.ambient * ambient + material.diffuse * diffuse + material.specular * specular;
    return vec4<f32>(sum.rgb + material.emission.rgb, 1.0);
}
