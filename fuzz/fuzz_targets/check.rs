//! What must hold of every model that a reader returns, whatever the bytes were.

use glanz_scene::read::{Format, NoFiles, ReadOptions, Resolver, read_model_bytes};

/// Reads bytes that refer to no files.
#[allow(dead_code)]
pub fn read(bytes: &[u8], format: Format) {
    read_with(bytes, format, &NoFiles);
}

/// Reads bytes whose references `files` resolves.
pub fn read_with(bytes: &[u8], format: Format, files: &dyn Resolver) {
    let options =
        ReadOptions { memory: glanz_math::MemoryBudget::of_bytes(64 << 20), ..ReadOptions::default() };
    match read_model_bytes(bytes, format, "file", files, &options) {
        Ok(model) => {
            model.meshes.iter().for_each(|mesh| assert_eq!(mesh.validate(), Ok(())));
            for object in &model.objects {
                assert!(object.mesh < model.meshes.len() && object.material < model.materials.len());
                assert!(object.transform.is_finite());
            }
            for material in &model.materials {
                for map in material.textures() {
                    assert!(map.texture < model.textures.len());
                }
            }
        }
        Err(error) => assert!(error.to_string().contains(": expected ")),
    }
}
