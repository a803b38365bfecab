// Ward's highlight. The numbers: those of the widths.
fn ward_f_cos(pair: DirectionPair, at: u32) -> f32 {
    let widths = widths_at(at);
    let height = height_squared(pair);
    let root = sqrt(max(pair.cos_i * pair.cos_o, 1e-30));
    // One division gives both reciprocals.
    let both = 1.0 / (height * root);
    let lobe = highlight_with(widths, pair, both * root);
    return above(pair, pair.cos_i * (both * height) * lobe.gauss * (0.25 * widths.height));
}
