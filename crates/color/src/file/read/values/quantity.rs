//! What is measured, and the words by which files say it.

/// What the values of a spectrum are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quantity {
    /// The file does not say.
    #[default]
    Unknown,
    /// The fraction of light that comes back: 0 to 1, more with fluorescence.
    Reflectance,
    /// The fraction of light that passes.
    Transmittance,
    /// The fraction of light that stays.
    Absorptance,
    /// The decadic logarithm of 1 over the transmittance. Readers give it as a transmittance.
    Absorbance,
    /// Light of some unit; see the spectrum's `unit`.
    Light,
    /// Light without a unit.
    Relative,
}

/// Words of headers, in several languages, and what they name; the first that is found counts.
const WORDS: [(&[&str], Quantity); 5] = [
    (&["reflec", "réflec", "remission", "radiance factor"], Quantity::Reflectance),
    (&["transmi"], Quantity::Transmittance),
    (&["absorptance"], Quantity::Absorptance),
    (&["absorbance", "optical density"], Quantity::Absorbance),
    (
        &["radiance", "irrad", "flux", "power", "intensity", "exitance", "spd", "emission", "éclairement"],
        Quantity::Light,
    ),
];

/// Words by which light comes back or passes, and those of its power: a reflected radiance is light, a reflectance is none.
const RETURNED: [&str; 2] = ["reflected", "transmitted"];
const POWER: [&str; 6] = ["radiance", "irrad", "flux", "power", "intensity", "exitance"];

/// What names a quantity where nothing else stands, in small letters without blanks. IT8.7/1 are targets of film, IT8.7/2 those of
/// paper (ANSI IT8.7/1 and IT8.7/2, 1993).
const ALONE: [(&[&str], Quantity); 4] = [
    (&["reflectance", "reflection", "refl", "%r", "r%", "r(%)", "r[%]", "it8.7/2"], Quantity::Reflectance),
    (&["transmittance", "transmission", "%t", "t%", "t(%)", "t[%]", "it8.7/1"], Quantity::Transmittance),
    (&["absorbance", "abs", "abs."], Quantity::Absorbance),
    (
        &[
            "irradiance",
            "radiance",
            "radiantflux",
            "emission",
            "ems",
            "energy",
            "spectralirradiance",
            "spectralradiance",
        ],
        Quantity::Light,
    ),
];

/// Words of files' names that say what they are of; CIE's illuminants, and charts of colours, among them.
const NAMES: [(&[&str], Quantity); 5] = [
    (
        &[
            "reflectance",
            "reflectances",
            "reflection",
            "reflectivity",
            "refl",
            "réflectance",
            "remission",
            "colorchecker",
            "colourchecker",
            "macbethcolorchecker",
            "munsell",
        ],
        Quantity::Reflectance,
    ),
    (&["transmittance", "transmittances", "transmission", "transmissivity"], Quantity::Transmittance),
    (&["absorptance"], Quantity::Absorptance),
    (&["absorbance"], Quantity::Absorbance),
    (
        &[
            "radiance",
            "irradiance",
            "spectralirradiance",
            "spectralradiance",
            "irrad",
            "ssirrad",
            "emission",
            "spd",
            "illuminant",
            "illum",
        ],
        Quantity::Light,
    ),
];

/// Things that send light: a name with one of them may be of it, whatever else it says.
const LAMPS: [&str; 15] = [
    "lamp",
    "lamps",
    "led",
    "leds",
    "light",
    "lights",
    "bulb",
    "bulbs",
    "luminaire",
    "lantern",
    "flash",
    "reflector",
    "reflectors",
    "transmitter",
    "transmitters",
];

/// Illuminants of the CIE, as files are named after them behind the word CIE.
const ILLUMINANTS: [&str; 5] = ["a", "d50", "d55", "d65", "d75"];

