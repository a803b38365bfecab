// D and G2 of GGX surfaces in the form in which they are evaluated per pixel: distribution.rs.

// q² w² with q = |H|² / ((Hx/αx)² + (Hy/αy)² + w² Hz²), where w widens. D without 1/(π αx αy).
fn ggx_d_unscaled(half: HalfVector, pair: DirectionPair, inverse2: Axes, w2: f32) -> f32 {
    let q = half.length2 / (across2(half, pair, inverse2) + half.up2 * w2);
    return sqr(q) * w2;
}

// G2 / cosθo as a numerator and a denominator, without the factor 2. G2 / (4 cosθo cosθi) is 1 / (2 (cosθi Lo + cosθo Li)) with
// L = √(cos² + w² α² sin²).
fn ggx_g2(pair: DirectionPair, squares: Axes, w2: f32) -> vec2<f32> {
    let lo = sqrt(sqr(pair.cos_o) + w2 * stretched2(pair.cos_o, pair.tangent_o, squares));
    let li = sqrt(sqr(pair.cos_i) + w2 * stretched2(pair.cos_i, pair.tangent_i, squares));
    return vec2<f32>(pair.cos_i, pair.cos_i * lo + pair.cos_o * li);
}
