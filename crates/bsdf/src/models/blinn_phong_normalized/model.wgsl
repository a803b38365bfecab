// Blinn's lobe scaled so that it keeps its energy at normal incidence. The numbers: the exponent, the scale.
fn blinn_phong_normalized_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let shininess = exponent_at(at);
    let scale = number(at + EXPONENT_NUMBERS);
    // Rounding may leave more than 1 for the mirror direction near the horizon.
    let cosine = min(pair_cos_half(pair), 1.0);
    let value = power(cosine, shininess) * pair.cos_i * scale;
    return select(0.0, value, 0.0 < pair.cos_i);
}
