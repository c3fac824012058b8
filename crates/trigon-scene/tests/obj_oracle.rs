//! The OBJ reader against the `tobj` crate: on well-formed files both must give the same triangles.

#[path = "../../../tests/shared_data.rs"]
mod shared_data;

use shared_data::shared_data;
use std::collections::HashMap;
use std::path::Path;
use trigon_scene::load::{LoadOptions, load_bytes, load_path};
use trigon_scene::scene::{MaterialId, Mesh};

/// Position, texture coordinates (v up) and normal of a corner.
type Corner = [f32; 8];

/// 1 - (1 - v) may differ from v by rounding.
const TOLERANCE: f32 = 1e-5;

/// Positions to the last bit, the rest within [`TOLERANCE`].
fn agree(a: &Corner, b: &Corner) -> bool {
    let near = |i: usize| (a[i] - b[i]).abs() <= TOLERANCE;
    a[..3].iter().zip(&b[..3]).all(|(a, b)| a.to_bits() == b.to_bits()) && (3..8).all(near)
}

/// The triangles of each material, in order; corners that tobj gives no normal have none here either.
fn ours(mesh: &Mesh, keep_normals: bool, name: impl Fn(MaterialId) -> String) -> HashMap<String, Vec<Corner>> {
    let mut triangles: HashMap<String, Vec<Corner>> = HashMap::new();
    for submesh in &mesh.submeshes {
        let corners = mesh.triangles[submesh.triangles.clone()].as_flattened().iter().map(|&index| {
            let index = index as usize;
            let [x, y, z] = mesh.positions[index];
            let [u, v] = mesh.uvs.get(index).map_or([0.0; 2], |uv| [uv[0], 1.0 - uv[1]]);
            let [a, b, c] = if keep_normals { unit(&mesh.normals[index]) } else { [0.0; 3] };
            [x, y, z, u, v, a, b, c]
        });
        triangles.entry(name(submesh.material)).or_default().extend(corners);
    }
    triangles
}

/// Files may have normals of any length.
fn unit(normal: &[f32]) -> [f32; 3] {
    let length = normal.iter().map(|c| c * c).sum::<f32>().sqrt().max(1e-30);
    [normal[0] / length, normal[1] / length, normal[2] / length]
}

fn theirs(path: &Path) -> Result<(HashMap<String, Vec<Corner>>, bool), tobj::LoadError> {
    let options = tobj::LoadOptions { triangulate: true, single_index: true, ..tobj::LoadOptions::default() };
    let (models, materials) = tobj::load_obj(path, &options)?;
    let materials = materials.unwrap_or_default();
    let mut triangles: HashMap<String, Vec<Corner>> = HashMap::new();
    let has_normals = models.iter().all(|model| !model.mesh.normals.is_empty() || model.mesh.indices.is_empty());
    for model in &models {
        let mesh = &model.mesh;
        let name = mesh.material_id.and_then(|id| materials.get(id)).map_or(String::new(), |m| m.name.clone());
        let corners = mesh.indices.iter().map(|&index| {
            let index = index as usize;
            let position = &mesh.positions[3 * index..3 * index + 3];
            let uv = mesh.texcoords.get(2 * index..2 * index + 2).unwrap_or(&[0.0; 2]);
            let normal = if has_normals { &mesh.normals[3 * index..3 * index + 3] } else { &[0.0; 3] };
            let [x, y, z] = [position[0], position[1], position[2]];
            let [u, v] = [uv[0], uv[1]];
            let [a, b, c] = unit(normal);
            [x, y, z, u, v, a, b, c]
        });
        triangles.entry(name).or_default().extend(corners);
    }
    Ok((triangles, has_normals))
}

