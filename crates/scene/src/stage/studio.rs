//! An environment map made in code: walls, windows and a lit screen, for mirrors to reflect.

use glam::DVec3;

use crate::EnvironmentMap;

/// Columns of the picture; half as many rows. A ball shows all of it, in a picture of a few hundred pixels.
const WIDTH: usize = 512;
/// Linear RGB of the walls at the ceiling, at eye level and at the floor's edge.
const CEILING: [f64; 3] = [0.5, 0.52, 0.56];
const WALL: [f64; 3] = [0.34, 0.34, 0.35];
/// The floor at the horizon; it is brighter below.
const FLOOR: [f64; 3] = [0.2, 0.185, 0.17];
/// Daylight in the window.
const WINDOW: [f64; 3] = [5.0, 5.3, 5.8];
/// The screen, in warm light.
const SCREEN: [f64; 3] = [2.6, 2.3, 1.9];

/// A rectangle on the sphere of directions, in degrees: azimuth from +Z to +X, and height.
struct Patch {
    azimuth: [f64; 2],
    height: [f64; 2],
}

/// On the upper left behind the viewer.
const WINDOW_AT: Patch = Patch { azimuth: [-62.0, -24.0], height: [22.0, 62.0] };
/// On the right, high and narrow.
const SCREEN_AT: Patch = Patch { azimuth: [64.0, 84.0], height: [-12.0, 48.0] };
/// Another window behind the ball, for what light passes through.
const BACK_AT: Patch = Patch { azimuth: [146.0, 178.0], height: [8.0, 44.0] };
/// Half the width of a window's bars, as a part of the window.
const BAR: f64 = 0.03;

impl Patch {
    /// Where in the rectangle a direction is, from 0 to 1; nothing outside.
    fn place(&self, azimuth: f64, height: f64) -> Option<[f64; 2]> {
        let part = |value: f64, [from, to]: [f64; 2]| (value - from) / (to - from);
        let place = [part(azimuth, self.azimuth), part(height, self.height)];
        place.iter().all(|part| (0.0..=1.0).contains(part)).then_some(place)
    }
}

/// An environment map of 512×256 pixels: grey walls, a dark floor, a window behind the viewer on the left and one
/// behind the object, and a lit screen on the right.
pub fn studio() -> EnvironmentMap {
    of_width(WIDTH, 1)
}

/// The same in 64×32 pixels, each the mean of what it covers: prepared in a hundredth of the time.
pub(crate) fn coarse_studio() -> EnvironmentMap {
    of_width(64, 8)
}

/// The picture in so many columns, each pixel the mean of so many places along either side.
fn of_width(width: usize, places: usize) -> EnvironmentMap {
    let (height, part) = (width / 2, 1.0 / places as f64);
    let pixel = |i: usize| {
        let mut sum = [0.0; 3];
        for (x, y) in (0..places).flat_map(|y| (0..places).map(move |x| (x, y))) {
            let u = (i % width) as f64 + (x as f64 + 0.5) * part;
            let v = (i / width) as f64 + (y as f64 + 0.5) * part;
            let own = color(EnvironmentMap::direction(u / width as f64, v / height as f64));
            sum = core::array::from_fn(|c| sum[c] + own[c]);
        }
        sum.map(|value| (value * part * part) as f32)
    };
    EnvironmentMap { width, height, pixels: (0..width * height).map(pixel).collect() }
}

fn color(direction: DVec3) -> [f64; 3] {
    let azimuth = libm::atan2(direction.x, direction.z).to_degrees();
    let height = libm::asin(direction.y.clamp(-1.0, 1.0)).to_degrees();
    for window in [WINDOW_AT, BACK_AT] {
        if let Some(place) = window.place(azimuth, height) {
            let barred = place.iter().any(|part| (part - 0.5).abs() < BAR);
            return if barred { WALL } else { WINDOW };
        }
    }
    if SCREEN_AT.place(azimuth, height).is_some() {
        return SCREEN;
    }
    match direction.y >= 0.0 {
        true => mixed(WALL, CEILING, direction.y),
        false => mixed(FLOOR, FLOOR.map(|value| 1.5 * value), -direction.y),
    }
}

fn mixed(from: [f64; 3], to: [f64; 3], part: f64) -> [f64; 3] {
    core::array::from_fn(|c| from[c] + (to[c] - from[c]) * part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_studio_is_brighter_at_its_windows_than_at_its_walls() {
        let map = studio();
        let toward = |azimuth: f64, height: f64| {
            let (azimuth, height) = (azimuth.to_radians(), height.to_radians());
            let ring = libm::cos(height);
            map.at(DVec3::new(ring * libm::sin(azimuth), libm::sin(height), ring * libm::cos(azimuth)))[1]
        };
        assert!(toward(-55.0, 30.0) > 8.0 * toward(20.0, 30.0), "a pane of the window");
        assert!(toward(74.0, 10.0) > 4.0 * toward(20.0, 10.0), "the screen");
        assert!(toward(0.0, -20.0) < toward(0.0, 20.0), "the floor is dark");
        let coarse = coarse_studio();
        let near = |(fine, coarse): (f64, f64)| (fine / coarse - 1.0).abs() < 0.01;
        assert!(map.mean().into_iter().zip(coarse.mean()).all(near), "{:?}", coarse.mean());
        assert!(map.mean().iter().all(|mean| (0.2..0.8).contains(mean)), "{:?}", map.mean());
    }
}
