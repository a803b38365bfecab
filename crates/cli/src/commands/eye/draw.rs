//! The pictures of one eye.

use glanz_eye::{Seen, Viewer};
use glanz_picture::Frame;
use glanz_picture::compare::Spread;
use glanz_plot::Canvas;
use glanz_render::{Aovs, Shot, ShotError};
use glanz_scene::Scene;

use super::{EyeArgs, Show, shown};
use crate::load::Input;
use crate::pipeline::Plan;
use crate::print::failure::Failure;
use crate::print::number;
use crate::progress::Progress;

/// What was drawn for one eye.
pub(super) struct Drawn {
    /// One picture, or what it is taken apart into, with names.
    pub pictures: Vec<(String, Canvas)>,
    /// What stands under the first.
    pub caption: Vec<String>,
    /// What the eye made of it.
    pub seen: Option<Seen>,
    /// How far another way to show its deficiency is from it.
    pub against: Option<Spread>,
    /// The linear picture of the screen, with the numbers of objects.
    pub frame: Frame,
    /// The names of the objects, by their numbers.
    pub objects: Vec<String>,
}

/// Draws a scene for an eye.
pub(super) fn draw(
    args: &EyeArgs,
    input: &mut Input,
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
    let (shot, frame) = frame(args, input, Some(&viewer), progress)?;
    let seen = shot.seen().copied();
    let screen = shot.on_screen(frame.clone())?;
    let picture = canvas(&shot, &screen)?;
    let mut against = None;
    let pictures = match show {
        Show::Picture => match args.eyes.against {
            None => vec![(String::new(), picture)],
            Some(way) => {
                let other = way.draw(args, input, &viewer, &screen, progress)?;
                against = Some(other.spread);
                vec![("true cones".to_owned(), picture), (way.title().to_owned(), other.picture)]
            }
        },
        Show::Opponent => shown::nerve(&shot, &frame, picture, args.develop.ev.unwrap_or(0.0))?,
        Show::Receptors => {
            let (_, frame) = receptors(args, input, &viewer, progress)?;
            shown::receptors(&frame, &viewer.eye, args.develop.ev.unwrap_or(0.0))
        }
        Show::Glare | Show::Acuity => {
            let name = if show == Show::Glare { "glare" } else { "what is resolved" };
            viewer.viewing.glare &= show != Show::Glare;
            if show == Show::Acuity {
                (viewer.viewing.acuity, viewer.viewing.gaze) = (false, None);
            }
            let (without_shot, without) = self::frame(args, input, Some(&viewer), progress)?;
            let without = canvas(&without_shot, &without_shot.on_screen(without)?)?;
            vec![("without".to_owned(), without), (name.to_owned(), picture)]
        }
    };
    let objects = input.scene.objects.iter().map(|object| object.name.clone()).collect();
    let caption = match against {
        None => caption(seen, show),
        Some(spread) => vec![format!("dE00 mean {:.2}, 95 % {:.2}", spread.mean, spread.p95)],
    };
    Ok(Drawn { pictures, caption, seen, against, frame: screen, objects })
}

/// A frame as an eye sees it, or as the scene's observer does.
pub(super) fn frame(
    args: &EyeArgs,
    input: &mut Input,
    viewer: Option<&Viewer>,
    progress: &mut Progress,
) -> Result<(Shot, Frame), Failure> {
    let Scene { eye, .. } = &mut input.scene;
    if let Some(viewer) = viewer {
        *eye = Some(viewer.clone());
    }
    let plan = Plan::new(input, args.size.size, &args.look(), &args.camera, args.develop)?;
    let mut shot = plan.shot(&input.scene)?;
    let aovs = Aovs { object: true, ..Aovs::default() };
    let frame = shot.frame_in_steps(aovs, &mut |part| progress.within(part))?;
    Ok((shot, frame))
}

/// A frame of all four kinds of receptors, as light falls on them.
fn receptors(
    args: &EyeArgs,
    input: &mut Input,
    viewer: &Viewer,
    progress: &mut Progress,
) -> Result<(Shot, Frame), Failure> {
    let own = (input.scene.eye.take(), input.scene.observer.replace(viewer.eye.observer_with_rods()));
    let drawn = frame(args, input, None, progress);
    (input.scene.eye, input.scene.observer) = own;
    drawn
}

/// A linear picture of the screen as codes.
pub(super) fn canvas(shot: &Shot, screen: &Frame) -> Result<Canvas, Failure> {
    let settings = glanz_picture::Develop { to_screen: None, ..*shot.develop_settings() };
    let rgba = glanz_picture::develop(screen, &settings).map_err(ShotError::from)?;
    Ok(Canvas { width: screen.width, height: screen.height, rgba })
}

/// What an eye is adapted to, in words, where that is not the day.
fn caption(seen: Option<Seen>, show: Show) -> Vec<String> {
    let digits = |value: f64| number(format!("{value:.2e}").parse().unwrap_or(value));
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
