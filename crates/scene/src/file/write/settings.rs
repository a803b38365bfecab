//! Picture, camera and settings.

use glam::DVec3;
use glanz_color::Observer;

use super::text::{Document, Table, degrees, inline, number, rgb, samples, string, tall_list, vector};
use crate::{Background, Camera, Image, Projection, RenderSettings, Scene};

/// Adds `[image]`, `[camera]` and `[render]`, what is not the default of them.
pub(super) fn write(scene: &Scene, document: &mut Document) {
    document.section("[image]", &image(&scene.image), true);
    if let Some(camera) = &scene.camera {
        document.section("[camera]", &camera_table(camera), false);
    }
    if let Some(viewer) = &scene.eye {
        document.section("[eye]", &super::eye::table(viewer), false);
    }
    let mut table = render(&scene.render);
    if let Some(observer) = &scene.observer {
        table.put("observer", observer_value(observer));
    }
    table.put_unless(!scene.photometric, "photometric", "true");
    document.section("[render]", &table, true);
}

fn image(image: &Image) -> Table {
    let default = Image::default();
    let mut table = Table::default();
    table.put_unless(image.width == default.width, "width", image.width.to_string());
    table.put_unless(image.height == default.height, "height", image.height.to_string());
    table.put_unless(image.samples == default.samples, "samples", image.samples.to_string());
    table.put_unless(!image.supersample, "supersample", "true");
    let background = match image.background {
        Background::Color(color) => rgb(color),
        Background::Transparent => string("transparent"),
        Background::Environment => string("environment"),
    };
    table.put_unless(image.background == default.background, "background", background);
    table
}

fn camera_table(camera: &Camera) -> Table {
    let mut table = Table::default();
    table.put("eye", vector(camera.eye));
    table.put_unless(camera.target == DVec3::ZERO, "target", vector(camera.target));
    table.put_unless(camera.up == DVec3::Y, "up", vector(camera.up));
    match camera.projection {
        Projection::Orthographic { height } => {
            table.put("projection", string("orthographic"));
            table.put("height", number(height));
        }
        Projection::Perspective { fov_y } => match degrees(fov_y) {
            Some(degrees) => table.put("fov_deg", degrees),
            None => table.put("fov_rad", number(fov_y)),
        },
    }
    table
}

fn render(render: &RenderSettings) -> Table {
    let default = RenderSettings::default();
    let mut table = Table::default();
    table.put_unless(render.shading == default.shading, "shading", string(render.shading.name()));
    let interpolation = string(render.interpolation.name());
    table.put_unless(render.interpolation == default.interpolation, "interpolation", interpolation);
    table.put_unless(render.show == default.show, "show", string(render.show.name()));
    table.put_unless(render.tone_map == default.tone_map, "tone_map", string(render.tone_map.name()));
    table.put_unless(render.ev == default.ev, "ev", number(render.ev));
    table.put_unless(render.mode == default.mode, "mode", string(&render.mode.to_string()));
    table.put_unless(render.white == default.white, "white", string(render.white.name()));
    table.put_unless(!render.shadows, "shadows", "true");
    table.put_unless(render.lighting == default.lighting, "lighting", string(render.lighting.name()));
    if let Some(points) = render.light_samples {
        table.put("light_samples", points.to_string());
    }
    let encoding = string(render.encoding.name());
    table.put_unless(render.encoding == default.encoding, "encoding", encoding);
    if let Some(mistake) = render.mistake {
        table.put("mistake", string(mistake.name()));
    }
    table
}

fn observer_value(observer: &Observer) -> String {
    if glanz_color::observer(&observer.name).as_ref() == Ok(observer) {
        return string(&observer.name);
    }
    let channels = observer.channels.iter().map(|channel| {
        inline([("name", string(&channel.name)), ("sensitivity", samples(&channel.sensitivity))])
    });
    let kind = serde_json::to_string(&observer.kind).expect("a name");
    inline([
        ("name", string(&observer.name)),
        ("title", string(&observer.title)),
        ("kind", kind),
        ("channels", tall_list(channels)),
    ])
}
