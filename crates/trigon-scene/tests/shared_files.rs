//! Every model file of the shared test data loads or fails with a clear error: no panic, hang or memory blow-up.
//! `cargo test -p trigon-scene --test shared_files -- --nocapture` prints the table of outcomes.

#[path = "../../../tests/shared_data.rs"]
mod shared_data;

use shared_data::shared_data;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trigon_scene::load::{LoadOptions, load_path};
use trigon_scene::scene::{Framing, Scene};

fn model_files(folder: &Path, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        let name = path.to_string_lossy().to_ascii_lowercase();
        if path.is_dir() {
            model_files(&path, found);
        } else if [".obj", ".stl", ".ply", ".ply.gz"].iter().any(|extension| name.ends_with(extension)) {
            found.push(path);
        }
    }
}

fn check_scene(scene: &Scene) {
    for mesh in &scene.meshes {
        mesh.validate().unwrap();
        assert!(mesh.submeshes.iter().all(|submesh| scene.material(submesh.material).is_some()));
        assert!(mesh.triangles.is_empty() || !mesh.normals.is_empty(), "a surface without normals");
        for normal in &mesh.normals {
            let length: f32 = normal.iter().map(|c| c * c).sum();
            assert!(length == 0.0 || (length - 1.0).abs() < 1e-3, "normal {normal:?}");
        }
    }
    for material in &scene.materials {
        material.clone().maps.for_each_mut(|map| assert!(scene.texture(map.texture).is_some()));
    }
    let camera = Framing::default().camera(scene);
    assert!(camera.clip_from_world(1.0).columns.iter().flatten().all(|m| m.is_finite()));
}

#[test]
fn every_shared_model_loads_or_fails_clearly() {
    let Some(data) = shared_data() else { return };
    let mut files = Vec::new();
    for folder in ["edge-cases", "meshes", "games101", "tinyrenderer", "scene-lighthouse", "scene-spider"] {
        model_files(&data.join(folder), &mut files);
    }
    assert!(files.len() > 100, "only {} models found", files.len());
    for path in &files {
        let start = Instant::now();
        let outcome = load_path(path, &LoadOptions::default());
        let time = start.elapsed();
        assert!(time < Duration::from_secs(5), "{} took {time:?}", path.display());
        let shown = path.strip_prefix(&data).unwrap().display();
        match outcome {
            Ok(loaded) => {
                check_scene(&loaded.scene);
                let mesh = &loaded.scene.meshes[0];
                println!(
                    "{shown}: {} vertices, {} triangles, {} segments, {} points, {} submeshes, {} textures, {time:.1?}",
                    mesh.positions.len(),
                    mesh.triangles.len(),
                    mesh.segments.len(),
                    mesh.points.len(),
                    mesh.submeshes.len(),
                    loaded.scene.textures.len(),
                );
                for warning in &loaded.warnings {
                    println!("    {}", warning.to_string().replace(&*data.to_string_lossy(), ""));
                }
            }
            Err(error) => {
                let message = error.to_string();
                println!("{shown}: ERROR {}", message.replace(&*data.to_string_lossy(), ""));
                assert!(message.contains(path.file_name().unwrap().to_str().unwrap()), "{message}");
            }
        }
    }
}

/// Files that are broken on purpose, and which of their faults must be found.
#[test]
fn known_faults_are_found() {
    let Some(data) = shared_data() else { return };
    let warnings = |file: &str| -> Vec<String> {
        let loaded = load_path(data.join(file), &LoadOptions::default()).unwrap();
        loaded.warnings.iter().map(|w| format!("{:?} {}", w.location.place, w.message)).collect()
    };
    let malformed = warnings("edge-cases/assimp/invalid/malformed.obj");
    assert_eq!(malformed.len(), 3, "{malformed:?}");
    assert!(malformed[0].starts_with("Line(22) material Default is not defined"));
    assert!(malformed[1].starts_with("Line(23) face left out") && malformed[2].starts_with("Line(28) face left out"));
    let crate_mtl = warnings("games101/models/Crate/Crate1.obj");
    assert!(crate_mtl.is_empty(), "{crate_mtl:?}");
}
