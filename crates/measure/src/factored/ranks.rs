//! Channels of a table as mixtures of few of them.
//!
//! A table of factors has a column for each channel. Columns that are chosen one after the other, each the one that those
//! before tell least, and least squares for all others: an interpolative decomposition. Factors of the ranks are then
//! those of a channel each, which are positive as the data are; signs are in the mixture alone, which is part of tints.

use super::judge::Judge;
use crate::linear::solve;

/// A table in ranks.
pub(super) struct Ranked {
    /// The channels that the ranks are.
    pub(super) chosen: Vec<usize>,
    /// For each rank what it counts for in each channel.
    pub(super) mix: Vec<Vec<f64>>,
}

/// Columns of factors: of each node its channels.
pub(super) struct Columns<'a> {
    pub(super) channels: usize,
    pub(super) factors: &'a [f64],
    /// Nodes that count, and how much.
    pub(super) nodes: Vec<(usize, f64)>,
    /// How much channels count.
    pub(super) weights: Vec<f64>,
}

impl Columns<'_> {
    fn column(&self, c: usize) -> Vec<f64> {
        let value = |(node, weight): &(usize, f64)| self.factors[node * self.channels + c] * weight;
        self.nodes.iter().map(value).collect()
    }

    /// With so few ranks that the judge sees no more than `most` of a difference, or with as many as are asked for; and
    /// what the judge sees with 1, 2 … of them.
    pub(super) fn ranked(&self, asked: Option<usize>, most: f64, judge: &Judge) -> (Ranked, Vec<f64>) {
        let limit = self.channels.min(glanz_bsdf::FactorTable::MOST_RANKS);
        let columns: Vec<Vec<f64>> = (0..self.channels).map(|c| self.column(c)).collect();
        let mut rest = columns.clone();
        let mut chosen = Vec::new();
        let mut seen = Vec::new();
        loop {
            chosen.push(self.next(&rest, &chosen));
            let newest = chosen[chosen.len() - 1];
            take_away(&mut rest, newest);
            let mix = mixture(&columns, &chosen);
            seen.push(judge.difference(&chosen, &mix));
            let is_enough = asked.map_or(seen[seen.len() - 1] <= most, |asked| chosen.len() >= asked);
            if is_enough || chosen.len() == limit {
                return (Ranked { chosen, mix }, seen);
            }
        }
    }

    /// The channel of which most is left.
    fn next(&self, rest: &[Vec<f64>], chosen: &[usize]) -> usize {
        let left = |c: usize| self.weights[c] * dot(&rest[c], &rest[c]);
        let open = (0..self.channels).filter(|c| !chosen.contains(c));
        open.max_by(|a, b| left(*a).total_cmp(&left(*b)).then(b.cmp(a))).unwrap_or(0)
    }
}

/// Leaves of all columns what is not along one of them.
fn take_away(rest: &mut [Vec<f64>], chosen: usize) {
    let axis = rest[chosen].clone();
    let squared = dot(&axis, &axis);
    if squared <= 0.0 {
        return;
    }
    for column in rest {
        let along = dot(column, &axis) / squared;
        column.iter_mut().zip(&axis).for_each(|(own, axis)| *own -= along * axis);
    }
}

/// What the chosen columns count for in each: least squares, the chosen ones being themselves.
fn mixture(columns: &[Vec<f64>], chosen: &[usize]) -> Vec<Vec<f64>> {
    let n = chosen.len();
    let gram: Vec<Vec<f64>> =
        chosen.iter().map(|a| chosen.iter().map(|b| dot(&columns[*a], &columns[*b])).collect()).collect();
    let mut mix = vec![vec![0.0; columns.len()]; n];
    for (c, column) in columns.iter().enumerate() {
        if let Some(rank) = chosen.iter().position(|own| *own == c) {
            mix[rank][c] = 1.0;
            continue;
        }
        let products: Vec<f64> = chosen.iter().map(|own| dot(&columns[*own], column)).collect();
        let solved = solved(gram.clone(), products);
        mix.iter_mut().zip(solved).for_each(|(rank, amount)| rank[c] = amount);
    }
    mix
}

/// The solution of a positive system that is a little heavier on its diagonal, so that columns that are alike share evenly.
fn solved(mut matrix: Vec<Vec<f64>>, mut x: Vec<f64>) -> Vec<f64> {
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] *= 1.0 + 1e-10;
    }
    solve(&mut matrix, &mut x);
    x
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
