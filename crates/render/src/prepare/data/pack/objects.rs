//! Objects with their facets and polygons.

use super::{NO_RECORD, Packer, Section, place, short};
use crate::prepare::data::{Facets, Polygons, PreparedObject};

impl Packer {
    pub(super) fn object(&mut self, object: &PreparedObject) {
        let [facets, facet_count, facet_colors] =
            object.facets.as_ref().map_or([NO_RECORD, 0, NO_RECORD], |facets| self.facets(facets));
        let [starts, corners, uvs, colors] =
            object.polygons.as_ref().map_or([NO_RECORD; 4], |polygons| self.polygons(polygons));
        let record = [
            object.material as u32,
            object.clusters.start as u32,
            object.clusters.len() as u32,
            object.first_facet,
            flags(object),
            facets,
            facet_count,
            facet_colors,
            starts,
            corners,
            uvs,
            colors,
        ];
        self.words(Section::Objects, &record);
        let [low, high] = object.bounds.map(short);
        self.floats(Section::ObjectPlaces, &[&place(object.anchor)[..], &low, &high].concat());
    }

    fn facets(&mut self, facets: &Facets) -> [u32; 3] {
        let both = facets.centroids.iter().zip(&facets.normals);
        let records: Vec<f32> = both.flat_map(|(centroid, normal)| [*centroid, *normal]).flatten().collect();
        let first = self.floats(Section::Facets, &records);
        [first, facets.centroids.len() as u32, self.attribute(Section::FacetColors, &facets.colors)]
    }

    fn polygons(&mut self, polygons: &Polygons) -> [u32; 4] {
        let both = polygons.positions.iter().zip(&polygons.normals);
        let records: Vec<f32> = both.flat_map(|(position, normal)| [*position, *normal]).flatten().collect();
        [
            self.words(Section::PolygonStarts, &polygons.starts),
            self.floats(Section::PolygonCorners, &records),
            self.attribute(Section::PolygonUvs, &polygons.uvs),
            self.attribute(Section::PolygonColors, &polygons.colors),
        ]
    }

    /// What a mesh may have or not.
    fn attribute<const N: usize>(&mut self, section: Section, values: &[[f32; N]]) -> u32 {
        if values.is_empty() { NO_RECORD } else { self.floats(section, values.as_flattened()) }
    }
}

fn flags(object: &PreparedObject) -> u32 {
    let attributes = object.attributes;
    object.shading as u32
        | (object.interpolation as u32) << 2
        | u32::from(object.closed) << 4
        | u32::from(attributes.uv) << 5
        | u32::from(attributes.color) << 6
        | u32::from(attributes.tangent) << 7
        | u32::from(attributes.uv2) << 8
}
