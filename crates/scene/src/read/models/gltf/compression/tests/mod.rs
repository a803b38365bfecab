//! A sheet of triangles, compressed in every way.

mod draco;
mod meshopt;

use glam::{Vec2, Vec3, Vec4};

use super::super::tests::glb;
use crate::read::Model;
use crate::read::tests::check;

/// Cells along each side of the sheet.
const CELLS: u32 = 12;
const VERTICES: usize = ((CELLS + 1) * (CELLS + 1)) as usize;

/// A curved square whose vertices are known by their place.
struct Sheet {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    colors: Vec<[u8; 4]>,
    triangles: Vec<[u32; 3]>,
}

fn sheet() -> Sheet {
    let places = (0..VERTICES as u32).map(|vertex| [vertex % (CELLS + 1), vertex / (CELLS + 1)]);
    let places: Vec<[f32; 2]> =
        places.map(|place| place.map(|number| number as f32 / CELLS as f32)).collect();
    let normal = |&[x, _]: &[f32; 2]| Vec3::new(-(6.0 * x).cos(), 0.0, 1.0).normalize().to_array();
    let corner = |i: u32, j: u32| j * (CELLS + 1) + i;
    let cells = (0..CELLS * CELLS).map(|cell| (cell % CELLS, cell / CELLS));
    Sheet {
        positions: places.iter().map(|&[x, y]| [x, y, (6.0 * x).sin() / 6.0]).collect(),
        normals: places.iter().map(normal).collect(),
        uvs: places.iter().map(|&[x, y]| [1.0 - x, y]).collect(),
        colors: places.iter().map(|&[x, y]| [(255.0 * x) as u8, (255.0 * y) as u8, 64, 255]).collect(),
        triangles: cells
            .flat_map(|(i, j)| {
                let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
                [[a, b, c], [a, c, d]]
            })
            .collect(),
    }
}

/// That a model is the sheet, its vertices in any order, moved by `offset`.
fn check_sheet(model: &Model, offset: Vec3, tolerance: f32) {
    check(model);
    let (sheet, mesh) = (sheet(), &model.meshes[0]);
    let place = |position: &Vec3| {
        let [x, y, _] = (*position - offset).to_array().map(|number| (number * CELLS as f32).round() as u32);
        y * (CELLS + 1) + x
    };
    let names: Vec<u32> = mesh.positions.iter().map(place).collect();
    for (vertex, name) in names.iter().map(|name| *name as usize).enumerate() {
        let position = Vec3::from(sheet.positions[name]) + offset;
        assert!(mesh.positions[vertex].distance(position) < tolerance, "{position}");
        assert!(mesh.normals[vertex].distance(Vec3::from(sheet.normals[name])) < 0.02, "{position}");
        assert!(mesh.uvs[vertex].distance(Vec2::from(sheet.uvs[name])) < tolerance, "{position}");
        let color = Vec4::from(sheet.colors[name].map(|channel| f32::from(channel) / 255.0));
        assert!(mesh.colors[vertex].distance(color) < 0.01, "{position} {color} {}", mesh.colors[vertex]);
    }
    let sorted = |triangles: &mut Vec<[u32; 3]>| {
        for triangle in triangles.iter_mut() {
            let least = (0..3).min_by_key(|corner| triangle[*corner]).unwrap();
            triangle.rotate_left(least);
        }
        triangles.sort_unstable();
    };
    let of_names = |corners: &[u32]| [0, 1, 2].map(|corner| names[corners[corner] as usize]);
    let mut found: Vec<[u32; 3]> = mesh.corners.chunks_exact(3).map(of_names).collect();
    let mut expected = sheet.triangles;
    sorted(&mut found);
    sorted(&mut expected);
    assert_eq!(found, expected);
}

fn bytes_of<const N: usize>(values: &[[f32; N]]) -> Vec<u8> {
    values.iter().flatten().flat_map(|value| value.to_le_bytes()).collect()
}

/// A file compressed by Draco, and one by meshopt.
pub(crate) fn compressed_samples() -> [Vec<u8>; 2] {
    let (document, binary) = meshopt::file("EXT_meshopt_compression", 0, "TRIANGLES");
    [draco::file(&[]), glb(&document, &binary)]
}
