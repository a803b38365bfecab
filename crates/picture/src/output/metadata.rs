//! What a picture file says about its making.

/// Texts that are written into a picture file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Metadata {
    /// The program and its version.
    pub software: String,
    /// The hash of the scene, so that a picture tells what it was made of.
    pub scene_hash: Option<String>,
    /// More texts, each with its key. For PNG a key has 1 to 79 Latin letters.
    pub entries: Vec<(String, String)>,
}

impl Default for Metadata {
    fn default() -> Self {
        Self {
            software: concat!("glanz ", env!("CARGO_PKG_VERSION")).to_owned(),
            scene_hash: None,
            entries: Vec::new(),
        }
    }
}

impl Metadata {
    /// The key under which the scene's hash is written.
    pub const SCENE_HASH: &'static str = "Scene-Hash";

    /// All of it in lines of text, for formats that have comments alone.
    pub fn text(&self) -> String {
        let software = [("Software", self.software.as_str())];
        software.into_iter().chain(self.pairs()).map(|(key, value)| format!("{key}: {value}\n")).collect()
    }

    /// The scene's hash, if there is one, and the other entries.
    pub fn pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        let hash = self.scene_hash.iter().map(|hash| (Self::SCENE_HASH, hash.as_str()));
        hash.chain(self.entries.iter().map(|(key, value)| (key.as_str(), value.as_str())))
    }
}
