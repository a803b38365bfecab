//! What is in a scene, for programs.

use std::collections::BTreeMap;

use glam::DVec3;
use glanz_scene::{
    AlphaMode, AreaShape, Attenuation, Background, Bounds, Camera, Light, LightKind, Lobe, Luminaire,
    Material, Mesh, Projection, Space,
};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::{Value, json};

use super::colors;
use super::matrices::MatrixTables;
use super::summary::{Summary, attributes, maps};
use super::vertices::VertexTables;

/// What is in a scene or a model.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct Document {
    file: String,
    /// How many triangles are drawn: those of a mesh count once per object
    triangles: usize,
    /// Of all objects; null where there is nothing
    bounds: Option<BoundsFacts>,
    image: ImageFacts,
    objects: Vec<ObjectFacts>,
    meshes: Vec<MeshFacts>,
    materials: Vec<MaterialFacts>,
    textures: Vec<TextureFacts>,
    lights: Vec<LightFacts>,
    /// Whether the file has no lights, and these are added
    default_lights: bool,
    cameras: Vec<CameraFacts>,
    /// The names of the variants of a glTF model's materials, which --variant takes
    variants: Vec<String>,
    /// Why the scene is not drawn, where that takes more memory than --memory allows; else null
    refusal: Option<String>,
    /// With --matrices: those of the camera and of all objects
    #[serde(skip_serializing_if = "Option::is_none")]
    matrices: Option<MatrixTables>,
    /// What is ignored or changed, in words
    notes: Vec<String>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct BoundsFacts {
    min: [f64; 3],
    max: [f64; 3],
}

#[derive(Debug, Serialize, JsonSchema)]
struct ImageFacts {
    width: u32,
    height: u32,
    /// Per pixel
    samples: u32,
    /// Linear RGB, or transparent or environment
    background: Value,
}

#[derive(Debug, Serialize, JsonSchema)]
struct ObjectFacts {
    name: String,
    /// A number in meshes, from 0
    mesh: usize,
    /// A number in materials, from 0
    material: usize,
}

#[derive(Debug, Serialize, JsonSchema)]
struct MeshFacts {
    name: String,
    vertices: usize,
    faces: usize,
    triangles: usize,
    /// What vertices have beside positions
    attributes: Vec<&'static str>,
    bounds: Option<BoundsFacts>,
    /// With --vertices: all of them
    #[serde(skip_serializing_if = "Option::is_none")]
    table: Option<VertexTables>,
}

#[derive(Debug, Serialize, JsonSchema)]
struct TextureFacts {
    name: String,
    width: u32,
    height: u32,
}

#[derive(Debug, Serialize, JsonSchema)]
struct MaterialFacts {
    name: String,
    lobes: Vec<LobeFacts>,
    two_sided: bool,
    /// What textures give
    textures: Vec<&'static str>,
    opacity: f64,
    /// opaque, mask or blend
    alpha_mode: &'static str,
}

#[derive(Debug, Serialize, JsonSchema)]
struct LobeFacts {
    /// The model's name
    shape: &'static str,
    params: BTreeMap<&'static str, f64>,
    /// Linear RGB, a spectrum (nm, value), or what Fresnel's law or re-radiation is of
    tint: Value,
}

