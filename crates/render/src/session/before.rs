//! The parts of a scene as they were when it was last drawn.

use glanz_color::Observer;
use glanz_eye::Viewer;
use glanz_scene::{Camera, Image, Light, Material, Object, RenderSettings, Scene};

use crate::prepare::Change;

/// A part of a scene that may have changed since, as it was.
#[derive(Clone, Debug)]
pub(super) enum Part {
    Light(usize, Light),
    Material(usize, Material),
    Object(usize, Object),
    Camera(Option<Camera>),
    Observer(Option<Observer>, Option<Viewer>),
    Image(Image),
    Render(RenderSettings),
}

/// All parts that may have changed since, as they were.
#[derive(Clone, Debug, Default)]
pub(super) struct Before {
    parts: Vec<Part>,
    /// The whole scene, where anything may have changed; then there are no parts.
    whole: Option<Box<Scene>>,
}

impl Before {
    /// Whether nothing can have changed.
    pub(super) fn is_empty(&self) -> bool {
        self.parts.is_empty() && self.whole.is_none()
    }

    /// Keeps a part, unless it is kept already. `is_it` tells it from others.
    pub(super) fn keep(&mut self, is_it: impl Fn(&Part) -> bool, part: impl FnOnce() -> Part) {
        if self.whole.is_none() && !self.parts.iter().any(is_it) {
            self.parts.push(part());
        }
    }

    /// Keeps all of a scene, of which parts may have changed already.
    pub(super) fn keep_all(&mut self, scene: &Scene) {
        if self.whole.is_none() {
            let mut whole = scene.clone();
            core::mem::take(self).restore(&mut whole);
            self.whole = Some(Box::new(whole));
        }
    }

    /// Makes a scene what it was.
    pub(super) fn restore(self, scene: &mut Scene) {
        if let Some(whole) = self.whole {
            *scene = *whole;
        }
        for part in self.parts {
            match part {
                Part::Light(number, light) => scene.lights[number] = light,
                Part::Material(number, material) => scene.materials[number] = material,
                Part::Object(number, object) => scene.objects[number] = object,
                Part::Camera(camera) => scene.camera = camera,
                Part::Observer(observer, eye) => (scene.observer, scene.eye) = (observer, eye),
                Part::Image(image) => scene.image = image,
                Part::Render(render) => scene.render = render,
            }
        }
    }

    /// What must be redone for the scene as it is now.
    pub(super) fn changes(&self, scene: &Scene) -> Vec<Change> {
        match &self.whole {
            Some(whole) => Change::between(whole, scene),
            None => self.parts.iter().flat_map(|part| part.changes(scene)).flatten().collect(),
        }
    }
}

impl Part {
    fn changes(&self, scene: &Scene) -> [Option<Change>; 3] {
        let one = |is_new: bool, change: Change| [is_new.then_some(change), None, None];
        match self {
            Self::Light(number, old) => one(*old != scene.lights[*number], Change::Light(*number)),
            Self::Material(number, old) => one(*old != scene.materials[*number], Change::Material(*number)),
            Self::Object(number, old) => one(*old != scene.objects[*number], Change::Object(*number)),
            Self::Camera(_) | Self::Observer(..) | Self::Image(_) => [None; 3],
            Self::Render(old) => {
                let new = &scene.render;
                let shaded_otherwise = (old.shading, old.interpolation) != (new.shading, new.interpolation);
                [
                    (old.white != new.white).then_some(Change::Colors),
                    shaded_otherwise.then_some(Change::Geometry),
                    (old.shadows != new.shadows).then_some(Change::Shadows),
                ]
            }
        }
    }
}
