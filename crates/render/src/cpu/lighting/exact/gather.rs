//! What one direction gives all lobes.

use glanz_math::{Real, Vec3};

use crate::cpu::lighting::environment::is_seen_through;
use crate::cpu::lighting::light_sum::{KnownFactors, LightSum, is_transmitting, layered, shape_value};
use crate::prepare::{DirectLobe, TintCoordinate};

/// The light of `N` rows of the table that came together so far, by lobes whose tint is the same in all directions.
pub(super) struct Gathered<R, const N: usize> {
    row: usize,
    of_lobes: Vec<[R; N]>,
    /// Lobes that see this light by other ways.
    skips: Vec<bool>,
}

impl<R: Real, const N: usize> Gathered<R, N> {
    /// Nothing yet, for the rows from `row` on; of an environment, or of an area.
    pub(super) fn new(sum: &LightSum<R>, row: usize, is_around: bool) -> Self {
        let material = sum.material;
        let skips =
            |lobe: &DirectLobe| lobe.shape.info().delta || (is_around && is_seen_through(material, lobe));
        let skips = material.lobes.iter().map(skips).collect();
        Self { row, of_lobes: vec![[sum.cos_o.zero(); N]; material.lobes.len()], skips }
    }

    /// Adds light from a direction: its solid angle times its amounts.
    #[inline(never)]
    pub(super) fn add(&mut self, sum: &mut LightSum<R>, wi: Vec3<R>, amounts: [R; N]) {
        wi.x.at_own_level(
            #[inline(always)]
            || self.add_here(sum, wi, amounts),
        );
    }

    #[inline(always)]
    fn add_here(&mut self, sum: &mut LightSum<R>, wi: Vec3<R>, amounts: [R; N]) {
        let pair = sum.pair(wi);
        let zero = pair.cos_i.zero();
        let (mut last, mut known) = (zero, KnownFactors::new(zero));
        let material = sum.material;
        for (k, lobe) in material.lobes.iter().enumerate() {
            let is_lit = if is_transmitting(lobe) { pair.cos_i.lt(zero) } else { zero.lt(pair.cos_i) };
            if self.skips[k] || !R::any(is_lit) {
                continue;
            }
            let is_known = material.repeats[k] && k > 0 && !self.skips[k - 1];
            if !is_known {
                let own = sum.own_pair(lobe, &pair);
                last = shape_value(lobe, own.as_ref().unwrap_or(&pair));
            }
            let value = match material.has_tables {
                true => known.layered(lobe, last, &pair),
                false => layered(lobe, last, &pair),
            };
            let value = value.select(is_lit, zero);
            for (basis, amount) in amounts.into_iter().enumerate() {
                match lobe.coordinate {
                    TintCoordinate::None => {
                        let gathered = &mut self.of_lobes[k][basis];
                        *gathered = *gathered + value * amount;
                    }
                    _ => sum.add(self.row + basis, k, value * amount, &pair),
                }
            }
        }
    }

    /// Gives the sum what came together.
    #[inline(always)]
    pub(super) fn finish(self, sum: &mut LightSum<R>) {
        let pair = sum.mirror_pair();
        for (k, values) in self.of_lobes.into_iter().enumerate() {
            if sum.material.lobes[k].coordinate == TintCoordinate::None {
                for (basis, value) in values.into_iter().enumerate() {
                    sum.add(self.row + basis, k, value, &pair);
                }
            }
        }
    }
}