/// A light, with the keys of its kind.
#[derive(Debug, Default, Serialize, JsonSchema)]
struct LightFacts {
    name: String,
    /// ambient, directional, point, spot, rectangle, disk, sphere or environment
    kind: &'static str,
    /// camera or world
    attached_to: &'static str,
    /// Linear RGB, or a spectrum (nm, value)
    ambient: Value,
    /// Linear RGB, or a spectrum (nm, value)
    diffuse: Value,
    /// Linear RGB, or a spectrum (nm, value)
    specular: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    direction: Option<[f64; 3]>,
    /// Constant, linear and quadratic
    #[serde(skip_serializing_if = "Option::is_none")]
    attenuation: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cutoff_deg: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    exponent: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    size: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    up: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    two_sided: Option<bool>,
    /// Width and height of an environment's map; null where it is uniform
    #[serde(skip_serializing_if = "Option::is_none")]
    map: Option<Option<[usize; 2]>>,
    /// Columns of the environment's rotation
    #[serde(skip_serializing_if = "Option::is_none")]
    rotation: Option<[[f64; 3]; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    profile: Option<ProfileFacts>,
}

/// The distribution of a luminaire.
#[derive(Debug, Serialize, JsonSchema)]
struct ProfileFacts {
    planes: usize,
    angles: usize,
    max_cd: f64,
    flux_lm: f64,
    axis: [f64; 3],
    c0: [f64; 3],
}

#[derive(Debug, Serialize, JsonSchema)]
struct CameraFacts {
    name: String,
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    /// The vertical field of view, of a perspective camera
    #[serde(skip_serializing_if = "Option::is_none")]
    fov_deg: Option<f64>,
    /// What the picture is high, of an orthographic camera
    #[serde(skip_serializing_if = "Option::is_none")]
    height: Option<f64>,
}

impl Document {
    /// What is in this scene.
    pub(crate) fn of(summary: &Summary<'_>) -> Self {
        let scene = &summary.input.scene;
        let image = scene.image;
        let texture = |texture: &glanz_scene::Texture| TextureFacts {
            name: texture.name.clone(),
            width: texture.width,
            height: texture.height,
        };
        let object = |object: &glanz_scene::Object| ObjectFacts {
            name: object.name.clone(),
            mesh: object.mesh,
            material: object.material,
        };
        Self {
            file: summary.path.display().to_string(),
            triangles: summary.triangles(),
            bounds: BoundsFacts::of(&scene.bounds()),
            image: ImageFacts {
                width: image.width,
                height: image.height,
                samples: image.samples,
                background: match image.background {
                    Background::Color(color) => json!(color),
                    Background::Transparent => json!("transparent"),
                    Background::Environment => json!("environment"),
                },
            },
            objects: scene.objects.iter().map(object).collect(),
            meshes: scene.meshes.iter().map(|mesh| MeshFacts::of(mesh, summary.vertices)).collect(),
            materials: scene.materials.iter().map(MaterialFacts::of).collect(),
            textures: scene.textures.iter().map(texture).collect(),
            lights: scene.lights.iter().map(LightFacts::of).collect(),
            default_lights: summary.input.default_lights,
            cameras: match (&scene.camera, summary.input.cameras.as_slice()) {
                (Some(camera), []) => vec![CameraFacts::of("", camera)],
                (_, named) => named.iter().map(|(name, camera)| CameraFacts::of(name, camera)).collect(),
            },
            variants: summary.input.variants.clone(),
            refusal: summary.refusal.clone(),
            matrices: summary.matrices.then(|| MatrixTables::of(scene)),
            notes: summary.input.notes.clone(),
        }
    }
}

impl BoundsFacts {
    fn of(bounds: &Bounds) -> Option<Self> {
        (!bounds.is_empty()).then(|| Self { min: bounds.min.to_array(), max: bounds.max.to_array() })
    }
}

impl MeshFacts {
    fn of(mesh: &Mesh, vertices: bool) -> Self {
        Self {
            table: vertices.then(|| VertexTables::of(mesh)),
            name: mesh.name.clone(),
            vertices: mesh.positions.len(),
            faces: mesh.face_count(),
            triangles: mesh.triangle_count(),
            attributes: attributes(mesh),
            bounds: BoundsFacts::of(&mesh.bounds()),
        }
    }
}

impl MaterialFacts {
    fn of(material: &Material) -> Self {
        Self {
            name: material.name.clone(),
            lobes: material.lobes.iter().map(LobeFacts::of).collect(),
            two_sided: material.two_sided,
            textures: maps(material),
            opacity: material.opacity.into(),
            alpha_mode: match material.alpha_mode {
                AlphaMode::Opaque => "opaque",
                AlphaMode::Mask { .. } => "mask",
                AlphaMode::Blend => "blend",
            },
        }
    }
}

impl LobeFacts {
    fn of(lobe: &Lobe) -> Self {
        let info = lobe.shape.info();
        Self {
            shape: info.name,
            params: info.params.iter().map(|param| param.name).zip(lobe.shape.params()).collect(),
            tint: colors::tint_json(&lobe.tint),
        }
    }
}

impl LightFacts {
    fn of(light: &Light) -> Self {
        Self {
            name: light.name.clone(),
            attached_to: if light.space == Space::Camera { "camera" } else { "world" },
            ambient: colors::light_json(&light.colors.ambient),
            diffuse: colors::light_json(&light.colors.diffuse),
            specular: colors::light_json(&light.colors.specular),
            profile: light.luminaire.as_ref().map(ProfileFacts::of),
            ..Self::of_kind(&light.kind)
        }
    }

