//! French names of models and of representations of spectra; names of people and years are the same.

/// English names that have words in them, and the French ones.
const FRENCH: [(&str, &str); 25] = [
    ("Charlie sheen 2017", "Charlie 2017, reflet de velours"),
    ("Emission", "Émission"),
    ("Ambient term", "Terme ambiant"),
    ("Perfect mirror", "Miroir parfait"),
    ("Perfect refraction", "Réfraction parfaite"),
    (
        "Rough refraction, Beckmann's slopes (Walter 2007)",
        "Réfraction rugueuse, pentes de Beckmann (Walter 2007)",
    ),
    ("Rough refraction, GGX slopes (Walter 2007)", "Réfraction rugueuse, pentes GGX (Walter 2007)"),
    ("Ashikhmin–Shirley 2000, diffuse", "Ashikhmin–Shirley 2000, diffus"),
    ("Ashikhmin–Shirley 2000, specular", "Ashikhmin–Shirley 2000, spéculaire"),
    (
        "Beckmann's slopes, reflected more than once (Kulla and Conty 2017)",
        "Pentes de Beckmann, réflexions multiples (Kulla et Conty 2017)",
    ),
    (
        "GGX slopes, reflected more than once (Kulla and Conty 2017)",
        "Pentes GGX, réflexions multiples (Kulla et Conty 2017)",
    ),
    ("Blinn–Phong, energy-normalised", "Blinn–Phong, normalisé en énergie"),
    ("Phong, energy-normalised (Lewis 1994)", "Phong, normalisé en énergie (Lewis 1994)"),
    (
        "GGX (Walter 2007, Heitz 2014) that keeps its energy",
        "GGX (Walter 2007, Heitz 2014) qui conserve l’énergie",
    ),
    (
        "Beckmann with Smith's shadowing (Walter 2007, Heitz 2014) that keeps its energy",
        "Beckmann avec l’ombrage de Smith (Walter 2007, Heitz 2014), qui conserve l’énergie",
    ),
    ("Cook–Torrance 1982, Gaussian angles", "Cook–Torrance 1982, angles gaussiens"),
    ("Cook–Torrance 1982, Beckmann's slopes", "Cook–Torrance 1982, pentes de Beckmann"),
    ("Lambert's law for light from behind", "Loi de Lambert, lumière venant de derrière"),
    ("Oren–Nayar 1994, qualitative", "Oren–Nayar 1994, qualitatif"),
    ("GGX through a thin sheet (glTF)", "GGX à travers une feuille mince (glTF)"),
    ("uniform, 300-780 nm", "uniforme, 300-780 nm"),
    ("uniform, 400-700 nm", "uniforme, 400-700 nm"),
    ("sRGB product", "produit sRGB"),
    ("Meyer, published", "Meyer, publié"),
    ("Meyer, adapted", "Meyer, adapté"),
];

/// The French name, where it is another one.
pub(super) fn french(name: &str) -> &str {
    FRENCH.iter().find(|(english, _)| *english == name).map_or(name, |(_, french)| french)
}

#[cfg(test)]
mod tests {
    use glanz_color::efficiency::Representation;

    use super::*;

    #[test]
    fn every_name_with_words_has_a_french_one() {
        let models = glanz_bsdf::MODELS.iter().map(|info| info.title.to_owned());
        let ways = Representation::all().into_iter().map(|one| one.name().to_owned());
        for name in models.chain(ways) {
            let has_words = name.split([' ', '-']).any(|word| {
                let letters = word.trim_matches(|c: char| !c.is_alphabetic());
                letters.len() > 3 && letters.chars().all(|c| c.is_ascii_lowercase())
            });
            assert!(!has_words || french(&name) != name, "{name}");
        }
    }
}
