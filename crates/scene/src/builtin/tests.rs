//! What holds for all built-in meshes, and for each.

use core::f64::consts::{PI, TAU};
use std::collections::HashMap;

use glam::DVec3;

use super::{Builtin, BuiltinError, MAX_TRIANGLES};
use crate::{Mesh, mesh::topology::Welded};

fn all() -> impl Iterator<Item = Builtin> {
    Builtin::NAMES.into_iter().map(|name| Builtin::named(name).expect("the name is in the list"))
}

fn make(builtin: Builtin) -> Mesh {
    builtin.mesh().expect("the parameters are in range")
}

fn closed() -> Vec<Builtin> {
    vec![
        Builtin::Cube { size: 3.0 },
        Builtin::Sphere { radius: 0.7, slices: 3, stacks: 2 },
        Builtin::Sphere { radius: 2.5, slices: 17, stacks: 9 },
        Builtin::Icosphere { radius: 1.5, subdivisions: 0 },
        Builtin::Icosphere { radius: 1.5, subdivisions: 3 },
        Builtin::Torus { major: 1.0, minor: 0.3, segments: 13, sides: 7 },
        Builtin::Cylinder { radius: 0.6, height: 3.0, slices: 11, capped: true },
        Builtin::Cone { radius: 0.6, height: 3.0, slices: 11, capped: true },
    ]
}

/// Triangles whose corners are points rather than vertices.
fn welded_triangles(mesh: &Mesh) -> (Vec<[u32; 3]>, usize) {
    let welded = Welded::of(&mesh.positions);
    let triangles = mesh.triangles().map(|t| t.map(|v| welded.point_of[v as usize])).collect();
    (triangles, welded.first.len())
}

/// How often each directed edge is run along, after welding.
fn directed_edges(mesh: &Mesh) -> HashMap<[u32; 2], usize> {
    let mut edges = HashMap::new();
    for [a, b, c] in welded_triangles(mesh).0 {
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_insert(0) += 1;
        }
    }
    edges
}

fn volume(mesh: &Mesh) -> f64 {
    let at = |i: u32| mesh.positions[i as usize].as_dvec3();
    mesh.triangles().map(|[a, b, c]| at(a).dot(at(b).cross(at(c))) / 6.0).sum()
}

fn area(mesh: &Mesh) -> f64 {
    let at = |i: u32| mesh.positions[i as usize].as_dvec3();
    mesh.triangles().map(|[a, b, c]| (at(b) - at(a)).cross(at(c) - at(a)).length() / 2.0).sum()
}

/// Checks each vertex normal against the gradient of the function whose zero is the surface.
fn normals_agree(mesh: &Mesh, gradient: impl Fn(DVec3) -> DVec3) {
    for (position, normal) in mesh.positions.iter().zip(&mesh.normals) {
        let expected = gradient(position.as_dvec3()).normalize();
        // f32 coordinates are right to 6e-8 of their size; the gradients here are tame.
        let error = (normal.as_dvec3() - expected).length();
        assert!(error < 1e-6, "{}: {normal} at {position}, expected {expected}", mesh.name);
    }
}

#[test]
fn every_mesh_is_valid_and_has_unit_normals() {
    for builtin in all().chain(closed()) {
        let mesh = make(builtin);
        assert_eq!(mesh.validate(), Ok(()), "{builtin:?}");
        assert_eq!(mesh.normals.len(), mesh.positions.len(), "{builtin:?}");
        assert_eq!(mesh.triangle_count() as u64, builtin.triangle_count(), "{builtin:?}");
        assert_eq!(mesh.name, builtin.name());
        for normal in &mesh.normals {
            // Rounded to f32 component by component: half a unit in the last place each.
            assert!((normal.as_dvec3().length() - 1.0).abs() < 1.1e-7, "{builtin:?}: {normal}");
        }
    }
}

#[test]
fn closed_meshes_run_along_each_edge_once_in_each_direction() {
    for builtin in closed() {
        let edges = directed_edges(&make(builtin));
        for (&[a, b], &count) in &edges {
            assert_eq!((count, edges.get(&[b, a])), (1, Some(&1)), "{builtin:?}: edge {a} {b}");
        }
    }
}

