// GGX reflection with Smith's masking and shadowing, and multiple-scattering compensation. The numbers: (αx², αy²) and their
// inverses, the scale, the least factor of the widths, the weight of the compensation, the compensation.
fn ggx_f_cos(pair: DirectionPair, at: u32) -> f32 {
    var value = ggx_single(pair, at);
    let multiscatter = number(at + 2u * AXES_NUMBERS + 2u);
    if multiscatter > 0.0 {
        let compensation = compensation_at(at + 2u * AXES_NUMBERS + 3u);
        value = value + compensation_f_cos(compensation, pair);
    }
    return select(0.0, value, (0.0 < pair.cos_o) & (0.0 < pair.cos_i));
}

// D · G2 / (4 cosθo) for light and viewer above.
fn ggx_single(pair: DirectionPair, at: u32) -> f32 {
    let squares = axes_at(at);
    let inverse2 = axes_at(at + AXES_NUMBERS);
    let scale = number(at + 2u * AXES_NUMBERS);
    let least_scale = number(at + 2u * AXES_NUMBERS + 1u);
    let half = half_vector(pair);
    let scale2 = sqr(max(pair.alpha_scale, least_scale));
    let d = ggx_d_unscaled(half, pair, inverse2, scale2);
    let g2 = ggx_g2(pair, squares, scale2);
    return d * scale * g2.x / max(g2.y, 1e-30);
}
