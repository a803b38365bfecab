//! Whether the crates can be published: what their manifests say, which files they hold, and that they compile from those.

use std::fmt::Write as _;
use std::path::Path;

use serde_json::Value;

use crate::workspace::{Workspace, run, run_quietly};
use crate::{Failure, Result};

/// What every package holds.
const NEEDED: &[&str] = &["README.md", "LICENSE-MIT", "LICENSE-APACHE", "NOTICE"];

/// Where else files of a package may lie; `build.rs` is a file by itself.
const FOLDERS: &[&str] = &["src/", "data/", "examples/", "programs/", "scenes/", "build.rs"];

/// What Cargo adds.
const ADDED: &[&str] = &[".cargo_vcs_info.json", "Cargo.lock", "Cargo.toml", "Cargo.toml.orig"];

/// The registry's limits for keywords: how many, and of how many characters.
const KEYWORDS: (usize, usize) = (5, 20);

/// Checks manifests and files of all packages, packs them, and compiles what was packed.
pub(crate) fn check(workspace: &Workspace) -> Result<()> {
    let metadata = run_quietly(&mut workspace.cargo("metadata --no-deps --format-version 1"))?;
    let metadata: Value = serde_json::from_slice(&metadata).map_err(Failure::during("cargo metadata"))?;
    for package in published(&metadata) {
        let name = package["name"].as_str().unwrap_or_default();
        let list = run_quietly(&mut workspace.cargo(&format!("package --list --allow-dirty -p {name}")))?;
        let list = String::from_utf8_lossy(&list);
        let files: Vec<&str> = list.lines().collect();
        if let Some(fault) = fault_of_manifest(package).or_else(|| fault_of_files(&files)) {
            return Err(Failure::new(format!("the package {name} {fault}")));
        }
    }
    run(&mut workspace.cargo("package --workspace --exclude xtask --allow-dirty --quiet --no-verify"))?;
    compile_packed(workspace, &metadata)
}

/// Unpacks the packages into a workspace of their own, in which they are each other's dependencies, and has the compiler
/// check them. Cargo's own verification builds each of them with all that it depends on, which takes eight times as long.
fn compile_packed(workspace: &Workspace, metadata: &Value) -> Result<()> {
    let tree = workspace.target().join("package/tree");
    if tree.exists() {
        std::fs::remove_dir_all(&tree).map_err(Failure::during("removing old packages"))?;
    }
    std::fs::create_dir_all(&tree).map_err(Failure::during(tree.display()))?;
    let (mut members, mut patches) = (String::new(), String::new());
    for package in published(metadata) {
        let [name, version] = ["name", "version"].map(|key| package[key].as_str().unwrap_or_default());
        let folder = format!("{name}-{version}");
        write!(members, "\"{folder}\", ").expect("a string takes everything");
        writeln!(patches, "{name} = {{ path = \"{folder}\" }}").expect("a string takes everything");
        let packed = workspace.target().join("package").join(format!("{folder}.crate"));
        // As new: Cargo would take what it made of an older package of the same times for this one.
        run_quietly(workspace.command("tar").arg("xmzf").arg(&packed).arg("-C").arg(&tree))?;
        // What is compiled is what others get, and that is not where our own lock and attributes lie.
        let lock = tree.join(&folder).join("Cargo.lock");
        std::fs::remove_file(&lock).map_err(Failure::during(lock.display()))?;
    }
    let profiles = profiles(&workspace.path("Cargo.toml"))?;
    let manifest = format!(
        "[workspace]\nresolver = \"3\"\nmembers = [{members}]\n\n[patch.crates-io]\n{patches}\n{profiles}"
    );
    let place = tree.join("Cargo.toml");
    std::fs::write(&place, manifest).map_err(Failure::during(place.display()))?;
    let lock = tree.join("Cargo.lock");
    std::fs::copy(workspace.path("Cargo.lock"), &lock).map_err(Failure::during(lock.display()))?;
    // In the same target folder, with the features of the linter's run: dependencies are checked already.
    let mut cargo = workspace.cargo("check --workspace --all-features --quiet --target-dir");
    run(cargo.arg(workspace.target()).arg("--manifest-path").arg(&place))
}

