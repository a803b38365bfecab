//! Shots of scenes with a mistake in them.

use std::borrow::Cow;

use glanz_scene::{Mistake, NoEffect, Scene};

use super::ShotOptions;

/// The scene with the mistake that the options ask for, and the options that go with it.
pub(crate) fn mistaken<'a>(
    scene: &'a Scene,
    options: &ShotOptions,
) -> (Cow<'a, Scene>, ShotOptions, Result<(), NoEffect>) {
    let mut options = options.clone();
    let Some(mistake) = options.mistake else { return (Cow::Borrowed(scene), options, Ok(())) };
    let (mut wrong, effect) = mistake.apply(&as_drawn(scene, &options));
    options.encoding = wrong.render.encoding;
    options.draw.raw_normals = mistake == Mistake::UnnormalisedNormal;
    wrong.render.encoding = scene.render.encoding;
    (Cow::Owned(wrong), options, effect)
}

/// The scene with the options' shading and encoding in place of its own, on which it depends whether a mistake is seen.
fn as_drawn(scene: &Scene, options: &ShotOptions) -> Scene {
    let mut scene = scene.clone();
    scene.render.encoding = options.encoding;
    if let Some(shading) = options.prepare.shading {
        scene.render.shading = shading;
        scene.objects.iter_mut().for_each(|object| object.shading = None);
    }
    scene
}
