//! The passes of a shader: those that the command line names, those that its text asks for by `#iChannel0 "file://…"`, and
//! those that glslViewer makes of one text by `#define BUFFER_0`.

use std::cell::RefCell;
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use glanz_math::names::did_you_mean;
use glanz_shader::{
    Border, Channel, Channels, Language, Pass, PassTexture, Passes, Program, ScreenError, Shader, Stage,
    TextureInfo, is_of_a_pass,
};

use super::RunArgs;
use super::given::{picture, uniforms};
use crate::input::shader_text::{Texts, read};
use crate::print::failure::{Failure, Report};

/// Passes of one picture.
const MOST_PASSES: usize = 32;

/// Endings of files that are shaders and no pictures.
const SHADERS: [&str; 9] = ["glsl", "frag", "fs", "fsh", "fragmentshader", "shader", "wgsl", "toy", "txt"];

/// A pass before its textures are known.
struct Draft {
    file: PathBuf,
    program: Arc<Program>,
    visited: bool,
    /// By the numbers of the channels: what they are, and the folder in which files are looked for.
    channels: HashMap<u32, (Channel, PathBuf)>,
    textures: Vec<Option<PassTexture>>,
}

/// All passes in the making.
struct Drafts<'a> {
    args: &'a RunArgs,
    list: Vec<Draft>,
    /// The passes of files that texts name, by what they were compiled with.
    known: HashMap<(PathBuf, String), usize>,
    /// Passes of the command line by their names.
    named: HashMap<String, usize>,
    /// The one that draws the picture.
    main: usize,
    /// In the order in which they are drawn.
    order: Vec<usize>,
    notes: Vec<String>,
}

/// What was made of a shader's file.
pub(super) struct Made {
    pub(super) passes: RefCell<Passes>,
    /// The file of each pass.
    pub(super) files: Vec<PathBuf>,
    /// What is odd.
    pub(super) notes: Vec<String>,
}

/// All passes of a command line.
pub(super) fn passes(args: &RunArgs) -> Result<Made, Failure> {
    let mut drafts = Drafts {
        args,
        list: Vec::new(),
        known: HashMap::new(),
        named: HashMap::new(),
        main: 0,
        order: Vec::new(),
        notes: Vec::new(),
    };
    let main = drafts.shared(&args.file, &args.defines())?;
    drafts.main = main;
    drafts.of_command_line()?;
    for (number, channel) in drafts.given_channels() {
        drafts.list[main].channels.insert(number, channel);
    }
    for (name, _) in &args.pass {
        if let Some(pass) = drafts.named.get(name).copied() {
            drafts.visit(pass)?;
        }
    }
    drafts.visit(main)?;
    drafts.made()
}

/// Channels with what they are.
type GivenChannels<'a> = Vec<(u32, &'a str)>;

/// `FILE,0=WHAT,1=WHAT`: the file, and what its channels are.
fn split(text: &str) -> Result<(&str, GivenChannels<'_>), String> {
    let mut parts = text.split(',');
    let file = parts.next().unwrap_or("");
    let mut channels = Vec::new();
    for part in parts {
        let (number, what) = part.split_once('=').unwrap_or((part, ""));
        match number.trim().parse() {
            Ok(number @ 0..4) if !what.is_empty() => channels.push((number, what)),
            _ => {
                return Err(format!(
                    "'{part}' is no channel: expected 0=, 1=, 2= or 3= and a pass or a file"
                ));
            }
        }
    }
    Ok((file, channels))
}