impl Quantity {
    /// The quantity that a header's text names.
    pub(in crate::file::read) fn of(text: &str) -> Self {
        let lower = text.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|word| lower.contains(word));
        if has(&RETURNED) && has(&POWER) && !lower.contains("factor") {
            return Self::Light;
        }
        if let Some((_, quantity)) = WORDS.iter().find(|(words, _)| has(words)) {
            return *quantity;
        }
        if is_word(&lower, "refl") {
            Self::Reflectance
        } else if has(&["w/", "w m", "w.m", "w·m"]) {
            Self::Light
        } else if has(&["relative"]) {
            Self::Relative
        } else {
            Self::alone(text)
        }
    }

    /// The quantity that a field names, and nothing else: `Reflectance`, `%T`, `energy`.
    pub(in crate::file::read) fn alone(field: &str) -> Self {
        let bare: String = field.to_lowercase().chars().filter(|c| !c.is_whitespace() && *c != '"').collect();
        let found = ALONE.iter().find(|(words, _)| words.contains(&bare.as_str()));
        found.map_or(Self::Unknown, |(_, quantity)| *quantity)
    }

    /// What a line says of the whole table: the field behind its last separator, if it is a quantity alone, as in
    /// `Technique,Transmission`, `Measurement: REFLECTANCE` or `quantity  energy`.
    pub(in crate::file::read) fn stated(line: &str) -> Self {
        // A title, and no key of a colorimeter's settings.
        if line.trim().to_lowercase().starts_with("cie illuminant") && !line.contains([':', '=']) {
            return Self::Light;
        }
        let line = line.replace("  ", "\t");
        let fields = line.trim().trim_end_matches([',', ';', '\t', ' ']);
        Self::alone(fields.rsplit([',', ';', '\t', ':', '=']).next().unwrap_or_default())
    }

    /// What a file's name says: `lamp.SSIrrad`, `leaf-reflectance.csv`, `CIE_illum_C.csv`.
    ///
    /// The ending `spd` says nothing: renderers write refractive indices into such files, too.
    pub(in crate::file::read) fn of_file(file: &str) -> Self {
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file).to_lowercase();
        let name = name.strip_suffix(".spd").unwrap_or(&name);
        let words: Vec<&str> = name.split(|c: char| !c.is_alphanumeric()).collect();
        let plain = |word: &&str| word.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned();
        let is_lamp = words.iter().map(plain).any(|word| LAMPS.contains(&word.as_str()));
        let has = |known: &[&str]| words.iter().any(|word| known.contains(word));
        match NAMES.iter().find(|(known, _)| has(known)) {
            Some((_, quantity)) if *quantity == Self::Light || !is_lamp => *quantity,
            None if is_illuminant(name) => Self::Light,
            _ => Self::Unknown,
        }
    }

    /// In words, with its article.
    pub(in crate::file::read) fn words(self) -> &'static str {
        match self {
            Self::Unknown => "unknown",
            Self::Reflectance => "a reflectance",
            Self::Transmittance => "a transmittance",
            Self::Absorptance => "an absorptance",
            Self::Absorbance => "an absorbance",
            Self::Light | Self::Relative => "light",
        }
    }

    /// Whether the values are fractions of light, so that per cent can be told from them.
    pub fn is_ratio(self) -> bool {
        matches!(self, Self::Reflectance | Self::Transmittance | Self::Absorptance)
    }
}

/// Whether a text has this word among its letters and digits.
fn is_word(lower: &str, word: &str) -> bool {
    lower.split(|c: char| !c.is_alphanumeric()).any(|found| found == word)
}

/// Whether a name is `CIE` and an illuminant behind it: `CIE-F11`, `cie_d65`.
fn is_illuminant(name: &str) -> bool {
    let words: Vec<&str> = name.split(|c: char| !c.is_alphanumeric()).collect();
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let is_lamp = |word: &str| word.strip_prefix("fl").or(word.strip_prefix('f')).is_some_and(is_number);
    words.windows(2).any(|pair| pair[0] == "cie" && (ILLUMINANTS.contains(&pair[1]) || is_lamp(pair[1])))
}
