// The Phong lobe scaled so that it keeps its energy. The numbers: the exponent, (n+2)/(2π).
fn phong_normalized_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let shininess = exponent_at(at);
    let scale = number(at + EXPONENT_NUMBERS);
    // Below 0 it counts as 0.
    let cosine = pair_cos_mirror(pair);
    let value = power(cosine, shininess) * pair.cos_i * scale;
    return select(0.0, value, 0.0 < pair.cos_i);
}
