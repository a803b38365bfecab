//! Linearly transformed cosines of a lobe, over the view angle.

use glanz_math::Real;

/// View angles: cosθ = 1 − (i / (ANGLES − 1))².
pub const ANGLES: usize = 32;

/// The maps of an isotropic lobe over the view angle.
#[derive(Clone, Debug, PartialEq)]
pub struct LtcTable {
    /// The inverse map is \[\[a, 0, b\], \[0, c, 0\], \[d, 0, e\]\] in the frame whose x axis is the viewer's
    /// tangential direction.
    pub inverses: Vec<[f32; 5]>,
}

impl LtcTable {
    /// The inverse map at a view angle: a, b, c, d, e.
    #[inline(always)]
    pub fn at<R: Real>(&self, cos_o: R) -> [R; 5] {
        let last = (ANGLES - 1) as f64;
        let place = ((cos_o.one() - cos_o).clamp(0.0, 1.0).sqrt() * cos_o.lit(last)).to_array();
        let mut values = [[0.0; 16]; 5];
        for lane in 0..R::LANES {
            let first = (place[lane] as usize).min(ANGLES - 2);
            let t = place[lane] - first as f32;
            let (a, b) = (&self.inverses[first], &self.inverses[first + 1]);
            for (i, array) in values.iter_mut().enumerate() {
                array[lane] = a[i] + (b[i] - a[i]) * t;
            }
        }
        // Not `map`, which would be a call below a SIMD dispatch.
        let [a, b, c, d, e] = &values;
        [
            cos_o.with_array(a),
            cos_o.with_array(b),
            cos_o.with_array(c),
            cos_o.with_array(d),
            cos_o.with_array(e),
        ]
    }
}
