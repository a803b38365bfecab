//! Points, edges and who shares them.

use core::hash::Hash;
use std::collections::HashMap;

use glam::Vec3;

/// Vertices that lie at exactly the same place, as one point each.
pub(crate) struct Welded {
    /// The point of each vertex, numbered in the order of first appearance.
    pub point_of: Vec<u32>,
    /// The first vertex at each point.
    pub first: Vec<u32>,
}

impl Welded {
    /// Welds by position, bit by bit but for the sign of zero.
    pub(crate) fn of(positions: &[Vec3]) -> Self {
        let mut known: HashMap<[u32; 3], u32> = HashMap::with_capacity(positions.len());
        let mut first = Vec::new();
        let point_of = positions
            .iter()
            .enumerate()
            .map(|(vertex, position)| {
                // Adding zero turns -0 into 0.
                let key = (*position + Vec3::ZERO).to_array().map(f32::to_bits);
                *known.entry(key).or_insert_with(|| {
                    first.push(vertex as u32);
                    first.len() as u32 - 1
                })
            })
            .collect();
        Self { point_of, first }
    }
}

/// Gives vertices that need several values of an attribute a twin for each further value.
pub(crate) struct Splitter<K> {
    /// The vertex that each vertex was at the beginning: first all of them, then the twins.
    pub sources: Vec<u32>,
    served: Vec<Option<K>>,
    twins: HashMap<(u32, K), u32>,
}

impl<K: Copy + Eq + Hash> Splitter<K> {
    /// For so many vertices.
    pub(crate) fn new(vertices: usize) -> Self {
        Self { sources: (0..vertices as u32).collect(), served: vec![None; vertices], twins: HashMap::new() }
    }

    /// The vertex to use where `vertex` needs the value that `key` stands for.
    pub(crate) fn user(&mut self, vertex: u32, key: K) -> u32 {
        let served = self.served[vertex as usize].get_or_insert(key);
        if *served == key {
            return vertex;
        }
        *self.twins.entry((vertex, key)).or_insert_with(|| {
            self.sources.push(vertex);
            self.sources.len() as u32 - 1
        })
    }

    /// Whether the vertex has been asked for any value yet.
    pub(crate) fn serves(&self, vertex: u32) -> bool {
        self.served[vertex as usize].is_some()
    }
}

/// The edges of a set of triangles, numbered by their lesser end, then by their greater.
pub(crate) struct Edges {
    /// The ends of each edge, the lesser index first.
    pub ends: Vec<[u32; 2]>,
    /// The edge from each corner of each triangle to its next.
    pub of_corner: Vec<[u32; 3]>,
}

impl Edges {
    /// Finds them in time linear in the number of triangles (times the logarithm of the most edges
    /// that meet in one point).
    pub(crate) fn of(triangles: &[[u32; 3]], points: usize) -> Self {
        let sides: Vec<[u32; 2]> = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]).collect();
        let mut ends = Vec::with_capacity(sides.len() / 2 + 1);
        let mut of_corner = vec![[0; 3]; triangles.len()];
        for_each_edge(&sides, points, |edge, members| {
            for &side in members {
                of_corner[side as usize / 3][side as usize % 3] = ends.len() as u32;
            }
            ends.push(edge);
        });
        Self { ends, of_corner }
    }

    /// Cuts each triangle in four, where edge `i` has got the vertex `first + i` in its middle.
    pub(crate) fn split(&self, triangles: &[[u32; 3]], first: u32) -> Vec<[u32; 3]> {
        let mut parts = Vec::with_capacity(4 * triangles.len());
        for (&[a, b, c], edges) in triangles.iter().zip(&self.of_corner) {
            let [ab, bc, ca] = edges.map(|edge| first + edge);
            parts.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        parts
    }
}

/// Calls `visit` for each edge with its ends (the lesser first) and the numbers of all `sides` that
/// run along it, in rising order; edges come by their lesser end, then by their greater.
pub(crate) fn for_each_edge(sides: &[[u32; 2]], points: usize, mut visit: impl FnMut([u32; 2], &[u32])) {
    let mut starts = vec![0_u32; points + 1];
    for side in sides {
        starts[side[0].min(side[1]) as usize + 1] += 1;
    }
    for i in 0..points {
        starts[i + 1] += starts[i];
    }
    let mut next = starts.clone();
    let mut sorted = vec![(0_u32, 0_u32); sides.len()];
    for (number, side) in sides.iter().enumerate() {
        let slot = &mut next[side[0].min(side[1]) as usize];
        sorted[*slot as usize] = (side[0].max(side[1]), number as u32);
        *slot += 1;
    }
    let mut members = Vec::new();
    for lesser in 0..points {
        let bucket = &mut sorted[starts[lesser] as usize..starts[lesser + 1] as usize];
        bucket.sort_unstable();
        for edge in bucket.chunk_by(|a, b| a.0 == b.0) {
            members.clear();
            members.extend(edge.iter().map(|&(_, side)| side));
            visit([lesser as u32, edge[0].0], &members);
        }
    }
}

/// Disjoint sets of numbers. The root of each is its first member.
pub(crate) struct Groups(Vec<u32>);

impl Groups {
    /// Each member alone.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    fn root(&mut self, mut member: u32) -> u32 {
        loop {
            let parent = self.0[member as usize];
            if parent == member {
                return member;
            }
            // Halving the path keeps later searches short.
            self.0[member as usize] = self.0[parent as usize];
            member = parent;
        }
    }

    /// Makes one set of those of both members.
    pub(crate) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    /// The first member of the set of each.
    pub(crate) fn into_roots(mut self) -> Vec<u32> {
        for member in 0..self.0.len() as u32 {
            // Parents come before their children, so one step is enough here.
            self.0[member as usize] = self.0[self.0[member as usize] as usize];
        }
        self.0
    }
}
