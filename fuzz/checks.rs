//! What must hold for any bytes given to a parser: it returns, and what it returns keeps its promises.
//!
//! Used by the fuzz targets here and by the test in `crates/trigon-scene/tests/fuzz_corpus.rs` that replays the corpus
//! on the stable toolchain.

use std::num::NonZeroUsize;
use std::sync::Arc;
use trigon_image::{Format, Limits, decode};
use trigon_scene::load::{self, LoadOptions, MemoryResolver, load_bytes};

/// An OBJ file: loads or fails, on one thread and on two alike; a mesh keeps its invariants.
pub(crate) fn obj(bytes: &[u8]) {
    let options = options();
    let mut two_threads = options.clone();
    two_threads.threads = NonZeroUsize::new(2);
    let one = load_bytes("a.obj", bytes, &options);
    let two = load_bytes("a.obj", bytes, &two_threads);
    match (one, two) {
        (Ok(mut one), Ok(two)) => {
            let mesh = &mut one.scene.meshes[0];
            mesh.validate().expect("a valid mesh");
            assert_eq!(mesh.positions.len(), two.scene.meshes[0].positions.len());
            assert_eq!(mesh.triangles, two.scene.meshes[0].triangles);
            assert_eq!(one.warnings, two.warnings);
            mesh.generate_tangents(|_| true);
            mesh.validate().expect("a valid mesh with tangents");
        }
        (Err(one), Err(two)) => assert_eq!(one.to_string(), two.to_string()),
        _ => panic!("one and two threads disagree"),
    }
}

/// An MTL file, used by a model: loads or fails; every map refers to a texture.
pub(crate) fn mtl(bytes: &[u8]) {
    let model = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b c\nf 1 2 3\nusemtl\nf 1 2 3\n";
    let mut options = options();
    options.resolver = Some(Arc::new(MemoryResolver::new().with("a.mtl", bytes).with("t.png", "not a picture")));
    if let Ok(mut loaded) = load_bytes("a.obj", model.as_bytes(), &options) {
        let n_textures = loaded.scene.textures.len();
        for material in &mut loaded.scene.materials {
            assert!((0.0..=1.0).contains(&material.opacity));
            material.maps.for_each_mut(|map| assert!((map.texture.0 as usize) < n_textures));
        }
    }
}

/// A TGA file: decodes or fails, within the limits.
pub(crate) fn tga(bytes: &[u8]) {
    let limits = Limits::default().with_max_side(4096).with_max_bytes(64 << 20);
    if let Ok(image) = decode(bytes, Some(Format::Tga), &limits) {
        assert!(image.width() <= 4096 && image.height() <= 4096);
    }
}

/// A JPEG file: decodes or fails, within the limits.
pub(crate) fn jpeg(bytes: &[u8]) {
    let limits = Limits::default().with_max_side(1024).with_max_bytes(4 << 20);
    if let Ok(image) = decode(bytes, Some(Format::Jpeg), &limits) {
        assert!(image.width() <= 1024 && image.height() <= 1024);
    }
}

fn options() -> LoadOptions {
    let mut options = LoadOptions::default();
    options.threads = NonZeroUsize::new(1);
    options.format = Some(load::Format::Obj);
    options.limits.file_bytes = 1 << 22;
    options.limits.triangles = 1 << 20;
    options
}
