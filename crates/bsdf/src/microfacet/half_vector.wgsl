// The half vector of a pair, unnormalised, as the numbers that distributions of slopes use: half_vector.rs.

// H = wo + wi.
struct HalfVector {
    // (n·H)², at least 1e-12.
    up2: f32,
    // |H|², at least up2.
    length2: f32,
}

// What there is for the width along the tangent and for that along the bitangent. Where both are equal, which single precision
// may not tell, the tangent is not read.
struct Axes {
    x: f32,
    y: f32,
    equal: bool,
}

const AXES_NUMBERS = 3u;

fn axes_at(at: u32) -> Axes {
    return Axes(number(at), number(at + 1u), number(at + 2u) == 1.0);
}

fn half_vector(pair: DirectionPair) -> HalfVector {
    let up2 = max(sqr(pair.cos_o + pair.cos_i), 1e-12);
    return HalfVector(up2, max(pair.half2, up2));
}

// The tangential part of H in parts of the widths, squared. `inverse2` is (1/αx², 1/αy²).
fn across2(half: HalfVector, pair: DirectionPair, inverse2: Axes) -> f32 {
    if inverse2.equal {
        return (half.length2 - half.up2) * inverse2.x;
    }
    let sum = pair.tangent_o + pair.tangent_i;
    return sqr(sum.x) * inverse2.x + sqr(sum.y) * inverse2.y;
}

// α² sin²θ of a direction for the width along it: αx² x² + αy² y². `squares` is (αx², αy²).
fn stretched2(cosine: f32, tangent: vec2<f32>, squares: Axes) -> f32 {
    if squares.equal {
        return max(1.0 - sqr(cosine), 0.0) * squares.x;
    }
    return sqr(tangent.x) * squares.x + sqr(tangent.y) * squares.y;
}
