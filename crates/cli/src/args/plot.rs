//! Where a plot goes and how it looks: the options that all plots share.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use glanz_plot::page::missing_letters;
use glanz_plot::{Figure, Lang, PlotFile, PlotFormat};

use super::check_folder;
use crate::print;
use crate::print::failure::Failure;

/// The widest and highest plot, in pixels.
const MAX_SIDE: u32 = 6000;

/// Where a plot goes, and how it looks.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Output")]
pub(crate) struct PlotOutputArgs {
    /// The plot's file, its format by its ending: .svg, .png or .pdf, or .csv or .json with the numbers of the curves;
    /// - for stdout
    #[arg(short, long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    output: PathBuf,

    /// The format, whatever the file is called [default: by the ending; svg to stdout]
    #[arg(long, value_name = "FORMAT", value_parser = formats())]
    format: Option<PlotFormat>,

    #[command(flatten)]
    look: PlotLookArgs,
}

/// How a plot looks.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Output")]
pub(crate) struct PlotLookArgs {
    /// A title in place of the plot's own
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,

    /// Width and height of the plot, in pixels (points of a PDF) [default: as the plot needs]
    #[arg(long, value_name = "WxH", value_parser = plot_size)]
    size: Option<(u32, u32)>,

    /// The language of the plot's words [default: en]
    #[arg(long, value_name = "LANG", value_parser = langs())]
    lang: Option<Lang>,
}

/// A plot beside the numbers that a command prints.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Output")]
pub(crate) struct BesidePlotArgs {
    /// Draw it into this file, its format by its ending: .svg, .png, .pdf, .csv or .json
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    plot: Option<PathBuf>,

    #[command(flatten)]
    look: PlotLookArgs,
}

/// Where a plot goes and how it looks, checked before any work is done.
#[derive(Clone, Debug)]
pub(crate) struct PlotTarget {
    /// The file, or none for stdout.
    file: Option<PathBuf>,
    format: PlotFormat,
    look: PlotLookArgs,
}

fn formats() -> impl TypedValueParser<Value = PlotFormat> {
    let names = PlotFormat::ALL.map(|(_, name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(names).map(|name| {
        let found = PlotFormat::ALL.into_iter().find(|(_, own, _)| *own == name);
        found.expect("the parser lets only known names through").0
    })
}

fn langs() -> impl TypedValueParser<Value = Lang> {
    let names = Lang::ALL.map(|(_, code, name)| PossibleValue::new(code).help(name));
    PossibleValuesParser::new(names)
        .map(|code| code.parse().expect("the parser lets only known codes through"))
}

/// `WxH`, neither of which is more than a picture of a plot may be.
fn plot_size(text: &str) -> Result<(u32, u32), String> {
    let (width, height) = super::size(text)?;
    match width.max(height) <= MAX_SIDE {
        true => Ok((width, height)),
        false => Err(format!("a plot must be at most {MAX_SIDE}x{MAX_SIDE}")),
    }
}

impl PlotOutputArgs {
    /// Where the plot goes.
    pub(crate) fn target(&self) -> Result<PlotTarget, Failure> {
        if self.output.as_os_str() == "-" {
            let format = self.format.unwrap_or(PlotFormat::Svg);
            if matches!(format, PlotFormat::Png | PlotFormat::Pdf) && io::stdout().is_terminal() {
                let name = format.name().to_uppercase();
                return Err(Failure::Usage(format!(
                    "stdout is a terminal, which shows no {name}; redirect it"
                )));
            }
            return PlotTarget::new(None, format, &self.look);
        }
        let of_ending = PlotFormat::from_path(&self.output);
        let format = match (self.format, of_ending) {
            (Some(format), Ok(own)) if format != own => {
                let (file, format) = (self.output.display(), format.name());
                return Err(Failure::Usage(format!(
                    "'{file}' ends in .{}, but --format is {format}",
                    own.name()
                )));
            }
            (Some(format), _) => format,
            (None, own) => own?,
        };
        PlotTarget::new(Some(self.output.clone()), format, &self.look)
    }
}

impl BesidePlotArgs {
    /// Where the plot goes, if there is one.
    pub(crate) fn target(&self) -> Result<Option<PlotTarget>, Failure> {
        let Some(file) = &self.plot else {
            return match self.look.first() {
                Some(option) => Err(Failure::Usage(format!("{option} has no effect without --plot"))),
                None => Ok(None),
            };
        };
        if file.as_os_str() == "-" {
            let message = "stdout takes the numbers, not the plot beside them; name a file with --plot";
            return Err(Failure::Usage(message.to_owned()));
        }
        PlotTarget::new(Some(file.clone()), PlotFormat::from_path(file)?, &self.look).map(Some)
    }
}

impl PlotLookArgs {
    /// The first of the options that is given.
    fn first(&self) -> Option<&'static str> {
        let given = [
            ("--title", self.title.is_some()),
            ("--size", self.size.is_some()),
            ("--lang", self.lang.is_some()),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }
}

impl PlotTarget {
    /// The file, unless it is stdout.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.file.as_deref()
    }

    /// A plot as it is by itself, in this file.
    pub(crate) fn of_file(file: &Path) -> Result<Self, Failure> {
        Self::new(Some(file.to_owned()), PlotFormat::from_path(file)?, &PlotLookArgs::default())
    }

    fn new(file: Option<PathBuf>, format: PlotFormat, look: &PlotLookArgs) -> Result<Self, Failure> {
        let name = format.name();
        if look.size.is_some() && !format.is_page() {
            let message = format!("--size has no effect on {name}; it acts on svg, png and pdf");
            return Err(Failure::Usage(message));
        }
        if look.title.is_some() && format == PlotFormat::Csv {
            let message = "--title has no effect on csv; it acts on svg, png, pdf and json";
            return Err(Failure::Usage(message.to_owned()));
        }
        file.as_deref().map_or(Ok(()), check_folder)?;
        Ok(Self { file, format, look: look.clone() })
    }

    /// The language of the plot's words.
    pub(crate) fn lang(&self) -> Lang {
        self.look.lang.unwrap_or_default()
    }

    /// Brings the plot to where it goes. A file is old or new, but never half.
    pub(crate) fn save(&self, figure: &mut dyn Figure) -> Result<(), Failure> {
        if let Some(title) = &self.look.title {
            figure.title_mut().clone_from(title);
        }
        self.tell_missing_letters(figure);
        let bytes = figure.to_bytes(self.format, self.look.size)?;
        let Some(path) = &self.file else { return print::bytes(&bytes) };
        PlotFile::of_format(path, self.format).write(&bytes)?;
        print::note(format_args!("wrote {}", path.display()));
        Ok(())
    }

    /// Tells which letters the plot's own font does not have; an SVG is shown in the viewer's fonts.
    fn tell_missing_letters(&self, figure: &dyn Figure) {
        if !matches!(self.format, PlotFormat::Png | PlotFormat::Pdf) {
            return;
        }
        let page = figure.page();
        let mut missing: Vec<_> = page.texts().flat_map(|text| missing_letters(&text.text)).collect();
        missing.sort_unstable();
        missing.dedup();
        if !missing.is_empty() {
            let letters: String = missing.into_iter().collect();
            print::note(format_args!(
                "note: the font of plots does not have '{letters}'; an SVG takes them from its viewer"
            ));
        }
    }
}
