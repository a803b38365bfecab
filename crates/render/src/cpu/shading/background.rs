//! The background: what a pixel shows that no surface covers.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real};
use glanz_scene::Background;

use crate::cpu::block::{self, Grid};
use crate::cpu::frame::FrameView;
use crate::cpu::lighting::point::mixed;
use crate::cpu::lighting::shade_material::ShadeLights;
use crate::prepare::EnvironmentMap;
use crate::view::camera::ViewCamera;
use crate::view::lights::{ViewLight, turned};
use glanz_math::inline::three;

/// The background of a frame.
#[derive(Clone, Copy)]
pub(crate) struct ViewBackground<'a> {
    /// Colour and coverage where no environment is seen.
    fixed: ([f32; 3], f32),
    environment: Option<EnvironmentView<'a>>,
}

/// The environment that is seen.
#[derive(Clone, Copy)]
struct EnvironmentView<'a> {
    camera: &'a ViewCamera,
    /// None where they are 1 everywhere.
    map: Option<&'a EnvironmentMap>,
    to_map: [[f32; 3]; 3],
    /// What each of the three spectra gives in the channels.
    tint: [[f32; 3]; 3],
}

impl<'a> ViewBackground<'a> {
    /// The background of a frame.
    #[inline(always)]
    pub(crate) fn of(frame: &'a FrameView<'a>) -> Self {
        Self::new(frame.options.background, &frame.camera, &frame.lights, frame.prepared.environment_tint)
    }

    /// The background of a view among lights; `tint` is what the environment gives in the channels.
    fn new(
        background: Background,
        camera: &'a ViewCamera,
        lights: &ShadeLights<'a>,
        tint: Option<[[f32; 3]; 3]>,
    ) -> Self {
        let fixed = match background {
            Background::Color(color) => (color.0, 1.0),
            Background::Transparent => ([0.0; 3], 0.0),
            Background::Environment => ([0.0; 3], 1.0),
        };
        let seen = || match (lights.environment()?, tint?) {
            (ViewLight::Environment { environment, to_map, .. }, tint) => {
                Some(EnvironmentView { camera, map: environment.map.as_deref(), to_map: *to_map, tint })
            }
            _ => None,
        };
        let environment = if background == Background::Environment { seen() } else { None };
        Self { fixed, environment }
    }

    /// Colour and coverage, if they are the same everywhere.
    pub(crate) fn fixed(&self) -> Option<([f32; 3], f32)> {
        self.environment.is_none().then_some(self.fixed)
    }

    /// Colour and coverage of the block at a place of a tile.
    #[inline(always)]
    pub(crate) fn block<S: Simd>(&self, simd: S, grid: &Grid, at: usize) -> ([Lanes<S>; 3], Lanes<S>) {
        let (color, alpha) = self.fixed;
        let alpha = Lanes::splat(simd, alpha);
        let Some(seen) = &self.environment else {
            let [r, g, b] = color;
            return ([Lanes::splat(simd, r), Lanes::splat(simd, g), Lanes::splat(simd, b)], alpha);
        };
        let [px, py] = block::coordinates(simd, grid, at, [0.5, 0.5]);
        (seen.colors(px, py), alpha)
    }

    /// Colour and coverage of a block with the background where nothing covers it.
    #[inline(always)]
    pub(crate) fn behind<S: Simd>(
        &self,
        simd: S,
        rgb: [Lanes<S>; 3],
        covered: u32,
        (grid, at): (&Grid, usize),
    ) -> ([Lanes<S>; 3], Lanes<S>) {
        let (color, alpha) = self.block(simd, grid, at);
        let mask = LanesMask::from_bits(simd, covered);
        let over = three(
            [0, 1, 2],
            #[inline(always)]
            |c| rgb[c].select(mask, color[c]),
        );
        (over, alpha.one().select(mask, alpha))
    }
}

impl EnvironmentView<'_> {
    #[inline(never)]
    fn colors<S: Simd>(&self, px: Lanes<S>, py: Lanes<S>) -> [Lanes<S>; 3] {
        px.at_own_level(
            #[inline(always)]
            || {
                let (_, wo) = self.camera.unproject(px, py, px.one());
                let amounts = match self.map {
                    Some(map) => map.at(turned(&self.to_map, -wo)),
                    None => [px.one(); 3],
                };
                mixed(&self.tint, &amounts)
            },
        )
    }
}
