//! SVG files, trigon beside resvg in one process: 1024 pixels wide, 16 samples, from the resolved file to its pixels.
//!
//! In: the files of a folder, `TRIGON_SVG_FILES` or that of the shared data. Out: criterion's figures for each file and program, and at
//! the end how many times as fast as resvg trigon was, by the best time of each, and the geometric means. Reading files is
//! not counted for either. resvg has no threads; trigon is measured with one and with two.
#![expect(clippy::print_stdout, reason = "the table of ratios")]

use criterion::Criterion;
use resvg::{tiny_skia, usvg};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trigon_image::Color;
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, Options, Size, View};

const WIDTH: u32 = 1024;

/// Threads that trigon is measured with.
const THREADS: [usize; 2] = [1, 2];

/// Best times by file: of resvg, then of trigon.
type Best = BTreeMap<String, [Duration; 3]>;

fn main() {
    let folder = std::env::var_os("TRIGON_SVG_FILES")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data/svg-perf"), PathBuf::from);
    if !folder.is_dir() {
        println!("SKIPPED: {} does not exist; name a folder of SVG files in TRIGON_SVG_FILES", folder.display());
        return;
    }
    let mut criterion = Criterion::default().configure_from_args().without_plots();
    let mut best = Best::new();
    for path in svg_files(&folder) {
        measure(&mut criterion, &path, &mut best);
    }
    criterion.final_summary();
    print_ratios(&best);
}

fn svg_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder that can be read").flatten();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "svg"));
    paths.sort();
    paths
}

/// Measures one file with both programs.
fn measure(criterion: &mut Criterion, path: &Path, best: &mut Best) {
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let bytes = std::fs::read(path).expect("a file that can be read");
    let tree = usvg::Tree::from_data(&bytes, &usvg::Options::default()).expect("a file that resvg reads");
    let document = Document::parse(&bytes, &Options::default()).expect("a file that trigon reads");
    let times = best.entry(name.clone()).or_insert([Duration::MAX; 3]);
    let mut group = criterion.benchmark_group(format!("svg/{name}"));
    group.sample_size(10).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));

    let size = tree.size().to_int_size().scale_to_width(WIDTH).expect("a picture with a height");
    let scale = WIDTH as f32 / tree.size().width();
    let mut pixmap = tiny_skia::Pixmap::new(size.width(), size.height()).expect("a picture that is not too large");
    group.bench_function("resvg", |bencher| {
        bencher.iter_custom(|count| {
            repeat(count, &mut times[0], &mut || {
                pixmap.fill(tiny_skia::Color::TRANSPARENT);
                resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixmap.as_mut());
                black_box(pixmap.data().len());
            })
        });
    });
    let view = View { size: Size::Width(WIDTH), ..View::default() };
    for (threads, time) in THREADS.into_iter().zip(&mut times[1..]) {
        let renderer = Renderer { threads, ..Renderer::new() };
        let draw = || document.draw(&view, &renderer, Color::TRANSPARENT).expect("a picture that is not too large");
        let (mut picture, _) = draw();
        group.bench_function(format!("trigon-{threads}"), |bencher| {
            bencher.iter_custom(|count| {
                repeat(count, time, &mut || {
                    let prepared = document.prepare(&view, &renderer).expect("as before");
                    renderer.draw_into(&prepared.drawing, Color::TRANSPARENT, &mut picture).expect("as before");
                    black_box(picture.pixels().len());
                })
            });
        });
    }
    group.finish();
}

/// The time of `count` calls; the shortest of them is noted.
fn repeat(count: u64, best: &mut Duration, call: &mut dyn FnMut()) -> Duration {
    let mut total = Duration::ZERO;
    for _ in 0..count {
        let started = Instant::now();
        call();
        let time = started.elapsed();
        *best = time.min(*best);
        total += time;
    }
    total
}

fn print_ratios(best: &Best) {
    let ms = |time: Duration| time.as_secs_f64() * 1e3;
    println!(
        "\n{:<24} {:>10} {:>10} {:>10} {:>8} {:>8}",
        "best time, ms", "resvg", "1 thread", "2 threads", "ratio 1", "ratio 2"
    );
    let mut logarithms = [0.0, 0.0];
    let measured: Vec<_> = best.iter().filter(|(_, times)| times.iter().all(|time| *time != Duration::MAX)).collect();
    for (name, [resvg, one, two]) in &measured {
        let ratios = [ms(*resvg) / ms(*one), ms(*resvg) / ms(*two)];
        logarithms = [logarithms[0] + libm::log(ratios[0]), logarithms[1] + libm::log(ratios[1])];
        let [resvg, one, two] = [resvg, one, two].map(|time| ms(*time));
        println!("{name:<24} {resvg:>10.2} {one:>10.2} {two:>10.2} {:>8.2} {:>8.2}", ratios[0], ratios[1]);
    }
    if !measured.is_empty() {
        let [one, two] = logarithms.map(|sum| libm::exp(sum / measured.len() as f64));
        println!("{:<24} {:>10} {:>10} {:>10} {one:>8.2} {two:>8.2}", "geometric mean", "", "", "");
    }
}
