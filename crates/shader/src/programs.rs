//! Programs to begin with, in the courses' own style and names: each can be printed, changed and drawn with.

use crate::Stage;

/// A program to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DefaultProgram {
    /// Its name.
    pub name: &'static str,
    /// What it does, in a line.
    pub title: &'static str,
    /// The model of the list that its highlights equal, if one does.
    pub model: Option<&'static str>,
    vertex: &'static str,
    fragment: &'static str,
    highlight: &'static str,
    /// Members of the material beside its colours.
    parameters: &'static str,
}

const PIXEL: DefaultProgram = DefaultProgram {
    name: "",
    title: "",
    model: None,
    vertex: include_str!("../programs/pixel.vert"),
    fragment: include_str!("../programs/pixel.frag"),
    highlight: include_str!("../programs/highlights/lambert.glsl"),
    parameters: "float shininess;",
};

const COURSE: DefaultProgram = DefaultProgram { vertex: include_str!("../programs/course.vert"), ..PIXEL };

/// All of them.
const ALL: [DefaultProgram; 14] = [
    DefaultProgram {
        name: "lambert-330",
        title: "Matte surfaces (Lambert 1760)",
        model: Some("lambert"),
        ..PIXEL
    },
    DefaultProgram {
        name: "phong-330",
        title: "Phong's highlights (1975)",
        model: Some("phong"),
        highlight: include_str!("../programs/highlights/phong.glsl"),
        ..PIXEL
    },
    DefaultProgram {
        name: "blinn-phong-330",
        title: "Blinn's highlights (1977)",
        model: Some("blinn-phong"),
        highlight: include_str!("../programs/highlights/blinn-phong.glsl"),
        ..PIXEL
    },
    DefaultProgram {
        name: "phong-normalized-330",
        title: "Phong's highlights with their energy kept (Lewis 1994)",
        model: Some("phong-normalized"),
        highlight: include_str!("../programs/highlights/phong-normalized.glsl"),
        ..PIXEL
    },
    DefaultProgram {
        name: "blinn-phong-normalized-330",
        title: "Blinn's highlights with their energy kept",
        model: Some("blinn-phong-normalized"),
        highlight: include_str!("../programs/highlights/blinn-phong-normalized.glsl"),
        ..PIXEL
    },
    DefaultProgram {
        name: "cook-torrance-330",
        title: "Facets with Beckmann's slopes (Cook and Torrance 1982)",
        model: Some("cook-torrance"),
        highlight: include_str!("../programs/highlights/cook-torrance.glsl"),
        parameters: "float m;                        // slope of the facets",
        ..PIXEL
    },
    DefaultProgram {
        name: "ggx-330",
        title: "Facets as GGX has them (Walter et al. 2007)",
        model: Some("ggx"),
        highlight: include_str!("../programs/highlights/ggx.glsl"),
        parameters: "float alpha;                    // width of the distribution of facets",
        ..PIXEL
    },
    DefaultProgram {
        name: "ward-330",
        title: "Ward's isotropic highlights (1992)",
        model: Some("ward"),
        highlight: include_str!("../programs/highlights/ward.glsl"),
        parameters: "float alpha;                    // width of the highlight",
        ..PIXEL
    },
    DefaultProgram {
        name: "gouraud-330",
        title: "Phong's highlights at the vertices, colours interpolated (Gouraud 1971)",
        vertex: include_str!("../programs/gouraud.vert"),
        fragment: include_str!("../programs/gouraud.frag"),
        highlight: include_str!("../programs/highlights/phong.glsl"),
        ..PIXEL
    },
    DefaultProgram {
        name: "kite-330",
        title: "Colours of vertices under one light, as on a kite",
        fragment: include_str!("../programs/kite.frag"),
        ..COURSE
    },
    DefaultProgram {
        name: "normals-330",
        title: "Normals as colours",
        fragment: include_str!("../programs/normals.frag"),
        ..COURSE
    },
    DefaultProgram {
        name: "mouse-330",
        title: "A light that follows the pointer",
        fragment: include_str!("../programs/mouse.frag"),
        ..COURSE
    },
    DefaultProgram {
        name: "toon-330",
        title: "Steps of light and a dark rim",
        fragment: include_str!("../programs/toon.frag"),
        ..PIXEL
    },
    DefaultProgram {
        name: "phong-wgsl",
        title: "Phong's highlights of one light, in WGSL",
        vertex: include_str!("../programs/phong.wgsl"),
        fragment: include_str!("../programs/phong.wgsl"),
        ..PIXEL
    },
];