    /// The keys of the kind alone.
    fn of_kind(kind: &LightKind) -> Self {
        let vector = |v: &DVec3| Some(v.to_array());
        let attenuation = |a: &Attenuation| Some([a.constant, a.linear, a.quadratic]);
        match kind {
            LightKind::Ambient => Self { kind: "ambient", ..Self::default() },
            LightKind::Directional { direction } => {
                Self { kind: "directional", direction: vector(direction), ..Self::default() }
            }
            LightKind::Point { position, attenuation: a } => {
                let (position, attenuation) = (vector(position), attenuation(a));
                Self { kind: "point", position, attenuation, ..Self::default() }
            }
            LightKind::Spot { position, direction, cutoff, exponent, attenuation: a, .. } => Self {
                kind: "spot",
                position: vector(position),
                direction: vector(direction),
                cutoff_deg: Some(cutoff.to_degrees()),
                exponent: Some(*exponent),
                attenuation: attenuation(a),
                ..Self::default()
            },
            LightKind::Area { shape, position, direction, up, two_sided } => {
                let area = || Self { position: vector(position), ..Self::default() };
                let directed = Self { direction: vector(direction), two_sided: Some(*two_sided), ..area() };
                Self::of_shape(shape, up, area(), directed)
            }
            LightKind::Environment { map, rotation } => Self {
                kind: "environment",
                map: Some(map.as_ref().map(|map| [map.width, map.height])),
                rotation: Some(rotation.to_cols_array_2d()),
                ..Self::default()
            },
        }
    }
    /// The keys of an area's form, beside those of a sphere and of what has a direction.
    fn of_shape(shape: &AreaShape, up: &DVec3, sphere: Self, directed: Self) -> Self {
        match *shape {
            AreaShape::Sphere { radius } => Self { kind: "sphere", radius: Some(radius), ..sphere },
            AreaShape::Disk { radius } => Self { kind: "disk", radius: Some(radius), ..directed },
            AreaShape::Rectangle { width, height } => {
                Self { kind: "rectangle", size: Some([width, height]), up: Some(up.to_array()), ..directed }
            }
        }
    }
}

impl ProfileFacts {
    fn of(luminaire: &Luminaire) -> Self {
        let profile = &luminaire.profile;
        Self {
            planes: profile.c_deg.len(),
            angles: profile.gamma_deg.len(),
            max_cd: profile.max(),
            flux_lm: profile.flux_lm(),
            axis: luminaire.axis.to_array(),
            c0: luminaire.c0.to_array(),
        }
    }
}

impl CameraFacts {
    fn of(name: &str, camera: &Camera) -> Self {
        let (fov_deg, height) = match camera.projection {
            Projection::Perspective { fov_y } => (Some(fov_y.to_degrees()), None),
            Projection::Orthographic { height } => (None, Some(height)),
        };
        Self {
            name: name.to_owned(),
            eye: camera.eye.to_array(),
            target: camera.target.to_array(),
            up: camera.up.to_array(),
            fov_deg,
            height,
        }
    }
}
