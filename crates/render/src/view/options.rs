//! What a frame shows, and how.

pub use glanz_scene::DebugView;
use glanz_scene::{Background, Lighting, RenderSettings};

use super::Samples;

/// Which planes a frame has beside colour and alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Aovs {
    /// Distance from the eye plane.
    pub depth: bool,
    /// Shading normals.
    pub normal: bool,
    /// Object numbers.
    pub object: bool,
}

/// How to draw.
///
/// ```
/// use glanz_render::{Aovs, DrawOptions, PrepareOptions, View, draw, prepare};
/// use glanz_scene::{Background, Camera, Mesh, Scene, library};
///
/// let scene = Scene::new().with_mesh(Mesh::builtin("sphere")?, library::material("gold")?);
/// let prepared = prepare(&scene, &PrepareOptions::default())?;
/// let view = View::new(&Camera::new([0.0, 0.0, 5.0], [0.0; 3]), 9, 9)?;
/// let aovs = Aovs { depth: true, ..Aovs::default() };
/// let frame = draw(&prepared, &view, &DrawOptions { aovs, ..DrawOptions::new(Background::Transparent) });
/// assert!((frame.depth[40] - 4.0).abs() < 0.1, "the front of the sphere");
/// assert_eq!((frame.alpha[0], frame.depth[0]), (0.0, f32::INFINITY), "nothing");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawOptions {
    /// Coverage samples per pixel.
    pub samples: Samples,
    /// Shade every sample rather than once per pixel and surface.
    pub supersample: bool,
    /// What the picture shows.
    pub show: DebugView,
    /// What is behind all surfaces. A colour is in the channels of the frame, which are those of the observer that the
    /// scene was prepared for: linear sRGB in mode `rgb`, else what `ToScreen::channels_of` makes of linear sRGB.
    /// [`ShotOptions`](crate::ShotOptions) takes linear sRGB in every mode and does that itself.
    pub background: Background,
    /// Planes beside colour and alpha.
    pub aovs: Aovs,
    /// Normals between vertices are used with the length that interpolation leaves them, and not made unit vectors: a
    /// mistake for teaching ([`Mistake::UnnormalisedNormal`](glanz_scene::Mistake::UnnormalisedNormal)).
    pub raw_normals: bool,
    /// Extended lights by points, rather than by what is prepared for them.
    pub exact: Option<ExactLighting>,
    /// What programs are told beside the scene.
    pub moment: Moment,
    /// The channels of linear red, green and blue of 1, of which programs' colours are made;
    /// [`ShotOptions`](crate::ShotOptions) sees to it in every mode.
    pub primaries: [[f32; 3]; 3],
}

/// Areas and environments by points in them, in the lobes and over the hemisphere: the slow truth, that the fast way is
/// measured against. With shadows each point is seen or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactLighting {
    /// Points of each light, and as many of each lobe and of the hemisphere, at each pixel. Powers of two are spread most evenly.
    pub points: u32,
    /// Half of the points alone, which are as even as all: the difference of the halves tells how far all are from the truth.
    pub half: Option<Half>,
}

impl ExactLighting {
    /// What a scene asks for, if it asks for it.
    pub fn of(settings: &RenderSettings) -> Option<Self> {
        let points = settings.light_samples.map_or_else(Self::default, Self::new);
        (settings.lighting == Lighting::Exact).then_some(points)
    }

    /// So many points.
    pub fn new(points: u32) -> Self {
        Self { points, half: None }
    }
}

impl Default for ExactLighting {
    /// 1024 points.
    fn default() -> Self {
        Self::new(1024)
    }
}

/// One of two halves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// The first.
    First,
    /// The second.
    Second,
}

/// When a picture is drawn, and where the pointer is: what programs may ask for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moment {
    /// Seconds since the start.
    pub time: f32,
    /// Seconds since the picture before.
    pub delta: f32,
    /// Number of the picture.
    pub frame: u32,
    /// The pointer: x and y in pixels from the lower left, then where it was pressed; zeros without any.
    pub mouse: [f32; 4],
}

/// Channels that are linear sRGB.
const SRGB: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl DrawOptions {
    /// One sample, shaded, on this background.
    pub fn new(background: Background) -> Self {
        Self {
            samples: Samples::One,
            supersample: false,
            show: DebugView::Shaded,
            background,
            aovs: Aovs::default(),
            raw_normals: false,
            exact: None,
            moment: Moment::default(),
            primaries: SRGB,
        }
    }
}
