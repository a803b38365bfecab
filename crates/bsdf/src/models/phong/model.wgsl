// Phong's highlight as he published it. The numbers: the exponent.
fn phong_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let shininess = exponent_at(at);
    // Below 0 it counts as 0.
    let cosine = pair_cos_mirror(pair);
    let value = power(cosine, shininess) * INVERSE_PI;
    return select(0.0, value, 0.0 < pair.cos_i);
}
