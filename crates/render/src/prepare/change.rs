//! What changed of a scene.

use glanz_scene::{Object, Scene};

/// What of a scene has changed since it was prepared or updated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Change {
    /// The camera, or the size of the picture. Nothing is redone: that is the view's.
    Camera,
    /// The light of this number: where it is, how it fades, its colour. Its kind too, which costs more.
    Light(usize),
    /// The material of this number: any parameter, tint or texture use. How many textures there are, too.
    Material(usize),
    /// Where the object of this number is. If its mesh, material or shading changed, that is [`Change::Geometry`].
    Object(usize),
    /// All lights and materials, most often their colours, and the white. How many there are, too, which costs more,
    /// and how many textures.
    Colors,
    /// Meshes and objects: how many, of what, shaded how.
    Geometry,
    /// The pictures that textures are.
    Textures,
    /// Shaders of the user's own, what their uniforms are set to, and which objects they draw.
    Programs,
    /// Whether surfaces stand in each other's light.
    Shadows,
    /// Anything, the numbers of lights and materials among it.
    All,
}

impl Change {
    /// What must be redone for the scene `new` of what was prepared for the scene `old`, found by comparing their parts.
    /// Nothing, where they are equal in all that a [`Prepared`](super::Prepared) holds: colour mode and observer are
    /// options of it, and who changes them takes [`Prepared::observed_by`](super::Prepared::observed_by).
    ///
    /// ```
    /// use glanz_render::Change;
    /// use glanz_scene::{Light, Scene};
    ///
    /// let old = Scene::new().with_light(Light::point([0.0; 3], [1.0; 3]));
    /// let mut new = old.clone();
    /// assert_eq!(Change::between(&old, &new), []);
    /// new.light_mut(0)?.set_position([1.0, 2.0, 3.0])?;
    /// assert_eq!(Change::between(&old, &new), [Change::Light(0)]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn between(old: &Scene, new: &Scene) -> Vec<Self> {
        if old.lights.len() != new.lights.len() || old.materials.len() != new.materials.len() {
            return vec![Self::All];
        }
        let mut changes = Vec::new();
        let mut note = |is_new: bool, change: Self| changes.extend(is_new.then_some(change));
        note(old.camera != new.camera || size(old) != size(new), Self::Camera);
        note(old.render.shadows != new.render.shadows, Self::Shadows);
        note(old.textures != new.textures, Self::Textures);
        let drawn = |scene: &Scene| scene.objects.iter().map(|object| object.program).collect::<Vec<_>>();
        let other_programs = old.programs != new.programs || old.program != new.program;
        note(other_programs || drawn(old) != drawn(new), Self::Programs);
        if old.photometric != new.photometric || old.render.white != new.render.white {
            note(true, Self::Colors);
        } else {
            numbers(&old.lights, &new.lights).for_each(|light| note(true, Self::Light(light)));
            numbers(&old.materials, &new.materials).for_each(|material| note(true, Self::Material(material)));
        }
        if has_other_geometry(old, new) {
            note(true, Self::Geometry);
        } else {
            numbers(&old.objects, &new.objects).for_each(|object| note(true, Self::Object(object)));
        }
        changes
    }
}

fn size(scene: &Scene) -> (u32, u32) {
    (scene.image.width, scene.image.height)
}

/// The numbers of the parts that are not as they were.
fn numbers<'a, T: PartialEq>(old: &'a [T], new: &'a [T]) -> impl Iterator<Item = usize> + 'a {
    old.iter().zip(new).enumerate().filter(|(_, (old, new))| old != new).map(|(number, _)| number)
}

/// Whether more changed than where objects are.
fn has_other_geometry(old: &Scene, new: &Scene) -> bool {
    let parts = |object: &Object| (object.mesh, object.material, object.shading, object.interpolation);
    old.objects.len() != new.objects.len()
        || old.objects.iter().map(parts).ne(new.objects.iter().map(parts))
        || old.render.shading != new.render.shading
        || old.render.interpolation != new.render.interpolation
        || old.meshes != new.meshes
}