impl Drafts<'_> {
    /// The passes that `--pass` names.
    fn of_command_line(&mut self) -> Result<(), Failure> {
        for (name, text) in &self.args.pass {
            let usage = |why: String| Failure::Usage(format!("--pass {name}: {why}"));
            if name == "self" || self.named.contains_key(name) {
                return Err(usage("the name is taken".to_owned()));
            }
            let (file, channels) = split(text).map_err(usage)?;
            let pass = self.own(Path::new(file), &self.args.defines())?;
            self.named.insert(name.clone(), pass);
            for (number, what) in channels {
                self.list[pass].channels.insert(number, of_words(what));
            }
        }
        Ok(())
    }

    fn given_channels(&self) -> Vec<(u32, (Channel, PathBuf))> {
        let args = self.args;
        let all = [&args.channel0, &args.channel1, &args.channel2, &args.channel3];
        (0..).zip(all).filter_map(|(number, what)| Some((number, of_words(what.as_ref()?)))).collect()
    }

    /// The pass of a file, which is one however often texts name it.
    fn shared(&mut self, file: &Path, defines: &[(String, String)]) -> Result<usize, Failure> {
        let key = (std::fs::canonicalize(file).unwrap_or_else(|_| file.to_owned()), format!("{defines:?}"));
        if let Some(known) = self.known.get(&key) {
            return Ok(*known);
        }
        let pass = self.own(file, defines)?;
        self.known.insert(key, pass);
        Ok(pass)
    }

    /// A pass of a file by itself.
    fn own(&mut self, file: &Path, defines: &[(String, String)]) -> Result<usize, Failure> {
        if self.list.len() == MOST_PASSES {
            return Err(Report::new(format_args!("there are more than {MOST_PASSES} passes"))
                .file(file)
                .into());
        }
        let (program, channels, notes) = compile(self.args, file, defines)?;
        let textures = vec![None; program.interface().textures.len()];
        let (file, program) = (file.to_owned(), Arc::new(program));
        self.list.push(Draft { file, program, visited: false, channels, textures });
        self.notes.extend(notes);
        Ok(self.list.len() - 1)
    }

    /// Finds what a pass looks into, and puts it behind what it needs. Those of the command line are in its order, and a
    /// circle is closed by the frame before.
    fn visit(&mut self, pass: usize) -> Result<(), Failure> {
        if std::mem::replace(&mut self.list[pass].visited, true) {
            return Ok(());
        }
        let textures = self.list[pass].program.interface().textures.clone();
        for (index, texture) in textures.iter().enumerate() {
            // What is only declared must not come first.
            if !self.list[pass].program.looks_into(index) {
                continue;
            }
            let found = self.texture(pass, texture)?;
            if let Some(PassTexture::Pass { number, .. }) = &found {
                let number = *number;
                let has_its_place = number == self.main || self.named.values().any(|named| *named == number);
                if !has_its_place {
                    self.visit(number)?;
                }
            }
            self.list[pass].textures[index] = found;
        }
        self.order.push(pass);
        Ok(())
    }

    /// What a texture of a pass is, if anything says it.
    fn texture(&mut self, pass: usize, texture: &TextureInfo) -> Result<Option<PassTexture>, Failure> {
        let name = texture.name.as_str();
        let number =
            ["iChannel", "u_tex"].iter().find_map(|head| name.strip_prefix(head)?.parse::<u32>().ok());
        if let Some((channel, folder)) =
            number.and_then(|number| self.list[pass].channels.get(&number)).cloned()
        {
            return self.channel(pass, texture, &channel, &folder);
        }
        let linear = |number: usize| PassTexture::Pass { number, border: Border::Hold, nearest: false };
        for (head, define) in [("u_doubleBuffer", "DOUBLE_BUFFER_"), ("u_buffer", "BUFFER_")] {
            let Some(index) = name.strip_prefix(head).and_then(|rest| rest.parse::<u32>().ok()) else {
                continue;
            };
            let define = format!("{define}{index}");
            let file = self.list[pass].file.clone();
            if !read(&file)?.contains(&define) {
                continue;
            }
            let mut defines = self.args.defines();
            defines.push((define, String::new()));
            return Ok(Some(linear(self.shared(&file, &defines)?)));
        }
        let lower = name.to_lowercase();
        let is_before = ["backbuffer", "prevframe", "previousframe"].iter().any(|word| lower.contains(word));
        Ok(is_before.then(|| linear(pass)))
    }

    /// What a channel is.
    fn channel(
        &mut self,
        pass: usize,
        texture: &TextureInfo,
        channel: &Channel,
        folder: &Path,
    ) -> Result<Option<PassTexture>, Failure> {
        let Some(source) = &channel.source else { return Ok(None) };
        let of_pass = |number: usize| {
            let border = channel.border.unwrap_or(Border::Hold);
            Some(PassTexture::Pass { number, border, nearest: channel.nearest })
        };
        if source == "self" || source == "file://self" {
            return Ok(of_pass(pass));
        }
        if let Some(named) = self.named.get(source) {
            return Ok(of_pass(*named));
        }
        if source.starts_with("http://") || source.starts_with("https://") {
            let (file, line) = (&self.list[pass].file, channel.line);
            let report = Report::new(format_args!("{}:{line}: '{source}' is not fetched", file.display()));
            let help = "save the picture, and name its file";
            return Err(report.file(file).place(line.into(), 1).help(help).into());
        }
        let path = folder.join(source.strip_prefix("file://").unwrap_or(source));
        let is_word = channel.line == 0 && source.chars().all(|c| c.is_alphanumeric() || c == '_');
        if is_word && !path.exists() {
            let hint = did_you_mean(source, self.named.keys().map(String::as_str));
            let message = format!("'{source}' is neither a pass, self, nor a file{hint}; see --pass");
            return Err(Failure::Usage(message));
        }
        let ending = path.extension().map(|end| end.to_string_lossy().to_lowercase()).unwrap_or_default();
        if SHADERS.contains(&ending.as_str()) {
            let defines = self.args.defines();
            return Ok(of_pass(self.shared(&path, &defines)?));
        }
        let picture = picture(&path.to_string_lossy(), texture)?;
        let picture = channel.border.map_or(picture.clone(), |border| picture.bordered(border));
        Ok(Some(PassTexture::Picture(if channel.nearest { picture.nearest() } else { picture })))
    }

    /// Puts all together.
    fn made(mut self) -> Result<Made, Failure> {
        self.named_textures()?;
        self.check()?;
        let place: HashMap<usize, usize> =
            self.order.iter().enumerate().map(|(at, pass)| (*pass, at)).collect();
        let mut passes = Vec::new();
        let set = uniforms(self.args, self.order.iter().map(|pass| &*self.list[*pass].program))?;
        for (pass, set) in self.order.iter().zip(set) {
            let draft = &self.list[*pass];
            let texture = |own: &Option<PassTexture>| match own.clone()? {
                PassTexture::Pass { number, border, nearest } => {
                    Some(PassTexture::Pass { number: *place.get(&number)?, border, nearest })
                }
                picture @ PassTexture::Picture(_) => Some(picture),
            };
            passes.push(Pass {
                program: Arc::clone(&draft.program),
                textures: draft.textures.iter().map(texture).collect(),
                set,
                from_top: Language::of_file(&draft.file.display().to_string()) == Language::Wgsl,
            });
        }
        let files: Vec<PathBuf> = self.order.iter().map(|pass| self.list[*pass].file.clone()).collect();
        let size = [self.args.size.0, self.args.size.1];
        let passes = Passes::new(passes, size, self.args.samples);
        let passes = passes.map_err(|error| screen_failure(&error, &self.args.file))?;
        Ok(Made { passes: RefCell::new(passes), files, notes: self.notes })
    }

    /// Pictures by the names of textures.
    fn named_textures(&mut self) -> Result<(), Failure> {
        for (name, file) in &self.args.texture {
            let mut is_there = false;
            for draft in &mut self.list {
                let textures = &draft.program.interface().textures;
                if let Some(index) = textures.iter().position(|own| own.name == *name) {
                    draft.textures[index] = Some(PassTexture::Picture(picture(file, &textures[index])?));
                    is_there = true;
                }
            }
            if !is_there {
                let all = self.list.iter().flat_map(|draft| &draft.program.interface().textures);
                let hint = did_you_mean(name, all.map(|own| own.name.as_str()));
                let message = format!("--texture: the shader looks into no texture '{name}'{hint}");
                return Err(Failure::Usage(message));
            }
        }
        Ok(())
    }

    /// That channels of the command line are looked into, and that what passes draw is known.
    fn check(&self) -> Result<(), Failure> {
        let textures = || self.list.iter().flat_map(|draft| &draft.program.interface().textures);
        for (number, _) in self.given_channels() {
            let names = [format!("iChannel{number}"), format!("u_tex{number}")];
            if !textures().any(|own| names.contains(&own.name)) {
                return Err(Failure::Usage(format!(
                    "--channel{number}: the shader looks into no texture '{}'",
                    names.join("' or '")
                )));
            }
        }
        for draft in &self.list {
            let textures = draft.program.interface().textures.iter().zip(&draft.textures).enumerate();
            for (index, (texture, found)) in textures {
                if found.is_none() && draft.program.looks_into(index) && is_of_a_pass(&texture.name) {
                    let name = &texture.name;
                    let message = format!("'{name}' is what another pass draws, and no pass is known for it");
                    let help = format!("a picture may stand for it: --texture {name}=FILE");
                    return Err(Report::new(message).file(&draft.file).help(help).into());
                }
            }
        }
        Ok(())
    }
}

