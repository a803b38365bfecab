//! Three-vectors and local frames over any [`Real`].

use core::ops::{Add, Mul, Neg, Sub};

use crate::Real;

/// A vector of three [`Real`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<R> {
    /// First coordinate.
    pub x: R,
    /// Second coordinate.
    pub y: R,
    /// Third coordinate; in a local frame the one along the normal.
    pub z: R,
}

impl<R> Vec3<R> {
    /// The vector of the three coordinates.
    #[inline(always)]
    pub const fn new(x: R, y: R, z: R) -> Self {
        Self { x, y, z }
    }
}

impl<R: Real> Vec3<R> {
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, other: Self) -> R {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
    /// Vector product.
    #[inline(always)]
    pub fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }
    /// The vector of length 1 along this one. A null vector gives infinities or NaN.
    #[inline(always)]
    pub fn normalized(self) -> Self {
        self * self.dot(self).rsqrt()
    }
    /// This direction mirrored about the unit vector `n`: both point away from the surface.
    #[inline(always)]
    pub fn reflected(self, n: Self) -> Self {
        let twice = self.dot(n) + self.dot(n);
        n * twice - self
    }
}

impl Vec3<f64> {
    /// The unit vector at polar angle `theta` from z and azimuth `phi` from x, both in radians.
    pub fn from_angles(theta: f64, phi: f64) -> Self {
        let (sin_theta, cos_theta) = libm::sincos(theta);
        let (sin_phi, cos_phi) = libm::sincos(phi);
        Self::new(sin_theta * cos_phi, sin_theta * sin_phi, cos_theta)
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<R: Real> Mul<R> for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: R) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl<R: Real> Neg for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

/// A right-handed orthonormal frame whose third axis is the surface normal.
#[derive(Clone, Copy, Debug)]
pub struct Frame<R> {
    /// The tangent.
    pub t: Vec3<R>,
    /// The bitangent, `n × t`.
    pub b: Vec3<R>,
    /// The normal.
    pub n: Vec3<R>,
}

impl<R: Real> Frame<R> {
    /// Some frame around the unit vector `n`, without a branch.
    ///
    /// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", JCGT 6(1).
    #[inline(always)]
    pub fn around(n: Vec3<R>) -> Self {
        let one = n.z.one();
        let sign = (-one).select(n.z.lt(n.z.zero()), one);
        let a = -one / (sign + n.z);
        let b = n.x * n.y * a;
        Self {
            t: Vec3::new(one + sign * n.x * n.x * a, sign * b, -(sign * n.x)),
            b: Vec3::new(b, sign + n.y * n.y * a, -n.y),
            n,
        }
    }
    /// The coordinates in this frame of a vector given in world coordinates.
    #[inline(always)]
    pub fn to_local(&self, v: Vec3<R>) -> Vec3<R> {
        Vec3::new(v.dot(self.t), v.dot(self.b), v.dot(self.n))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_frame_is_orthonormal_and_right_handed_around_any_normal() {
        for i in 0..50 {
            for j in 0..50 {
                let n = Vec3::from_angles(i as f64 * 0.0641, j as f64 * 0.1257);
                let frame = Frame::around(n);
                assert!(frame.t.dot(frame.b).abs() < 1e-12);
                assert!(frame.t.dot(n).abs() < 1e-12);
                assert!((frame.t.dot(frame.t) - 1.0).abs() < 1e-12);
                let handed = frame.t.cross(frame.b) - n;
                assert!(handed.dot(handed) < 1e-20);
            }
        }
    }

    #[test]
    fn reflection_keeps_the_angle_to_the_normal() {
        let n = Vec3::from_angles(0.3, 1.0);
        let l = Vec3::from_angles(1.1, 2.0);
        let r = l.reflected(n);
        assert!((r.dot(n) - l.dot(n)).abs() < 1e-12);
        assert!((r.dot(r) - 1.0).abs() < 1e-12);
    }
}
