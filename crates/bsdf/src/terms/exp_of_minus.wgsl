// e to the power -x for x >= 0, exactly 0 from 2^-100 on: distribution.rs.
fn exp_of_minus(x: f32) -> f32 {
    return select(0.0, exp(-x), x < 69.3);
}
