//! Clusters, vertices, triangles, and what casts shadows.

use super::{Packer, Section, place};
use crate::prepare::data::{Bvh, Cluster, Geometry};

impl Packer {
    pub(super) fn geometry(&mut self, geometry: &Geometry) {
        geometry.clusters.iter().for_each(|cluster| self.cluster(cluster));
        let [x, y, z] = &geometry.position;
        let positions: Vec<f32> = (0..x.len()).flat_map(|i| [x[i], y[i], z[i]]).collect();
        self.floats(Section::Positions, &positions);
        self.floats(Section::Normals, geometry.normals.as_flattened());
        self.floats(Section::Uvs, geometry.uvs.as_flattened());
        self.floats(Section::Uvs2, geometry.uvs2.as_flattened());
        self.floats(Section::Colors, geometry.colors.as_flattened());
        self.floats(Section::Tangents, geometry.tangents.as_flattened());
        self.words(Section::Sources, &geometry.sources);
        self.triangles(geometry);
    }

    fn cluster(&mut self, cluster: &Cluster) {
        let Cluster { object, first_vertex, vertices, first_triangle, triangles, .. } = *cluster;
        self.words(Section::Clusters, &[object, first_vertex, vertices, first_triangle, triangles]);
        let ([x, y, z], [a, b, c]) = (cluster.center, cluster.cone_axis);
        self.floats(Section::ClusterBounds, &[x, y, z, cluster.radius, a, b, c, cluster.cone_sin]);
    }

    fn triangles(&mut self, geometry: &Geometry) {
        let both = geometry.triangles.iter().zip(&geometry.facets);
        let record = |([a, b, c], (facet, edges)): (&[u8; 3], &(u32, u8))| {
            [u32::from_le_bytes([*a, *b, *c, *edges]), *facet]
        };
        let records: Vec<u32> = both.flat_map(record).collect();
        self.words(Section::Triangles, &records);
    }

    pub(super) fn bvh(&mut self, bvh: &Bvh) {
        let mut origin = place(bvh.center).to_vec();
        origin.push(bvh.size);
        self.floats(Section::BvhPlace, &origin);
        self.floats(Section::BvhTriangles, bvh.triangles.as_flattened().as_flattened());
        for node in &bvh.nodes {
            self.words(Section::BvhNodes, &[node.first, node.count]);
            self.floats(Section::BvhBoxes, [node.min, node.max].as_flattened());
        }
    }
}
