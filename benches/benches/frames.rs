//! Whole frames of the generated scenes, all threads, at 1 and 4 samples.

use criterion::{Criterion, criterion_group, criterion_main};
use trigon::pipeline::{Picture, Renderer, RendererOptions};
use trigon_bench::scene::{ModelFiles, SceneKind};
use trigon_bench::shot;

const SIZE: [u32; 2] = [1280, 720];

fn frames(criterion: &mut Criterion) {
    let options = RendererOptions::from_env().expect("TRIGON_SIMD names a level of this CPU");
    let mut renderer = Renderer::new(options).expect("the level is available");
    let mut picture = Picture::default();
    let mut group = criterion.benchmark_group("frames");
    group.sample_size(20);
    for kind in SceneKind::ALL.into_iter().filter(|kind| !kind.needs_model()) {
        let scene = kind.build(SIZE, &ModelFiles::default()).expect("generated scenes need no files");
        for samples in [1, 4] {
            let frame = shot::frame(SIZE, samples).expect("a standard pattern");
            group.bench_function(format!("{}/{samples}", kind.name()), |bencher| {
                bencher.iter(|| shot::draw(&mut renderer, &scene, &frame, 3, &mut picture));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, frames);
criterion_main!(benches);
