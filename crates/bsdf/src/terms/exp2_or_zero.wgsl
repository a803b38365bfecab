// 2 to the power `exponent`, and exactly 0 below 2^-100: exp2_or_zero.rs.
fn exp2_or_zero(exponent: f32) -> f32 {
    return select(0.0, exp2(exponent), POW_FLOOR_LOG2 < exponent);
}
