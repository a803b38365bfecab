// Multiple-scattering compensation of GGX surfaces: compensation.rs, where the numbers come from.

const COMPENSATION_TERMS = 7u;

// pₖ of an isotropic GGX surface as polynomials in α, lowest power first.
const GGX_P0 = array<f32, 6>(-7.3287927e-08, -0.000253404659, -2.14054226, -0.319312619, 5.85471844, -3.57643332);
const GGX_P1 = array<f32, 6>(-6.24737662e-05, 1.33244929, 7.45090315, 35.441814, -60.0, 23.1072418);
const GGX_P2 = array<f32, 6>(0.0132322842, -2.52562619, 4.02259811, -60.0, 59.4590532, -5.63388137);
const GGX_P3 = array<f32, 6>(0.0269279474, -4.20427331, -40.8543623, -13.7401741, 60.0, -60.0);
const GGX_P4 = array<f32, 6>(9.00209102, 32.5369887, 60.0, 60.0, -30.2694241, 40.9445698);
const GGX_P5 = array<f32, 6>(-16.2354059, -60.0, -0.651039119, -60.0, -60.0, 13.1108136);
const GGX_P6 = array<f32, 6>(7.55169252, 33.1832102, -21.132786, 32.2616261, 26.8632417, -8.43317318);

// The lobe of a surface.
struct Compensation {
    isotropic: bool,
    // c α where the width along the direction is α; the width itself is a factor where it is not everywhere the same.
    center: f32,
    // What is taken off 1 − x before its powers.
    origin: f32,
    // What is taken off the series.
    less: f32,
    // weight / (π (1 − Eavg)), and weight / π.
    scale: f32,
    weight_per_pi: f32,
    // αx², αy² and √(αx αy).
    squares: vec2<f32>,
    mean: f32,
    // Where the numbers of pₖ begin; behind them are those that go with the cosine of twice the azimuth.
    series: u32,
}

// That of `Compensation::numbers`.
fn compensation_at(at: u32) -> Compensation {
    return Compensation(
        number(at) == 1.0,
        number(at + 1u),
        number(at + 2u),
        number(at + 3u),
        number(at + 4u),
        number(at + 5u),
        vec2<f32>(number(at + 6u), number(at + 7u)),
        number(at + 8u),
        at + 9u,
    );
}

// The lobe's f_cos, for light and viewer above.
fn compensation_f_cos(lobe: Compensation, pair: DirectionPair) -> f32 {
    if pair.alpha_scale < 1.0 {
        return compensation_widened(lobe, pair, pair.alpha_scale);
    }
    let known = compensation_missing(lobe, pair.cos_o, pair.tangent_o)
        * compensation_missing(lobe, pair.cos_i, pair.tangent_i);
    return known * pair.cos_i * lobe.scale;
}

// 1 − E towards one direction.
fn compensation_missing(lobe: Compensation, cosine_or_less: f32, tangent: vec2<f32>) -> f32 {
    let cosine = max(cosine_or_less, 0.0);
    if lobe.isotropic {
        let center = lobe.center;
        let q = 1.0 / (cosine + center);
        let sum = compensation_series(lobe, center * q - lobe.origin);
        return max(cosine * q * sum - lobe.less, 0.0);
    }
    let along = compensation_along(lobe, tangent);
    let center = lobe.center * along.x;
    let q = 1.0 / (cosine + center);
    let sum = compensation_series_along(lobe, along.y, center * q - lobe.origin);
    return max(cosine * q * sum - lobe.less, 0.0);
}

// The width along a direction, and the cosine of twice its azimuth.
fn compensation_along(lobe: Compensation, tangent: vec2<f32>) -> vec2<f32> {
    // Along the normal there is no azimuth: the floor makes it a mean of both axes.
    let x2 = sqr(tangent.x) + 1e-12;
    let y2 = sqr(tangent.y) + 1e-12;
    let q = 1.0 / (x2 + y2);
    let width = sqrt((x2 * lobe.squares.x + y2 * lobe.squares.y) * q);
    return vec2<f32>(width, (x2 - y2) * q);
}

// Σ pₖ yᵏ.
fn compensation_series(lobe: Compensation, y: f32) -> f32 {
    var sum = number(lobe.series + COMPENSATION_TERMS - 1u);
    for (var k = COMPENSATION_TERMS - 1u; k > 0u; k -= 1u) {
        sum = sum * y + number(lobe.series + k - 1u);
    }
    return sum;
}

// The same of an anisotropic surface, with the cosine of twice the azimuth.
fn compensation_series_along(lobe: Compensation, twice: f32, y: f32) -> f32 {
    var sum = compensation_term_along(lobe, twice, COMPENSATION_TERMS - 1u);
    for (var k = COMPENSATION_TERMS - 1u; k > 0u; k -= 1u) {
        sum = sum * y + compensation_term_along(lobe, twice, k - 1u);
    }
    return sum;
}

fn compensation_term_along(lobe: Compensation, twice: f32, k: u32) -> f32 {
    return number(lobe.series + k) + twice * number(lobe.series + COMPENSATION_TERMS + k);
}

// The f_cos of a surface whose widths are multiplied by w.
fn compensation_widened(lobe: Compensation, pair: DirectionPair, w: f32) -> f32 {
    let mean = clamp(w * lobe.mean, 1e-3, 1.0);
    let c = 1.8 + -1.3 * mean;
    let terms = array<f32, 7>(
        ggx_polynomial(GGX_P0, mean),
        ggx_polynomial(GGX_P1, mean),
        ggx_polynomial(GGX_P2, mean),
        ggx_polynomial(GGX_P3, mean),
        ggx_polynomial(GGX_P4, mean),
        ggx_polynomial(GGX_P5, mean),
        ggx_polynomial(GGX_P6, mean),
    );
    let average = ggx_average(sqrt(mean)) * sqr(mean);
    let both = compensation_widened_missing(lobe, terms, c, w, mean, pair.cos_o, pair.tangent_o)
        * compensation_widened_missing(lobe, terms, c, w, mean, pair.cos_i, pair.tangent_i);
    return both * pair.cos_i * lobe.weight_per_pi / average;
}

// 1 − E of the widened surface towards one direction.
fn compensation_widened_missing(
    lobe: Compensation,
    terms: array<f32, 7>,
    c: f32,
    w: f32,
    mean: f32,
    cosine_or_less: f32,
    tangent: vec2<f32>,
) -> f32 {
    let cosine = max(cosine_or_less, 0.0);
    var width = mean;
    if !lobe.isotropic {
        width = compensation_along(lobe, tangent).x * w;
    }
    let center = c * max(width, 1e-3);
    let q = 1.0 / (cosine + center);
    let y = center * q;
    let high = ((terms[6] * y + terms[5]) * y + terms[4]) * y + terms[3];
    let sum = ((high * y + terms[2]) * y + terms[1]) * y + terms[0];
    return max(cosine * q * sum, 0.0);
}

fn ggx_polynomial(c: array<f32, 6>, x: f32) -> f32 {
    return ((((c[5] * x + c[4]) * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0];
}

// (1 − Eavg) / α² of the series, a polynomial in √α.
fn ggx_average(x: f32) -> f32 {
    return (((-0.640273 * x + -0.700107) * x + 6.237659) * x + -9.513936) * x + 5.205616;
}
