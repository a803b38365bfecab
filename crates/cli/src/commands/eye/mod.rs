//! `glanz eye`: one scene as other people see it.

mod against;
mod draw;
mod facts;
pub(crate) mod mach;
mod patches;
pub(crate) mod population;
mod shown;
mod source;
mod variants;

use clap::{Args, ValueEnum};
use glanz_color::Rgb;
use glanz_eye::RodColor;
use glanz_picture::output::{Animation, Format, write_apng, write_atomically, write_gif};
use glanz_plot::{Canvas, ContactSheet};
use glanz_render::DebugView;
use glanz_scene::{Background, Shading};

use self::against::Against;
use self::draw::Drawn;
pub(crate) use self::facts::Document;
use self::facts::EyeFacts;
use self::patches::Patches;
use self::source::Source;
use self::variants::{Ages, Variants};
use crate::args::{
    CameraArgs, ColorArgs, DevelopArgs, InputArgs, LookArgs, MachineArgs, SizeArgs, Target, TargetArgs,
    choices, values,
};
use crate::encode;
use crate::frames::tell_of_gif;
use crate::print::failure::Failure;
use crate::print::{self, FormatArgs};
use crate::progress::Progress;

/// Shown after the help.
pub(crate) const EXAMPLES: &str = "\
Examples:
  glanz eye scene.toml --age 20,50,80 -o ages.png
  glanz eye scene.toml --age 25,75 --level day,dusk,moon --glare -o evening.png
  glanz eye scene.toml --deficiency none,deutan:10,deutan,protan,tritan -o deficiencies.png
  glanz eye scene.toml --deficiency deutan,protan,tritan --against machado,daltonlens -o ways.png
  glanz eye scene.toml --show opponent -o opponent.png
  glanz eye scene.toml --gaze 400,300 -o looked-at.png
  glanz eye scene.toml --level moon,stars --noise --acuity -o photons.png
  glanz eye photo.png --age 20,80 -o photo-by-age.png
  glanz eye scene.toml --age 20:80:60 -o ageing.gif
  glanz eye scene.toml --population 20 --seed 1 -o people.png
  glanz eye scene.toml --mach y=250 --gain 10 -o mach.svg

Each column is an eye, each row a light level, or what it is adapted to: an eye that just got its lens sees its yellow
(unadapted), one that has lived with it sees white as white (adapted). Pictures have ordinary exposure at every light level; --ev
darkens them. docs/EYE.md says what is standard, and what is not known.";

/// Options of `glanz eye`.
#[derive(Args, Debug)]
pub(crate) struct EyeArgs {
    #[command(flatten)]
    pub(crate) input: InputArgs,
    #[command(flatten)]
    eyes: EyesArgs,
    #[command(flatten)]
    target: TargetArgs,
    #[command(flatten)]
    size: SizeArgs,
    #[command(flatten)]
    picture: PictureArgs,
    #[command(flatten)]
    camera: CameraArgs,
    #[command(flatten)]
    develop: DevelopArgs,
    #[command(flatten)]
    machine: MachineArgs,
    #[command(flatten)]
    format: FormatArgs,
}

/// Who looks, and how.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Eye")]
struct EyesArgs {
    /// The eye that the other options change, such as field:10+iris:1.2, or population:20 for --population 20 [default: the scene's,
    /// else the standard one]
    #[arg(long, value_name = "EYE")]
    observer: Option<String>,

    /// Ages in years: 20,50,80, or FIRST:LAST:COUNT
    #[arg(long, value_name = "YEARS,…")]
    age: Option<Ages>,

    /// Deficiencies: none, protan, deutan, tritan, rods, or protan:10 and deutan:10 with a shift of the pigment in nm
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    deficiency: Vec<String>,

    /// Show beside each deficiency what other ways make of it, and how far that is from true cones
    #[arg(long, value_enum, value_name = "WAY,…", value_delimiter = ',')]
    against: Vec<Against>,

    /// Light levels: sun, day, room, dusk, moon, stars, or the luminance of white in cd/m²
    #[arg(long, value_name = "LEVEL,…", value_delimiter = ',')]
    level: Vec<String>,

    /// How far the cones are adapted to the white as the eye sees it, 0 to 1 [default: both where ages or lenses differ, else 1]
    #[arg(long, value_name = "DEGREE,…", value_delimiter = ',')]
    adapted: Vec<f64>,

    /// The luminance that rods and pupil are adapted to, in cd/m² [default: the mean of the picture]
    #[arg(long, value_name = "CD/M²")]
    adaptation: Option<f64>,

    /// The colour of what rods see
    #[arg(long, value_name = "COLOR", value_enum)]
    rods: Option<RodChoice>,

    /// Scatter light in the eye, as it does at the eye's age
    #[arg(long)]
    glare: bool,

    /// Blur what is out of focus since an eye focuses on 555 nm, through the pupil that it has at this light
    #[arg(long)]
    chromatic: bool,

    /// Draw the photons that are caught in a tenth of a second; the number says which noise
    #[arg(long, value_name = "SEED", num_args = 0..=1, default_missing_value = "1")]
    noise: Option<u32>,