impl DefaultProgram {
    /// All programs to begin with.
    pub fn all() -> &'static [Self] {
        &ALL
    }

    /// The program of this name.
    ///
    /// ```
    /// use glanz_shader::{DefaultProgram, Stage};
    ///
    /// let program = DefaultProgram::named("phong-330").expect("it is listed");
    /// assert!(program.text(Stage::Fragment).contains("reflect(-L, N)"));
    /// ```
    pub fn named(name: &str) -> Option<&'static Self> {
        ALL.iter().find(|program| program.name == name)
    }

    /// Whether it is in WGSL, whose texts hold both stages.
    pub fn is_wgsl(&self) -> bool {
        self.name.ends_with("-wgsl")
    }

    /// The whole text of a stage.
    pub fn text(&self, stage: Stage) -> String {
        let text = match stage {
            Stage::Vertex => self.vertex,
            Stage::Fragment => self.fragment,
        };
        text.replace("@TITLE@", self.title)
            .replace("@LIGHTS@", include_str!("../programs/lights.glsl"))
            .replace("@MATERIAL@", include_str!("../programs/material.glsl"))
            .replace("@PARAMETERS@", self.parameters)
            .replace("@HIGHLIGHT@", self.highlight)
            .replace("@SUM@", include_str!("../programs/sum.glsl"))
    }

    /// The text of a GLSL stage with its lights and its material filled in: `values` are the constants that stand in place
    /// of the two uniforms.
    pub fn filled(&self, stage: Stage, values: &str) -> String {
        let declared =
            "uniform LightSources lights;        // in the camera's space\nuniform Material material;\n";
        self.text(stage).replace(declared, values)
    }

    /// A whole WGSL text of Phong's highlights with its lights and its material filled in.
    pub fn filled_wgsl(values: &str) -> String {
        include_str!("../programs/scene.wgsl")
            .replace("@TITLE@", "Phong's highlights")
            .replace("@VALUES@", values)
    }

    /// The name of the file that a stage goes into.
    pub fn file_name(&self, stage: Stage) -> String {
        let (stem, _) = self.name.rsplit_once('-').unwrap_or((self.name, ""));
        match (self.is_wgsl(), stage) {
            (true, _) => format!("{stem}.wgsl"),
            (false, Stage::Vertex) => format!("{stem}.vert"),
            (false, Stage::Fragment) => format!("{stem}.frag"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Pair, Shader};

    #[test]
    fn every_program_compiles_and_its_stages_fit_without_a_warning() {
        for program in DefaultProgram::all() {
            let shader = |stage| Shader::new(stage, program.text(stage)).named(program.file_name(stage));
            let (vertex, fragment) = (shader(Stage::Vertex), shader(Stage::Fragment));
            let pair =
                Pair::new(Some(&vertex), Some(&fragment)).unwrap_or_else(|e| panic!("{}: {e}", program.name));
            let unfilled = |program: &crate::Program| {
                let uniforms = program.interface().uniforms.clone();
                uniforms.into_iter().filter(|own| own.role.is_none()).map(|own| own.name).collect::<Vec<_>>()
            };
            let expected: &[&str] = if program.name == "toon-330" { &["steps"] } else { &[] };
            assert_eq!(
                [unfilled(&pair.vertex), unfilled(&pair.fragment)].concat(),
                expected,
                "{}",
                program.name
            );
            let warnings = [pair.vertex.warnings(), pair.fragment.warnings()].concat();
            assert!(warnings.is_empty(), "{}: {warnings:?}", program.name);
        }
    }

    #[test]
    fn a_fragment_shader_by_itself_is_enough() {
        for program in DefaultProgram::all().iter().filter(|program| !program.is_wgsl()) {
            let fragment = Shader::fragment(program.text(Stage::Fragment));
            Pair::new(None, Some(&fragment)).unwrap_or_else(|error| panic!("{}: {error}", program.name));
        }
    }
}
