//! Shaders in place of materials.

use std::ops::Range;
use std::path::Path;

use super::builder::Builder;
use crate::file::error::Problem;
use crate::file::tables::program::{ProgramTable, UniformEntry};
use crate::file::tables::values::At;
use crate::read::{FolderFiles, Resolver};
use crate::{Program, ProgramText, UniformValue, cube_face_files};

/// A file of a shader is no longer than this.
const MOST_BYTES: usize = 1 << 20;

impl Builder {
    /// The number of a program; equal ones are one.
    pub(super) fn program(&mut self, table: &At<ProgramTable>) -> Result<usize, Problem> {
        if table.vertex.is_none() && table.fragment.is_none() {
            return Err(Problem::at(&table.span, "a program needs 'vertex', 'fragment' or both"));
        }
        let mut program = Program {
            vertex: table.vertex.as_ref().map(|file| self.program_text(file)).transpose()?,
            fragment: table.fragment.as_ref().map(|file| self.program_text(file)).transpose()?,
            ..Program::default()
        };
        for (name, entry) in &table.uniforms {
            let value = match &entry.value {
                UniformEntry::Numbers(numbers) => UniformValue::Numbers(numbers.clone()),
                UniformEntry::Picture(name) if name.contains('*') => {
                    self.cube_by_pattern(name, &entry.span)?
                }
                UniformEntry::Picture(name) => UniformValue::Texture(self.picture(name, &entry.span)?),
                UniformEntry::Cube(names) => UniformValue::Cube(self.faces(names, &entry.span)?),
            };
            program.uniforms.insert(name.clone(), value);
        }
        if let Some(known) = self.scene.programs.iter().position(|known| *known == program) {
            return Ok(known);
        }
        self.scene.programs.push(program);
        Ok(self.scene.programs.len() - 1)
    }

    /// The textures of six faces.
    fn faces(&mut self, names: &[String; 6], span: &Range<usize>) -> Result<[usize; 6], Problem> {
        let mut faces = [0; 6];
        for (face, name) in faces.iter_mut().zip(names) {
            *face = self.picture(name, span)?;
        }
        Ok(faces)
    }

    /// Six faces by the pattern of their names; the first of the ways to name them whose first file is there.
    fn cube_by_pattern(&mut self, pattern: &str, span: &Range<usize>) -> Result<UniformValue, Problem> {
        let ways = cube_face_files(pattern);
        let Some(way) = ways.iter().find(|names| self.picture(&names[0], span).is_ok()) else {
            let first: Vec<String> = ways.iter().map(|names| format!("'{}'", names[0])).collect();
            let message = format!("'{pattern}': none of {} can be read", first.join(", "));
            return Err(
                Problem::at(span, message).help("the faces of a cube map are named so in place of '*'")
            );
        };
        Ok(UniformValue::Cube(self.faces(way, span)?))
    }

    /// A file of a shader and what it includes, all of its folder.
    fn program_text(&mut self, file: &At<String>) -> Result<ProgramText, Problem> {
        let text = self.read_beside(file)?;
        if text.len() > MOST_BYTES {
            let message = format!("a shader of {} bytes is more than {MOST_BYTES}", text.len());
            return Err(Problem::at(&file.span, message));
        }
        let not_text = |_| Problem::at(&file.span, format!("'{}': expected text in UTF-8", file.value));
        let text = String::from_utf8(text).map_err(not_text)?;
        let path = Path::new(&file.value);
        let name = path.file_name().map_or_else(|| file.value.clone(), |name| name.to_string_lossy().into());
        let folder = path.parent().unwrap_or(Path::new(""));
        let files = FolderFiles::new(self.base(), &self.input.options);
        let mut read = |path: &str| {
            let bytes = files.read(&folder.join(path).to_string_lossy()).ok()?;
            String::from_utf8(bytes).ok().filter(|text| text.len() <= MOST_BYTES)
        };
        Ok(ProgramText::with_includes(name, text, &mut read))
    }
}