    /// Leave out what the eye does not resolve at this light
    #[arg(long)]
    acuity: bool,

    /// The pixel that is looked at, from the top left; details are lost around it
    #[arg(long, value_name = "X,Y", value_parser = gaze)]
    gaze: Option<[f64; 2]>,

    /// Pixels per degree of sight [default: the camera's if it is perspective, else 40]
    #[arg(long, value_name = "N")]
    px_per_deg: Option<f64>,

    /// Draw so many people who differ as people do (Asano 2016), and how far they are apart
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    population: Option<u32>,

    /// Which people
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Plot the Mach bands of a row, such as y=250, for flat, Gouraud and Phong shading; -o names the plot
    #[arg(long, value_name = "y=ROW")]
    mach: Option<mach::Row>,

    /// How many times as high as predicted bands are drawn
    #[arg(long, value_name = "N", default_value_t = 10.0)]
    gain: f64,

    /// What the pictures show
    #[arg(long, value_name = "WHAT", value_enum, default_value = "picture")]
    show: Show,
}

/// What the pictures show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Show {
    /// What the eye sees
    Picture,
    /// What each kind of receptors gets: L, M, S and the rods
    Receptors,
    /// The channels of the optic nerve: luminance, red against green, yellow against blue
    Opponent,
    /// Without and with the loss of detail
    Acuity,
    /// Without and with the light that is scattered in the eye
    Glare,
}

/// The colour of what rods see.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum RodChoice {
    /// Colourless
    White,
    /// Bluish, as in films
    Blue,
}

/// How the pictures are drawn.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Picture")]
struct PictureArgs {
    /// Samples per pixel for smooth edges [default: the scene's, else 4]
    #[arg(long, value_name = "N", value_parser = choices::samples())]
    samples: Option<u32>,

    /// Where light is computed, for all objects
    #[arg(long, value_name = "SHADING", value_parser = choices::shading())]
    shading: Option<Shading>,

    /// The background: #rrggbb, linear r,g,b, or transparent
    #[arg(long, value_name = "COLOR", value_parser = values::background)]
    background: Option<Background>,

    /// Frames per second of a film
    #[arg(long, value_name = "N", default_value_t = 20.0)]
    fps: f64,
}

fn gaze(text: &str) -> Result<[f64; 2], String> {
    let numbers: Vec<f64> = text.split(',').filter_map(|n| n.trim().parse().ok()).collect();
    <[f64; 2]>::try_from(numbers).map_err(|_| "expected the pixel as X,Y, such as 400,300".to_owned())
}

impl EyesArgs {
    /// How many people are drawn who differ as people do.
    fn people(&self) -> Result<Option<u32>, Failure> {
        let Some(count) = self.observer.as_deref().and_then(|name| name.strip_prefix("population:")) else {
            return Ok(self.population);
        };
        let count = count.parse::<u32>().ok().filter(|count| (1..=1000).contains(count));
        count.map(Some).ok_or_else(|| {
            let message = "--observer: expected population:N with N from 1 to 1000, such as population:20";
            Failure::Usage(message.to_owned())
        })
    }

    /// The eye that is named, if one is.
    fn observer(&self) -> Option<&str> {
        self.observer.as_deref().filter(|name| !name.starts_with("population:"))
    }
}

