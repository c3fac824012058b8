//! The `trigon-bench` command: timings of the benchmark scenes, and coverage counts for the oracle.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a command talks to its caller")]

mod args;

use args::{Command, CoverageArgs, TimingArgs};
use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use trigon::pipeline::{Frame, Picture, Renderer, RendererOptions};
use trigon::schedule::TileOrder;
use trigon_bench::scene::BenchScene;
use trigon_bench::{coverage, measure, shot};
use trigon_image::{EncodeOptions, Format, Rgba8Image, write_atomically};

fn main() -> ExitCode {
    let command = match args::parse() {
        Ok(command) => command,
        Err(error) => {
            eprintln!("trigon-bench: {error}\n\n{}", args::USAGE);
            return ExitCode::from(2);
        }
    };
    let done = match command {
        Command::Help => {
            println!("{}", args::USAGE);
            Ok(())
        }
        Command::Timing(args) => run_timing(&args),
        Command::Coverage(args) => run_coverage(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("trigon-bench: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Every combination of the listed scenes, sizes, samples, levels and threads, one line each.
fn run_timing(args: &TimingArgs) -> Result<(), Box<dyn Error>> {
    for kind in &args.scenes {
        for &size in &args.sizes {
            let scene = kind.build(size, &args.model)?;
            for &samples in &args.samples {
                let frame = shot::frame(size, samples).ok_or("samples are 1, 2, 4, 8 or 16")?;
                for &simd in &args.simd {
                    for &threads in &args.threads {
                        let options = RendererOptions { threads, simd, tile_order: TileOrder::default() };
                        time_one(args, &scene, &frame, options)?;
                    }
                }
            }
        }
    }
    Ok(())
}

fn time_one(
    args: &TimingArgs,
    scene: &BenchScene,
    frame: &Frame,
    options: RendererOptions,
) -> Result<(), Box<dyn Error>> {
    let mut renderer = Renderer::new(options)?;
    if let Some(path) = &args.png {
        let mut picture = Picture::default();
        shot::draw(&mut renderer, scene, frame, args.png_frame, &mut picture)?;
        write_png(path, picture)?;
    }
    if args.budget.frames > 0 {
        let measured = measure::measure(&mut renderer, scene, frame, args.budget)?;
        println!(
            "{{\"scene\": \"{}\", \"size\": \"{}x{}\", \"samples\": {}, \"threads\": {}, \"simd\": \"{}\", \"tris\": {}, {}}}",
            scene.kind.name(),
            frame.width,
            frame.height,
            frame.samples.count(),
            options.threads,
            options.simd,
            scene.mesh.triangles.len(),
            measured.to_json_members(),
        );
    }
    Ok(())
}

fn write_png(path: &Path, picture: Picture) -> Result<(), Box<dyn Error>> {
    let color = picture.color.ok_or("the frame has no colours")?;
    let image = Rgba8Image::from_pixels(color.width(), color.height(), color.into_values())?;
    write_atomically(path, &trigon_image::encode(&image, Format::Png, &EncodeOptions::default())?)?;
    Ok(())
}

fn run_coverage(args: &CoverageArgs) -> Result<(), Box<dyn Error>> {
    let triangles = coverage::parse_csv(&std::fs::read_to_string(&args.csv)?)?;
    let options = RendererOptions { threads: args.threads, simd: args.simd, tile_order: TileOrder::default() };
    let mut renderer = Renderer::new(options)?;
    let counts = coverage::count(&mut renderer, &triangles, args.size, args.samples, args.path)?;
    let bytes: Vec<u8> = counts.iter().flat_map(|word| word.to_le_bytes()).collect();
    write_atomically(&args.out, &bytes)?;
    let covered: u64 = bytes.iter().map(|count| u64::from(*count)).sum();
    println!(
        "{{\"tris\": {}, \"samples\": {}, \"covered_samples\": {covered}}}",
        triangles.len(),
        args.samples.count()
    );
    Ok(())
}
