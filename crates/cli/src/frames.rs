//! Several pictures in a row: their numbers, their names, their cameras.

use std::ffi::OsString;
use std::ops::Range;
use std::path::{Path, PathBuf};

use glam::{DQuat, DVec3};
use glanz_picture::output::Animation;
use glanz_scene::Camera;

use super::print::failure::Failure;
use super::print::{self, number};

/// The most frames of one film.
const MAX_FRAMES: u32 = 100_000;

/// The most digits of a frame's number in a name.
const MAX_DIGITS: usize = 20;

/// `0..120` (without 120) or `0..=119`.
pub(crate) fn range(text: &str) -> Result<Range<u32>, String> {
    const EXPECTED: &str = "expected FIRST..END, such as 0..120 for 120 frames from 0 to 119";
    let (first, end) = text.split_once("..").ok_or(EXPECTED)?;
    let (end, inclusive) = end.strip_prefix('=').map_or((end, 0), |end| (end, 1));
    let number = |text: &str| text.trim().parse::<u32>().map_err(|_| EXPECTED);
    let (first, end) = (number(first)?, number(end)?.saturating_add(inclusive));
    match end.checked_sub(first) {
        None | Some(0) => Err(format!("there is no frame in {text}; {EXPECTED}")),
        Some(count) if count > MAX_FRAMES => {
            Err(format!("{count} frames are too many; at most {MAX_FRAMES}"))
        }
        Some(_) => Ok(first..end),
    }
}

/// A number of the scene, or a list of numbers, that changes evenly during a film.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Motion {
    path: String,
    /// One number, or as many as the list has.
    from: Vec<f64>,
    to: Vec<f64>,
    is_list: bool,
}

impl Motion {
    /// `PATH=FROM:TO`, where both are numbers or lists of as many numbers.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        const EXPECTED: &str =
            "expected PATH=FROM:TO, such as camera.fov_deg=20:60 or lights.0.direction=[0,0,-1]:[8,0,-1]";
        let (path, values) = text.split_once('=').ok_or(EXPECTED)?;
        let (from, to) = values.split_once(':').ok_or(EXPECTED)?;
        let ((from, is_list), (to, ends_as_list)) = numbers(from).zip(numbers(to)).ok_or(EXPECTED)?;
        if is_list != ends_as_list || from.len() != to.len() {
            return Err(format!("'{values}' begins with {} and ends with {} numbers", from.len(), to.len()));
        }
        match path.trim() {
            "" => Err(EXPECTED.to_owned()),
            path => Ok(Self { path: path.to_owned(), from, to, is_list }),
        }
    }

    /// What to set after a part of the film.
    pub(crate) fn at(&self, part: f64) -> (String, String) {
        // Not more digits than a value that is set by hand would have.
        let between = self.from.iter().zip(&self.to).map(|(from, to)| number(from + (to - from) * part));
        let values = between.collect::<Vec<_>>().join(", ");
        (self.path.clone(), if self.is_list { format!("[{values}]") } else { values })
    }
}

/// A number, or the numbers of a list, and whether it is a list.
fn numbers(text: &str) -> Option<(Vec<f64>, bool)> {
    let text = text.trim();
    let list = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|value| value.is_finite());
    let numbers = list.unwrap_or(text).split(',').map(number).collect::<Option<Vec<f64>>>()?;
    (list.is_some() || numbers.len() == 1).then_some((numbers, list.is_some()))
}

/// A file name with a place for the frame's number: `{frame}`, or `{frame:04}` for four digits.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Template {
    before: OsString,
    after: OsString,
    digits: usize,
}

/// Says of a GIF that it is shown at another rate than was asked for.
pub(crate) fn tell_of_gif(animation: &Animation) {
    let shown = f64::from(animation.gif_hundredths()) / 100.0;
    if (shown / animation.frame_s - 1.0).abs() > 0.01 {
        let [shown, asked] = [shown, animation.frame_s].map(|seconds| number(1.0 / seconds));
        print::note(format_args!(
            "note: a GIF counts hundredths of a second: it has {shown} frames a second, not {asked}; an .apng or .mp4 counts finer"
        ));
    }
}

impl Template {
    /// The template in a path; `None` if there is no place for a number.
    pub(crate) fn of_path(path: &Path) -> Result<Option<Self>, Failure> {
        let text = path.to_string_lossy();
        let template = Self::parse(&text);
        if let (None, Some(place)) = (&template, place_of(&text)) {
            let message = format!(
                "'{place}' is no place for a number: write {{frame}} or {{frame:04}}, with at most {MAX_DIGITS} digits"
            );
            return Err(Failure::Usage(message));
        }
        Ok(match template {
            Some(template) if path.to_str().is_none() => Some(template.with_bytes_of(path)?),
            template => template,
        })
    }

