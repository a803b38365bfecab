// GGX without multiple scattering, the model 'ggx' of glanz with multiscatter = 0: D · G2 / (4 cosθi cosθo), as one function.
@group(0) @binding(0) var<uniform> alpha: f32;

fn ggx(L: vec3<f32>, V: vec3<f32>, N: vec3<f32>) -> f32 {
    let i = dot(N, L);
    let o = dot(N, V);
    if (i <= 0.0 || o <= 0.0) {
        return 0.0;
    }
    let h = normalize(L + V);
    let a2 = alpha * alpha;
    // sin²θh from the cross product, which keeps its digits at the peak where 1 − cos² has none.
    let across = cross(N, h);
    let z = dot(N, h);
    let t = dot(across, across) + a2 * z * z;
    let d = a2 / (3.14159265 * t * t);
    let shadowing = o * sqrt(a2 + (1.0 - a2) * i * i) + i * sqrt(a2 + (1.0 - a2) * o * o);
    // G2 = 2 i o / shadowing, and i o of it cancels with 4 i o.
    return d * 0.5 / shadowing;
}