/// The profiles of the workspace, by which dependencies are found compiled.
fn profiles(manifest: &Path) -> Result<String> {
    let text = std::fs::read_to_string(manifest).map_err(Failure::during(manifest.display()))?;
    let begin = text.find("[profile.").unwrap_or(text.len());
    Ok(text[begin..].to_owned())
}

/// The packages that are not marked as private.
fn published(metadata: &Value) -> impl Iterator<Item = &Value> {
    let packages = metadata["packages"].as_array().into_iter().flatten();
    packages.filter(|package| package["publish"].is_null())
}

/// What the manifest lacks.
fn fault_of_manifest(package: &Value) -> Option<String> {
    let text = |key: &str| package[key].as_str().is_some_and(|text| !text.is_empty());
    if let Some(key) = ["description", "license", "readme", "rust_version"].into_iter().find(|key| !text(key))
    {
        return Some(format!("has no {key}"));
    }
    let list = |key: &str| -> Vec<&str> {
        package[key].as_array().into_iter().flatten().filter_map(Value::as_str).collect()
    };
    let (keywords, (most, longest)) = (list("keywords"), KEYWORDS);
    if keywords.is_empty() || keywords.len() > most || keywords.iter().any(|word| word.len() > longest) {
        return Some(format!("needs 1 to {most} keywords of at most {longest} characters: {keywords:?}"));
    }
    if list("categories").is_empty() {
        return Some("has no categories".to_owned());
    }
    if package["metadata"]["docs"]["rs"]["all-features"] != true {
        return Some("is not documented with all features".to_owned());
    }
    let mut dependencies = package["dependencies"].as_array().into_iter().flatten();
    let free = dependencies.find(|dependency| !dependency["path"].is_null() && dependency["req"] == "*")?;
    Some(format!("takes {} by its path alone, without a version", free["name"]))
}

/// A file that is missing, or too many.
fn fault_of_files(files: &[&str]) -> Option<String> {
    if let Some(missing) = NEEDED.iter().find(|name| !files.contains(name)) {
        return Some(format!("does not hold {missing}"));
    }
    let known = |file: &&&str| {
        NEEDED.contains(*file)
            || ADDED.contains(*file)
            || FOLDERS.iter().any(|folder| file.starts_with(folder))
    };
    files.iter().find(|file| !known(file)).map(|file| format!("holds {file}, which is no part of it"))
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn package() -> Value {
        json!({
            "description": "a", "license": "MIT", "readme": "README.md", "rust_version": "1.95",
            "keywords": ["color"], "categories": ["graphics"],
            "metadata": { "docs": { "rs": { "all-features": true } } },
            "dependencies": [{ "name": "b", "path": "/b", "req": "^0.1.0" }, { "name": "c", "req": "*" }]
        })
    }

    #[test]
    fn what_a_manifest_lacks_is_told() {
        assert_eq!(fault_of_manifest(&package()), None);
        let with = |key: &str, value: Value| {
            let mut package = package();
            package[key] = value;
            fault_of_manifest(&package).unwrap_or_default()
        };
        assert_eq!(with("readme", Value::Null), "has no readme");
        assert!(with("keywords", json!(["a", "b", "c", "d", "e", "f"])).starts_with("needs 1 to 5 keywords"));
        assert_eq!(with("categories", json!([])), "has no categories");
        assert_eq!(with("metadata", Value::Null), "is not documented with all features");
        let by_path = json!([{ "name": "b", "path": "/b", "req": "*" }]);
        assert_eq!(with("dependencies", by_path), "takes \"b\" by its path alone, without a version");
    }

    #[test]
    fn private_packages_are_left_out() {
        let metadata =
            json!({ "packages": [{ "name": "a", "publish": null }, { "name": "b", "publish": [] }] });
        assert!(published(&metadata).map(|package| &package["name"]).eq([&json!("a")]));
    }

    #[test]
    fn files_that_do_not_belong_are_told() {
        let good = [NEEDED, ADDED, &["src/lib.rs", "data/a.csv", "build.rs"]].concat();
        assert_eq!(fault_of_files(&good), None);
        let junk = [good.as_slice(), &["tests/big.png"]].concat();
        assert_eq!(fault_of_files(&junk), Some("holds tests/big.png, which is no part of it".to_owned()));
        assert_eq!(fault_of_files(&good[1..]), Some("does not hold README.md".to_owned()));
    }
}
