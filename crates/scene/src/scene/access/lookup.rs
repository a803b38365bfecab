//! Finding the parts of a scene.

use super::{Key, LookupError};
use crate::{Light, Lobe, Material, Mesh, Object, Scene};

/// Something that a list holds under a name.
pub(crate) trait Part {
    /// What it is called in messages.
    const KIND: &'static str;

    /// Its own name; may be empty.
    fn name(&self) -> &str;
}

macro_rules! parts {
    ($($part:ty => $kind:literal),+) => {
        $(impl Part for $part {
            const KIND: &'static str = $kind;

            fn name(&self) -> &str {
                &self.name
            }
        })+
    };
}

parts! { Material => "material", Light => "light", Object => "object", Mesh => "mesh" }

impl Part for Lobe {
    const KIND: &'static str = "lobe";

    fn name(&self) -> &str {
        self.shape.info().name
    }
}

/// The place in a list of what is asked for.
pub(crate) fn number_of<T: Part>(list: &[T], key: Key) -> Result<usize, LookupError> {
    let kind = T::KIND;
    let asked = match key {
        Key::Number(number) if number < list.len() => return Ok(number),
        Key::Number(asked) => return Err(LookupError::Number { kind, asked, count: list.len() }),
        Key::Name(name) => name.to_owned(),
    };
    let named = list.iter().enumerate().filter(|(_, part)| part.name() == asked && !asked.is_empty());
    let found: Vec<usize> = named.map(|(number, _)| number).collect();
    match found[..] {
        [number] => Ok(number),
        [] => {
            let known = list.iter().map(|part| part.name().to_owned()).filter(|name| !name.is_empty());
            Err(LookupError::Name { kind, asked, known: known.collect() })
        }
        _ => Err(LookupError::Several { kind, asked, found }),
    }
}

macro_rules! access {
    ($($list:ident: $part:ty, $kind:literal, $get:ident, $get_mut:ident, $number:ident;)+) => {
        /// The parts of a scene by name or number.
        ///
        /// ```
        /// use glanz_scene::{Light, Scene};
        ///
        /// let key = Light::directional([-1.0, -1.0, -1.0], glanz_color::Rgb::WHITE).named("key");
        /// let mut scene = Scene::new().with_light(key);
        /// assert_eq!(scene.light_number("key")?, 0);
        /// scene.light_mut(0)?.set_spectrum(glanz_color::light("A")?);
        /// assert!(scene.light("fill").is_err());
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        impl Scene {
            $(
                #[doc = concat!("The ", $kind, " of this name or number.")]
                ///
                /// # Errors
                /// [`LookupError`] where there is none, or where several have the name.
                pub fn $get<'k>(&self, key: impl Into<Key<'k>>) -> Result<&$part, LookupError> {
                    Ok(&self.$list[number_of(&self.$list, key.into())?])
                }

                #[doc = concat!("The ", $kind, " of this name or number, to be changed.")]
                ///
                /// # Errors
                /// [`LookupError`] where there is none, or where several have the name.
                pub fn $get_mut<'k>(&mut self, key: impl Into<Key<'k>>) -> Result<&mut $part, LookupError> {
                    let number = number_of(&self.$list, key.into())?;
                    Ok(&mut self.$list[number])
                }

                #[doc = concat!("The number of the ", $kind, " of this name or number.")]
                ///
                /// # Errors
                /// [`LookupError`] where there is none, or where several have the name.
                pub fn $number<'k>(&self, key: impl Into<Key<'k>>) -> Result<usize, LookupError> {
                    number_of(&self.$list, key.into())
                }
            )+
        }
    };
}

access! {
    materials: Material, "material", material, material_mut, material_number;
    lights: Light, "light", light, light_mut, light_number;
    objects: Object, "object", object, object_mut, object_number;
    meshes: Mesh, "mesh", mesh, mesh_mut, mesh_number;
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let named = |name: &str| Material { name: name.to_owned(), ..Material::default_gray() };
        let materials = ["red", "", "white", "white"].map(named).to_vec();
        Scene { materials, ..Scene::default() }
    }

    #[test]
    fn a_name_that_several_have_is_no_answer() {
        let error = scene().material("white").unwrap_err();
        assert_eq!(
            error.to_string(),
            "several have the name of material 'white': ask by number for one of 2, 3"
        );
    }

    #[test]
    fn the_empty_name_names_nothing() {
        let error = scene().material("").unwrap_err();
        assert_eq!(error.to_string(), "there is no material ''; there are: red, white, white");
        assert_eq!(
            Scene::new().object("ball").unwrap_err().to_string(),
            "there is no object 'ball'; there are: none"
        );
    }

    #[test]
    fn names_and_numbers_find_the_same() {
        let mut scene = scene();
        assert_eq!(scene.material_number("red").unwrap(), 0);
        scene.material_mut("red").unwrap().opacity = 0.5;
        assert_eq!(scene.material(0).unwrap().opacity, 0.5);
        assert!(matches!(
            scene.material(4),
            Err(LookupError::Number { kind: "material", asked: 4, count: 4 })
        ));
    }
}
