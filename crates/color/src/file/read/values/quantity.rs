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

/// What names a quantity where nothing else stands, in small letters without blanks.
const ALONE: [(&[&str], Quantity); 4] = [
    (&["reflectance", "reflection", "refl", "%r", "r%", "r(%)", "r[%]"], Quantity::Reflectance),
    (&["transmittance", "transmission", "%t", "t%", "t(%)", "t[%]"], Quantity::Transmittance),
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

/// Words of files' names that say that they are of light.
const LIGHTS: [&str; 3] = ["illuminant", "illuminants", "illum"];

impl Quantity {
    /// The quantity that a header's text names.
    pub(in crate::file::read) fn of(text: &str) -> Self {
        let lower = text.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|word| lower.contains(word));
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
        let has = |words: &[&str]| words.iter().any(|word| name.contains(word));
        match WORDS.iter().find(|(words, _)| has(words)) {
            // These are words of many names: power plants, flux lines.
            Some((_, Self::Light)) if !has(&["radiance", "irrad", "emission"]) && !is_word(name, "spd") => {
                Self::Unknown
            }
            Some((_, quantity)) => *quantity,
            None if LIGHTS.iter().any(|word| is_word(name, word)) => Self::Light,
            None => Self::Unknown,
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
