//! The levels of a texture's picture.

use glanz_math::Real;

/// What happens beyond the border of a picture, along u or v.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Border {
    /// It begins anew.
    #[default]
    Repeat,
    /// Its last texel goes on.
    Hold,
    /// It goes back.
    Mirror,
}

/// A picture at one size, by rows from the bottom.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Level {
    pub(super) size: [usize; 2],
    texels: Texels,
}

#[derive(Clone, Debug, PartialEq)]
enum Texels {
    /// 0 to 255 for 0 to 1.
    Codes(Vec<[u8; 4]>),
    Numbers(Vec<[f32; 4]>),
}

/// How a look goes from texel to texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Sampling {
    pub(super) borders: [Border; 2],
    /// The nearest texel instead of a mean of four.
    pub(super) nearest: bool,
}

/// The level, as a number, for a square of the way in texels from one pixel to the next (OpenGL 4.6, §8.14, by the longer
/// of the two).
pub(super) fn level_of(square: f32) -> f32 {
    if square > 0.0 && square.is_finite() { 0.5 * Real::log2(square) } else { 0.0 }
}

pub(super) fn trilinear(
    levels: &[Level],
    uv: [f32; 2],
    level: f32,
    offset: [i64; 2],
    sampling: Sampling,
) -> [f32; 4] {
    let last = (levels.len() - 1) as f32;
    let level = if level.is_nan() { 0.0 } else { level.clamp(0.0, last) };
    let (fine, part) = (level.floor(), level - level.floor());
    let near = levels[fine as usize].look(uv, offset, sampling);
    if part == 0.0 {
        return near;
    }
    mix(near, levels[fine as usize + 1].look(uv, offset, sampling), part)
}

impl Level {
    pub(super) fn of_codes(size: [usize; 2], texels: Vec<[u8; 4]>) -> Self {
        Self { size, texels: Texels::Codes(texels) }
    }

    pub(super) fn of_numbers(size: [usize; 2], texels: Vec<[f32; 4]>) -> Self {
        Self { size, texels: Texels::Numbers(texels) }
    }

    /// It and those of half the size each, down to 1×1.
    pub(super) fn with_smaller(self) -> Vec<Self> {
        let mut levels = vec![self];
        while let Some(last) = levels.last().filter(|level| level.size != [1, 1]) {
            let next = last.halved();
            levels.push(next);
        }
        levels
    }

    /// At half the size: means of 2×2 texels.
    fn halved(&self) -> Self {
        let size = self.size.map(|side| (side / 2).max(1));
        let texels = match &self.texels {
            Texels::Codes(all) => Texels::Codes(self.blocks(all, size, |block| {
                let mean = |c: usize| (block.iter().map(|texel| u32::from(texel[c])).sum::<u32>() + 2) / 4;
                std::array::from_fn(|c| mean(c) as u8)
            })),
            Texels::Numbers(all) => Texels::Numbers(self.blocks(all, size, |block| {
                std::array::from_fn(|c| block.iter().map(|texel| texel[c]).sum::<f32>() * 0.25)
            })),
        };
        Self { size, texels }
    }