/// What the command line says of a channel.
fn of_words(what: &str) -> (Channel, PathBuf) {
    (Channel { source: Some(what.to_owned()), ..Channel::default() }, PathBuf::new())
}

type Compiled = (Program, HashMap<u32, (Channel, PathBuf)>, Vec<String>);

/// Compiles a file with the lines that tell of its channels taken out.
fn compile(args: &RunArgs, file: &Path, defines: &[(String, String)]) -> Result<Compiled, Failure> {
    let texts = Texts::read(file)?;
    let found = Mutex::new((HashMap::new(), Vec::new()));
    let take = |text: &str, of: &Path| {
        let (rest, channels) = Channels::read(text);
        let folder = of.parent().unwrap_or(Path::new("")).to_owned();
        let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
        found.1.extend(
            channels
                .ignored
                .iter()
                .map(|(line, words)| format!("{}:{line}: '{words}' means nothing here", of.display())),
        );
        for (number, channel) in channels.list {
            found.0.entry(number).or_insert((channel, folder.clone()));
        }
        rest
    };
    let is_glsl = Language::of_file(texts.name()) == Language::Glsl;
    let text = if is_glsl { take(&texts.text(), file) } else { texts.text() };
    let include = |path: &str, _: &str| {
        let text = texts.include(path)?;
        Some(take(&text, &file.parent()?.join(path)))
    };
    let mut shader = Shader::new(Stage::Fragment, text).named(texts.name()).include(&include).toy();
    for (name, text) in defines {
        shader = shader.define(name, text);
    }
    if let Some(common) = args.common.as_ref().filter(|_| is_glsl) {
        let name = common.display().to_string();
        let text = read(common)?;
        texts.add(&name, &text);
        shader = shader.common(&name, text);
    }
    let program = shader.compile().map_err(|error| texts.failure(&error))?;
    let (channels, notes) = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok((program, channels, notes))
}

/// A shader that cannot fill a picture.
pub(super) fn screen_failure(error: &ScreenError, file: &Path) -> Failure {
    match error {
        ScreenError::Uniform(error) => Failure::Usage(format!("--uniform: {error}")),
        error => Report::new(error).file(file).into(),
    }
}
