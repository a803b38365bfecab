// Blinn's highlight. The numbers: the exponent.
fn blinn_phong_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let shininess = exponent_at(at);
    // Rounding may leave more than 1 for the mirror direction near the horizon.
    let cosine = min(pair_cos_half(pair), 1.0);
    let value = power(cosine, shininess) * INVERSE_PI;
    return select(0.0, value, 0.0 < pair.cos_i);
}
