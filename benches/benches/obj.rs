//! Reading OBJ: a generated file with positions, normals and texture coordinates, from memory.

use core::fmt::Write;
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use trigon_bench::scene::{ModelFiles, SceneKind};
use trigon_scene::load::{LoadOptions, load_bytes};

/// The hall as an OBJ file.
fn hall() -> String {
    let scene = SceneKind::Hall.build([64, 64], &ModelFiles::default()).expect("generated scenes need no files");
    let mut text = String::new();
    let mesh = &scene.mesh;
    // Writing to a string cannot fail.
    for ((p, n), t) in mesh.positions.iter().zip(&mesh.normals).zip(&mesh.uvs) {
        let _ = writeln!(text, "v {} {} {}\nvn {} {} {}\nvt {} {}", p[0], p[1], p[2], n[0], n[1], n[2], t[0], t[1]);
    }
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|vertex| vertex + 1);
        let _ = writeln!(text, "f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}");
    }
    text
}

fn read(criterion: &mut Criterion) {
    let text = hall();
    let mut group = criterion.benchmark_group("obj");
    group.sample_size(20).throughput(Throughput::Bytes(text.len() as u64));
    for (name, threads) in [("one thread", std::num::NonZeroUsize::new(1)), ("all threads", None)] {
        let mut options = LoadOptions::default();
        options.threads = threads;
        group.bench_function(name, |bencher| {
            bencher.iter(|| load_bytes("hall.obj", text.as_bytes(), &options).expect("a valid file"));
        });
    }
    group.finish();
}

criterion_group!(benches, read);
criterion_main!(benches);
