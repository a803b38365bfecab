//! Matrices from XYZ to cones, and the adaptation of von Kries that they give.

use crate::algebra::Matrix3;

/// XYZ to the sharpened cones of Bradford (Lam 1985, as in ICC profiles version 4 and Lindbloom 2017).
pub const BRADFORD: Matrix3 =
    Matrix3([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]]);

/// XYZ to the cones of CAT16 (Li, Li, Wang, Zu, Luo, Cui, Melgosa, Brill, Pointer 2017).
pub const CAT16: Matrix3 = Matrix3([
    [0.401_288, 0.650_173, -0.051_461],
    [-0.250_268, 1.204_414, 0.045_854],
    [-0.002_079, 0.048_952, 0.953_127],
]);

/// XYZ to the cones of Hunt, Pointer and Estevez, scaled so that D65 gives 1, 1, 1 to the digits of the
/// table (Hunt 1991; Fairchild 2013, eq. 9.2).
pub const HUNT_POINTER_ESTEVEZ_D65: Matrix3 =
    Matrix3([[0.400_24, 0.707_60, -0.080_81], [-0.226_30, 1.165_32, 0.045_70], [0.0, 0.0, 0.918_22]]);

/// The matrix that takes XYZ under the white `from` to XYZ under the white `to`, for any cones and whites that are
/// known to be positive; at compile time too.
pub(crate) const fn adaptation_matrix(cones: &Matrix3, from: [f64; 3], to: [f64; 3]) -> Matrix3 {
    let from = cones.apply(from);
    let to = cones.apply(to);
    let scale = Matrix3::diagonal([to[0] / from[0], to[1] / from[1], to[2] / from[2]]);
    cones.inverse().times(&scale.times(cones))
}
