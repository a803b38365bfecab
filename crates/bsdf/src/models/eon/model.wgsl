// The rough diffuse surface that conserves energy. The numbers: A/π, A r/π and M/π.

// What roughness takes from the albedo along the normal.
const EON_K1: f32 = 0.5 - 2.0 / (3.0 * 3.141592653589793);

fn eon_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let even = number(at);
    let rough = number(at + 1u);
    let multiple = number(at + 2u);
    let cos_i = max(pair.cos_i, 0.0);
    let cos_o = max(pair.cos_o, 0.0);
    let s = pair.cos_io - cos_i * cos_o;
    let behind = s / max(max(cos_i, cos_o), 1e-20);
    let single = even + rough * select(s, behind, 0.0 < s);
    return cos_i * (max(single, 0.0) + multiple * eon_single_loss(cos_o) * eon_single_loss(cos_i));
}

// g: 1 − E of the single scattering of a fully rough surface, up to a factor.
fn eon_single_loss(cosine: f32) -> f32 {
    let sine = sqrt(max(1.0 - sqr(cosine), 0.0));
    let cubes = sine * cosine * (1.0 + sine + sqr(sine)) / (1.0 + sine);
    let g = sine * (real_acos(cosine) - sine * cosine) + (2.0 / 3.0) * (cubes - sine);
    return max(EON_K1 - g * INVERSE_PI, 0.0);
}
