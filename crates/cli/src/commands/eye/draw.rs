//! The pictures of one eye.

use glanz_eye::{Seen, Viewer};
use glanz_picture::Frame;
use glanz_picture::compare::Spread;
use glanz_plot::Canvas;
use glanz_render::ShotError;

use super::against::Against;
use super::source::{Looked, Source};
use super::{EyeArgs, Show, shown};
use crate::print::failure::Failure;
use crate::print::number;
use crate::progress::Progress;

/// What was drawn for one eye.
pub(super) struct Drawn {
    /// One picture, or what it is taken apart into, with names.
    pub pictures: Vec<(String, Canvas)>,
    /// What stands under each of them, in lines.
    pub captions: Vec<Vec<String>>,
    /// What the eye made of it.
    pub seen: Option<Seen>,
    /// How far other ways to show its deficiency are from it.
    pub against: Vec<(Against, Spread)>,
    /// The linear picture of the screen, with the numbers of objects.
    pub frame: Frame,
    /// The names of the objects, by their numbers.
    pub objects: Vec<String>,
}

/// Draws a scene for an eye.
pub(super) fn draw(
    args: &EyeArgs,
    source: &mut Source,
    viewer: &Viewer,
    progress: &mut Progress,
) -> Result<Drawn, Failure> {
    let show = args.eyes.show;
    let mut viewer = viewer.clone();
    match show {
        Show::Glare => viewer.viewing.glare = true,
        Show::Acuity => viewer.viewing.acuity = true,
        _ => {}
    }
    let (looked, frame) = source.look(args, &viewer, progress)?;
    let seen = looked.seen();
    let screen = looked.on_screen(frame.clone())?;
    let picture = canvas(&looked, &screen)?;
    let mut against = Vec::new();
    let pictures = match show {
        Show::Picture if args.eyes.against.is_empty() => vec![(String::new(), picture)],
        Show::Picture => {
            let mut pictures = vec![("true cones".to_owned(), picture)];
            for way in &args.eyes.against {
                let other = way.draw(args, source, &viewer, &screen, progress)?;
                against.push((*way, other.spread));
                pictures.push((way.title().to_owned(), other.picture));
            }
            pictures
        }
        Show::Opponent => shown::nerve(&looked, &frame, picture, args.develop.ev.unwrap_or(0.0))?,
        Show::Receptors => {
            let frame = source.receptors(args, &viewer, progress)?;
            shown::receptors(&frame, &viewer.eye, args.develop.ev.unwrap_or(0.0))
        }
        Show::Glare | Show::Acuity => {
            let name = if show == Show::Glare { "glare" } else { "what is resolved" };
            viewer.viewing.glare &= show != Show::Glare;
            if show == Show::Acuity {
                (viewer.viewing.acuity, viewer.viewing.gaze) = (false, None);
            }
            let (without, frame) = source.look(args, &viewer, progress)?;
            let without = canvas(&without, &without.on_screen(frame)?)?;
            vec![("without".to_owned(), without), (name.to_owned(), picture)]
        }
    };
    let captions = match against.is_empty() {
        true => vec![caption(seen, show)],
        false => {
            let spread = |(_, spread): &(Against, Spread)| {
                vec![format!("dE00 mean {:.2}, 95 % {:.2}", spread.mean, spread.p95)]
            };
            core::iter::once(Vec::new()).chain(against.iter().map(spread)).collect()
        }
    };
    Ok(Drawn { pictures, captions, seen, against, frame: screen, objects: source.objects() })
}

/// A linear picture of the screen as codes.
pub(super) fn canvas(looked: &Looked, screen: &Frame) -> Result<Canvas, Failure> {
    let rgba = glanz_picture::develop(screen, &looked.develop()).map_err(ShotError::from)?;
    Ok(Canvas { width: screen.width, height: screen.height, rgba })
}

/// What an eye is adapted to, in words, where that is not the day.
fn caption(seen: Option<Seen>, show: Show) -> Vec<String> {
    let digits = |value: f64| match value {
        0.001.. => number(format!("{value:.2e}").parse().unwrap_or(value)),
        _ => format!("{value:.2e}"),
    };
    match seen {
        Some(seen) if seen.cones < 1.0 => {
            vec![
                format!("adapted to {} cd/m²", digits(seen.adaptation_cd_m2)),
                format!("cones {:.0} %, pupil {:.1} mm", 100.0 * seen.cones, seen.pupil_mm),
            ]
        }
        Some(seen) if show == Show::Acuity => vec![format!("up to {:.1} cycles per degree", seen.cutoff_cpd)],
        _ => Vec::new(),
    }
}
