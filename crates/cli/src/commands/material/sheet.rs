//! `glanz material sheet`: balls of the library's materials, each with its name.

use clap::Args;
use glanz_color::Rgb;
use glanz_plot::ContactSheet;
use glanz_scene::LightColor;
use glanz_scene::library::{self, Category, MaterialInfo, materials};
use glanz_scene::stage::MaterialStage;

use super::categories::categories;
use crate::args::{choices, size};
use crate::commands::draw::stage_sheet::StageSheetArgs;
use crate::input::spectra;
use crate::load::input_of_stage;
use crate::print;
use crate::print::failure::Failure;

/// Shown after the help.
pub(super) const EXAMPLES: &str = "\
Examples:
  glanz material sheet -o all.png
  glanz material sheet --category metal --columns 6 -o metals.png
  glanz material sheet gold copper-satin velvet-red --size 256x256 -o three.png

The environment of the balls is a studio with a window behind the viewer on the left and a lit screen on the right;
transparent materials stand before a checkerboard. Without names or categories all materials are drawn.";

/// The most columns, if nothing is said.
const DEFAULT_COLUMNS: u32 = 9;

/// The width and height of a picture.
#[derive(Clone, Copy, Debug)]
struct CellSize {
    pixels: (u32, u32),
    /// Whether one number was given for both, as before.
    is_old: bool,
}

/// `WxH`, or one number for both.
fn cell_size(text: &str) -> Result<CellSize, String> {
    let is_old = text.trim().parse::<u32>().is_ok();
    let pixels = if is_old { size(&format!("{0}x{0}", text.trim()))? } else { size(text)? };
    match [pixels.0, pixels.1].iter().all(|side| (16..=2048).contains(side)) {
        true => Ok(CellSize { pixels, is_old }),
        false => Err("width and height must be between 16 and 2048 pixels".to_owned()),
    }
}

/// Options of `glanz material sheet`.
#[derive(Args, Debug)]
pub(crate) struct SheetArgs {
    /// Names of materials, from `glanz material list`
    #[arg(value_name = "NAME")]
    names: Vec<String>,

    /// All materials of this category; may be repeated
    #[arg(long, value_name = "CATEGORY", value_parser = categories())]
    category: Vec<Category>,

    /// Width and height of each picture, in pixels
    #[arg(long, value_name = "WxH", default_value = "160x160", value_parser = cell_size)]
    size: CellSize,

    /// Pictures per row
    #[arg(long, value_name = "N", default_value_t = DEFAULT_COLUMNS,
          value_parser = clap::value_parser!(u32).range(1..=1000))]
    columns: u32,

    /// The spectrum of the lamps and the environment, from `glanz color list lights` or a file [default: D65]
    #[arg(long, value_name = "SPECTRUM")]
    light: Option<String>,

    /// Samples per pixel for smooth edges
    #[arg(long, value_name = "N", value_parser = choices::samples(), default_value = "8")]
    samples: u32,

    #[command(flatten)]
    sheet: StageSheetArgs,
}

impl SheetArgs {
    /// Draws the sheet.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let target = self.sheet.begin("materials")?;
        let chosen = self.chosen()?;
        let stage = MaterialStage::new(self.lamp()?);
        let size = self.size.pixels;
        if self.size.is_old {
            print::note(format_args!("note: --size is WxH now, such as {0}x{0}", size.0));
        }
        let sheet = ContactSheet {
            captions: chosen.iter().map(|info| vec![info.name.clone()]).collect(),
            per_row: chosen.len().min(self.columns as usize),
            count: chosen.len(),
            cell: (size.0 as usize, size.1 as usize),
            ..ContactSheet::default()
        };
        let stages = chosen.iter().map(|info| Ok(input_of_stage(stage.scene(info.material(), size))));
        let canvas = self.sheet.draw(&sheet, stages, size, self.samples)?;
        let cells: Vec<_> =
            chosen.iter().map(|info| vec![("material".to_owned(), info.name.clone())]).collect();
        self.sheet.deliver(canvas, &target, &cells, sheet.per_row)
    }

    /// The materials that are named, then those of the categories; all if nothing is said.
    fn chosen(&self) -> Result<Vec<&'static MaterialInfo>, Failure> {
        if self.names.is_empty() && self.category.is_empty() {
            return Ok(materials().iter().collect());
        }
        let named = |name: &String| library::info(name).map_err(|error| Failure::Usage(error.to_string()));
        let mut chosen = self.names.iter().map(named).collect::<Result<Vec<_>, _>>()?;
        chosen.extend(materials().iter().filter(|info| self.category.contains(&info.category)));
        Ok(chosen)
    }

    fn lamp(&self) -> Result<LightColor, Failure> {
        let Some(name) = &self.light else { return Ok(LightColor::Rgb(Rgb::WHITE)) };
        let source = spectra::light_source(name)?;
        LightColor::unit(&source.spectrum)
            .ok_or_else(|| Failure::new(format_args!("--light '{name}' sends no light")))
    }
}
