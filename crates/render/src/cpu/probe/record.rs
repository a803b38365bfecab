//! Pictures of what lies behind the shading of a pixel, number by number.

use fearless_simd::Simd;
use glanz_math::{Lanes, LanesMask, Real};

use crate::cpu::lighting::point::ShadingPoint;
use crate::cpu::shading::shade_block::{Place, ShadeBlock};
use crate::cpu::shading::texturing::SurfaceAttributes;

/// Three numbers that a frame holds in place of light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Record {
    /// What multiplies textured lobes.
    Base,
    /// What multiplies the emission.
    Emission,
    /// The factor of roughness, how metallic the surface is, and whether it has a tangent.
    Roughness,
    /// The tangent.
    Tangent,
    /// The facet, and 1 on its back.
    Facet,
    /// The interpolation's coordinates of the second and third corner.
    Place,
    /// The texture coordinates, and whether there are any.
    Uv,
    /// The opacity.
    Opacity,
    /// What pictures say: the channels of the material from this one on.
    Channels(usize),
}

/// Replaces a block's colours by what is recorded.
pub(crate) fn replace<S: Simd>(
    record: Record,
    block: &ShadeBlock<S>,
    place: &Place<S>,
    (point, alpha): (&ShadingPoint<Lanes<S>>, Lanes<S>),
    extra: &SurfaceAttributes<S>,
) -> [Lanes<S>; 3] {
    let zero = block.px.zero();
    let flag = |is: bool| if is { zero.one() } else { zero };
    match record {
        Record::Base => extra.base,
        Record::Emission => extra.emission,
        Record::Roughness => [point.alpha_scale, point.metal, flag(point.tangent.is_some())],
        Record::Tangent => point.tangent.map_or([zero; 3], |tangent| [tangent.x, tangent.y, tangent.z]),
        Record::Opacity => [alpha, zero, zero],
        Record::Channels(first) => {
            [0, 1, 2].map(|next| point.channels.get(first + next).copied().unwrap_or(zero))
        }
        Record::Facet => facets(block),
        Record::Place => [place.u, place.v, zero],
        Record::Uv => [extra.uv[0], extra.uv[1], flag(block.object.layout.uv.is_some())],
    }
}

/// The facet of each pixel, in two numbers since `f32` holds whole ones to 2^24 only, and its side.
fn facets<S: Simd>(block: &ShadeBlock<S>) -> [Lanes<S>; 3] {
    let mut lanes = [block.px.zero(); 3];
    for run in block.runs {
        let mask = LanesMask::from_bits(block.simd, run.bits);
        let setup = block.setup(run);
        let numbers = [setup.facet >> 16, setup.facet & 0xffff, u32::from(setup.back)];
        for (lanes, number) in lanes.iter_mut().zip(numbers) {
            *lanes = Lanes::splat(block.simd, number as f32).select(mask, *lanes);
        }
    }
    lanes
}
