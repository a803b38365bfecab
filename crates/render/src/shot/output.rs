//! Pictures as files keep them.

use std::path::Path;

use glanz_picture::Frame;
use glanz_picture::output::{Format, Metadata, OutputError, PictureData, PictureKind};
use glanz_scene::White;

use super::{SaveError, Shot, ShotError, Step};
use crate::prepare::Observation;
use crate::view::Aovs;

impl Shot {
    /// Draws the picture into a file, in the format that its name ends in: linear light with depth, normals and
    /// object numbers into `.exr`, the developed picture into `.png`, `.gif` and `.apng`. The file tells how its
    /// colours came to be, and the hash of the scene.
    ///
    /// ```
    /// use glanz_render::Shot;
    /// use glanz_scene::Scene;
    ///
    /// let folder = std::env::temp_dir().join("glanz-doc-save");
    /// std::fs::create_dir_all(&folder)?;
    /// let scene = Scene::new().with_size(8, 8);
    /// Shot::new(&scene)?.save(folder.join("empty.png"))?;
    /// assert!(std::fs::read(folder.join("empty.png"))?.starts_with(b"\x89PNG"));
    /// let error = Shot::new(&scene)?.save(folder.join("empty.bmp")).unwrap_err();
    /// assert!(error.to_string().ends_with("the name must end in .png, .exr, .gif or .apng"));
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If the picture cannot be drawn or written, or the format needs a feature that this build does not have (`exr`,
    /// `gif`). The file is as it was then.
    pub fn save(&mut self, path: impl AsRef<Path>) -> Result<(), SaveError> {
        let format = Format::from_path(&path)?;
        format.check_feature().map_err(OutputError::from)?;
        let picture = self.picture(PictureKind::of(format), &mut |_| ())?;
        Ok(picture.save(path, &self.metadata())?)
    }

    /// Draws the picture as a file keeps it; `step` is told how far it is.
    ///
    /// # Errors
    /// As [`Shot::frame`]; if there is no memory for it; and if spectra are asked for where there are none.
    pub fn picture(&mut self, kind: PictureKind, step: Step) -> Result<PictureData, ShotError> {
        self.check_memory(kind)?;
        if matches!(kind, PictureKind::Light | PictureKind::Spectrum) {
            self.check_names()?;
        }
        let (width, height) = (self.sight.view.width as usize, self.sight.view.height as usize);
        Ok(match kind {
            PictureKind::Codes8 => PictureData::Codes8 { width, height, rgba: self.rgba8_in_steps(step)? },
            PictureKind::Codes16 => {
                let frame = self.frame_in_steps(Aovs::default(), step)?;
                PictureData::Codes16 { width, height, rgba: self.codes16(frame)? }
            }
            PictureKind::Light => {
                let frame = self.frame_in_steps(Aovs { depth: true, normal: true, object: true }, step)?;
                self.light_of(frame)?
            }
            PictureKind::Spectrum => PictureData::Spectrum(self.spectral_image(step)?),
        })
    }

    /// That a file can hold the names of the observer's channels, before anything is drawn for it.
    fn check_names(&self) -> Result<(), ShotError> {
        let Some(observer) = self.prepared.observation().observer() else { return Ok(()) };
        let fail = |what: String| Err(ShotError::ChannelNames { observer: observer.name.clone(), what });
        let names = || observer.channels.iter().map(|channel| channel.name.as_str());
        let is_foreign = |name: &&str| !name.chars().all(|letter| u8::try_from(letter).is_ok());
        if let Some(name) = std::iter::once(observer.name.as_str()).chain(names()).find(is_foreign) {
            return fail(format!("'{name}' has letters that are not Latin ones"));
        }
        let twice =
            names().enumerate().find(|(number, name)| names().take(*number).any(|other| other == *name));
        twice.map_or(Ok(()), |(_, name)| fail(format!("two of its channels are named '{name}'")))
    }

    /// The observer's channels of a frame beside what the screen shows of them.
    ///
    /// # Errors
    /// If it is not a frame of this observer.
    pub fn light_of(&self, frame: Frame) -> Result<PictureData, ShotError> {
        let channels = match &frame.channels.observer {
            Some(observer) => {
                let names = frame.channels.names.iter().map(|name| format!("{observer}.{name}"));
                names.zip(frame.rgb.iter().chain(&frame.more).cloned()).collect()
            }
            None => Vec::new(),
        };
        Ok(PictureData::Light { screen: self.on_screen(frame)?, channels })
    }

    /// What a file tells about the picture: colour mode, observer and adaptation where there is an observer, and the
    /// hash of the scene.
    pub fn metadata(&self) -> Metadata {
        Metadata {
            scene_hash: self.scene_hash.map(|hash| format!("{hash:016x}")),
            entries: [facts(self.prepared.observation(), self.sight.white), self.makings.clone()].concat(),
            ..Metadata::default()
        }
    }

    /// The same with this hash of the scene, which [`Shot::new`] knows by itself.
    #[must_use]
    pub fn of_scene_hash(self, hash: u64) -> Self {
        Self { scene_hash: Some(hash), ..self }
    }
}

/// Colour mode, observer and adaptation, in words; nothing for plain RGB.
fn facts(observation: &Observation, white: White) -> Vec<(String, String)> {
    let Some(observer) = observation.observer() else { return Vec::new() };
    let adaptation = match white {
        White::None => "none".to_owned(),
        white => format!("white {} to D65 by Bradford", white.name()),
    };
    let facts = [
        ("Color-Mode", observation.mode().to_string()),
        ("Observer", observer.name.clone()),
        ("Adaptation", adaptation),
    ];
    facts.map(|(key, value)| (key.to_owned(), value)).to_vec()
}
