// Numbers: what real.rs and poly.rs add to the functions of WGSL.
//
// A twin's `log2`, `exp2` and `exp` are WGSL's own. On the machine of glanz-shader they are those of `Real`, bit by bit.

const INVERSE_PI: f32 = 1.0 / 3.141592653589793;

// The least normal number.
const TINY: f32 = 1.1754943508222875e-38;

// Powers below 2^-100 are exactly zero.
const POW_FLOOR_LOG2: f32 = -100.0;

// x times itself.
fn sqr(x: f32) -> f32 {
    return x * x;
}

// x to the power n, for a base of up to 1 or a little above it and n >= 0; a base below 0 counts as 0. 0^0 is 1.
fn real_pow(x: f32, n: f32) -> f32 {
    let exponent = log2(max(x, TINY)) * n;
    return select(0.0, exp2(min(exponent, 127.0)), POW_FLOOR_LOG2 < exponent);
}

// The angle in radians whose cosine x is: M. Abramowitz and I. Stegun 1964, 4.4.46, within 3e-7. WGSL asks no more of its own
// `acos` than 7e-5.
fn real_acos(x: f32) -> f32 {
    let size = min(abs(x), 1.0);
    var sum = -0.0012624911;
    sum = sum * size + 0.0066700901;
    sum = sum * size + -0.0170881256;
    sum = sum * size + 0.0308918810;
    sum = sum * size + -0.0501743046;
    sum = sum * size + 0.0889789874;
    sum = sum * size + -0.2145988016;
    sum = sum * size + 1.5707963050;
    let angle = sqrt(1.0 - size) * sum;
    return select(angle, 3.141592653589793 - angle, x < 0.0);
}
