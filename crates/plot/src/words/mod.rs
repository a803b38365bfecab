//! The words of plots, in each language: one table for axes, legends, titles and remarks.

mod names;

use std::str::FromStr;

/// The language of a plot's words. Names of media, spectra and parameters are the same in all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// French.
    Fr,
}

impl Lang {
    /// Every language with its code of ISO 639-1 and its own name.
    pub const ALL: [(Self, &'static str, &'static str); 2] =
        [(Self::En, "en", "English"), (Self::Fr, "fr", "français")];

    /// The code of ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Fr => "fr",
        }
    }

    /// The words in this language, with `parts` in place of `{0}`, `{1}`, ….
    ///
    /// ```
    /// use glanz_plot::words::{Lang, Word};
    ///
    /// assert_eq!(Lang::Fr.say(Word::Viewer, &[]), "observateur");
    /// assert_eq!(Lang::En.say(Word::MirrorAt, &["30"]), "mirror 30°");
    /// ```
    pub fn say(self, word: Word, parts: &[&str]) -> String {
        let text = match self {
            Self::En => word.english(),
            Self::Fr => word.french(),
        };
        filled(text, parts)
    }
}

impl Lang {
    /// The name of a model or of a representation of spectra.
    ///
    /// ```
    /// use glanz_plot::words::Lang;
    ///
    /// assert_eq!(Lang::Fr.name("Perfect mirror"), "Miroir parfait");
    /// assert_eq!(Lang::Fr.name("Phong 1975"), "Phong 1975");
    /// ```
    pub fn name(self, english: &str) -> &str {
        match self {
            Self::En => english,
            Self::Fr => names::french(english),
        }
    }

    /// A number as [`number`](crate::number) writes it, in French with a decimal comma.
    ///
    /// ```
    /// use glanz_plot::words::Lang;
    ///
    /// assert_eq!(Lang::Fr.number(0.25), "0,25");
    /// assert_eq!(Lang::En.number(0.25), "0.25");
    /// ```
    pub fn number(self, value: f64) -> String {
        self.decimal(crate::number(value))
    }

    /// The text of a number as this language writes it.
    pub(crate) fn decimal(self, number: String) -> String {
        match self {
            Self::En => number,
            Self::Fr => number.replace('.', ","),
        }
    }

    /// Parts of a sentence, one after the other.
    pub(crate) fn join(self, parts: &[String]) -> String {
        parts.join(match self {
            Self::En => "; ",
            Self::Fr => " ; ",
        })
    }
}

/// The code of ISO 639-1.
impl FromStr for Lang {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|(_, code, _)| code.eq_ignore_ascii_case(text));
        found.map(|(lang, ..)| lang).ok_or_else(|| "expected en or fr".to_owned())
    }
}

/// The text with the parts in their places; what a part holds is not looked into again.
fn filled(text: &str, parts: &[&str]) -> String {
    let mut all = String::new();
    let mut pieces = text.split('{');
    all.push_str(pieces.next().unwrap_or_default());
    for piece in pieces {
        let (index, rest) = piece.split_once('}').unwrap_or(("", piece));
        all.push_str(index.parse::<usize>().ok().and_then(|index| parts.get(index)).unwrap_or(&""));
        all.push_str(rest);
    }
    all
}

macro_rules! words {
    ($($name:ident: $english:literal, $french:literal;)+) => {
        /// What plots say. `{0}`, `{1}`, … are the places of numbers and names.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Word {
            $(
                #[doc = concat!("“", $english, "”")]
                $name,
            )+
        }

        impl Word {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name),+];

            fn english(self) -> &'static str {
                match self { $(Self::$name => $english,)+ }
            }

            fn french(self) -> &'static str {
                match self { $(Self::$name => $french,)+ }
            }
        }
    };
}