#[test]
fn closed_meshes_have_the_euler_number_of_their_shape() {
    for builtin in closed() {
        let mesh = make(builtin);
        let (triangles, points) = welded_triangles(&mesh);
        let edges = directed_edges(&mesh).len() / 2;
        let euler = points as i64 - edges as i64 + triangles.len() as i64;
        let expected = if matches!(builtin, Builtin::Torus { .. }) { 0 } else { 2 };
        assert_eq!(euler, expected, "{builtin:?}");
    }
}

#[test]
fn facets_face_the_way_their_normals_do() {
    for builtin in all().chain(closed()) {
        let mesh = make(builtin);
        for (number, face) in mesh.faces().enumerate() {
            let facet = mesh.face_normal(number);
            assert!(facet != DVec3::ZERO, "{builtin:?}: face {number} has no area");
            for &corner in face {
                let cos = facet.dot(mesh.normals[corner as usize].as_dvec3());
                assert!(cos > 0.0, "{builtin:?}: face {number} looks away from its normal: {cos}");
            }
        }
    }
}

#[test]
fn volume_and_area_are_those_of_the_exact_shapes_but_for_the_facets() {
    let slant = (0.7_f64 * 0.7 + 4.0).sqrt();
    let cases = [
        (Builtin::Sphere { radius: 1.3, slices: 256, stacks: 128 }, 4.0 / 3.0 * PI * 2.197, 4.0 * PI * 1.69),
        (Builtin::Icosphere { radius: 1.3, subdivisions: 6 }, 4.0 / 3.0 * PI * 2.197, 4.0 * PI * 1.69),
        (
            Builtin::Torus { major: 1.0, minor: 0.25, segments: 256, sides: 128 },
            TAU * PI * 0.0625,
            TAU * TAU * 0.25,
        ),
        (
            Builtin::Cylinder { radius: 0.7, height: 2.0, slices: 256, capped: true },
            PI * 0.49 * 2.0,
            TAU * 0.7 * 2.0 + TAU * 0.49,
        ),
        (
            Builtin::Cone { radius: 0.7, height: 2.0, slices: 256, capped: true },
            PI * 0.49 * 2.0 / 3.0,
            PI * 0.7 * slant + PI * 0.49,
        ),
    ];
    for (builtin, exact_volume, exact_area) in cases {
        let mesh = make(builtin);
        // A polygon of n sides has (2π/n)²/6 = 1e-4 (n = 256) less area than its circle; the
        // coarsest direction here is the tube of 128 sides with 4e-4.
        let (volume, area) = (volume(&mesh) / exact_volume, area(&mesh) / exact_area);
        assert!(volume < 1.0 && volume > 1.0 - 1e-3, "{builtin:?}: volume {volume}");
        assert!(area < 1.0 && area > 1.0 - 1e-3, "{builtin:?}: area {area}");
    }
    let cube = make(Builtin::Cube { size: 3.0 });
    assert_eq!((volume(&cube), area(&cube)), (27.0, 54.0));
}

#[test]
fn sphere_normals_are_radii() {
    normals_agree(&make(Builtin::Sphere { radius: 0.7, slices: 33, stacks: 20 }), |p| p);
    normals_agree(&make(Builtin::Icosphere { radius: 0.7, subdivisions: 4 }), |p| p);
}

#[test]
fn torus_normals_point_away_from_the_circle_in_the_tube() {
    let torus = make(Builtin::Torus { major: 1.0, minor: 0.3, segments: 40, sides: 20 });
    normals_agree(&torus, |p| p - (p * DVec3::new(1.0, 0.0, 1.0)).normalize());
}

#[test]
fn cylinder_and_cone_sides_have_the_normals_of_their_equations() {
    let horizontal = |p: DVec3| DVec3::new(p.x, 0.0, p.z);
    let cylinder = Builtin::Cylinder { radius: 0.7, height: 1.5, slices: 19, capped: false };
    normals_agree(&make(cylinder), horizontal);
    // The cone is |horizontal| = radius (h/2 - y) / h.
    let cone = make(Builtin::Cone { radius: 0.5, height: 2.0, slices: 18, capped: false });
    let base =
        Mesh { positions: cone.positions[18..].to_vec(), normals: cone.normals[18..].to_vec(), ..cone };
    normals_agree(&base, |p| horizontal(p).normalize() + DVec3::Y * 0.25);
}