impl EyeArgs {
    /// Draws.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        self.machine.apply()?;
        if let Some(row) = self.eyes.mach {
            return self.mach(row);
        }
        if !self.eyes.against.is_empty() && (self.eyes.show != Show::Picture || self.eyes.people()?.is_some())
        {
            return Err(Failure::Usage(
                "--against goes with pictures: leave out --show or --population".to_owned(),
            ));
        }
        let target = self.target.resolve(&self.input.input, "_eye.png")?;
        let moving = self.moving(&target)?;
        self.format.check_beside(&target)?;
        let mut source = Source::open(self)?;
        print::notes(&self.input.input, source.notes());
        if let Some(count) = self.eyes.people()? {
            let base = variants::base(&self.eyes, &source)?;
            return self.population(count as usize, &mut source, &base, &target);
        }
        let variants = Variants::of(&self.eyes, &source)?;
        variants.remarks().iter().for_each(|remark| print::note(format_args!("note: {remark}")));
        let drawn = self.draw(&mut source, &variants)?;
        match moving {
            Some(format) => self.film(&drawn, &target, format, &source)?,
            None => self.sheet(&variants, &drawn, &target, &source)?,
        }
        self.tell(&target, &variants, &drawn, source.notes().to_vec())
    }

    /// The format of a film, if the target is one.
    fn moving(&self, target: &Target) -> Result<Option<Format>, Failure> {
        if !target.path().is_some_and(|path| {
            encode::format(target).is_ok_and(Format::is_animation) && path.extension().is_some()
        }) {
            encode::expect_png(target, "a sheet")?;
            return Ok(None);
        }
        if !(self.picture.fps > 0.0 && self.picture.fps <= 1000.0) {
            let fps = self.picture.fps;
            return Err(Failure::Usage(format!("--fps is {fps}, but must be above 0 and at most 1000")));
        }
        if self.eyes.show != Show::Picture || !self.eyes.against.is_empty() {
            return Err(Failure::Usage(
                "a film shows pictures alone: leave out --show and --against, or write a .png".to_owned(),
            ));
        }
        Ok(Some(encode::format(target)?))
    }

    fn draw(&self, source: &mut Source, variants: &Variants) -> Result<Vec<Drawn>, Failure> {
        let mut progress = Progress::new(variants.eyes.len(), "eyes");
        let mut drawn = Vec::with_capacity(variants.eyes.len());
        for variant in &variants.eyes {
            drawn.push(draw::draw(self, source, &variant.viewer, &mut progress)?);
            progress.step();
        }
        Ok(drawn)
    }

    /// The options of a drawing command, for the scene's own eye.
    fn look(&self) -> LookArgs {
        LookArgs {
            samples: self.picture.samples,
            shading: self.picture.shading,
            background: self.picture.background,
            show: Some(DebugView::Shaded),
            color: ColorArgs { mode: Some(glanz_scene::ColorMode::Spectral), ..ColorArgs::default() },
            ..LookArgs::default()
        }
    }

    fn sheet(
        &self,
        variants: &Variants,
        drawn: &[Drawn],
        target: &Target,
        source: &Source,
    ) -> Result<(), Failure> {
        // An eye is one picture, or a row of pictures that take it apart.
        let parts = drawn[0].pictures.len();
        let (columns, rows, per_row) = match parts {
            1 => (variants.columns.clone(), variants.rows.clone(), variants.columns.len()),
            _ => {
                let labels = variants.eyes.iter().map(|variant| variant.label.clone()).collect();
                (drawn[0].pictures.iter().map(|(name, _)| name.clone()).collect(), labels, parts)
            }
        };
        let captions = drawn
            .iter()
            .flat_map(|eye| (0..parts).map(|part| eye.captions.get(part).cloned().unwrap_or_default()));
        let pictures: Vec<&Canvas> =
            drawn.iter().flat_map(|eye| eye.pictures.iter().map(|(_, picture)| picture)).collect();
        let sheet = ContactSheet {
            columns,
            rows,
            captions: captions.collect(),
            per_row,
            count: pictures.len(),
            cell: (pictures[0].width, pictures[0].height),
            ..ContactSheet::default()
        };
        let mut canvas = sheet.begin()?;
        for (index, picture) in pictures.iter().enumerate() {
            sheet.put(&mut canvas, index, picture);
        }
        encode::deliver(
            canvas.into(),
            target,
            &encode::metadata_of_sheet(source.content_hash(), Vec::new()),
        )?;
        self.wrote(target);
        Ok(())
    }

    fn film(&self, drawn: &[Drawn], target: &Target, format: Format, source: &Source) -> Result<(), Failure> {
        let Target::File(path) = target else { return Ok(()) };
        let first = &drawn[0].pictures[0].1;
        let animation = Animation {
            width: first.width,
            height: first.height,
            frames: drawn.len(),
            frame_s: 1.0 / self.picture.fps,
        };
        if format == Format::Gif {
            tell_of_gif(&animation);
        }
        let metadata = encode::metadata_of_sheet(source.content_hash(), Vec::new());
        let codes =
            drawn.iter().map(|eye| -> Result<Vec<u8>, Failure> { Ok(eye.pictures[0].1.rgba.clone()) });
        write_atomically(path, |out| match format {
            Format::Gif => write_gif(out, &animation, codes, &metadata),
            _ => write_apng(out, &animation, codes, &metadata),
        })?;
        self.wrote(target);
        Ok(())
    }

    fn wrote(&self, target: &Target) {
        if let Target::File(path) = target {
            print::note(format_args!("wrote {}", path.display()));
        }
    }

    fn tell(
        &self,
        target: &Target,
        variants: &Variants,
        drawn: &[Drawn],
        notes: Vec<String>,
    ) -> Result<(), Failure> {
        let patches = Patches::of(variants, drawn);
        let Target::File(path) = target else {
            print::note(patches.text().trim_end());
            return Ok(());
        };
        if !self.format.is_json() {
            return match patches.is_empty() {
                true => Ok(()),
                false => print::text(&patches.text()),
            };
        }
        let eyes = variants.eyes.iter().zip(drawn);
        print::json(&Document {
            file: path.display().to_string(),
            eyes: eyes.map(|(variant, drawn)| EyeFacts::of(&variant.label, &variant.viewer, drawn)).collect(),
            patches,
            notes,
        })
    }
}

impl From<RodChoice> for RodColor {
    fn from(choice: RodChoice) -> Self {
        match choice {
            RodChoice::White => Self::White,
            RodChoice::Blue => Self::Blue,
        }
    }
}

/// Linear light of the screen as codes.
fn code(rgb: [f32; 3]) -> [u8; 4] {
    let Rgb(rgb) = Rgb(rgb);
    let [r, g, b] = rgb.map(|c| (255.0 * glanz_color::srgb_encode(c.clamp(0.0, 1.0)) + 0.5) as u8);
    [r, g, b, 255]
}
