//! What is in a scene, in words.

use std::fmt::Write;
use std::path::Path;

use glam::DVec3;
use glanz_bsdf::{FactorTable, LayerWeight};
use glanz_math::names::shown;
use glanz_plot::number;
use glanz_scene::{
    AlphaMode, AreaShape, Attenuation, Bounds, Camera, Light, LightColors, LightKind, Lobe, Luminaire,
    Material, Mesh, Projection, RoughnessMap, Space,
};

use super::matrices::MatrixTables;
use super::scene_document::Document;
use super::{colors, vertices};
use crate::load::Input;

/// The most things of a kind that are listed for people; JSON has all.
const MOST_LISTED: usize = 40;

/// What is in a scene.
pub(crate) struct Summary<'a> {
    /// The scene.
    pub input: &'a Input,
    /// Why it is not drawn: what takes more memory than it may.
    pub refusal: Option<String>,
    /// Its file.
    pub path: &'a Path,
    /// Whether all vertices and facets are told.
    pub vertices: bool,
    /// Whether the matrices of camera and objects are told.
    pub matrices: bool,
}

impl Summary<'_> {
    /// For people.
    pub(crate) fn text(&self) -> String {
        let scene = &self.input.scene;
        let mut text = format!("{}\n", self.path.display());
        let total: usize = self.triangles();
        let instances = plural(scene.objects.len(), "object");
        line(&mut text, "shows", &format!("{instances} with {}", plural(total, "triangle")));
        line(&mut text, "bounds", &bounds_text(&scene.bounds()));
        if let Some(refusal) = &self.refusal {
            line(&mut text, "drawing", &format!("refused: {refusal}"));
        }
        let image = scene.image;
        line(
            &mut text,
            "picture",
            &format!("{}x{}, {}", image.width, image.height, plural(image.samples as usize, "sample")),
        );
        section(&mut text, "meshes", scene.meshes.iter().map(mesh_text));
        if self.vertices {
            scene.meshes.iter().for_each(|mesh| text.push_str(&vertices::tables(mesh)));
        }
        if self.matrices {
            text.push_str(&MatrixTables::of(scene).text());
        }
        section(&mut text, "materials", scene.materials.iter().map(material_text));
        section(
            &mut text,
            "textures",
            scene
                .textures
                .iter()
                .map(|texture| format!("{} {}x{}", name(&texture.name), texture.width, texture.height)),
        );
        let lights =
            if self.input.default_lights { "lights (the file has none; these are added)" } else { "lights" };
        let is_ambient = |light: &&Light| light.kind == LightKind::Ambient;
        let ambient = scene.lights.iter().filter(is_ambient).map(light_text);
        section(&mut text, "ambient light", ambient);
        section(&mut text, lights, scene.lights.iter().filter(|light| !is_ambient(light)).map(light_text));
        self.cameras(&mut text);
        section(&mut text, "variants of materials", self.input.variants.iter().cloned());
        section(&mut text, "ignored or changed", self.input.notes.iter().cloned());
        text
    }

    fn cameras(&self, text: &mut String) {
        let scene = &self.input.scene;
        match (&scene.camera, self.input.cameras.is_empty()) {
            (Some(camera), true) => section(text, "cameras", [camera_text("", camera)]),
            (None, true) => line(text, "cameras", "none; the scene is framed automatically"),
            _ => {
                let cameras = self.input.cameras.iter();
                section(text, "cameras", cameras.map(|(name, camera)| camera_text(name, camera)));
            }
        }
    }

    /// For programs.
    pub(crate) fn document(&self) -> Document {
        Document::of(self)
    }

    /// How many triangles are drawn: those of a mesh count once per object.
    pub(super) fn triangles(&self) -> usize {
        let scene = &self.input.scene;
        scene.objects.iter().map(|object| scene.meshes[object.mesh].triangle_count()).sum()
    }
}

fn line(text: &mut String, title: &str, content: &str) {
    writeln!(text, "  {title:<10} {content}").expect("a string takes everything");
}

/// A title with a number, and the things below it; nothing where there is nothing.
fn section(text: &mut String, title: &str, items: impl IntoIterator<Item = String>) {
    let items: Vec<_> = items.into_iter().collect();
    if items.is_empty() {
        return;
    }
    writeln!(text, "  {title}: {}", items.len()).expect("a string takes everything");
    for item in items.iter().take(MOST_LISTED) {
        writeln!(text, "    {}", shown(item)).expect("a string takes everything");
    }
    if let Some(more) = items.len().checked_sub(MOST_LISTED).filter(|more| *more > 0) {
        writeln!(text, "    and {more} more; --format json lists all").expect("a string takes everything");
    }
}

