// Phong 1975 for each pixel, in WGSL, with one light.

struct VertexInput {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

struct VertexOutput {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
}

struct Material {
    ambient: vec3<f32>,
    diffuse: vec3<f32>,
    specular: vec3<f32>,
    shininess: f32,
}

struct Light {
    position: vec3<f32>,
    ambient: vec3<f32>,
    diffuse: vec3<f32>,
    specular: vec3<f32>,
}

@group(0) @binding(0) var<uniform> mvp: mat4x4<f32>;
@group(0) @binding(1) var<uniform> model: mat4x4<f32>;
@group(0) @binding(2) var<uniform> normalMatrix: mat3x3<f32>;
@group(0) @binding(3) var<uniform> eyePos: vec3<f32>;
@group(0) @binding(4) var<uniform> light: Light;
@group(0) @binding(5) var<uniform> material: Material;

@vertex
fn vertex_main(in: VertexInput) -> VertexOutput {
    var out: VertexOutput;
    out.clip = mvp * vec4<f32>(in.position, 1.0);
    out.position = (model * vec4<f32>(in.position, 1.0)).xyz;
    out.normal = normalMatrix * in.normal;
    return out;
}

@fragment
fn fragment_main(in: VertexOutput) -> @location(0) vec4<f32> {
    let n = normalize(in.normal);
    let l = normalize(light.position - in.position);
    let v = normalize(eyePos - in.position);
    let cosine = dot(n, l);
    var sum = material.ambient * light.ambient + material.diffuse * light.diffuse * max(cosine, 0.0);
    if (cosine > 0.0) {
        let r = reflect(-l, n);
        sum += material.specular * light.specular * pow(max(dot(r, v), 0.0), material.shininess);
    }
    return vec4<f32>(sum, 1.0);
}
