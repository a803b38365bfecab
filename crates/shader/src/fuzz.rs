//! The steps of the intake, each by itself, for fuzz targets. Not a part of the library's interface.

use crate::intake::{Map, Origin, Sources, expand, rewrite_text};
use crate::{Stage, intake};

/// The preprocessor alone, with an include that includes itself.
pub fn preprocess(text: &str) {
    let include: intake::Include<'_> = &|path: &str, _: &str| match path {
        "a.glsl" => Some("#define INCLUDED(x) (x + 1)\nfloat included(float x) { return x; }\n".to_owned()),
        "self.glsl" => Some("#include \"self.glsl\"\nint again;\n".to_owned()),
        _ => None,
    };
    let mut sources = Sources::default();
    let file = sources.add("fuzz", text.to_owned());
    match expand(&mut sources, file, Some(include)) {
        Ok(origins) => origins.iter().for_each(|origin| check_origin(&sources, *origin)),
        Err(complaint) => drop(complaint.into_error(&sources)),
    }
}

/// The rewriter alone: on the tokens of the text as they stand.
pub fn rewrite(text: &str, stage: Stage) {
    let mut sources = Sources::default();
    let file = sources.add("fuzz", text.to_owned());
    match rewrite_text(text, file, stage) {
        Ok((text, map)) => check_map(&sources, &text, &map),
        Err(complaint) => drop(complaint.into_error(&sources)),
    }
}

fn check_origin(sources: &Sources, origin: Origin) {
    assert!(origin.start <= origin.end && origin.end as usize <= sources.text(origin.file).len());
    assert!(sources.place(origin).line > 0);
}

/// Every place of the output leads back to one of the source.
fn check_map(sources: &Sources, text: &str, map: &Map) {
    for at in (0..text.len()).step_by(7) {
        if let Some(origin) = map.origin(at, (at + 3).min(text.len())) {
            assert!(origin.end as usize <= sources.text(origin.file).len());
        }
    }
}
