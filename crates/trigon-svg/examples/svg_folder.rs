//! Draws every SVG file of a folder, or of its list `manifest.tsv`, in one process, and says how long each took.
//!
//! `svg_folder SUITE OUT [WIDTH]`: pictures go to OUT under the names of the files. Fonts come from SUITE/fonts alone. The
//! list has a file a line: path, two columns that are not read, and the width in pixels.

#![expect(clippy::print_stdout, reason = "a tool for the terminal")]

use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;

use trigon_image::{Color, EncodeOptions, Format, encode};
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, FontOptions, Options, Size, View};

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [suite, out, rest @ ..] = arguments.as_slice() else {
        println!("usage: svg_folder SUITE OUT [WIDTH] [ONLY]");
        std::process::exit(2);
    };
    let (suite, out) = (Path::new(suite), Path::new(out));
    let width = rest.first().and_then(|text| text.parse().ok());
    let only = rest.get(1).map_or("", String::as_str);
    let cases: Vec<_> =
        cases(suite, width).into_iter().filter(|case| case.0.to_string_lossy().contains(only)).collect();
    let queue = Mutex::new(cases.iter());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                loop {
                    let next = queue.lock().unwrap().next();
                    let Some((path, width)) = next else { break };
                    draw(suite, out, path, *width);
                }
            });
        }
    });
}

/// Paths from the folder, and the width to draw them with.
fn cases(suite: &Path, width: Option<u32>) -> Vec<(PathBuf, Option<u32>)> {
    if let Ok(list) = std::fs::read_to_string(suite.join("manifest.tsv")) {
        let case = |line: &str| {
            let columns: Vec<&str> = line.split('\t').collect();
            (PathBuf::from(columns[0]), width.or(columns.get(3).and_then(|text| text.parse().ok())))
        };
        return list.lines().map(case).collect();
    }
    let mut paths: Vec<PathBuf> = std::fs::read_dir(suite)
        .unwrap()
        .map(|entry| PathBuf::from(entry.unwrap().file_name()))
        .filter(|path| path.extension().is_some_and(|end| end == "svg"))
        .collect();
    paths.sort();
    paths.into_iter().map(|path| (path, width)).collect()
}

fn draw(suite: &Path, out: &Path, path: &Path, width: Option<u32>) {
    let started = Instant::now();
    let file = suite.join(path);
    let family = |name: &str| Some(name.to_owned());
    let options = Options {
        folder: file.parent().map(Path::to_owned),
        fonts: FontOptions {
            use_system_fonts: false,
            folders: vec![suite.join("fonts")],
            default_family: family("Noto Sans"),
            serif: family("Noto Serif"),
            sans_serif: family("Noto Sans"),
            cursive: family("Yellowtail"),
            fantasy: family("Sedgwick Ave Display"),
            monospace: family("Noto Mono"),
            ..FontOptions::default()
        },
        ..Options::default()
    };
    let renderer = Renderer::new();
    let view = View { size: width.map_or(Size::Document, Size::Width), ..View::default() };
    let parsed = Document::parse(&std::fs::read(&file).unwrap(), &options);
    let read = started.elapsed();
    match parsed.and_then(|document| document.draw(&view, &renderer, Color::TRANSPARENT)) {
        Ok((picture, warnings)) => {
            let drawn = started.elapsed() - read;
            let target = out.join(path).with_extension("png");
            std::fs::create_dir_all(target.parent().unwrap()).unwrap();
            let bytes = encode(&picture.to_image(), Format::Png, &EncodeOptions::default()).unwrap();
            std::fs::write(target, bytes).unwrap();
            println!(
                "{} {:.1} ms read, {:.1} ms drawn",
                path.display(),
                read.as_secs_f64() * 1e3,
                drawn.as_secs_f64() * 1e3
            );
            warnings.iter().for_each(|warning| println!("  {warning}"));
        }
        Err(error) => println!("{} FAILED: {error}", path.display()),
    }
}
