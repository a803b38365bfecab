//! What eyes look at: a scene, or a picture.

use glanz_eye::{Seen, Viewer};
use glanz_picture::{Develop, Frame};
use glanz_render::{Aovs, SeenPicture, Shot, ShotError};
use glanz_scene::{RenderSettings, Scene};

use super::EyeArgs;
use crate::input::picture::PictureInput;
use crate::load::{Input, More};
use crate::pipeline::Plan;
use crate::print::failure::Failure;
use crate::progress::Progress;

/// What eyes look at.
pub(super) enum Source {
    Scene(Box<Input>),
    Picture(PictureInput),
}

/// How the channels of an eye come to a screen.
pub(super) enum Looked {
    Scene(Box<Shot>),
    Picture(Box<SeenPicture>, Develop),
}

impl Source {
    /// Opens the file that the arguments name.
    pub(super) fn open(args: &EyeArgs) -> Result<Self, Failure> {
        let path = &args.input.input;
        if !PictureInput::is_named(path) {
            return Ok(Self::Scene(Box::new(args.input.load(Some(&args.camera), More::default())?)));
        }
        PictureInput::read(path, args.input.memory).map(Self::Picture)
    }

    /// What is odd about it.
    pub(super) fn notes(&self) -> &[String] {
        match self {
            Self::Scene(input) => &input.notes,
            Self::Picture(picture) => &picture.notes,
        }
    }

    /// The eye that it has of its own.
    pub(super) fn viewer(&self) -> Option<&Viewer> {
        match self {
            Self::Scene(input) => input.scene.eye.as_ref(),
            Self::Picture(_) => None,
        }
    }

    /// Whether it knows its luminance.
    pub(super) fn photometric(&self) -> bool {
        matches!(self, Self::Scene(input) if input.scene.photometric)
    }

    /// The names of its objects.
    pub(super) fn objects(&self) -> Vec<String> {
        match self {
            Self::Scene(input) => input.scene.objects.iter().map(|object| object.name.clone()).collect(),
            Self::Picture(_) => Vec::new(),
        }
    }

    /// The hash of a scene's content; 0 for a picture.
    pub(super) fn content_hash(&self) -> u64 {
        match self {
            Self::Scene(input) => input.scene.content_hash(),
            Self::Picture(_) => 0,
        }
    }

    /// What an eye sees, in its channels.
    pub(super) fn look(
        &mut self,
        args: &EyeArgs,
        viewer: &Viewer,
        progress: &mut Progress,
    ) -> Result<(Looked, Frame), Failure> {
        match self {
            Self::Scene(input) => {
                input.scene.eye = Some(viewer.clone());
                drawn(args, input, progress)
            }
            Self::Picture(picture) => {
                let seen = picture.seen_by(viewer)?;
                let frame = seen.frame.clone();
                let develop = args.develop.resolve(&RenderSettings::default())?;
                Ok((Looked::Picture(Box::new(seen), develop), frame))
            }
        }
    }

    /// A frame of all four kinds of receptors, as light falls on them.
    pub(super) fn receptors(
        &mut self,
        args: &EyeArgs,
        viewer: &Viewer,
        progress: &mut Progress,
    ) -> Result<Frame, Failure> {
        let observer = viewer.eye.observer_with_rods();
        match self {
            Self::Picture(picture) => picture.channels(&observer),
            Self::Scene(input) => {
                let Scene { eye, observer: own, .. } = &mut input.scene;
                let kept = (eye.take(), own.replace(observer));
                let drawn = drawn(args, input, progress);
                (input.scene.eye, input.scene.observer) = kept;
                drawn.map(|(_, frame)| frame)
            }
        }
    }
}

/// A frame of a scene, as its eye or its observer sees it.
fn drawn(args: &EyeArgs, input: &Input, progress: &mut Progress) -> Result<(Looked, Frame), Failure> {
    let plan = Plan::new(input, args.size.size, &args.look(), &args.camera, args.develop)?;
    let plan = plan.at(args.input.program.moment());
    let mut shot = plan.shot(&input.scene)?;
    let aovs = Aovs { object: true, ..Aovs::default() };
    let frame = shot.frame_in_steps(aovs, &mut |part| progress.within(part))?;
    Ok((Looked::Scene(Box::new(shot)), frame))
}

impl Looked {
    /// What the eye made of it.
    pub(super) fn seen(&self) -> Option<Seen> {
        match self {
            Self::Scene(shot) => shot.seen().copied(),
            Self::Picture(seen, _) => seen.seen,
        }
    }

    /// A frame of the eye's channels, in linear light of a screen.
    pub(super) fn on_screen(&self, frame: Frame) -> Result<Frame, ShotError> {
        match self {
            Self::Scene(shot) => shot.on_screen(frame),
            Self::Picture(seen, _) => seen.on_screen(frame),
        }
    }

    /// How linear light of a screen is developed.
    pub(super) fn develop(&self) -> Develop {
        let settings = match self {
            Self::Scene(shot) => shot.develop_settings(),
            Self::Picture(_, settings) => settings,
        };
        Develop { to_screen: None, ..*settings }
    }
}
