// Exponents that a whole surface shares, and powers that are products: exponent.rs.

struct Exponent {
    n: f32,
    // n, if the power is a product of so many factors; 0 if not.
    factors: u32,
    // The base below which a product is 0.
    least: f32,
}

const EXPONENT_NUMBERS = 3u;

// That of `Exponent::numbers`.
fn exponent_at(at: u32) -> Exponent {
    return Exponent(number(at), u32(number(at + 1u)), number(at + 2u));
}

// x to the power of the exponent: see `real_pow`.
fn power(x: f32, exponent: Exponent) -> f32 {
    if exponent.factors == 0u {
        return real_pow(x, exponent.n);
    }
    return exponent_product(x, exponent);
}

// The product of the factors, at least one; 0 where it would be below the floor.
fn exponent_product(x: f32, exponent: Exponent) -> f32 {
    let base = select(0.0, x, exponent.least < x);
    // n = odd · 2^twos.
    let twos = countTrailingZeros(exponent.factors);
    let odd = exponent.factors >> twos;
    var product = base;
    // From the second highest bit of the odd part to the lowest.
    for (var bit = firstLeadingBit(odd); bit > 0u; bit -= 1u) {
        product = product * product;
        if ((odd >> (bit - 1u)) & 1u) == 1u {
            product = product * base;
        }
    }
    for (var i = 0u; i < twos; i += 1u) {
        product = product * product;
    }
    return product;
}
