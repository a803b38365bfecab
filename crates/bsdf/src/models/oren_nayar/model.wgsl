// Oren and Nayar's rough diffuse surface with interreflection. The numbers: C1, and what C2, C3 and L2 have in σ.
fn oren_nayar_f_cos(pair: DirectionPair, at: u32) -> f32 {
    // Keeps quotients of vanishing sines and cosines finite; what they multiply vanishes faster.
    let nothing = 1e-20;
    let c1 = number(at);
    let c2 = number(at + 1u);
    let c3 = number(at + 2u);
    let l2 = number(at + 3u);
    let cos_i = max(pair.cos_i, 0.0);
    let cos_o = max(pair.cos_o, 0.0);
    let cos_a = min(cos_i, cos_o);
    let cos_b = max(cos_i, cos_o);
    let sin_a = sqrt(max(1.0 - sqr(cos_a), 0.0));
    let sin_b = sqrt(max(1.0 - sqr(cos_b), 0.0));
    // sinα sinβ cosφ.
    let s = pair.cos_io - cos_i * cos_o;
    let cos_phi = clamp(s / max(sin_a * sin_b, nothing), -1.0, 1.0);
    let a = real_acos(cos_a) * (2.0 / 3.141592653589793);
    let b = real_acos(cos_b) * (2.0 / 3.141592653589793);
    let forward = min(cos_phi, 0.0) * sin_b * (sqr(b) * b);
    let grooves = c2 * (s - forward) / max(cos_b, nothing);
    let sides = (1.0 - abs(cos_phi)) * c3 * sqr(a * b) * (sin_a + sin_b) / max(cos_a + cos_b, nothing);
    let between = l2 * (1.0 - cos_phi * sqr(b));
    return cos_i * INVERSE_PI * max(c1 + grooves + sides + between, 0.0);
}
