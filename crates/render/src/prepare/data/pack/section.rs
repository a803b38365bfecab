//! The sections of the pools.

/// One of the two pools.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pool {
    /// That of `u32`.
    Words,
    /// That of `f32`.
    Floats,
}

macro_rules! sections {
    ($($name:ident: $pool:ident $stride:literal, $fields:literal;)+) => {
        /// The sections, and the fields of their records in order. A name with a number in brackets is so many
        /// numbers.
        ///
        /// | section | pool | numbers | fields |
        /// |---|---|---|---|
        $(#[doc = concat!(
            "| [`", stringify!($name), "`](Section::", stringify!($name), ") | ", stringify!($pool), " | ",
            stringify!($stride), " | ", $fields, " |"
        )])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Section {
            $(
                #[doc = concat!($fields, ".")]
                $name,
            )+
        }

        impl Section {
            /// All sections, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$name),+];

            /// The pool that it is in.
            pub const fn pool(self) -> Pool {
                match self {
                    $(Self::$name => Pool::$pool,)+
                }
            }

            /// How many numbers a record has.
            pub const fn stride(self) -> usize {
                match self {
                    $(Self::$name => $stride,)+
                }
            }
        }
    };
}

sections! {
    Clusters: Words 5, "object, first vertex, vertices, first triangle, triangles";
    ClusterBounds: Floats 8, "centre(3), radius, axis of the cone of normals(3), sine of its half angle";
    Positions: Floats 3, "of each vertex, relative to its object's anchor";
    Normals: Floats 3, "of each vertex, in the world, not normalised";
    Uvs: Floats 2, "texture coordinates of each vertex; no records if no object has them";
    Uvs2: Floats 2, "texture coordinates of the second set; no records if no object has them";
    Colors: Floats 4, "of each vertex; no records if no object has them";
    Tangents: Floats 4, "of each vertex; no records if no object has them";
    Sources: Words 1, "of each vertex: the vertex of its object's mesh";
    Triangles: Words 2, "corners as vertices within the cluster in bits 0–7, 8–15, 16–23 and edges in bits 24–26, facet";
    Objects: Words 12, "material, first cluster, clusters, first facet among all, flags (bits 0–1 shading, 2–3 \
        interpolation, 4 closed, 5 texture coordinates, 6 colours, 7 tangents, 8 a second set of texture coordinates), first of Facets, facets there, first of \
        FacetColors, first of PolygonStarts, first of PolygonCorners, first of PolygonUvs, first of PolygonColors";
    ObjectPlaces: Floats 12, "of each object: anchor as pairs(6), least corner relative to it(3), greatest(3)";
    Facets: Floats 6, "centroid relative to the anchor(3), normal(3)";
    FacetColors: Floats 4, "at the centroid";
    PolygonStarts: Words 1, "first corner of each facet among those of its object, and a last record for the end";
    PolygonCorners: Floats 6, "position relative to the anchor(3), normal(3)";
    PolygonUvs: Floats 2, "texture coordinates of each corner";
    PolygonColors: Floats 4, "of each corner";
    Materials: Words 19, "first lobe, lobes, first of Tints (entry light · lobes + lobe), first of Series with the same \
        entries, first of SpotAmbient, first of Integrals, first of MixTints, first of MixSpotAmbient, of MixValues, of \
        Series for the transmittance, TextureUses of base colour, normals, emission, metalness and roughness, flags (bit \
        0 two-sided, 1 back faces are not drawn, 2 anisotropic, 3 transmits), alpha mode, first of Channels, channels, Mask of occlusion";
    MaterialValues: Floats 17, "of each material: ambient that textures multiply(3), the rest(3), emission(3), sine and \
        cosine of the tangent's angle, opacity, cutoff of masks, means of the picture of metal and roughness(2: roughness, \
        metal), which part the ambient terms belong to (0 any, 1 metal, 2 dielectric) and the factor of that";
    TextureUses: Words 2, "texture, set of texture coordinates (0 or 1)";
    TextureUseValues: Floats 7, "of each use: rows of the map of coordinates(6), scale";
    Channels: Words 2, "TextureUse, channel of it (0 red, 1 green, 2 blue, 3 alpha)";
    ChannelMeans: Floats 1, "of each channel";
    Masks: Words 1, "channel's number among those of the material";
    MaskValues: Floats 2, "of each mask: the factor where the channel is 0, and where it is 1";
    Lobes: Words 12, "model's stable number (Shape::id), first of Params, parameters, light term, whether textured, \
        coordinate of the tint (0 none, 1 half angle, 2 path in a coat), metalness (0 any, 1 metal, 2 dielectric), first \
        of Layers, layers, first of Masks, masks, roughness (0 as the material's picture says, 1 uniform, 2 and more: that less 2 \
        is the number of a channel of the material)";
    LobeValues: Floats 2, "of each lobe: the coat's index of refraction, the factor of its metalness; 0 where there is none";
    Params: Floats 1, "a parameter of a model, in the order of its list";
    Layers: Words 3, "kind (0 constant, 1 Schlick, 2 series, 3 coat, 4 sheen, 5 coat over a boundary, 6 table), angle or rank, ScalarSeries: of a \
        series the factor, of a coat its transmittance, of a sheen its albedo over (√cosθ − √0.002) / (1 − √0.002); of a table its \
        number in FactorTables";
    FactorTables: Words 6, "nodes along x, y, z and around the normal, ranks, first of Factors";
    Factors: Floats 1, "the ranks of each node, along x fastest";
    LayerValues: Floats 2, "of each layer: the constant, the values at 0 and grazing, the gain or the strength";
    Tints: Floats 3, "channels";
    Series: Words 2, "first of Terms, terms; 0 terms for 0 everywhere";
    Terms: Floats 3, "channels of a Chebyshev coefficient over 2x − 1, from degree 0";
    ScalarSeries: Words 2, "first of ScalarTerms, terms";
    ScalarTerms: Floats 1, "a Chebyshev coefficient over 2x − 1, from degree 0";
    SpotAmbient: Floats 6, "of each light of the table: ambient that textures multiply(3), the rest(3)";
    MixTints: Floats 9, "of each entry: channels through each of three spectra(3 · 3)";
    MixSpotAmbient: Floats 9, "of each light of the table: channels through each of three spectra(3 · 3)";
    MixValues: Floats 18, "ambient through each of three spectra(3 · 3), emission likewise(3 · 3)";
    Integrals: Words 5, "of each lobe: first of ScalarSeries of albedo, waves after it (0 or 2), area (0 cosine, 1 LTC, 2 points, 3 mirror), one of \
        LtcTables, one of LookupTables";
    LtcTables: Words 4, "components of a view, azimuths, the last azimuth in quarters of a turn, first of LtcComponents";
    LtcComponents: Floats 10, "by azimuth, view and number: the rows of the inverse map, fraction of the lobe";
    LookupTables: Words 6, "lookups of a view, azimuths, the last azimuth in quarters of a turn, 1 where levels of whole \
        octaves are mixed, first of Lookups, first of LookupCosines";
    Lookups: Floats 5, "by azimuth, view and number: direction, place among the levels in half octaves, fraction of the \
        lobe";
    LookupCosines: Floats 1, "by azimuth and view: the fraction of the lobe that is a cosine";
    Lights: Words 6, "kind (0 directional, 1 point, 2 spot, 3 area, 4 environment), flags (bit 0 in the camera's space, 1 \
        fades, 2 smooth edge, 3 two-sided), area (0 rectangle, 1 disk, 2 sphere), its first light of the tint table, one \
        of Luminaires, one of Environments";
    LightValues: Floats 27, "of each light: position as pairs(6), direction towards a directional light or a spot's axis(3), \
        an area's axes(3 · 3), factors of fading(3), a spot's cosine of cut-off, exponent, inner and outer cosine, an area's \
        width and height or radius(2)";
    Luminaires: Words 1, "first of Intensities";
    LuminaireFrames: Floats 9, "of each luminaire: directions of C 0°, C 90° and γ 0°(3 · 3)";
    Intensities: Floats 1, "fraction of the greatest intensity; 361 planes C of 181 angles γ";
    Environments: Words 2, "one of Maps, none for 1 everywhere; first of ChainLevels";
    EnvironmentValues: Floats 102, "of each environment: irradiance polynomial(31 · 3), columns of the rotation(3 · 3)";
    EnvironmentTint: Floats 9, "of the first environment, seen directly: channels of each of three spectra(3 · 3)";
    Maps: Words 3, "width, height, first of Pixels";
    Pixels: Floats 3, "of an environment map, by rows from the top";
    ChainLevels: Words 3, "of each level of a chain: width, height, first of ChainPixels";
    ChainPixels: Floats 4, "by rows from the top, one pixel more at both ends of each, and a row more at the bottom";
    Textures: Words 5, "first of Levels, levels, wrap along u, along v, filter";
    Decode: Floats 256, "of each texture: the linear value of each code of red, green and blue";
    Levels: Words 3, "width, height, first of Texels; the finest first";
    Texels: Words 1, "codes of red, green, blue and alpha, red in the lowest bits";
    BvhNodes: Words 2, "first triangle of a leaf or first of two children, triangles (0 for inner nodes)";
    BvhBoxes: Floats 6, "of each node: least corner(3), greatest corner(3)";
    BvhTriangles: Floats 9, "corner(3), edges from it(2 · 3)";
    BvhPlace: Floats 7, "point that it is relative to as pairs(6), diagonal; no record without shadows";
}
