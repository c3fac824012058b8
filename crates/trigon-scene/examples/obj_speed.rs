//! Loading speed against the `tobj` crate: generates an OBJ file of about 100 MB in the system's temporary folder, then
//! loads it with both, alternately, and prints the times.
//!
//! `cargo run --release -p trigon-scene --example obj_speed [MEGABYTES] [ROUNDS]`

#![expect(clippy::print_stdout, reason = "a program for people")]

use std::fmt::Write as _;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trigon_scene::load::{LoadOptions, load_path};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let megabytes: usize = arguments.next().map_or(Ok(100), |text| text.parse())?;
    let rounds: usize = arguments.next().map_or(Ok(5), |text| text.parse())?;
    let path = std::env::temp_dir().join(format!("trigon-obj-speed-{}.obj", std::process::id()));
    let outcome = compare(&path, megabytes, rounds);
    std::fs::remove_file(&path)?;
    outcome
}

fn compare(path: &PathBuf, megabytes: usize, rounds: usize) -> Result<(), Box<dyn std::error::Error>> {
    let text = wavy_sheet(megabytes << 20);
    std::fs::write(path, &text)?;
    println!("{}: {:.1} MB", path.display(), text.len() as f64 / 1e6);
    drop(text);
    let mut options = LoadOptions::default();
    let (mut one, mut all, mut other, mut plain) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for _ in 0..rounds {
        options.threads = NonZeroUsize::new(1);
        one.push(time_trigon(path, &options)?);
        options.threads = None;
        all.push(time_trigon(path, &options)?);
        other.push(time_tobj(path, &tobj::GPU_LOAD_OPTIONS)?);
        plain.push(time_tobj(path, &tobj::LoadOptions { triangulate: true, ..tobj::LoadOptions::default() })?);
    }
    let (one, all, other, plain) = (best(&one), best(&all), best(&other), best(&plain));
    println!("best of {rounds} rounds, file in the page cache:");
    println!("  trigon, 1 thread                       {one:6.3} s");
    println!("  trigon, all threads                    {all:6.3} s");
    println!(
        "  tobj, triangulate and single index     {other:6.3} s  {:.1} x  (1 thread {:.1} x)",
        other / all,
        other / one
    );
    println!(
        "  tobj, triangulate only                 {plain:6.3} s  {:.1} x  (1 thread {:.1} x)",
        plain / all,
        plain / one
    );
    Ok(())
}

fn best(times: &[Duration]) -> f64 {
    times.iter().min().map_or(0.0, Duration::as_secs_f64)
}

fn time_trigon(path: &Path, options: &LoadOptions) -> Result<Duration, Box<dyn std::error::Error>> {
    let start = Instant::now();
    let loaded = load_path(path, options)?;
    let time = start.elapsed();
    let mesh = &loaded.scene.meshes[0];
    mesh.validate()?;
    assert!(loaded.warnings.is_empty() && mesh.normals.len() == mesh.positions.len());
    Ok(time)
}

fn time_tobj(path: &Path, options: &tobj::LoadOptions) -> Result<Duration, Box<dyn std::error::Error>> {
    let start = Instant::now();
    let (models, _) = tobj::load_obj(path, options)?;
    let time = start.elapsed();
    assert!(!models.is_empty());
    Ok(time)
}

/// A grid of quads cut into triangles, each corner with position, texture coordinates and normal of its own index,
/// as exporters write them.
fn wavy_sheet(bytes: usize) -> String {
    let side = (1..).find(|n| n * n * 150 >= bytes).unwrap_or(2).max(2);
    let mut text = String::with_capacity(bytes + bytes / 4);
    let at = |i: usize| i as f64 / (side - 1) as f64;
    for y in 0..side {
        for x in 0..side {
            let height = libm::sin(at(x) * 40.0) * libm::cos(at(y) * 30.0) * 0.05;
            let _ = writeln!(text, "v {:.6} {:.6} {:.6}", at(x) * 2.0 - 1.0, height, at(y) * 2.0 - 1.0);
        }
    }
    for y in 0..side {
        for x in 0..side {
            let _ = writeln!(text, "vt {:.6} {:.6}", at(x), at(y));
        }
    }
    for y in 0..side {
        for x in 0..side {
            let slope_x = 2.0 * libm::cos(at(x) * 40.0) * libm::cos(at(y) * 30.0);
            let slope_y = -1.5 * libm::sin(at(x) * 40.0) * libm::sin(at(y) * 30.0);
            let length = libm::sqrt(slope_x * slope_x + slope_y * slope_y + 1.0);
            let _ = writeln!(text, "vn {:.4} {:.4} {:.4}", -slope_x / length, 1.0 / length, -slope_y / length);
        }
    }
    for y in 0..side - 1 {
        for x in 0..side - 1 {
            let a = y * side + x + 1;
            let (b, c, d) = (a + 1, a + side + 1, a + side);
            let _ = writeln!(text, "f {a}/{a}/{a} {d}/{d}/{d} {c}/{c}/{c}\nf {a}/{a}/{a} {c}/{c}/{c} {b}/{b}/{b}");
        }
    }
    text
}
