// Cook and Torrance's reflection: V-grooves of mirrors, with Beckmann's slopes of one or two widths. The numbers: weight / (π m²)
// and 1/m² of each slope, and the weight of the second slope.
fn cook_torrance_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let half = half_vector(pair);
    let inverse = 1.0 / half.up2;
    let ratio = half.length2 * inverse;
    let tan2 = ratio - 1.0;
    var d = cook_torrance_term(tan2, number(at), number(at + 1u));
    if number(at + 4u) > 0.0 {
        d = d + cook_torrance_term(tan2, number(at + 2u), number(at + 3u));
    }
    return d * sqr(ratio) * cook_torrance_groove(pair, half.length2);
}

// The part of D of one slope, without 1/cos⁴θh.
fn cook_torrance_term(tan2: f32, scale: f32, steep: f32) -> f32 {
    return exp_of_minus(tan2 * steep) * scale;
}

// G / (4 cosθo) of the V-grooves, 0 where light or viewer is below: (n·h)/(wo·h) is 2 n·H / |H|².
fn cook_torrance_groove(pair: DirectionPair, length2: f32) -> f32 {
    let least = min(pair.cos_o, pair.cos_i);
    // The masked and shadowed fraction of a groove, over cosθo, and at most that of a facet alone.
    let edge = (pair.cos_o + pair.cos_i) * least / length2;
    let factor = min(edge, 0.25) / max(pair.cos_o, 1e-30);
    return select(0.0, factor, 0.0 < least);
}