#[test]
fn caps_are_sharp_and_flat() {
    let cylinder = make(Builtin::Cylinder { radius: 0.7, height: 2.0, slices: 9, capped: true });
    for (position, normal) in cylinder.positions[20..].iter().zip(&cylinder.normals[20..]) {
        assert_eq!(*normal, glam::Vec3::Y * position.y);
    }
    assert_eq!(cylinder.positions.len(), 20 + 2 * 10);
}

#[test]
fn the_front_of_a_sphere_shows_the_middle_of_its_texture() {
    let sphere = make(Builtin::Sphere { radius: 1.0, slices: 8, stacks: 4 });
    let uv_at = |x: f32, y: f32, z: f32| {
        let vertex = sphere.positions.iter().position(|p| p.distance(glam::Vec3::new(x, y, z)) < 1e-6);
        sphere.uvs[vertex.expect("there is a vertex")].to_array()
    };
    assert_eq!(uv_at(0.0, 0.0, 1.0), [0.5, 0.5]);
    assert_eq!(uv_at(1.0, 0.0, 0.0), [0.75, 0.5]);
    assert_eq!(uv_at(0.0, 1.0, 0.0)[1], 0.0);
}

#[test]
fn texture_coordinates_run_rightwards_and_downwards_seen_from_outside() {
    // Then the texture is not mirrored: the determinant of position by (u, -v) has the sign of the facet.
    for builtin in all().filter(|b| !matches!(b, Builtin::Icosphere { .. })) {
        let mesh = make(builtin);
        let [at, uv] = [
            |mesh: &Mesh, i: u32| mesh.positions[i as usize].as_dvec3(),
            |mesh: &Mesh, i: u32| mesh.uvs[i as usize].as_dvec2().extend(0.0),
        ];
        for [a, b, c] in mesh.triangles() {
            let facet = (at(&mesh, b) - at(&mesh, a)).cross(at(&mesh, c) - at(&mesh, a));
            let texture = (uv(&mesh, b) - uv(&mesh, a)).cross(uv(&mesh, c) - uv(&mesh, a));
            assert!(facet.length() > 0.0 && texture.z < 0.0, "{builtin:?}: {a} {b} {c}");
        }
    }
}

#[test]
fn the_kite_is_folded_along_ab_and_coloured_by_point() {
    let kite = make(Builtin::Kite);
    let normals = [kite.face_normal(0), kite.face_normal(1)];
    assert!(normals[0].z > 0.0 && normals[1].z > 0.0 && normals[0].dot(normals[1]) < 0.9);
    let points: Vec<_> = kite.corners.iter().map(|&c| kite.positions[c as usize]).collect();
    let colors: Vec<_> = kite.corners.iter().map(|&c| kite.colors[c as usize]).collect();
    // ACB and ABD.
    assert_eq!((points[0], points[2]), (points[3], points[4]));
    assert_eq!((colors[0], colors[2]), (colors[3], colors[4]));
    assert!(points[1].x < 0.0 && points[5].x > 0.0);
}

#[test]
fn the_quad_and_the_plane_face_as_promised() {
    let quad = make(Builtin::Quad);
    assert!(quad.positions.iter().all(|p| p.x.abs() == 1.0 && p.y.abs() == 1.0 && p.z == 0.0));
    assert_eq!((quad.face_count(), quad.face(0).len(), quad.normals[0]), (1, 4, glam::Vec3::Z));
    let plane = make(Builtin::Plane);
    assert!(plane.positions.iter().all(|p| p.x.abs() == 1.0 && p.z.abs() == 1.0 && p.y == 0.0));
    assert_eq!((plane.face(0).len(), plane.normals[0]), (4, glam::Vec3::Y));
}

#[test]
fn the_teapot_is_open_only_where_newell_left_it_open() {
    for tessellation in [2, 4, 9] {
        let mesh = make(Builtin::Teapot { tessellation });
        let edges = directed_edges(&mesh);
        let borders = edges.keys().filter(|&&[a, b]| !edges.contains_key(&[b, a])).count();
        // Four patch sides at the rim's inner and the lid's outer circle, two at each end of the
        // handle, two where the spout leaves the body and two at its mouth.
        assert_eq!(borders as u32, (4 + 4 + 2 * 2 + 2 * 2) * tessellation);
        assert!(edges.values().all(|&count| count == 1));
    }
}

