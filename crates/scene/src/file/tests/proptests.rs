//! Whatever is done to a scene file, reading it ends with a scene or an error that has a place.

use proptest::prelude::*;

use super::*;

/// Scenes that use every kind of table, without files.
const TEXTS: [&str; 4] = [
    include_str!("../../../../../examples/orientation.toml"),
    include_str!("../../../../../examples/lights.toml"),
    "[image]\nbackground = 'transparent'\n[camera]\neye = [0, 0, 1]\nprojection = 'orthographic'\nheight = 2\n\
     [render]\nev = 1\n[materials.a]\nmodel = 'phong'\nalpha = 0.5\n[materials.b]\n\
     lobes = [{ shape = 'phong', shininess = 3, tint = '#aabbcc' }]\n[[objects]]\nmesh = { cube = { size = 1 } }\n\
     material = 'b'\nrotate_deg = [{ axis = [0, 1, 0], angle = 3 }]\nnormals = 'smooth'\ncrease_deg = 30\nsubdivide = 1\n\
     [[objects]]\nmesh = 'quad'\nmatrix = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]\ncolors = 'none'\n",
    "[image]\nbackground = 'environment'\n[render]\nshadows = true\n[[lights]]\nkind = 'environment'\nrotate_deg = 30\n\
     [[lights]]\nkind = 'rectangle'\nposition = [0, 2, 0]\ntarget = [0, 0, 0]\nsize = [1, 2]\nup = [1, 0, 0]\n\
     [[lights]]\nkind = 'disk'\nposition = [0, 2, 0]\ndirection = [0, -1, 0]\nradius = 1\ntwo_sided = true\n\
     [[lights]]\nkind = 'sphere'\nposition = [0, 2, 0]\nradius = 1\nintensity = 3\n",
];

/// Pieces that mean something in TOML or in scenes.
const PIECES: [&str; 24] = [
    "[",
    "]",
    "{",
    "}",
    "=",
    "\n",
    ".",
    ",",
    "'",
    "\"",
    "0",
    "-1",
    "1e308",
    "nan",
    "inf",
    "true",
    "[[objects]]\n",
    "[image]\n",
    "é",
    "color",
    "#",
    "[materials.a]\n",
    "99999999999999999999",
    "\u{0}",
];

/// Replaces a range of characters with a piece.
fn mutated(text: &str, edits: &[(usize, usize, usize)]) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for (at, length, piece) in edits {
        let at = at % (characters.len() + 1);
        let end = (at + length).min(characters.len());
        characters.splice(at..end, PIECES[piece % PIECES.len()].chars());
    }
    characters.into_iter().collect()
}

fn check(result: Result<Loaded, FileError>) -> Result<(), TestCaseError> {
    match result {
        Ok(loaded) => {
            for mesh in &loaded.scene.meshes {
                prop_assert_eq!(mesh.validate(), Ok(()));
            }
            for object in &loaded.scene.objects {
                prop_assert!(object.mesh < loaded.scene.meshes.len());
                prop_assert!(object.material < loaded.scene.materials.len());
                prop_assert!(object.transform.is_finite() && object.transform.determinant() != 0.0);
            }
        }
        Err(error) => {
            let span = error.span.clone().expect("every error in a text has a place");
            prop_assert!(error.text.get(span).is_some() && error.line > 0 && error.column > 0);
            prop_assert!(!error.message.is_empty());
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    #[test]
    fn mutated_scenes_are_read_or_refused_with_a_place(
        text in 0..TEXTS.len(),
        edits in prop::collection::vec((any::<usize>(), 0..12usize, any::<usize>()), 1..4),
    ) {
        let text = mutated(TEXTS[text], &edits);
        check(parse_str(&text, Path::new("."), &LoadOptions::default()))?;
    }

    #[test]
    fn truncated_scenes_are_read_or_refused_with_a_place(text in 0..TEXTS.len(), length in 0..2000usize) {
        let text: String = TEXTS[text].chars().take(length).collect();
        check(parse_str(&text, Path::new("."), &LoadOptions::default()))?;
    }

    #[test]
    fn overrides_of_any_kind_are_done_or_refused_with_a_place(
        text in 0..TEXTS.len(),
        path in "(image|camera|lights|objects|materials|x)?(\\.(a|0|1|mesh|color|width|eye|lobes|name)){0,4}",
        value in "(\\[?[0-9.e-]{0,4},?[a-z'#={}]{0,5}\\]?|.{0,8})",
    ) {
        let options = LoadOptions { sets: vec![(path, value)], ..LoadOptions::default() };
        check(parse_str(TEXTS[text], Path::new("."), &options))?;
    }
}
