//! The stages of the pipeline, one thread: geometry, rasterization without shading, shading, resolve and store.
//!
//! Stages are measured inside whole frames, by the times that the frame's statistics report, on pictures that leave the
//! other stages little to do. Throughput is in triangles or pixels.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use trigon::lanes::SimdLevel;
use trigon::pipeline::{Frame, FrameStatistics, Outputs, Picture, Renderer, RendererOptions};
use trigon::schedule::TileOrder;
use trigon_bench::scene::{BenchScene, ModelFiles, SceneKind};
use trigon_bench::shot;

const SIZE: [u32; 2] = [1280, 720];

/// Orbit frame that is drawn.
const NUMBER: u32 = 3;

fn renderer() -> Renderer {
    let options = RendererOptions { threads: 1, simd: SimdLevel::detect(), tile_order: TileOrder::default() };
    Renderer::new(options).expect("the detected level is available")
}

fn scene(kind: SceneKind) -> BenchScene {
    kind.build(SIZE, &ModelFiles::default()).expect("generated scenes need no files")
}

/// One frame of `scene` again and again; `time` says which part of it counts.
fn stage(
    criterion: &mut Criterion,
    name: &str,
    throughput: Throughput,
    scene: &BenchScene,
    frame: &Frame,
    time: impl Fn(&FrameStatistics) -> Duration,
) {
    let (mut renderer, mut picture) = (renderer(), Picture::default());
    let mut group = criterion.benchmark_group("stages");
    group.sample_size(20).throughput(throughput);
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|count| {
            let draw = |_| shot::draw(&mut renderer, scene, frame, NUMBER, &mut picture);
            (0..count).map(draw).map(|drawn| time(&drawn.expect("the frame is not too large"))).sum()
        });
    });
    group.finish();
}

fn frame(samples: u32, outputs: Outputs) -> Frame {
    Frame { outputs, ..shot::frame(SIZE, samples).expect("a standard pattern") }
}

fn pixels() -> Throughput {
    Throughput::Elements(u64::from(SIZE[0]) * u64::from(SIZE[1]))
}

fn geometry(criterion: &mut Criterion) {
    for kind in [SceneKind::Big, SceneKind::Small, SceneKind::Hall] {
        let scene = scene(kind);
        let triangles = Throughput::Elements(scene.mesh.triangles.len() as u64);
        for samples in [1, 4] {
            let name = format!("geometry/{}/{samples}", kind.name());
            let frame = frame(samples, Outputs::DEPTH);
            stage(criterion, &name, triangles.clone(), &scene, &frame, |statistics| statistics.geometry_time);
        }
    }
}

/// Visibility without colour: large triangles in both orders, and micro-triangles.
fn raster(criterion: &mut Criterion) {
    for kind in [SceneKind::FillFrontToBack, SceneKind::FillBackToFront, SceneKind::Small] {
        let scene = scene(kind);
        for samples in [1, 4] {
            let name = format!("raster/{}/{samples}", kind.name());
            let frame = frame(samples, Outputs::DEPTH);
            stage(criterion, &name, pixels(), &scene, &frame, |statistics| statistics.tile_time);
        }
    }
}

/// The same shader where one triangle fills whole lane groups and where each lane is of its own triangle.
fn shading(criterion: &mut Criterion) {
    let packed = scene(SceneKind::Small);
    let mut broadcast = scene(SceneKind::FillFrontToBack);
    broadcast.surface = packed.surface;
    for (name, scene) in [("shading/packed", &packed), ("shading/broadcast", &broadcast)] {
        stage(criterion, name, pixels(), scene, &frame(1, Outputs::COLOR), |statistics| statistics.tile_time);
    }
}

/// Nothing but the background: clear, resolve, encode, store.
fn store(criterion: &mut Criterion) {
    let mut empty = scene(SceneKind::FillFrontToBack);
    empty.runs.clear();
    for samples in [1, 4] {
        let name = format!("store/{samples}");
        stage(criterion, &name, pixels(), &empty, &frame(samples, Outputs::COLOR), |statistics| statistics.tile_time);
    }
}

criterion_group!(benches, geometry, raster, shading, store);
criterion_main!(benches);
