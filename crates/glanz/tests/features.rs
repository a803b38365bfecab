//! What needs a feature either works or ends in an error that names it.

use glanz::picture::output::{Animation, Format, Metadata, write_gif};
use glanz::{Error, Scene, Shot};

/// An empty scene, drawn into a file of this ending.
fn saved(ending: &str) -> Result<(), Error> {
    let folder = std::env::temp_dir().join(format!("glanz-features-{}-{ending}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let saved = Shot::new(&Scene::new().with_size(4, 4))?.save(folder.join("empty").with_extension(ending));
    std::fs::remove_dir_all(&folder)?;
    Ok(saved?)
}

/// What is said where the feature is off.
fn off(format: &str, feature: &str) -> String {
    format!("{format}: Glanz was built without the feature `{feature}`; add features = [\"{feature}\"]")
}

#[test]
fn pictures_are_saved_or_the_feature_is_named() {
    for (ending, format, feature) in [("exr", Format::Exr, "exr"), ("gif", Format::Gif, "gif")] {
        match (format.check_feature(), saved(ending)) {
            (Ok(()), saved) => saved.expect("the feature is on"),
            (Err(_), saved) => {
                let error = saved.expect_err("the feature is off");
                assert_eq!(error.to_string(), off(format.name(), feature));
            }
        }
    }
    saved("png").expect("PNG needs no feature");
    saved("apng").expect("APNG needs no feature");
}

#[test]
fn features_asked_for_are_on() {
    assert!(!cfg!(feature = "exr") || Format::Exr.check_feature().is_ok());
    assert!(!cfg!(feature = "gif") || Format::Gif.check_feature().is_ok());
}

#[test]
fn films_are_written_or_the_feature_is_named() {
    let animation = Animation { width: 1, height: 1, frames: 1, frame_s: 0.04 };
    let written = write_gif(Vec::new(), &animation, [Ok::<_, Error>(vec![255; 4])], &Metadata::default());
    match Format::Gif.check_feature() {
        Ok(()) => written.expect("the feature is on"),
        Err(_) => assert_eq!(written.expect_err("it is off").to_string(), off("GIF", "gif")),
    }
}

#[test]
fn an_environment_of_openexr_is_read_or_the_feature_is_named() {
    let folder = std::env::temp_dir().join(format!("glanz-features-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("the temporary folder is writable");
    std::fs::write(folder.join("sky.exr"), [0x76, 0x2f, 0x31, 0x01]).expect("written");
    let scene = folder.join("scene.toml");
    std::fs::write(&scene, "[[lights]]\nkind = \"environment\"\nfile = \"sky.exr\"\n").expect("written");
    let error = glanz::load(&scene).expect_err("the file ends after its first bytes").to_string();
    std::fs::remove_dir_all(&folder).expect("removed");
    let expected = match Format::Exr.check_feature() {
        Ok(()) => "expected an OpenEXR picture of scan lines or tiles".to_owned(),
        Err(_) => off("OpenEXR", "exr"),
    };
    assert!(error.contains(&expected), "{error}");
}
