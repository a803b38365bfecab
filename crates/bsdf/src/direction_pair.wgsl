// The two directions that a lobe is evaluated for: direction_pair.rs.

struct DirectionPair {
    // n·wo, cosine of the view angle.
    cos_o: f32,
    // n·wi, cosine of the angle of incidence.
    cos_i: f32,
    // wo·wi.
    cos_io: f32,
    // |wo + wi|², of the half vector before it is normalised.
    half2: f32,
    // The tangential coordinates of wo and wi; zero where the model does not read them.
    tangent_o: vec2<f32>,
    tangent_i: vec2<f32>,
    // Multiplies the width of a microfacet distribution, 0 … 1.
    alpha_scale: f32,
}

// Below this |wo + wi|² is taken from the vectors.
const FROM_VECTORS: f32 = 0.25;

// The pair of two unit vectors in the local frame.
fn pair_new(wo: vec3<f32>, wi: vec3<f32>) -> DirectionPair {
    var pair = pair_between(wo.z, wo, wi.z, wi);
    pair.tangent_o = wo.xy;
    pair.tangent_i = wi.xy;
    return pair;
}

// The pair for models that do not read the tangent: the cosine to the normal of each of two unit vectors, and the vectors in
// any frame.
fn pair_between(cos_o: f32, wo: vec3<f32>, cos_i: f32, wi: vec3<f32>) -> DirectionPair {
    var pair = pair_isotropic(cos_o, cos_i, dot(wo, wi));
    let sum = wo + wi;
    pair.half2 = select(pair.half2, dot(sum, sum), pair.half2 < FROM_VECTORS);
    return pair;
}

// The pair from cosines alone.
fn pair_isotropic(cos_o: f32, cos_i: f32, cos_io: f32) -> DirectionPair {
    let half2 = (cos_io + 1.0) * 2.0;
    return DirectionPair(cos_o, cos_i, cos_io, half2, vec2<f32>(0.0), vec2<f32>(0.0), 1.0);
}

// R·wo, where R is wi mirrored about the normal.
fn pair_cos_mirror(pair: DirectionPair) -> f32 {
    let height = pair.cos_i * pair.cos_o;
    return height + height - pair.cos_io;
}

// wo·h, where h is the half vector.
fn pair_cos_view_half(pair: DirectionPair) -> f32 {
    return sqrt(clamp(pair.half2 * 0.25, 0.0, 1.0));
}

// n·h, where h is the half vector.
fn pair_cos_half(pair: DirectionPair) -> f32 {
    return (pair.cos_i + pair.cos_o) * inverseSqrt(max(pair.half2, 1e-12));
}