#[test]
fn teapot_normals_are_those_of_a_finer_teapot_s_facets() {
    let [coarse, fine] = [4, 64].map(|tessellation| make(Builtin::Teapot { tessellation }));
    for patch in 0..32 {
        for (row, column) in (0..4).flat_map(|row| (0..4).map(move |column| (row, column))) {
            let normal = coarse.normals[patch * 25 + row * 5 + column].as_dvec3();
            let facet = fine.face_normal(patch * 4096 + row * 16 * 64 + column * 16);
            // A facet is 1/64 of a patch; the tightest bends (rim, knob) turn by a few degrees in it.
            assert!(normal.dot(facet) > 0.99, "patch {patch}, {row} {column}: {normal} {facet}");
        }
    }
}

#[test]
fn the_teapot_stands_upright_around_the_axis() {
    let bounds = make(Builtin::Teapot { tessellation: 10 }).bounds();
    assert!((bounds.max.y - 0.7875).abs() < 1e-6 && (bounds.min.y + 0.7875).abs() < 1e-6, "{bounds:?}");
    assert!((bounds.max.z - 1.0).abs() < 2e-3 && (bounds.min.z + 1.0).abs() < 2e-3, "{bounds:?}");
    assert!(bounds.max.x > 1.6 && bounds.min.x < -1.4, "{bounds:?}");
}

#[test]
fn parameters_out_of_range_are_refused_with_their_name() {
    let message = |builtin: Builtin| builtin.mesh().expect_err("out of range").to_string();
    assert_eq!(
        message(Builtin::Sphere { radius: 1.0, slices: 2, stacks: 8 }),
        "sphere: slices must be at least 3, but is 2"
    );
    assert_eq!(
        message(Builtin::Cone { radius: 1.0, height: f64::NAN, slices: 9, capped: true }),
        "cone: height must be between 1e-15 and 1e15, but is NaN"
    );
    assert_eq!(
        message(Builtin::Torus { major: 1.0, minor: 1.0, segments: 9, sides: 9 }),
        "torus: minor must be less than major (1), but is 1"
    );
    assert_eq!(
        message(Builtin::Icosphere { radius: 1.0, subdivisions: 13 }),
        "icosphere: at most 500000000 triangles are made, but 1342177280 are asked for"
    );
    assert_eq!(
        message(Builtin::Icosphere { radius: 1.0, subdivisions: 4_000_000_000 }),
        "icosphere: at most 500000000 triangles are made, but more than can be counted are asked for"
    );
    for length in [0.0, -1.0, f64::INFINITY, 1e-16, 1e16] {
        assert!(matches!(Builtin::Cube { size: length }.mesh(), Err(BuiltinError::Length { .. })));
    }
}

#[test]
fn absurd_counts_are_refused_without_making_anything() {
    let most = u32::MAX;
    let absurd = [
        Builtin::Sphere { radius: 1.0, slices: most, stacks: most },
        Builtin::Torus { major: 1.0, minor: 0.5, segments: most, sides: most },
        Builtin::Icosphere { radius: 1.0, subdivisions: most },
        Builtin::Cylinder { radius: 1.0, height: 1.0, slices: most, capped: true },
        Builtin::Cone { radius: 1.0, height: 1.0, slices: most, capped: false },
        Builtin::Teapot { tessellation: most },
    ];
    for builtin in absurd {
        assert!(builtin.triangle_count() > MAX_TRIANGLES);
        assert!(matches!(builtin.mesh(), Err(BuiltinError::TooLarge { .. })), "{builtin:?}");
    }
}

#[test]
fn names_and_serialised_forms_agree() {
    for builtin in all() {
        let text = serde_json::to_value(builtin).expect("plain data");
        let name = text.as_str().map_or_else(
            || text.as_object().and_then(|o| o.keys().next().cloned()).expect("one key"),
            str::to_owned,
        );
        assert_eq!(name, builtin.name());
        assert_eq!(serde_json::from_value::<Builtin>(text).expect("it is its own form"), builtin);
    }
    assert_eq!(Builtin::named("teapots"), None);
}

#[test]
fn fields_left_out_take_their_defaults_and_unknown_ones_are_refused() {
    for builtin in all().filter(|b| serde_json::to_value(b).is_ok_and(|v| v.is_object())) {
        let empty = serde_json::json!({ builtin.name(): {} });
        assert_eq!(serde_json::from_value::<Builtin>(empty).expect("all have defaults"), builtin);
        let unknown = serde_json::json!({ builtin.name(): { "slcies": 3 } });
        assert!(serde_json::from_value::<Builtin>(unknown).is_err());
    }
}