#[test]
fn well_formed_files_agree_with_tobj() {
    let Some(data) = shared_data() else { return };
    let files = [
        "meshes/teapot.obj",
        "meshes/stanford-bunny.obj",
        "meshes/trimesh/box.obj",
        "meshes/trimesh/ico4uv.obj",
        "meshes/trimesh/fuze.obj",
        "meshes/trimesh/groups.obj",
        "games101/models/spot/spot_triangulated_good.obj",
        "games101/models/rock/rock.obj",
        "games101/models/bunny/bunny.obj",
        "tinyrenderer/obj/african_head/african_head.obj",
        "tinyrenderer/obj/diablo3_pose/diablo3_pose.obj",
        "scene-lighthouse/lighthouse.obj",
        "edge-cases/tinyobjloader/cornell_box.obj",
        "edge-cases/tinyobjloader/cube.obj",
        "edge-cases/trimesh/negative_indices.obj",
    ];
    for file in files {
        let path = data.join(file);
        let (expected, has_normals) = theirs(&path).unwrap_or_else(|error| panic!("{file}: tobj: {error}"));
        let loaded = load_path(&path, &LoadOptions::default()).unwrap();
        let materials = &loaded.scene.materials;
        // tobj knows only the materials that a library defines.
        let name = |id: MaterialId| {
            let name = &materials[id.0 as usize].name;
            if expected.contains_key(name) { name.clone() } else { String::new() }
        };
        let got = ours(&loaded.scene.meshes[0], has_normals, name);
        assert_eq!(got.values().map(Vec::len).sum::<usize>(), expected.values().map(Vec::len).sum(), "{file}");
        for (material, expected) in &expected {
            let got = &got[material];
            let differing = got.iter().zip(expected).position(|(g, e)| !agree(g, e));
            assert!(got.len() == expected.len(), "{file}: material {material:?}");
            if let Some(i) = differing {
                panic!("{file}: material {material:?} corner {i}: {:?} {:?}", got[i], expected[i]);
            }
        }
    }
}

/// A file of several blocks with every kind of statement, indices of both signs, and faults.
fn long_file() -> String {
    use std::fmt::Write as _;
    let mut text = String::from("mtllib missing.mtl\n");
    for i in 0..60_000_u32 {
        let (x, y) = (i % 300, i / 300);
        let _ = writeln!(text, "v {x} {y} {}.{:03}", i % 7, i % 1000);
        let _ = writeln!(text, "vt 0.{:04} {}e-4", x, y * 7);
        if i % 3 == 0 {
            let _ = writeln!(text, "vn 0 {} 1", i % 2);
        }
        if i % 500 == 400 {
            let _ = writeln!(text, "o object {}\ng a b{}\ns {}", i / 2000, i / 1000, i % 3);
            let _ = writeln!(text, "usemtl m{} # {}", i % 11, "x".repeat(40));
        }
        if i > 400 && x > 2 {
            let _ = match i % 5 {
                0 => writeln!(text, "f -1/-1 -2/-2 -301/-301"),
                1 => writeln!(text, "f {}/{}/1 {}/{}/2 {}/{}/3", i, i, i - 1, i - 1, i - 300, i - 300),
                2 => writeln!(text, "f {} {} \\\n {} {}", i, i - 1, i - 301, i - 300),
                3 => writeln!(text, "l {} {} {}\np -1 {}", i, i - 1, i - 2, i),
                _ => writeln!(text, "f 0 1 2\nf {} 1 2\nf x", i + 1_000_000),
            };
        }
    }
    text
}

#[test]
fn the_result_does_not_depend_on_the_number_of_threads() {
    let text = long_file();
    assert!(text.len() > 3 << 20, "several blocks, not {} bytes", text.len());
    let mut options = LoadOptions::default();
    options.threads = std::num::NonZeroUsize::new(1);
    let one = load_bytes("long.obj", text.as_bytes(), &options).unwrap();
    one.scene.meshes[0].validate().unwrap();
    for threads in [2, 3, 16] {
        options.threads = std::num::NonZeroUsize::new(threads);
        let many = load_bytes("long.obj", text.as_bytes(), &options).unwrap();
        assert!(many.scene.meshes == one.scene.meshes, "{threads} threads");
        assert_eq!(many.warnings, one.warnings);
        assert_eq!(many.scene.materials, one.scene.materials);
    }
}
