//! Who looks: an observer, or an eye.

use glanz_eye::{Eye, Viewer, Viewing};

use super::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::eye::EyeTable;
use crate::file::tables::sampled::ObserverValue;
use crate::file::tables::scene::SceneTable;
use crate::file::tables::values::At;

impl Builder {
    /// Takes over the observer or the eye of a scene.
    pub(super) fn looks(&mut self, table: &SceneTable) -> Result<(), Problem> {
        if let Some(eye) = &table.eye {
            if let Some(observer) = &table.render.observer {
                let message = "the scene has an eye and an observer; one of them looks";
                return Err(
                    Problem::at(&observer.span, message).help("leave out 'observer', or the table [eye]")
                );
            }
            return self.eye(eye);
        }
        let Some(observer) = &table.render.observer else { return Ok(()) };
        match &observer.value {
            ObserverValue::Name(name) if Eye::is_named(name) => {
                let eye: Eye =
                    name.parse().map_err(|error| Problem::at(&observer.span, format!("{error}")))?;
                self.look_by(eye.into());
            }
            _ => self.scene.observer = Some(self.observer(observer)?),
        }
        Ok(())
    }

    fn look_by(&mut self, viewer: Viewer) {
        self.input.notes.extend(viewer.eye.remark());
        self.scene.eye = Some(viewer);
    }

    fn eye(&mut self, table: &At<EyeTable>) -> Result<(), Problem> {
        let usual = Viewing::default();
        let viewing = Viewing {
            level_cd_m2: table.level.map(|level| level.0),
            adapted: table.adapted.map_or(usual.adapted, |adapted| adapted.0),
            adaptation_cd_m2: table.adaptation_cd_m2.map(|luminance| luminance.0),
            rods: table.rods.unwrap_or(usual.rods),
            glare: table.glare,
            chromatic: table.chromatic,
            noise: table.noise.map(|seed| seed.0),
            acuity: table.acuity,
            gaze: table.gaze.map(|gaze| gaze.map(|c| c.0)),
            px_per_deg: table.px_per_deg.map(|px| px.0),
            night: table.night,
        };
        let viewer = Viewer { eye: who(table)?, viewing };
        viewer.check().map_err(|message| Problem::at(&table.span, message))?;
        self.look_by(viewer);
        Ok(())
    }
}

/// The eye of a table.
fn who(table: &At<EyeTable>) -> Result<Eye, Problem> {
    let usual = Eye::default();
    let mut eye = Eye {
        age: table.age.map_or(usual.age, |age| age.0),
        field_deg: table.field_deg.map_or(usual.field_deg, |field| field.0),
        lens: table.lens.unwrap_or(usual.lens),
        lens_density: table.lens_density.map_or(usual.lens_density, |density| density.0),
        macula_density: table.macula_density.map_or(usual.macula_density, |density| density.0),
        pigment_density: table.pigment_density.map_or(usual.pigment_density, |density| density.map(|d| d.0)),
        shift_nm: table.shift_nm.map_or(usual.shift_nm, |shift| shift.map(|s| s.0)),
        iris: table.iris.map_or(usual.iris, |iris| iris.0),
        cones: usual.cones,
    };
    let Some(name) = &table.deficiency else { return Ok(eye) };
    let wrong = |message: String| Problem::at(&name.span, message);
    let deficient: Eye = name.parse().map_err(|error: glanz_eye::EyeError| wrong(error.to_string()))?;
    eye.cones = deficient.cones;
    if deficient.shift_nm != Eye::default().shift_nm {
        if table.shift_nm.is_some() {
            return Err(wrong("'deficiency' and 'shift_nm' both move pigments; one of them does".to_owned()));
        }
        eye.shift_nm = deficient.shift_nm;
    }
    let bare = Eye { cones: deficient.cones, shift_nm: deficient.shift_nm, ..Eye::default() };
    match bare == deficient {
        true => Ok(eye),
        false => Err(wrong(format!(
            "expected protan, deutan or tritan, protan:10 or deutan:10 (nm), or rods, found '{}'",
            **name
        ))),
    }
}