    /// What `f` makes of each 2×2 texels.
    fn blocks<T: Copy>(&self, all: &[T], size: [usize; 2], f: impl Fn([T; 4]) -> T) -> Vec<T> {
        let mut out = Vec::with_capacity(size[0] * size[1]);
        for y in 0..size[1] {
            for x in 0..size[0] {
                out.push(f([(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| {
                    let column = (2 * x + dx).min(self.size[0] - 1);
                    let row = (2 * y + dy).min(self.size[1] - 1);
                    all[row * self.size[0] + column]
                })));
            }
        }
        out
    }

    /// The values of a texel.
    pub(super) fn values(&self, [x, y]: [usize; 2]) -> [f32; 4] {
        let at = y * self.size[0] + x;
        match &self.texels {
            Texels::Codes(all) => all[at].map(|code| f32::from(code) / 255.0),
            Texels::Numbers(all) => all[at],
        }
    }

    /// A place in texels, 0 being the centre of the first.
    pub(super) fn place(&self, uv: [f32; 2], borders: [Border; 2]) -> [f32; 2] {
        std::array::from_fn(|i| {
            let is_inside = (0.0..=1.0).contains(&uv[i]);
            // Inside the first repetition, so that no number is too large for a texel's.
            let part = match borders[i] {
                _ if is_inside => uv[i],
                Border::Repeat => uv[i] - uv[i].floor(),
                Border::Hold => uv[i].clamp(0.0, 1.0),
                Border::Mirror => {
                    let there = uv[i] * 0.5 - (uv[i] * 0.5).floor();
                    1.0 - (there * 2.0 - 1.0).abs()
                }
            };
            part * self.size[i] as f32 - 0.5
        })
    }

    /// The texel so far from a place.
    pub(super) fn texel(&self, at: [f32; 2], d: [i64; 2], borders: [Border; 2]) -> [f32; 4] {
        let along = |i: usize| {
            let (at, side) = (at[i].floor() as i64 + d[i], self.size[i] as i64);
            match borders[i] {
                Border::Repeat => at.rem_euclid(side) as usize,
                Border::Hold => at.clamp(0, side - 1) as usize,
                Border::Mirror => {
                    let there = at.rem_euclid(2 * side);
                    there.min(2 * side - 1 - there) as usize
                }
            }
        };
        self.values([along(0), along(1)])
    }

    fn look(&self, uv: [f32; 2], offset: [i64; 2], sampling: Sampling) -> [f32; 4] {
        let Sampling { borders, nearest } = sampling;
        let at = self.place(uv, borders);
        let texel =
            |at: [f32; 2], dx: i64, dy: i64| self.texel(at, [offset[0] + dx, offset[1] + dy], borders);
        if nearest {
            return texel(at.map(|at| at + 0.5), 0, 0);
        }
        let part = at.map(|at| if at.is_nan() { 0.0 } else { at - at.floor() });
        let below = mix(texel(at, 0, 0), texel(at, 1, 0), part[0]);
        mix(below, mix(texel(at, 0, 1), texel(at, 1, 1), part[0]), part[1])
    }
}

fn mix(a: [f32; 4], b: [f32; 4], t: f32) -> [f32; 4] {
    std::array::from_fn(|c| a[c] + (b[c] - a[c]) * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four texels in a row: 0, 1, 2, 3.
    fn row() -> Level {
        Level::of_numbers([4, 1], [0.0, 1.0, 2.0, 3.0].map(|x| [x; 4]).to_vec())
    }

    fn at(u: f32, border: Border, nearest: bool) -> f32 {
        row().look([u, 0.5], [0; 2], Sampling { borders: [border; 2], nearest })[0]
    }

    #[test]
    fn borders_repeat_hold_and_mirror() {
        // Between the last texel and what follows it, and well beyond.
        for (border, expected) in [
            (Border::Repeat, [1.5, 1.0, 2.5]),
            (Border::Hold, [3.0, 3.0, 0.0]),
            (Border::Mirror, [3.0, 2.0, 0.5]),
        ] {
            let got = [1.0, 1.375, -0.25].map(|u| at(u, border, false));
            assert_eq!(got, expected, "{border:?}");
        }
        assert_eq!(at(0.5, Border::Repeat, false), 1.5);
        assert_eq!([0.49, 0.51, 0.74].map(|u| at(u, Border::Repeat, true)), [1.0, 2.0, 2.0]);
        assert!(at(f32::NAN, Border::Mirror, true).is_finite());
    }

    #[test]
    fn numbers_are_not_cut_in_smaller_levels() {
        let levels = row().with_smaller();
        assert_eq!(levels.iter().map(|level| level.size).collect::<Vec<_>>(), [[4, 1], [2, 1], [1, 1]]);
        assert_eq!([0, 1].map(|x| levels[1].values([x, 0])[0]), [0.5, 2.5]);
        assert_eq!(levels[2].values([0, 0])[0], 1.5);
    }
}
