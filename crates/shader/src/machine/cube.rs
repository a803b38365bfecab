//! Directions as places of pictures: the faces of a cube map, and panoramas.

use glanz_math::Real;

/// For each face of a cube, in OpenGL's order (+X, −X, +Y, −Y, +Z, −Z): the axes along s and t and through its middle, and
/// their signs (OpenGL 4.6, table 8.19).
const FACES: [[(usize, f32); 3]; 6] = [
    [(2, -1.0), (1, -1.0), (0, 1.0)],
    [(2, 1.0), (1, -1.0), (0, -1.0)],
    [(0, 1.0), (2, 1.0), (1, 1.0)],
    [(0, 1.0), (2, -1.0), (1, -1.0)],
    [(0, 1.0), (1, -1.0), (2, 1.0)],
    [(0, -1.0), (1, -1.0), (2, -1.0)],
];

/// Where a direction meets a cube around the origin, as OpenGL's cube maps have it.
///
/// ```
/// use glanz_shader::CubePlace;
///
/// let place = CubePlace::of([0.5, 1.0, -2.0]);
/// assert_eq!((place.face, place.uv), (5, [0.375, 0.25]));
/// assert_eq!(place.direction(), [0.25, 0.5, -1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubePlace {
    /// The face: 0 to 5 for +X, −X, +Y, −Y, +Z, −Z.
    pub face: usize,
    /// The place on it, 0 to 1: u to the right and v **downwards** as the picture of the face is seen from inside.
    pub uv: [f32; 2],
}

impl CubePlace {
    /// Where a direction of any length leads to; one that is 0 or no number, to the middle of the first face.
    pub fn of(direction: [f32; 3]) -> Self {
        let face = face(direction);
        let [s, t, middle] = FACES[face].map(|(axis, sign)| direction[axis] * sign);
        let part = |x: f32| {
            let part = 0.5 * (x / middle + 1.0);
            if part.is_nan() { 0.5 } else { part }
        };
        Self { face, uv: [part(s), part(t)] }
    }

    /// How `uv` changes, on the face where `direction` leads to, if the direction changes by `change`.
    pub fn change(direction: [f32; 3], change: [f32; 3]) -> [f32; 2] {
        let axes = FACES[face(direction)];
        let [s, t, middle] = axes.map(|(axis, sign)| direction[axis] * sign);
        let [ds, dt, d_middle] = axes.map(|(axis, sign)| change[axis] * sign);
        let part = |x: f32, dx: f32| 0.5 * (dx * middle - x * d_middle) / (middle * middle);
        [part(s, ds), part(t, dt)]
    }

    /// A direction that leads to the place; the greatest of its components is 1.
    pub fn direction(self) -> [f32; 3] {
        let mut direction = [0.0; 3];
        let lengths = [2.0 * self.uv[0] - 1.0, 2.0 * self.uv[1] - 1.0, 1.0];
        for ((axis, sign), length) in FACES[self.face.min(5)].into_iter().zip(lengths) {
            direction[axis] = sign * length;
        }
        direction
    }
}

fn face(direction: [f32; 3]) -> usize {
    let [x, y, z] = direction.map(f32::abs);
    let axis = if y > x && y >= z {
        1
    } else if z > x && z > y {
        2
    } else {
        0
    };
    2 * axis + usize::from(direction[axis] < 0.0)
}

/// Where a picture in equirectangular projection shows a direction of any length, 0 to 1: u once around to the right, −Z
/// in the middle and +X at ¾; v from straight up (+Y) to straight down. Of a direction that is 0, the upper edge.
pub fn panorama_place([x, y, z]: [f32; 3]) -> [f32; 2] {
    let length = Real::sqrt(x * x + y * y + z * z);
    if !(length > 0.0 && length.is_finite()) {
        return [0.5, 0.0];
    }
    let around = Real::atan2(x, -z) * (0.5 / core::f32::consts::PI) + 0.5;
    let down = Real::acos((y / length).clamp(-1.0, 1.0)) * (1.0 / core::f32::consts::PI);
    [around, down]
}

/// The angle that a direction turns by if it changes a little, in radians; 0 of a direction that is 0.
pub fn turned(direction: [f32; 3], change: [f32; 3]) -> f32 {
    let dot = |a: [f32; 3], b: [f32; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let square = dot(direction, direction);
    if !(square > 0.0 && square.is_finite()) {
        return 0.0;
    }
    let along = dot(direction, change) / square;
    let across: [f32; 3] = core::array::from_fn(|i| change[i] - along * direction[i]);
    Real::sqrt(dot(across, across) / square)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middles_and_corners_of_faces_are_those_of_opengl() {
        // Face, its middle, and the direction of its upper left corner.
        for (face, middle, corner) in [
            (0, [1.0, 0.0, 0.0], [1.0, 1.0, 1.0]),
            (1, [-1.0, 0.0, 0.0], [-1.0, 1.0, -1.0]),
            (2, [0.0, 1.0, 0.0], [-1.0, 1.0, -1.0]),
            (3, [0.0, -1.0, 0.0], [-1.0, -1.0, 1.0]),
            (4, [0.0, 0.0, 1.0], [-1.0, 1.0, 1.0]),
            (5, [0.0, 0.0, -1.0], [1.0, 1.0, -1.0]),
        ] {
            assert_eq!(CubePlace::of(middle), CubePlace { face, uv: [0.5; 2] });
            assert_eq!(CubePlace { face, uv: [0.0; 2] }.direction(), corner);
        }
        assert_eq!(CubePlace::of([0.0; 3]).uv, [0.5; 2]);
        assert_eq!(CubePlace::of([f32::NAN; 3]).uv, [0.5; 2]);
    }

    #[test]
    fn changes_are_differences() {
        let (direction, change) = ([0.3, -2.0, 0.7], [1e-3, 2e-3, -1e-3]);
        let moved = core::array::from_fn(|i| direction[i] + change[i]);
        let (before, after) = (CubePlace::of(direction), CubePlace::of(moved));
        for (i, change) in CubePlace::change(direction, change).into_iter().enumerate() {
            assert!((after.uv[i] - before.uv[i] - change).abs() < 2e-6);
        }
        assert!((turned([0.0, 2.0, 0.0], [0.1, 5.0, 0.0]) - 0.05).abs() < 1e-6);
    }

    #[test]
    fn panoramas_show_what_environment_maps_show() {
        for (direction, [u, v]) in [
            ([0.0, 0.0, -3.0], [0.5, 0.5]),
            ([2.0, 0.0, 0.0], [0.75, 0.5]),
            ([-1.0, 0.0, 0.0], [0.25, 0.5]),
            ([0.0, 1.0, -1e-9], [0.5, 0.0]),
            ([1.0, -1.0, 0.0], [0.75, 0.75]),
        ] {
            let place = panorama_place(direction);
            assert!((place[0] - u).abs() < 1e-5 && (place[1] - v).abs() < 1e-5, "{direction:?}: {place:?}");
        }
    }
}