fn plural(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}

fn name(name: &str) -> &str {
    if name.is_empty() { "(unnamed)" } else { name }
}

fn vector(v: DVec3) -> String {
    v.to_array().map(number).join(", ")
}

fn bounds_text(bounds: &Bounds) -> String {
    match bounds.is_empty() {
        true => "empty".to_owned(),
        false => format!("({}) to ({})", vector(bounds.min), vector(bounds.max)),
    }
}

pub(super) fn attributes(mesh: &Mesh) -> Vec<&'static str> {
    let has = [
        (!mesh.normals.is_empty(), "normals"),
        (!mesh.uvs.is_empty(), "uvs"),
        (!mesh.tangents.is_empty(), "tangents"),
        (!mesh.colors.is_empty(), "colors"),
    ];
    has.into_iter().filter(|(has, _)| *has).map(|(_, name)| name).collect()
}

fn mesh_text(mesh: &Mesh) -> String {
    let mut text = format!(
        "{}: {}, {}",
        name(&mesh.name),
        plural(mesh.triangle_count(), "triangle"),
        plural(mesh.positions.len(), "vertex").replace("vertexs", "vertices"),
    );
    let attributes = attributes(mesh);
    if !attributes.is_empty() {
        write!(text, ", with {}", attributes.join(", ")).expect("a string takes everything");
    }
    text
}

fn lobe_text(lobe: &Lobe) -> String {
    format!("{} × {}", shape_text(lobe), colors::tint_text(&lobe.tint))
}

fn shape_text(lobe: &Lobe) -> String {
    let info = lobe.shape.info();
    let params = info.params.iter().zip(lobe.shape.params());
    let params: String = params.map(|(param, value)| format!(" {} {}", param.name, number(value))).collect();
    format!("{}{params}", info.name)
}

/// What textures give a material.
pub(super) fn maps(material: &Material) -> Vec<&'static str> {
    let any = |gives: fn(&Lobe) -> bool| material.lobes.iter().any(gives);
    let has = [
        (material.base_color.is_some(), "base color"),
        (material.metal_rough_map.is_some(), "metal and roughness"),
        (material.normal_map.is_some(), "normal"),
        (material.occlusion.is_some(), "occlusion"),
        (material.emission_map.is_some(), "emission"),
        (any(|lobe| !lobe.masks.is_empty()), "masks of lobes"),
        (any(|lobe| matches!(lobe.roughness, RoughnessMap::Own(_))), "roughness of lobes"),
    ];
    has.into_iter().filter(|(has, _)| *has).map(|(_, name)| name).collect()
}

/// The table of factors that a lobe of measured reflectance lies under.
fn factor_table(lobe: &Lobe) -> Option<&FactorTable> {
    lobe.layers.iter().find_map(|layer| match layer {
        LayerWeight::Table { table, .. } => Some(&**table),
        _ => None,
    })
}

/// Measured reflectance in a few words: its table, and what that is a factor of.
fn measured_text(lobes: &[Lobe]) -> Option<String> {
    let measured: Vec<(&Lobe, &FactorTable)> =
        lobes.iter().filter_map(|lobe| Some((lobe, factor_table(lobe)?))).collect();
    let (_, table) = measured.first()?;
    let mut shapes: Vec<String> = measured.iter().map(|(lobe, _)| shape_text(lobe)).collect();
    shapes.dedup();
    let [x, y, z, w] = table.sizes();
    let around = if w > 1 { format!(" x {w}") } else { String::new() };
    let (ranks, kilobytes) = (table.ranks(), table.bytes().div_ceil(1000));
    let ranks = plural(ranks, "rank");
    let over = shapes.join(" and ");
    Some(format!("measured: {ranks} of {x} x {y} x {z}{around} factors ({kilobytes} kB) over {over}"))
}