    /// The same with the bytes of a name that is not UTF-8.
    #[cfg(unix)]
    fn with_bytes_of(self, path: &Path) -> Result<Self, Failure> {
        use std::ffi::OsStr;
        use std::os::unix::ffi::OsStrExt;

        let bytes = path.as_os_str().as_bytes();
        // The place itself is ASCII, and no part of another character.
        let open = bytes.windows(6).position(|six| six == b"{frame").unwrap_or(0);
        let close =
            bytes[open..].iter().position(|byte| *byte == b'}').map_or(bytes.len(), |at| open + at + 1);
        let part = |bytes: &[u8]| OsStr::from_bytes(bytes).to_owned();
        Ok(Self { before: part(&bytes[..open]), after: part(&bytes[close..]), ..self })
    }

    #[cfg(not(unix))]
    fn with_bytes_of(self, path: &Path) -> Result<Self, Failure> {
        Err(Failure::Usage(format!(
            "'{}' is not Unicode, so it cannot be the pattern of names with {{frame}}",
            path.display()
        )))
    }

    /// The template in `text`; `None` if there is no place for a number.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let (before, rest) = text.split_once("{frame")?;
        let (format, after) = rest.split_once('}')?;
        let digits = match format.strip_prefix(':') {
            Some(digits) => digits.parse().ok().filter(|digits| *digits <= MAX_DIGITS)?,
            None if format.is_empty() => 1,
            None => return None,
        };
        Some(Self { before: before.into(), after: after.into(), digits })
    }

    /// The name of frame `number`.
    pub(crate) fn name(&self, number: u32) -> PathBuf {
        let mut name = self.before.clone();
        name.push(format!("{number:0digits$}", digits = self.digits));
        name.push(&self.after);
        name.into()
    }
}

/// What is written like a place for a number.
fn place_of(text: &str) -> Option<&str> {
    let place = &text[text.find("{frame:")?..];
    place.find('}').map(|end| &place[..=end])
}

/// The camera after `part` of a full turn around its target, counter-clockwise seen from above.
///
/// The axis is the camera's `up`, so that the horizon stays level.
pub(crate) fn turned(camera: &Camera, part: f64) -> Camera {
    if part == 0.0 {
        // The picture before the first turn is that without any, to the last bit.
        return *camera;
    }
    let axis = camera.up.try_normalize().unwrap_or(DVec3::Y);
    let turn = DQuat::from_axis_angle(axis, part * core::f64::consts::TAU);
    Camera { eye: camera.target + turn * (camera.eye - camera.target), ..*camera }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glanz_scene::Bounds;

    #[test]
    fn a_range_leaves_its_end_out_unless_told() {
        assert_eq!(range("0..120"), Ok(0..120));
        assert_eq!(range("3..=3"), Ok(3..4));
        for wrong in ["", "5", "5..5", "6..5", "-1..3", "0..4294967295", "a..b"] {
            assert!(range(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_motion_is_of_a_number_or_of_a_list() {
        let at = |text: &str, part: f64| Motion::parse(text).map(|motion| motion.at(part).1);
        assert_eq!(at("camera.fov_deg=20:60", 0.5).as_deref(), Ok("40"));
        assert_eq!(at("lights.0.direction=[0,0,-1]:[8, 2,-1]", 0.25).as_deref(), Ok("[2, 0.5, -1]"));
        for wrong in ["a=1", "a=[1,2]:[1]", "a=[1]:2", "a=1,2:3,4", "=1:2", "a=[]:[]", "a=x:y"] {
            assert!(Motion::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_template_says_where_the_number_goes() {
        let name = |text: &str| Template::parse(text).map(|template| template.name(7));
        assert_eq!(name("spin_{frame:04}.png").as_deref(), Some(Path::new("spin_0007.png")));
        assert_eq!(name("{frame}/a.png").as_deref(), Some(Path::new("7/a.png")));
        for wrong in ["spin.png", "{frame", "{frames}", "{frame:x}", "{frame:99999}"] {
            assert_eq!(name(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn a_place_with_too_many_digits_is_told() {
        for (text, place) in [("a_{frame:300}.png", "{frame:300}"), ("{frame:x}", "{frame:x}")] {
            match Template::of_path(Path::new(text)) {
                Err(Failure::Usage(message)) => {
                    assert!(message.starts_with(&format!("'{place}' is no place")), "{message}");
                }
                other => panic!("{text}: {other:?}"),
            }
        }
        assert!(matches!(Template::of_path(Path::new("a_{frame:20}.png")), Ok(Some(_))));
        assert!(matches!(Template::of_path(Path::new("a_{frames}.png")), Ok(None)));
    }

    #[test]
    fn a_quarter_turn_keeps_distance_and_height() {
        let camera = Camera { eye: DVec3::new(0.0, 1.0, 4.0), ..Camera::framing(&Bounds::EMPTY, 1.0) };
        let camera = Camera { target: DVec3::new(0.0, 1.0, 0.0), ..camera };
        let quarter = turned(&camera, 0.25);
        assert!((quarter.eye - DVec3::new(4.0, 1.0, 0.0)).length() < 1e-12);
        assert_eq!(turned(&camera, 0.0).eye, camera.eye);
    }
}
