//! What other programs show of a deficiency, beside the projection of true cones.

use clap::ValueEnum;
use glanz_eye::{Viewer, machado};
use glanz_picture::Frame;
use glanz_picture::compare::Spread;
use glanz_picture::compare::frames::DeltaE;
use glanz_plot::Canvas;

use super::EyeArgs;
use super::draw::{canvas, frame};
use crate::load::Input;
use crate::print::failure::Failure;
use crate::progress::Progress;

/// Another way to show a deficiency.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Against {
    /// A matrix on linear sRGB (Machado, Oliveira, Fernandes 2009, severity 1), as browsers have it
    Machado,
}

/// A picture by another way, and how far it is from the one by true cones.
pub(super) struct Other {
    pub picture: Canvas,
    pub spread: Spread,
}

impl Against {
    /// Its name on sheets.
    pub(super) fn title(self) -> &'static str {
        match self {
            Self::Machado => "Machado 2009",
        }
    }

    /// The same scene as this way shows it to `viewer`; `seen` is what true cones show.
    pub(super) fn draw(
        self,
        args: &EyeArgs,
        input: &mut Input,
        viewer: &Viewer,
        seen: &Frame,
        progress: &mut Progress,
    ) -> Result<Other, Failure> {
        let Some(matrix) = machado(viewer.eye.cones) else {
            return Err(Failure::Usage(format!(
                "--against machado has matrices of protan, deutan and tritan, but not of '{}'",
                viewer.eye
            )));
        };
        let usual = Viewer { eye: viewer.eye.with_usual_cones(), viewing: viewer.viewing.clone() };
        let (shot, drawn) = frame(args, input, Some(&usual), progress)?;
        let mut screen = shot.on_screen(drawn)?;
        for i in 0..screen.alpha.len() {
            let rgb = [0, 1, 2].map(|c| f64::from(screen.rgb[c][i]));
            let shown = matrix.apply(rgb);
            screen.rgb.iter_mut().zip(shown).for_each(|(plane, value)| plane[i] = value as f32);
        }
        let spread = DeltaE::between(seen, &screen, args.develop.ev.unwrap_or(0.0)).spread;
        Ok(Other { picture: canvas(&shot, &screen)?, spread })
    }
}