fn material_text(material: &Material) -> String {
    let others = material.lobes.iter().filter(|lobe| factor_table(lobe).is_none()).map(lobe_text);
    let lobes = measured_text(&material.lobes).into_iter().chain(others).collect::<Vec<_>>().join(" + ");
    let mut text = format!("{}: {}", name(&material.name), if lobes.is_empty() { "black" } else { &lobes });
    let maps = maps(material);
    if !maps.is_empty() {
        write!(text, ", textures: {}", maps.join(", ")).expect("a string takes everything");
    }
    match material.alpha_mode {
        AlphaMode::Opaque => {}
        AlphaMode::Mask { cutoff } => {
            write!(text, ", cut out below alpha {cutoff}").expect("a string takes everything");
        }
        AlphaMode::Blend => {
            write!(text, ", opacity {}", number(material.opacity.into())).expect("a string takes everything")
        }
    }
    text
}

fn attenuation_text(attenuation: &Attenuation) -> String {
    match *attenuation {
        Attenuation::NONE => String::new(),
        Attenuation { constant, linear, quadratic } => {
            format!(", attenuation {}, {}, {}", number(constant), number(linear), number(quadratic))
        }
    }
}

fn light_text(light: &Light) -> String {
    let kind = match &light.kind {
        LightKind::Ambient => "ambient".to_owned(),
        LightKind::Directional { direction } => format!("directional along ({})", vector(*direction)),
        LightKind::Point { position, attenuation } => {
            format!("point at ({}){}", vector(*position), attenuation_text(attenuation))
        }
        LightKind::Spot { position, direction, cutoff, attenuation, .. } => format!(
            "spot at ({}) along ({}), cutoff {}°{}",
            vector(*position),
            vector(*direction),
            number(cutoff.to_degrees()),
            attenuation_text(attenuation)
        ),
        LightKind::Area { shape, position, direction, two_sided, .. } => {
            area_text(*shape, *position, *direction, *two_sided)
        }
        LightKind::Environment { map: Some(map), .. } => {
            format!("environment of {}x{} pixels", map.width, map.height)
        }
        LightKind::Environment { map: None, .. } => "environment, uniform".to_owned(),
    };
    let sent = match light.kind {
        LightKind::Ambient => &light.colors.ambient,
        _ => &light.colors.diffuse,
    };
    let camera = if light.space == Space::Camera { ", moves with the camera" } else { "" };
    let prefix = if light.name.is_empty() { String::new() } else { format!("{}: ", light.name) };
    let luminaire = light.luminaire.as_ref().map(luminaire_text).unwrap_or_default();
    let more = parts_text(light);
    format!("{prefix}{kind}{luminaire}, color {}{more}{camera}", colors::light_text(sent))
}

/// What a light sends to specular and ambient terms, where that is not its colour, or not nothing.
fn parts_text(light: &Light) -> String {
    let LightColors { ambient, diffuse, specular } = &light.colors;
    if light.kind == LightKind::Ambient {
        return String::new();
    }
    let specular = (specular != diffuse).then(|| format!(", specular {}", colors::light_text(specular)));
    let ambient = if ambient.is_black() { "0".to_owned() } else { colors::light_text(ambient) };
    format!("{}, ambient {ambient}", specular.unwrap_or_default())
}

fn area_text(shape: AreaShape, position: DVec3, direction: DVec3, two_sided: bool) -> String {
    let position = vector(position);
    let (form, size) = match shape {
        AreaShape::Rectangle { width, height } => {
            ("rectangle", format!("{} x {} m", number(width), number(height)))
        }
        AreaShape::Disk { radius } => ("disk", format!("of radius {} m", number(radius))),
        AreaShape::Sphere { radius } => {
            return format!("sphere of radius {} m at ({position})", number(radius));
        }
    };
    let sides = if two_sided { ", two-sided" } else { "" };
    format!("{form} {size} at ({position}) facing ({}){sides}", vector(direction))
}

fn luminaire_text(luminaire: &Luminaire) -> String {
    let (profile, axis) = (&luminaire.profile, vector(luminaire.axis));
    let size = format!("{}x{} directions", profile.c_deg.len(), profile.gamma_deg.len());
    let (max, flux) = (number(profile.max()), number(profile.flux_lm()));
    format!(", profile of {size} along ({axis}), up to {max} cd, {flux} lm")
}

fn camera_text(label: &str, camera: &Camera) -> String {
    let projection = match camera.projection {
        Projection::Perspective { fov_y } => format!("{}° vertical", number(fov_y.to_degrees())),
        Projection::Orthographic { height } => format!("orthographic, {} high", number(height)),
    };
    let prefix = if label.is_empty() { String::new() } else { format!("{label}: ") };
    format!("{prefix}from ({}) to ({}), {projection}", vector(camera.eye), vector(camera.target))
}
