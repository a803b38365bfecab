// Lambert's law.
fn lambert_f_cos(pair: DirectionPair, at: u32) -> f32 {
    return max(pair.cos_i, 0.0) * INVERSE_PI;
}