words! {
    // Directions.
    Viewer: "viewer", "observateur";
    Mirror: "mirror", "miroir";
    MirrorAt: "mirror {0}°", "miroir {0}°";
    Surface: "surface", "surface";
    ByLight: "{0} by the direction of the light", "{0} selon la direction de la lumière";
    AngleFromNormal: "angle from the normal in °", "angle avec la normale en °";
    AngleOfLight: "angle of the light from the normal in °", "angle de la lumière avec la normale en °";
    AngleOfViewer: "angle of the viewer from the normal in °", "angle de l’observateur avec la normale en °";
    AngleOfIncidence: "angle of incidence in °", "angle d’incidence en °";
    ViewerSide: "negative angles are on the viewer's side of the normal",
        "les angles négatifs sont du côté de l’observateur";
    ViewerAtPhi: "viewer at φ = {0}°", "observateur à φ = {0}°";
    // Lobes.
    Lobes: "Lobes", "Lobes";
    LobesInPlane: "Lobes in the plane of incidence", "Lobes dans le plan d’incidence";
    F: "f in 1/sr", "f en 1/sr";
    FCos: "f · cosθi in 1/sr", "f · cosθi en 1/sr";
    CourseF: "π · f", "π · f";
    CourseFCos: "π · f · cosθi", "π · f · cosθi";
    PeakOverPi: "Lambert's and Phong's peak is 1/π", "le maximum de Lambert et de Phong est 1/π";
    PeakOne: "Lambert's and Phong's peak is 1", "le maximum de Lambert et de Phong est 1";
    Logarithmic: "{0} (logarithmic, {1} decades)", "{0} (logarithmique, {1} décades)";
    UpTo: "{0}: up to {1}", "{0} : jusqu’à {1}";
    TimesReflectance: "times {0} at {1} nm", "fois {0} à {1} nm";
    TimesFresnel: "times the reflectance of {0} at {1} nm", "fois la réflectance de {0} à {1} nm";
    Direction: "direction of the light, {0}", "direction de la lumière, {0}";
    // Albedo.
    Albedo: "Directional albedo: {0}", "Albédo directionnel : {0}";
    SeveralModels: "several models", "plusieurs modèles";
    UnderFurnace: "under light of 1 from all around", "sous une lumière de 1 venant de partout";
    PartThatLeaves: "part of the light that leaves", "part de la lumière qui repart";
    // Slices.
    Slices: "BRDF slices", "Coupes de BRDF";
    SliceAxes: "half vector across, difference angle up, φd = 90°; grey is below the surface, and black holds all that is more",
        "vecteur médian en abscisse, angle de différence en ordonnée, φd = 90° ; gris : sous la surface ; noir : tout ce qui dépasse";
    HalfAngle: "θh, half vector from the normal, in °", "θh, vecteur médian et normale, en °";
    DifferenceAngle: "θd, light from the half vector, in °", "θd, lumière et vecteur médian, en °";
    // Factors of microfacet models.
    Factors: "Factors of facet models", "Facteurs des modèles à facettes";
    DTitle: "D: facets by their normals", "D : facettes selon leur normale";
    DLabel: "D in 1/sr", "D en 1/sr";
    FacetAngle: "facet from the normal in °", "facette et normale en °";
    GTitle: "G: facets neither masked nor in shadow", "G : facettes ni masquées ni à l’ombre";
    GAxis: "light from the normal in °, the viewer stays", "lumière et normale en °, l’observateur fixe";
    FTitle: "F: reflectance of a facet", "F : réflectance d’une facette";
    FacetIncidence: "light from the facet's normal in °", "lumière et normale de la facette en °";
    AtNm: "{0} at {1} nm", "{0} à {1} nm";
    // Fresnel.
    Fresnel: "Fresnel reflectance", "Réflectance de Fresnel";
    FromAir: "of unpolarised light of {0} nm, from air; dashed: Schlick 1994",
        "lumière non polarisée de {0} nm, venant de l’air ; tirets : Schlick 1994";
    FromMedium: "of unpolarised light of {0} nm; n < 1 is the way out, from a medium of 1/n to air; dashed: Schlick 1994",
        "lumière non polarisée de {0} nm ; n < 1 : à la sortie, d’un milieu 1/n vers l’air ; tirets : Schlick 1994";
    Polarisations: "{0}; dotted: s above, p below", "{0} ; pointillés : s en haut, p en bas";
    Brewster: "Brewster {0}°", "Brewster {0}°";
    Critical: "critical angle {0}°", "angle limite {0}°";
    Schlick: "{0}, Schlick", "{0}, Schlick";
    Reflectance: "reflectance", "réflectance";
    // Lights.
    Attenuation: "Attenuation over distance", "Atténuation avec la distance";
    AttenuationLaw: "1 / (constant + linear · d + quadratic · d²)", "1 / (constante + linéaire · d + quadratique · d²)";
    Distance: "distance in m", "distance en m";
    PartThatArrives: "part of the light that arrives", "part de la lumière qui arrive";
    Spot: "Cone of a spot", "Cône d’un projecteur";
    SpotLaw: "cosine to the power of the exponent within the cutoff, nothing beyond",
        "cosinus à la puissance de l’exposant dans le cône, rien au-delà";
    AngleFromAxis: "angle from the axis in °", "angle avec l’axe en °";
    // Directions at a point.
    Vectors: "Directions at a point", "Directions en un point";
    VectorsLaw: "N normal, L light, V viewer, R = 2 (N·L) N – L, H = (L + V) / |L + V|",
        "N normale, L lumière, V observateur, R = 2 (N·L) N – L, H = (L + V) / |L + V|";
    AzimuthInDeg: "azimuth in °", "azimut en °";
    // Spectra.
    Wavelength: "wavelength in nm", "longueur d’onde en nm";
    Ultraviolet: "ultraviolet", "ultraviolet";
    Band: "300 to 780 nm", "300 à 780 nm";
    Spectra: "Spectra", "Spectres";
    Lights: "Lights", "Lumières";
    Reflectances: "Reflectances", "Réflectances";
    TwoSurfaces: "Two surfaces", "Deux surfaces";
    And: "{0} and {1}", "{0} et {1}";
    RelativePower: "relative power per nm", "puissance relative par nm";
    PowerOrReflectance: "relative power per nm, or reflectance", "puissance relative par nm, ou réflectance";
    Normalized: "relative to the greatest value", "rapporté à la plus grande valeur";
    // The eye and its colours.
    Cones: "Cones and rods", "Cônes et bâtonnets";
    ConesSource: "Cone fundamentals of Stockman and Sharpe (CIE 170-1:2006), rods of CIE 1951",
        "Cônes de Stockman et Sharpe (CIE 170-1:2006), bâtonnets de la CIE 1951";
    Confusion: "Confusion lines", "Lignes de confusion";
    ConfusionSource: "Colours of a line differ in the missing cones alone; the diagram of CIE 170-2:2015, 2°",
        "Les couleurs d’une ligne ne diffèrent que par les cônes absents ; le diagramme de la CIE 170-2:2015, 2°";
    ConesOfEyes: "CIE 170-1:2006, rods of CIE 1951 through the lens; 1 is the peak of the standard eye",
        "CIE 170-1:2006, bâtonnets de la CIE 1951 à travers le cristallin ; 1 est le maximum de l’observateur standard";
    Rods: "rods, V′(λ)", "bâtonnets, V′(λ)";
    Sensitivity: "relative sensitivity, by energy", "sensibilité relative, en énergie";
    Meyer: "Meyer’s basis functions", "Fonctions de base de Meyer";
    MeyerAxes: "The opponent space AC1C2 over wavelength, and the four samples in nm (Meyer 1988)",
        "L’espace antagoniste AC1C2 selon la longueur d’onde, et les quatre échantillons en nm (Meyer 1988)";
    MeyerA: "A, light and dark", "A, clair et sombre";
    MeyerC1: "C1, green and red", "C1, vert et rouge";
    MeyerC2: "C2, blue and yellow", "C2, bleu et jaune";
    MeyerLabel: "response per nm, in the unit of the published weights", "réponse par nm, dans l’unité des poids publiés";
    Chromaticity: "Chromaticity, CIE 1931", "Chromaticité, CIE 1931";
    ChromaticityAxes: "Spectral colours by wavelength in nm, black bodies by temperature in K",
        "Couleurs du spectre par longueur d’onde en nm, corps noirs par température en K";
    Locus: "spectral colours", "couleurs du spectre";
    BlackBodies: "black bodies", "corps noirs";
    Temperature: "temperature in K", "température en K";
    Gamuts: "primaries", "primaires";
    Marks: "marked colours", "couleurs marquées";
    // Curves of the eye.
    Years: "{0} years", "{0} ans";
    LensByAge: "Lens by age", "Cristallin selon l’âge";
    LensSource: "solid: CIE 170-1:2006, the lens, from 390 nm; dashed: CIE 203:2012, all media of the eye",
        "traits pleins : CIE 170-1:2006, le cristallin, dès 390 nm ; tirets : CIE 203:2012, tous les milieux oculaires";
    Transmittance: "transmittance", "transmittance";
    RodsByAge: "Rods by age", "Bâtonnets selon l’âge";
    RodsSource: "V′(λ) of CIE 1951, taken for that of 32 years, through the lens of CIE 170-1:2006",
        "V′(λ) de la CIE 1951, prise pour celle de 32 ans, à travers le cristallin de la CIE 170-1:2006";
    PupilByAge: "Pupil by age", "Pupille selon l’âge";
    PupilSource: "Watson and Yellott 2012; a field of 60° across, seen by both eyes",
        "Watson et Yellott 2012 ; un champ de 60° de diamètre, vu des deux yeux";
    Diameter: "diameter in mm", "diamètre en mm";
    Luminance: "luminance in cd/m²", "luminance en cd/m²";
    WhiteLuminance: "luminance of white in cd/m²", "luminance du blanc en cd/m²";
    Mesopic: "From day to night", "Du jour à la nuit";
    MesopicSource: "CIE 191:2010, MES2, standard observer; S/P: scotopic over photopic luminance",
        "CIE 191:2010, MES2, observateur de référence ; S/P : luminance scotopique sur photopique";
    ConeShareTitle: "Share of the cones", "Part des cônes";
    ConeShare: "m", "m";
    Purkinje: "Patches of the ColorChecker under D65", "Plages du ColorChecker sous D65";
    OverWhite: "luminance relative to white", "luminance rapportée au blanc";
    Red: "red", "rouge";
    Green: "green", "vert";
    Blue: "blue", "bleu";
    Glare: "Light scattered in the eye by age", "Diffusion intraoculaire de la lumière selon l’âge";
    GlareSource: "solid: CIE 135/1:1999; dashed: CIE 146:2002; pigment p = {0} (0 black, 0.5 brown, 1.2 light blue eyes)",
        "traits pleins : CIE 135/1:1999 ; tirets : CIE 146:2002 ; pigment p = {0} (yeux noirs 0, bruns 0,5, bleu clair 1,2)";
    GlareFunction: "Glare function", "Fonction d’éblouissement";
    PerSteradian: "f in 1/sr", "f en 1/sr";
    StrayLight: "Stray light: the function times θ²", "Lumière parasite : la fonction fois θ²";
    StrayLightLabel: "θ² f in deg²/sr", "θ² f en deg²/sr";
    AngleFromSource: "θ, angle from the source in °", "θ, angle avec la source en °";
    Contrast: "Contrast sensitivity", "Sensibilité au contraste";
    ContrastSource: "castleCSF and Barten: a still grating of 7 deg² in the fovea, young eyes; each channel in its own unit of contrast",
        "castleCSF et Barten : un réseau fixe de 7 deg² dans la fovéa, yeux jeunes ; chaque canal dans sa propre unité de contraste";
    ContrastLabel: "sensitivity, 1 / contrast at threshold", "sensibilité, 1 / contraste au seuil";
    Frequency: "cycles per degree", "cycles par degré";
    Achromatic: "light–dark", "clair–sombre";
    RedGreen: "red–green", "rouge–vert";
    YellowViolet: "yellow–violet", "jaune–violet";
    AtLuminance: "{0}, {1} cd/m²", "{0}, {1} cd/m²";
    MannosSakrison: "Mannos and Sakrison 1974, scaled", "Mannos et Sakrison 1974, à l’échelle";
    Response: "Response to luminance", "Réponse à la luminance";
    ResponseSource: "from 0 at 0.05 cd/m² to 1 at white; cones adapted to a fifth of white",
        "de 0 à 0,05 cd/m² à 1 au blanc ; cônes adaptés au cinquième du blanc";
    ResponseLabel: "response relative to that to white", "réponse rapportée à celle au blanc";
    Logarithm: "logarithm (Weber–Fechner)", "logarithme (Weber–Fechner)";
    CubeRoot: "cube root (L*)", "racine cubique (L*)";
    Saturating: "cones (Naka–Rushton)", "cônes (Naka–Rushton)";
    Steps: "just noticeable steps (DICOM GSDF)", "échelons juste perceptibles (GSDF DICOM)";
    Proportional: "proportional", "proportionnelle";
    Mosaic: "Rods, cones and midget ganglion cells", "Bâtonnets, cônes et cellules ganglionnaires naines";
    MosaicSource: "rods and cones: fits to Curcio 1990, means over all directions; midget fields: Watson 2014",
        "bâtonnets et cônes : ajustés à Curcio 1990, moyennes sur toutes les directions ; champs nains : Watson 2014";
    Eccentricity: "eccentricity in °", "excentricité en °";
    PerSquareDegree: "cells per deg²", "cellules par deg²";
    RodCells: "rods", "bâtonnets";
    ConeCells: "cones", "cônes";
    MidgetTemporal: "midget fields, towards the temple", "champs nains, côté temporal";
    MidgetNasal: "midget fields, towards the nose", "champs nains, côté nasal";
    // Samples of spectra.
    ColorVectorGraphic: "Colour vector graphic, ANSI/IES TM-30-20", "Diagramme des vecteurs de couleur, ANSI/IES TM-30-20";
    LocalFidelity: "local fidelity Rf,h", "fidélité locale Rf,h";
    ChromaShift: "chroma shift Rcs,h in %", "décalage de chroma Rcs,h en %";
    HueShift: "hue shift Rhs,h", "décalage de teinte Rhs,h";
    Efficiency: "Efficiency of representations", "Efficacité des représentations";
    EfficiencyOver: "Mean ΔE₀₀ over the {0} surfaces of '{1}', against the whole spectrum",
        "ΔE₀₀ moyen sur les {0} surfaces de « {1} », par rapport au spectre entier";
    SampleCount: "number of samples", "nombre d’échantillons";
    MeanDifference: "mean ΔE₀₀", "ΔE₀₀ moyen";
    // Regressions.
    Ward: "Ward’s regression", "Régression de Ward";
    WardFound: "αx = {0}, αy = {1}, ρs = {2}, ρd = {3}", "αx = {0}, αy = {1}, ρs = {2}, ρd = {3}";
    WardX: "tan²δ of the facet that mirrors", "tan²δ de la facette qui réfléchit";
    WardXStretched: "tx² + (αx/αy)² ty², slopes of the facet that mirrors",
        "tx² + (αx/αy)² ty², pentes de la facette qui réfléchit";
    WardY: "ln[(f – ρd/π) 4π (cosθi cosθo)^½]", "ln[(f – ρd/π) 4π (cosθi cosθo)^½]";
    WardReadings: "readings", "mesures";
    WardLight: "of little weight", "de faible poids";
    WardLine: "slope –1/αx² = {0}", "pente –1/αx² = {0}";
    WardTrue: "the model itself", "le modèle lui-même";
    // Fluorescence.
    Reradiation: "Re-radiation: fraction of the light of each wavelength that leaves at each other, per 5 nm",
        "Réémission : part de la lumière de chaque longueur d’onde qui repart à chaque autre, par 5 nm";
    Incidence: "wavelength of incidence in nm", "longueur d’onde incidente en nm";
    Emission: "wavelength of emission in nm", "longueur d’onde émise en nm";
    Fraction: "fraction per 5 nm", "part par 5 nm";
    RadianceFactor: "Total radiance factor", "Facteur de luminance énergétique total";
    LeavingOverArriving: "light leaving / light arriving", "lumière émise / lumière reçue";
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::letters;

    #[test]
    fn both_languages_have_the_same_places_for_parts() {
        for word in Word::ALL {
            for index in 0..4 {
                let place = format!("{{{index}}}");
                let (en, fr) = (word.english().contains(&place), word.french().contains(&place));
                assert_eq!(en, fr, "{word:?} {place}");
            }
        }
    }

    #[test]
    fn the_font_has_every_letter_of_every_word() {
        for word in Word::ALL {
            let texts = [word.english(), word.french()];
            let missing: String = texts.iter().flat_map(|text| letters::missing(text)).collect();
            assert!(missing.is_empty(), "{word:?}: {missing}");
        }
    }

    #[test]
    fn parts_are_put_in_place_and_not_looked_into() {
        assert_eq!(Lang::En.say(Word::AtNm, &["{1}", "550"]), "{1} at 550 nm");
        assert_eq!("FR".parse::<Lang>(), Ok(Lang::Fr));
        assert!("de".parse::<Lang>().is_err());
    }
}
