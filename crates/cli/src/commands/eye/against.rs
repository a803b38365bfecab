//! What other programs show of a deficiency, beside the projection of true cones.

use clap::ValueEnum;
use glanz_color::Matrix3;
use glanz_eye::{BrettelOnScreen, Cones, Viewer, machado};
use glanz_picture::Frame;
use glanz_picture::compare::Spread;
use glanz_picture::compare::frames::DeltaE;
use glanz_plot::Canvas;

use super::EyeArgs;
use super::draw::canvas;
use super::source::Source;
use crate::print::failure::Failure;
use crate::progress::Progress;

/// Another way to show a deficiency.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Against {
    /// A matrix on linear sRGB (Machado, Oliveira, Fernandes 2009, severity 1), as browsers have it
    Machado,
    /// The projection of Brettel, Viénot and Mollon 1997 on linear sRGB, with the cones of Smith and Pokorny, as DaltonLens has it
    Daltonlens,
}

/// What another way makes of a colour of linear sRGB.
enum Map {
    Matrix(Matrix3),
    Brettel(BrettelOnScreen),
}

impl Map {
    /// That of an eye without a kind of cones.
    fn of(way: Against, cones: Cones) -> Option<Self> {
        match way {
            Against::Machado => machado(cones).map(Self::Matrix),
            Against::Daltonlens => BrettelOnScreen::without(cones).map(Self::Brettel),
        }
    }

    fn apply(&self, rgb: [f64; 3]) -> [f64; 3] {
        match self {
            Self::Matrix(matrix) => matrix.apply(rgb),
            Self::Brettel(way) => way.apply(rgb),
        }
    }
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
            Self::Daltonlens => "DaltonLens",
        }
    }

    /// The same scene as this way shows it to `viewer`; `seen` is what true cones show.
    pub(super) fn draw(
        self,
        args: &EyeArgs,
        source: &mut Source,
        viewer: &Viewer,
        seen: &Frame,
        progress: &mut Progress,
    ) -> Result<Other, Failure> {
        let Some(map) = Map::of(self, viewer.eye.cones) else {
            return Err(Failure::Usage(format!(
                "--against shows protan, deutan and tritan by other ways, but not '{}'",
                viewer.eye
            )));
        };
        let usual = Viewer { eye: viewer.eye.with_usual_cones(), viewing: viewer.viewing.clone() };
        let (looked, drawn) = source.look(args, &usual, progress)?;
        let mut screen = looked.on_screen(drawn)?;
        for i in 0..screen.alpha.len() {
            let shown = map.apply([0, 1, 2].map(|c| f64::from(screen.rgb[c][i])));
            screen.rgb.iter_mut().zip(shown).for_each(|(plane, value)| plane[i] = value as f32);
        }
        let spread = DeltaE::between(seen, &screen, args.develop.ev.unwrap_or(0.0)).spread;
        Ok(Other { picture: canvas(&looked, &screen)?, spread })
    }
}
